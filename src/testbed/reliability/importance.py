"""Importance sampling about the design points of every failure region: `importance`.

Schueller and Stix 1987, Structural Safety 4:293; Melchers 1989, Structural Safety 6:3.
"""

from __future__ import annotations

import numpy as np
from scipy import stats
from threadpoolctl import threadpool_limits

from testbed.common.statistics import CONFIDENCE
from testbed.reliability.limit_state import Asked
from testbed.reliability.mixture import AboutPoints
from testbed.reliability.results import FailureProbability
from testbed.reliability.smallest import search_from
from testbed.reliability.subset import first_run, go_on, instead, log_normal, missing_evaluations
from testbed.reliability.subset_run import Run
from testbed.reliability.surface import Search
from testbed.reliability.weighing import Rounds, regions_missed

BATCH = 200
MOST_REGIONS = 8
COVERED = 0.8
"""A failure u belongs to the region of design point c if u.c is at least this share of c.c: it then weighs little."""
MISSED = 0.02
"""Share of the failures found beforehand that may belong to no region."""
SINGLE = 0.15
"""Largest share of the independent draws that may be alone in their region. It estimates the share of the failures in regions
that were not found."""
HEAVY = 0.1
"""Share of the sum that a single weight may have."""


def importance(asked: Asked, random: np.random.Generator, cov: float) -> FailureProbability:
    """Find the failure regions by a short subset simulation, their design points by search, and draw about these.

    Where that cannot be trusted, subset simulation goes on instead: many regions, failures all around, single heavy
    weights, or a result that differs from that of subset simulation. It also goes on where it has little left to do.
    The interval's upper end has room for a region that none of the independent draws led to: with E draws that failures
    descend from, one with a share q of all failures is missed with probability (1 - q)^E.
    """
    run = first_run(asked, random, cov)
    if run.end != "reached" or missing_evaluations(run, cov) < _search_evaluations(asked) + 2 * BATCH:
        return go_on(asked, random, cov, [run])
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so the points
        mixture = _mixture(asked, run, random)
        if mixture is None:
            return instead(asked, random, cov, run, "the failures are not in a few regions")
        drawn = _draw(asked, mixture, random, cov)
    why = drawn.doubt(run, asked, "the design points", HEAVY)
    why = why or regions_missed(mixture.likeliest(run.failures), run.draws, SINGLE)
    if why:
        return instead(asked, random, cov, run, why)
    regions, reached = len(mixture.shares), drawn.cov <= cov
    said = f"{drawn.drawn} points about {regions} design point{'s' * (regions > 1)}, c.o.v. {drawn.cov:.2f}"
    said += "." if reached else f"; the budget was spent before {cov:g} was reached."
    low, high = log_normal(drawn.probability, drawn.cov, drawn.effective - 1)
    ends = low, min(1.0, high / (1 - CONFIDENCE) ** (1 / run.ancestors))
    return asked.answer("importance", drawn.probability, drawn.cov, ends, run.levels, reached, said)


def _mixture(asked: Asked, run: Run, random: np.random.Generator) -> AboutPoints | None:
    """Design points one after another, each from the nearest failure that belongs to none yet; None with too many."""
    failures = run.failures[np.argsort(np.linalg.norm(run.failures, axis=1), kind="stable")]
    search, centres = Search(asked), np.empty((0, asked.dimensions))
    while len(left := failures[~_covered(failures, centres)]) > (
        MISSED * len(failures) if len(centres) else 0
    ):
        share = min(_search_evaluations(asked), asked.left // 6)
        if len(centres) == MOST_REGIONS or share < 30:
            return None
        search_from(search, left[0], share, random)
        if search.best is None:
            return None
        if not _covered(left[:1], search.best[None])[0]:  # the search left for another region
            search.best = left[0]
        centres = np.vstack([centres, search.best])
        if np.mean(_covered(failures, centres)) < len(centres) / MOST_REGIONS / 2:
            return None
    alone = stats.norm.sf(np.linalg.norm(centres, axis=1))
    return AboutPoints(centres, (alone / alone.sum() + 1 / len(centres)) / 2)


def _search_evaluations(asked: Asked) -> int:
    """Evaluations of the search for one design point."""
    return 60 + 15 * asked.dimensions


def _covered(failures: np.ndarray, centres: np.ndarray) -> np.ndarray:
    """Which of the failures [n] belong to the region of any centre."""
    return np.any(failures @ centres.T >= COVERED * np.sum(centres**2, axis=1), axis=1)


def _draw(asked: Asked, mixture: AboutPoints, random: np.random.Generator, cov: float) -> Rounds:
    """Draw batches until the precision is reached, the weights turn out useless, or the budget is spent."""
    drawn = Rounds()
    while asked.left and (
        drawn.drawn < 2 * BATCH or (drawn.enough and drawn.cov > cov and drawn.heaviest <= HEAVY)
    ):
        drawn.draw(asked, mixture, min(BATCH, asked.left), random)
    return drawn
