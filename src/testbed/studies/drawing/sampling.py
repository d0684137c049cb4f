"""Points of the unit cube, and seeds: each a pure function of the sweep's seed and the number of the run.

Sobol and Halton sequences and independent draws can be continued: the first 1000 of 2000 runs are the runs of a sweep of
1000. A latin hypercube cannot be continued, because its points depend on their number.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence

import numpy as np
from scipy.stats import qmc

BATCH = 1024
"""Number of points made at a time: a power of two, for which a Sobol sequence is balanced."""


def hashed(*words: object) -> int:
    """A seed of 31 bits from any words; never 0 or 1, which JSBSim takes for "no seed".

    It is a hash, because JSBSim's random numbers from neighbouring seeds are correlated.
    """
    digest = hashlib.sha256("\0".join(map(str, words)).encode()).digest()
    return 2 + int.from_bytes(digest[:8], "big") % (2**31 - 3)


def batch(sampling: str, seed: int, names: Sequence[str], runs: int, index: int) -> np.ndarray:
    """[BATCH, dimensions] points from number BATCH * index on; the last batch of a latin hypercube may have fewer.

    Args:
        names: the varied paths, one for each dimension.
        runs: number of runs of the sweep, on which only a latin hypercube depends.
    """
    rng = np.random.default_rng(hashed(seed, "sampling"))
    first = BATCH * index
    if sampling == "latin_hypercube":
        return np.asarray(qmc.LatinHypercube(len(names), rng=rng).random(runs)[first : first + BATCH])
    if sampling == "random":
        return np.column_stack([_independent(seed, name, index) for name in names])
    sequence = (qmc.Sobol if sampling == "sobol" else qmc.Halton)(len(names), rng=rng)
    if first:
        sequence.fast_forward(first)
    return np.asarray(sequence.random(BATCH))


def _independent(seed: int, name: str, index: int) -> np.ndarray:
    """[BATCH] draws of one varied value from its own stream, so that varying another value does not change them."""
    return np.random.default_rng(hashed(seed, "draw", name, index)).random(BATCH)


def grid_point(levels: Sequence[np.ndarray], index: int) -> np.ndarray:
    """[dimensions] point `index` of a grid, as probabilities; the last varied value changes fastest."""
    chosen = np.unravel_index(index, [len(values) for values in levels])
    return np.array([values[k] for values, k in zip(levels, chosen, strict=True)])
