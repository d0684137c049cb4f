"""A search for the nearest failure: every point it asked for, the nearest so far, and moves that bring it nearer."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import cma
import numpy as np

from testbed.reliability.limit_state import Asked, nearest_of
from testbed.reliability.results import Step

PARTS = 8
"""Parts of an interval that one batch divides it into."""


@dataclass
class Search:
    """Points and values so far, and the nearest failure of this start, `best` [d].

    A coordinate is mirrored if u and -u have the same value there. `independent` draws were made, of which `failing` failed.
    """

    asked: Asked
    points: list[np.ndarray] = field(default_factory=list)
    values: list[np.ndarray] = field(default_factory=list)
    path: list[Step] = field(default_factory=list)
    best: np.ndarray | None = None
    limit: int = 0
    mirrored: tuple[int, ...] = ()
    independent: int = 0
    failing: int = 0

    def folded(self, points: np.ndarray) -> np.ndarray:
        """The points [n, d] with the mirrored coordinates' signs away: the same values, in half of the space for each."""
        folded = points.copy()
        folded[:, list(self.mirrored)] = np.abs(folded[:, list(self.mirrored)])
        return folded

    @property
    def distance(self) -> float:
        """Distance of this start's nearest failure; infinite without one."""
        return math.inf if self.best is None else float(np.linalg.norm(self.best))

    @property
    def nearest(self) -> float:
        """Distance of the nearest failure of all starts; infinite without one."""
        return self.path[-1].distance if self.path else math.inf

    @property
    def left(self) -> int:
        """Evaluations that this start still has."""
        return max(0, self.limit - self.asked.evaluations)

    def begin(self, evaluations: int) -> None:
        """Begin a start with so many evaluations at most, without a failure of its own."""
        self.best = None
        self.limit = self.asked.evaluations + max(0, min(evaluations, self.asked.left))

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """Values [n] at as many of the points as are left; the others are NaN, like what is not a number."""
        values = np.full(len(points), np.nan)
        points = self.folded(points[: self.left])
        if len(points):
            values[: len(points)] = self.asked(points)
            self._keep(points, values[: len(points)])
        return values

    def draw(self, n: int, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """At most n independent standard normal points [n, d], as many as are left, and their values [n]."""
        points = random.standard_normal((min(n, self.left), self.asked.dimensions))
        values = self(points)
        self.independent += len(points)
        self.failing += int(np.sum(values <= 0))
        return points, values

    def _keep(self, points: np.ndarray, values: np.ndarray) -> None:
        self.points.append(points)
        self.values.append(values)
        failure = nearest_of(points[values <= 0])
        if failure is not None and np.linalg.norm(failure) < self.distance:
            self.best = failure
            if self.distance < self.nearest:
                self.path.append(Step(self.asked.evaluations, self.distance, failure))


def section(search: Search, low: float, rounds: int) -> None:
    """Look for failures between the origin and the best one, along the ray, from the share `low` of its distance on.

    Each round divides the part before the nearest failure by PARTS. A ray that fails, passes and fails again is seen if
    its parts are wider than that.
    """
    assert search.best is not None
    ray, high = search.best, 1.0
    for _ in range(rounds):
        shares = np.linspace(low, high, PARTS + 1)[:-1]
        values = search(shares[:, None] * ray)
        failing = np.flatnonzero(values <= 0)
        first = int(failing[0]) if len(failing) else PARTS
        high = shares[first] if len(failing) else high
        low = shares[first - 1] if first else max(0.0, 2 * low - 1)


def plane(points: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, float, float] | None:
    """The plane through values [n] at points [n, d]: unit vector [d] downward, slope, value at the origin; None if level.

    By least squares with a ridge of a millionth, so that with fewer points than dimensions it is the flattest that fits.
    """
    known = np.isfinite(values)
    points, values = points[known], values[known]
    if len(values) < 3:
        return None
    middle, mean = points.mean(axis=0), values.mean()
    spread = (points - middle).T @ (points - middle)
    ridge = 1e-6 * max(np.trace(spread) / len(middle), 1e-12) * np.eye(len(middle))
    fit = np.linalg.solve(spread + ridge, (points - middle).T @ (values - mean))
    slope = float(np.linalg.norm(fit))
    if not (slope > 0 and math.isfinite(slope)):
        return None
    return -fit / slope, slope, float(mean - fit @ middle)


def toward_plane(search: Search) -> None:
    """Try points on the way to the foot of the perpendicular from the origin to the local plane (Hasofer and Lind 1974)."""
    assert search.best is not None
    points, values = np.concatenate(search.points), np.concatenate(search.values)
    near = np.argsort(np.linalg.norm(points - search.best, axis=1), kind="stable")
    near = near[: 2 * points.shape[1] + 10]
    found = plane(points[near], values[near])
    if found is None:
        return
    foot = (search.best @ found[0]) * found[0]
    shares = np.array([0.25, 0.5, 0.75, 1.0, 1.0])
    scales = np.array([1.0, 1.0, 1.0, 1.0, 1.03])
    search(scales[:, None] * (search.best + shares[:, None] * (foot - search.best)))


def around(search: Search, spread: float, n: int, random: np.random.Generator) -> bool:
    """Try `n` points a little nearer to the origin, in directions that differ by `spread`; whether one failed."""
    assert search.best is not None
    before = search.distance
    directions = search.best / before + spread * random.standard_normal((n, len(search.best))) / math.sqrt(
        len(search.best)
    )
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    nearer = before * (1 - np.linspace(0.25, 1.0, n) * min(0.02, spread**2 + 0.001))
    search(nearer[:, None] * directions)
    return search.distance < before


def evolve(
    search: Search, start: np.ndarray, spread: float, scale: float, random: np.random.Generator
) -> None:
    """CMA-ES from a start: the distance plus a penalty on the limit state above 0 is minimised.

    The penalty grows by half whenever a safe point seems better than any failure.
    """
    dimensions = len(start)
    if dimensions == 1:  # CMA-ES needs two; the second coordinate is not used
        start = np.append(start, 0.0)
    strategy = cma.CMAEvolutionStrategy(start, spread, _options(random, dimensions))
    boost = 2.0
    while search.left >= strategy.popsize and not strategy.stop():
        candidates = strategy.ask()
        points = np.array(candidates)[:, :dimensions]
        values = np.nan_to_num(search(points), nan=10 * scale, posinf=10 * scale)
        excess = np.maximum(values, 0) / scale
        far = min(search.distance, 10 * math.sqrt(dimensions) + 10)
        merits = np.linalg.norm(points, axis=1) + boost * far * excess
        best = int(np.argmin(merits))
        if excess[best] > 0 and merits[best] < search.distance < math.inf:
            boost *= 1.5
        strategy.tell(candidates, list(merits))


def _options(random: np.random.Generator, dimensions: int) -> dict[str, object]:
    """Silent, with random numbers of its own stream, and settled at a hundredth of a standard deviation (`tolx`)."""
    return {
        "verbose": -9,
        "seed": math.nan,
        "randn": lambda n, d: random.standard_normal((n, d)),
        "popsize": max(12, 4 + int(3 * math.log(dimensions))),
        "tolx": 1e-2,
        "tolfun": 5e-3,
        "CMA_diagonal": dimensions > 200,
    }
