"""What the methods return: a probability with what is known of it, and the smallest failure with the way to it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np


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
        low, high = map(_number, self.interval)
        doubt = "" if self.converged else "not known well: "
        cov = f"{self.cov:.2f}" if math.isfinite(self.cov) else "unknown"
        return (
            f"<FailureProbability {_number(self.probability)} ({low} to {high}), c.o.v. {cov}, "
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
        return _block([repr(self).strip("<>"), plain], head, rows)


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
        return _block([repr(self).strip("<>")], ("evaluations", "distance"), rows)


def _number(value: float) -> str:
    """Three digits, or that it is unknown."""
    return "unknown" if math.isnan(value) else f"{value:.3g}"


def _block(lines: Iterable[str], head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """HTML of some lines of text, those that are not empty, and a table."""
    told = "".join(f"<p>{escape(line)}</p>" for line in lines if line)
    cells = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<div>{told}<table><tr>{cells}</tr>{body}</table></div>"
