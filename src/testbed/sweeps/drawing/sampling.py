"""Points of the unit cube, block by block, and seeds: each a pure function of the sweep's seed and the index.

Sobol and Halton sequences and independent draws can be continued: the first 1000 points of 2000 are those of
1000. A latin hypercube belongs to its number of runs and cannot.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence

import numpy as np
from scipy.stats import qmc

SAMPLINGS = ("sobol", "latin_hypercube", "halton", "random", "grid")
BLOCK = 1024
"""Points made at a time; a power of two, as Sobol sequences want."""


def hashed(*words: object) -> int:
    """31 bits from any words, never 0 or 1: JSBSim takes these for no seed; neighbouring ones correlate."""
    digest = hashlib.sha256("\0".join(map(str, words)).encode()).digest()
    return 2 + int.from_bytes(digest[:8], "big") % (2**31 - 3)


def block(sampling: str, seed: int, names: Sequence[str], runs: int, index: int) -> np.ndarray:
    """[BLOCK, dimensions] points BLOCK * index and on of a sampling; fewer where a latin hypercube ends."""
    rng = np.random.default_rng(hashed(seed, "sampling"))
    first = BLOCK * index
    if sampling == "latin_hypercube":
        return np.asarray(qmc.LatinHypercube(len(names), rng=rng).random(runs)[first : first + BLOCK])
    if sampling == "random":
        return np.column_stack([_independent(seed, name, index) for name in names])
    sequence = (qmc.Sobol if sampling == "sobol" else qmc.Halton)(len(names), rng=rng)
    if first:
        sequence.fast_forward(first)
    return np.asarray(sequence.random(BLOCK))


def _independent(seed: int, name: str, index: int) -> np.ndarray:
    """One stream for each varied value: varying one more leaves the others' draws as they are."""
    return np.random.default_rng(hashed(seed, "draw", name, index)).random(BLOCK)


def grid_point(levels: Sequence[np.ndarray], index: int) -> np.ndarray:
    """Probabilities of point `index` of a grid; the last varied value changes fastest."""
    point = []
    for values in reversed(levels):
        index, k = divmod(index, len(values))
        point.append(values[k])
    return np.array(point[::-1])


def grid_size(levels: Sequence[np.ndarray]) -> int:
    """Points of the whole grid."""
    return math.prod(len(values) for values in levels)
