"""Bounds of the bias that an error of the input matrix causes in the estimates, for the references of a flight."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from testbed.flight.flight import Flight
from testbed.margins.bounds import (
    bias_bound,
    certified_range,
    error_bound,
    largest_ratios,
    sector_bias,
    uniform_limit,
)

_BISECTIONS = 40


@dataclass(frozen=True)
class ActuatorBias:
    """Bound of the bias of one estimate, for the references that were flown until the actuator was flagged.

    Attributes:
        trim_reference: |r| at the start, in units of the actuator's `scale`.
        trim_beta, median_beta, high_beta: the bound at the start; its median and 95th percentile.
        share: of the time in which the bound is below 1.
        error_limit: relative error of all entries up to which it is below 1 at the start.
        threshold: of the monitor.
    """

    actuator: str
    trim_reference: float
    trim_beta: float
    median_beta: float
    high_beta: float
    share: float
    error_limit: float
    threshold: float

    @property
    def range(self) -> tuple[float, float]:
        """Least and largest lam_hat / lam at the start."""
        low, high = certified_range(np.array([self.trim_beta]))
        return float(low[0]), float(high[0])

    @property
    def no_false_alarm(self) -> bool:
        """Whether a healthy actuator is certainly not flagged for the error of the input matrix."""
        return self.range[0] > self.threshold

    @property
    def seen_below(self) -> float:
        """Effectiveness below which a loss is certainly flagged; 0 if none is."""
        return self.threshold / self.range[1]


@dataclass(frozen=True)
class Flown:
    """The references of a flight.

    Attributes:
        references: [k, n] in scaled units.
        healthy: [k, n] whether the actuator was not flagged as failed.
    """

    references: np.ndarray
    healthy: np.ndarray

    @property
    def phases(self) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Each set of actuators that are not flagged, and the rows [k] in which it is they."""
        patterns, which = np.unique(self.healthy, axis=0, return_inverse=True)
        for k, pattern in enumerate(patterns):
            if pattern.any():
                yield np.flatnonzero(pattern), np.flatnonzero(which.ravel() == k)


def flown(flight: Flight) -> Flown:
    """The references of a flight."""
    log = flight.log
    references = [log[f"{name}_reference"] / each["scale"] for name, each in flight.actuators.items()]
    return Flown(
        np.column_stack(references),
        np.column_stack([log[f"{name}_failed"] < 0.5 for name in flight.actuators]),
    )


def biases(
    b: np.ndarray, each: Flown, actuators: Sequence[str], thresholds: np.ndarray, error: float
) -> tuple[ActuatorBias, ...]:
    """The bound of each actuator's bias.

    Args:
        b: [4, n] scaled input matrix of the design model.
        thresholds: [n] of the monitor.
        error: relative error of all entries of b.
    """
    beta, limits = _beta(error_bound(b, error * np.abs(b)), each), error_limits(b, each.references[0])
    found = []
    for i, name in enumerate(actuators):
        of_this = beta[~np.isnan(beta[:, i]), i]
        found.append(
            ActuatorBias(
                actuator=name,
                trim_reference=float(abs(each.references[0, i])),
                trim_beta=float(beta[0, i]),
                median_beta=float(np.quantile(of_this, 0.5, method="lower")),
                high_beta=float(np.quantile(of_this, 0.95, method="higher")),
                share=float(np.mean(of_this < 1.0)),
                error_limit=float(limits[i]),
                threshold=float(thresholds[i]),
            )
        )
    return tuple(found)


def _beta(e: np.ndarray, each: Flown) -> np.ndarray:
    """[k, n] `bias_bound` in each row, among the actuators that are not flagged; NaN for the others."""
    beta = np.full(each.references.shape, np.nan)
    for left, rows in each.phases:
        beta[np.ix_(rows, left)] = bias_bound(e[np.ix_(left, left)], each.references[np.ix_(rows, left)])
    return beta


def error_limits(b: np.ndarray, r: np.ndarray) -> np.ndarray:
    """[n] relative error of all entries of b [4, n] up to which each bound of the bias is below 1 for a constant r [n]."""
    e = error_bound(b, np.abs(b))

    def certain(i: int, error: float) -> bool:
        return bool(bias_bound(error * e, r)[i] < 1.0)

    return np.array([_largest(partial(certain, i), uniform_limit(b)) for i in range(len(r))])


def sector_limit(b: np.ndarray, each: Flown) -> float:
    """Relative error of all entries of b [4, n] up to which `sector_bias` is below 1 in each phase of the flight."""
    e = error_bound(b, np.abs(b))
    parts = [
        (e[np.ix_(left, left)], largest_ratios(each.references[np.ix_(rows, left)]))
        for left, rows in each.phases
    ]

    def certain(error: float) -> bool:
        return all(bool(np.all(sector_bias(error * part, ratios) < 1.0)) for part, ratios in parts)

    return _largest(certain, uniform_limit(b))


def _largest(holds: Callable[[float], bool], high: float) -> float:
    """The largest number up to `high` of which this holds, by bisection."""
    low = 0.0
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low
