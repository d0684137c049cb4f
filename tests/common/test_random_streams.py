"""Every name has a stream of its own; seeds for JSBSim are spread."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from measuring import NAMES

from testbed.common.random_streams import engine_seed, generator


def test_streams_are_named_and_differ() -> None:
    names = [f"sensors.{n}.{p}" for n in NAMES for p in ("noise", "bias", "drift", "wander", "scale")]
    names += ["turbulence"]
    firsts = [generator(1, name).standard_normal() for name in names]
    assert len(set(firsts)) == len(names)
    assert generator(1, "a").standard_normal() == generator(1, "a").standard_normal()
    seeds = np.array([engine_seed(seed, "turbulence") for seed in range(2000)], dtype=float)
    assert seeds.min() >= 2 and seeds.max() < 2**31 - 1 and len(set(seeds)) == 2000
    assert abs(np.corrcoef(seeds[1:], seeds[:-1])[0, 1]) < 5 / math.sqrt(2000)
    assert all(abs(b - a) > 1 for a, b in pairwise(sorted(seeds[:5])))
