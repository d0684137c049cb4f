"""Points and seeds."""

from __future__ import annotations

import numpy as np

from testbed.studies.drawing.distributions import hashed


def test_seeds_are_fit_for_the_engine() -> None:
    """31 bits, never 0 or 1, no two alike, and neighbours uncorrelated."""
    seeds = [hashed(7, "run", i) for i in range(5000)]
    assert min(seeds) >= 2 and max(seeds) < 2**31 and len(set(seeds)) == 5000
    assert abs(np.corrcoef(seeds[:-1], seeds[1:])[0, 1]) < 0.05
    assert hashed(7, "run", 1) != hashed(7, "draw", 1) != hashed(71, "run")
