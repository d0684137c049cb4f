"""`smallest_failure`: the failure nearest to the origin, by CMA-ES and then along the limit surface."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator

import numpy as np
from threadpoolctl import threadpool_limits

from testbed.common.random_streams import generator
from testbed.common.statistics import CONFIDENCE, proportion
from testbed.reliability.exploration import KRIGED, Exploration
from testbed.reliability.limit_state import Asked, LimitState, check, refused
from testbed.reliability.results import SmallestFailure
from testbed.reliability.surface import Search, around, evolve, plane, section, toward_plane

MOST_DIMENSIONS = 1000
"""More would take matrices of their square."""
DRAWS = 0.1
"""Share of the budget for independent draws, with which a search begins; half as many where kriging chooses further points."""
SEARCHED = 0.75
"""Share of the budget after which a search that found nothing gives up: the rest are independent draws, for the bound."""
EXPLORED = 0.45
"""Share of the budget until the end of the starts, after which the nearest failure of all is refined."""
SPREAD, CLOSE = 0.5, 0.08
"""Standard deviations of CMA-ES's first points around a start, and around a failure to be refined."""
BATCH = 64
SETTLED = 2e-3
"""Relative improvement below which a move along the surface counts as none."""


def smallest_failure(
    limit_state: LimitState,
    dimensions: int,
    *,
    seed: int = 0,
    budget: int = 2000,
    starts: int = 3,
    mirrored: Collection[int] = (),
) -> SmallestFailure:
    """The failure of `limit_state` (at or below 0) that is nearest to the origin, by `starts` searches within `budget`.

    Directions are surveyed, and in few dimensions further points are chosen by kriging, to find other regions that fail. After
    that, each start minimises distance + weight max(limit state, 0) by CMA-ES (Hansen 2016, arXiv:1604.00772). It looks for a
    nearer failure between the best one and the origin, and then moves that along the limit surface until it comes no nearer.
    Without a failure the rest of the budget is spent on independent draws, whose number bounds the probability.

    `mirrored` names coordinates, from 0, whose values at u and -u are the same: only one side of them is looked at, with u >= 0.

    Raises BadInput for arguments that cannot be used, for a limit state that returns anything but [n] numbers, and if it
    fails at the origin, or is not a number there: there is nothing to search.
    """
    check(limit_state, MOST_DIMENSIONS, dimensions=dimensions, seed=seed, budget=budget, starts=starts)
    if wrong := [each for each in mirrored if each not in range(dimensions)]:
        raise refused("mirrored", f"has {wrong[0]!r}", f"coordinates from 0 to {dimensions - 1}")
    search = Search(Asked(limit_state, int(dimensions), int(budget)), mirrored=tuple(mirrored))
    search.begin(search.asked.budget)
    scale = _at_origin(search)
    random = generator(int(seed), "reliability smallest")
    with threadpool_limits(1):  # the number of BLAS threads changes the last bits, and so the points
        _all_starts(search, int(starts), scale, random)
    return _result(search)


def _all_starts(search: Search, starts: int, scale: float, random: np.random.Generator) -> None:
    """Draw, explore, search from every start, refine and explore."""
    asked, exploration = search.asked, Exploration(search, scale, random)
    share = DRAWS / 2 if exploration.kriges else DRAWS
    draws, values = search.draw(max(8, int(share * asked.budget)), random)
    exploration.explore(KRIGED)
    for start, point in enumerate(_starts(draws, values, starts)):
        whole = (EXPLORED if search.path else SEARCHED) * asked.budget
        search.begin(int((whole - asked.evaluations) / (starts - start)))
        _search(search, point, SPREAD, scale, random)
    search.limit = asked.budget
    while not search.path and search.left:  # without a failure, for the bound
        search.draw(BATCH, random)
    before = math.inf
    while search.nearest < before:
        _refine(search, scale, random)
        before = search.nearest
        exploration.explore()


def _at_origin(search: Search) -> float:
    """The limit state at the origin, which is what everything else is scaled by."""
    value = float(search(np.zeros((1, search.asked.dimensions)))[0])
    if value <= 0:
        raise refused("limit_state", "fails at the origin: nothing is needed to break it")
    if math.isnan(value):
        raise refused("limit_state", "is not a number at the origin")
    return value if math.isfinite(value) else 1.0


