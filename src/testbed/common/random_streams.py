"""Random streams: every random part of a flight draws from its own, so adding one does not change the numbers of another."""

from __future__ import annotations

import zlib

import numpy as np

_ENGINE_SEEDS = 2**31 - 3  # JSBSim's generator works modulo 2^31 - 1, and to it seeds 0 and 1 are the same


def generator(seed: int, name: str) -> np.random.Generator:
    """The random stream with this name in a flight with this seed."""
    return np.random.Generator(np.random.PCG64(_sequence(seed, name)))


def engine_seed(seed: int, name: str) -> int:
    """Seed from 2 to 2^31 - 2 for a generator inside JSBSim.

    Hashed, because the first samples from neighbouring seeds of its generator are correlated.
    """
    return 2 + int(_sequence(seed, name).generate_state(1, np.uint64)[0]) % _ENGINE_SEEDS


def _sequence(seed: int, name: str) -> np.random.SeedSequence:
    return np.random.SeedSequence([seed, zlib.crc32(name.encode())])
