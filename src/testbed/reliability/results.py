"""What the methods return: a probability with what is known of it, and the smallest failure with the way to it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from testbed.reliability.display import block, number


@dataclass(frozen=True)
class Level:
    """One level of subset simulation: the points whose limit state is at or below `threshold`.

    `probability` is that of this level given the level before, `cov` its coefficient of variation, and `evaluations` how
    many points were evaluated for it.
    """

    threshold: float
    probability: float
    cov: float
    evaluations: int


@dataclass(frozen=True, eq=False, repr=False)
class FailureProbability:
    """The probability that a limit state is at or below 0, and how well it is known.

    `cov` is the coefficient of variation of the estimate (infinite if it is not known), `interval` has 95 % confidence.
    `probability` is NaN if nothing but the interval can be said. `method` is the one that gave the estimate. `levels` are
    those of the first run of subset simulation.
    `design_point` [d] is the failure nearest to the origin among the evaluated points, None without a failure.
    `converged` says whether the asked coefficient of variation was reached and nothing speaks against the estimate;
    `reason` says it in a sentence.
    """

    probability: float
    cov: float
    interval: tuple[float, float]
    evaluations: int
    method: str
    levels: tuple[Level, ...]
    design_point: np.ndarray | None
    converged: bool
    reason: str

    @property
    def distance(self) -> float:
        """Distance of the design point from the origin; infinite without a failure."""
        return math.inf if self.design_point is None else float(np.linalg.norm(self.design_point))

    def __repr__(self) -> str:
        low, high = map(number, self.interval)
        doubt = "" if self.converged else "not known well: "
        cov = f"{self.cov:.2f}" if math.isfinite(self.cov) else "unknown"
        return (
            f"<FailureProbability {number(self.probability)} ({low} to {high}), c.o.v. {cov}, "
            f"{self.evaluations} evaluations, {self.method}: {doubt}{self.reason}>"
        )

    def _repr_html_(self) -> str:
        """What a notebook shows: the line, what plain sampling would need, and the levels."""
        plain = ""
        if 0 < self.probability < 1 and math.isfinite(self.cov):
            needed = (1 - self.probability) / (self.probability * self.cov**2)
            plain = (
                f"Plain sampling needs about {needed:.2g} evaluations for the same coefficient of variation."
            )
        rows = [
            (f"{level.threshold:.4g}", f"{level.probability:.3g}", f"{level.cov:.2f}", level.evaluations)
            for level in self.levels
        ]
        head = ("at or below", "probability given the one before", "c.o.v.", "evaluations")
        return block([repr(self).strip("<>"), plain], head, rows)


@dataclass(frozen=True, eq=False)
class Step:
    """An improvement of a search: the failure `point` [d] at this `distance`, after so many evaluations."""

    evaluations: int
    distance: float
    point: np.ndarray


@dataclass(frozen=True, eq=False, repr=False)
class SmallestFailure:
    """The failure nearest to the origin that was found, or that none was.

    `design_point` [d] and `limit_state`, its value there, are None and NaN if nothing was found; `distance` is then
    infinite. `path` has every improvement, the last being the design point. `independent` of the evaluations were
    independent standard normal draws. `upper_bound` is what these allow the failure probability to be, with 95 %
    confidence.
    """

    found: bool
    design_point: np.ndarray | None
    distance: float
    limit_state: float
    evaluations: int
    path: tuple[Step, ...]
    independent: int
    upper_bound: float
    reason: str

    def __repr__(self) -> str:
        found = f"at {self.distance:.4g} standard deviations" if self.found else "not found"
        return f"<SmallestFailure {found}, {self.evaluations} evaluations: {self.reason}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: the line, and the last improvements."""
        rows = [(step.evaluations, f"{step.distance:.4g}") for step in self.path[-10:]]
        return block([repr(self).strip("<>")], ("evaluations", "distance"), rows)
