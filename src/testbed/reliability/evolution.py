"""CMA-ES toward the nearest failure: the distance plus a penalty on the limit state above 0 is minimised."""

from __future__ import annotations

import math

import cma
import numpy as np

from testbed.reliability.surface import Search


def evolve(
    search: Search, start: np.ndarray, spread: float, scale: float, random: np.random.Generator
) -> None:
    """CMA-ES from a start. The penalty grows by half whenever a safe point seems better than any failure."""
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
