"""Sufficient conditions on the error of the input matrix, and bounds of the estimates' bias: what the paper's 4.3 asks for.

|B_c - B_mc| <= Delta, entry by entry, gives |M - I| <= E = |B_mc^-1| Delta for M = B_mc^-1 B_c.

* rho(E) < 1: M is H+ (`matrix_classes`) for each such B_c.
* beta_i = (F |r|)_i / |r_i| < 1 for each i, with F = (I - E)^-1 - I: for this constant r the estimates converge from any start,
  e -> 0, and 1/(1 + beta_i) <= lam_hat_i / lam_i <= 1/(1 - beta_i).
* The same with `sector_bias` in place of beta, for an r(t) and an M(t) that vary in any way within a sector: then lam_hat_i / lam_i
  enters that interval and stays in it.

Multiplying a column of B_c by a positive number is the same as another effectiveness, and no error. Proofs are on the page
"Error of the input matrix" of the documentation.

`flown` has the references of a flight, for which `biases` and `sector_limit` give these bounds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from testbed.flight.flight import Flight
from testbed.margins.matrix_classes import comparison, jacobi_radius, spectral_radius


def mismatch(b_mc: np.ndarray, b_c: np.ndarray) -> np.ndarray:
    """[n, n] M = B_mc^-1 B_c; the identity if there is no error. With fewer actuators than rates, the left inverse."""
    return np.asarray(np.linalg.pinv(b_mc) @ b_c)


def error_bound(b_mc: np.ndarray, delta: np.ndarray) -> np.ndarray:
    """[n, n] E = |B_mc^-1| Delta, a bound of |M - I|.

    Args:
        b_mc: [m, n] modelled input matrix of full column rank.
        delta: [m, n] largest error of each entry.
    """
    return np.asarray(np.abs(np.linalg.pinv(b_mc)) @ delta)


def uniform_limit(b_mc: np.ndarray) -> float:
    """Largest relative error of all entries at once for which M is certainly H+: 1 / rho(|B_mc^-1| |B_mc|).

    It is one over the least condition number in the infinity norm that scaling of rows and columns can give B_mc
    (Bauer, Numerische Mathematik 5, 1963), so units do not matter.
    """
    return 1.0 / spectral_radius(error_bound(b_mc, np.abs(b_mc)))


def remaining_limit(m: np.ndarray, e: np.ndarray) -> float:
    """Largest factor f such that each matrix within f E of an H+ matrix M is certainly H+: 1 / rho(C^-1 E), C its `comparison`.

    Args:
        m: [n, n] what is known of the mismatch; with the identity and E = |B_mc^-1| |B_mc| it is `uniform_limit`.
        e: [n, n] a bound of what is not known, entry by entry.
    """
    return 1.0 / spectral_radius(np.linalg.solve(comparison(m), e)) if jacobi_radius(m) < 1.0 else 0.0


def entry_limits(b_mc: np.ndarray) -> np.ndarray:
    """[m, n] largest relative error of one entry alone: 1 / |(B_mc^-1)_ji B_ij|. With the worse sign it makes M_jj zero."""
    share = np.abs(np.linalg.pinv(b_mc).T * b_mc)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / share)


def bias_bound(e: np.ndarray, r: np.ndarray) -> np.ndarray:
    """[..., n] beta_i = (F |r|)_i / |r_i|, F = (I - E)^-1 - I; infinite where r_i is 0, and everywhere if rho(E) >= 1.

    Args:
        e: [n, n] bound of |M - I|.
        r: [..., n] references.
    """
    size = np.abs(r)
    if spectral_radius(e) >= 1.0:
        return np.full(size.shape, np.inf)
    f = np.linalg.inv(np.eye(len(e)) - e) - np.eye(len(e))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(size > 0.0, size @ f.T / size, np.inf)


def largest_ratios(r: np.ndarray) -> np.ndarray:
    """[n, n] largest |r_j| / |r_i| over the rows of r [k, n]: the sector of references. Infinite where r_i has a zero."""
    size = np.abs(r)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.where(size[:, :, None] > 0.0, size[:, None, :] / size[:, :, None], np.inf)
    ratios[:, range(size.shape[1]), range(size.shape[1])] = 1.0
    return np.asarray(np.max(ratios, axis=0))


def sector_bias(e: np.ndarray, ratios: np.ndarray) -> np.ndarray:
    """[n] bound of the bias over a sector, for an r(t) that varies in it in any way: (I - E_s)^-1 E_s 1, E_s = E * ratios.

    Infinite if rho(E_s) >= 1. For one direction of r it is `bias_bound`.

    Args:
        e: [n, n] bound of |M - I|.
        ratios: [n, n] largest |r_j| / |r_i|, as `largest_ratios` gives them.
    """
    n = len(e)
    with np.errstate(invalid="ignore"):
        within = np.where(e > 0.0, e * ratios, 0.0)
    if not np.all(np.isfinite(within)) or spectral_radius(within) >= 1.0:
        return np.full(n, np.inf)
    return np.asarray(np.linalg.solve(np.eye(n) - within, within @ np.ones(n)))


def certified_range(beta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least and largest lam_hat / lam for these bounds of the bias; 0 and infinity where beta is not below 1."""
    inside = beta < 1.0
    low = np.where(inside, 1.0 / (1.0 + beta), 0.0)
    return low, np.where(inside, 1.0 / (1.0 - np.where(inside, beta, 0.0)), np.inf)


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
