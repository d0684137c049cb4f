"""Why the weights of importance sampling are not to be trusted, beside the subset simulation that found the failures."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from testbed.reliability.limit_state import Asked
from testbed.reliability.subset_run import Run

DIFFERS = 3.3
"""Standard deviations by which subset simulation and importance sampling may differ: one in a thousand."""


class Estimate(Protocol):
    """What importance sampling found: the probability, its coefficient of variation, and the share of the greatest weight."""

    @property
    def probability(self) -> float: ...
    @property
    def cov(self) -> float: ...
    @property
    def heaviest(self) -> float: ...


def doubt(found: Estimate, run: Run, asked: Asked, about: str, heavy: float) -> str:
    """What speaks against the weights, in words; "" if nothing does.

    Args:
        about: what the points were drawn about, for the words.
        heavy: share of the sum that a single weight may have.
    """
    if not math.isfinite(found.cov):
        return f"hardly any of the points drawn about {about} fail"
    if found.heaviest > heavy:
        return f"a single weight is {found.heaviest:.0%} of the sum"
    apart = abs(math.log(found.probability / run.probability))
    if apart > DIFFERS * math.sqrt(math.log1p(run.variance) + math.log1p(found.cov**2)):
        return f"importance sampling gives {found.probability:.1e}, subset simulation {run.probability:.1e}"
    return f"{asked.unknown} values were not a number" if asked.unknown else ""


def regions_missed(region: np.ndarray, draws: np.ndarray, single: float) -> str:
    """Whether the failures seem to have regions that were not seen, in words; "" if they do not.

    The share of the failures in regions not seen is near that of the independent draws that are alone in theirs (Good 1953,
    Biometrika 40:237).

    Args:
        region: [n] number of the region of each failure.
        draws: [n] the independent draw that each failure descends from.
        single: share of the draws that may be alone.
    """
    pairs = np.unique(np.column_stack([region, draws]), axis=0)
    alone = int(np.sum(np.bincount(pairs[:, 0]) == 1))
    if alone <= single * len(pairs):
        return ""
    return f"{alone} of {len(pairs)} independent lines are alone in their region, and others may be missing"