def _starts(draws: np.ndarray, values: np.ndarray, starts: int) -> Iterator[np.ndarray]:
    """Where the searches begin: where a plane through the draws falls to 0, and then the worst draws, each apart from the others.

    Of the tenth of the draws that is worst (nearest first if they fail, else with the lowest values) a start is the one
    whose direction differs most from those of the starts before it.
    """
    values = np.where(np.isfinite(values), values, np.inf)
    chosen = [_by_plane(draws, values)]
    distances = np.linalg.norm(draws, axis=1)
    order = np.lexsort((np.where(values <= 0, distances, values), values > 0))
    worst = draws[order[: max(5, len(draws) // 10)]]
    for start in range(1, starts):
        apart = np.max([_cosines(worst, other) for other in chosen[-len(worst) :]], axis=0)
        chosen.append(worst[0] if start == 1 else worst[int(np.argmin(apart))])
    yield from chosen


def _cosines(points: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Cosines of the angles between points [n, d] and another one; 0 if that is the origin."""
    lengths = np.linalg.norm(points, axis=1) * np.linalg.norm(other)
    return np.divide(points @ other, lengths, out=np.zeros(len(points)), where=lengths > 0)


def _by_plane(draws: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Where the plane through the draws comes to 0, at most as far out as the draws are; the origin if it is level."""
    found = plane(draws, values)
    if found is None:
        return np.zeros(draws.shape[1])
    toward, slope, middle = found
    return toward * min(max(middle / slope, 0.0), 2 + math.sqrt(len(toward)))


def _search(
    search: Search, start: np.ndarray, spread: float, scale: float, random: np.random.Generator
) -> None:
    """One start: CMA-ES with most of its evaluations, then along the ray and the limit surface with the rest."""
    reserve = int(0.4 * search.left)
    search.limit -= reserve
    evolve(search, start, spread, scale, random)
    search.limit += reserve
    if search.best is not None:
        section(search, 0.0, 3)
        _along_surface(search, random)


def search_from(search: Search, failure: np.ndarray, evaluations: int, random: np.random.Generator) -> None:
    """Search for the failure nearest to the origin from one that is known, with so many evaluations at most."""
    search.begin(evaluations)
    search.best = failure
    _search(search, failure, 2 * CLOSE, 1.0, random)


def _refine(search: Search, scale: float, random: np.random.Generator) -> None:
    """Search again, close to the nearest failure of all starts, until that brings it no nearer."""
    before = math.inf
    while search.path and search.path[-1].distance < before * (1 - SETTLED) and search.asked.left:
        before = search.path[-1].distance
        search.begin(max(search.asked.left // 2, search.asked.budget // 8))
        search.best = search.path[-1].point
        _search(search, search.best, CLOSE, scale, random)


def _along_surface(search: Search, random: np.random.Generator) -> None:
    """Toward the foot of the fitted plane and around the best failure, until neither brings it nearer."""
    spread, idle = 0.3, 0
    while search.left and idle < 6:
        before = search.distance
        toward_plane(search)
        if around(search, spread, BATCH // 4, random):
            spread = min(0.6, 1.5 * spread)
        else:
            spread *= 0.6
        if search.distance < before:
            section(search, 0.96, 1)
        idle = idle + 1 if search.distance > before * (1 - SETTLED) else 0
    if search.best is not None:
        section(search, 0.98, 1)


def _result(search: Search) -> SmallestFailure:
    n, evaluations, path = search.independent, search.asked.evaluations, tuple(search.path)
    bound = proportion(search.failing, n, 2 * CONFIDENCE - 1, "exact").high  # one side of the interval
    if not path:
        reason = (
            f"Not found in {evaluations} evaluations. As {n} of them were independent and none failed, the failure probability "
            f"is at most {bound:.2g} with 95 % confidence."
        )
        return SmallestFailure(False, None, math.inf, math.nan, evaluations, path, n, bound, reason)
    last, points = path[-1], np.concatenate(search.points)
    value = np.concatenate(search.values)[np.argmin(np.linalg.norm(points - last.point, axis=1))]
    reason = f"The nearest of the failures found in {evaluations} evaluations is {last.distance:.3g} standard deviations away."
    return SmallestFailure(True, last.point, last.distance, float(value), evaluations, path, n, bound, reason)
