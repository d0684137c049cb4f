"""Roots are those of scipy's `brentq`, to the last bit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from testbed.common.bracketed_root import bracketed_root


@settings(deadline=None, max_examples=300)
@given(st.floats(-3, 3), st.floats(0.01, 50), st.lists(st.floats(-5, 5), min_size=3, max_size=12))
def test_is_that_of_scipy(root: float, scale: float, slopes: list[float]) -> None:
    """Of a table with corners, rising or not, and of a smooth function."""
    values = np.cumsum(np.abs(slopes) + 0.1)
    grid = np.linspace(-3.1, 3.1, len(values))
    at_root = float(np.interp(root, grid, values))
    for function in (
        lambda x: scale * (float(np.interp(x, grid, values)) - at_root) * (1.0 + x * x),
        lambda x: scale * (math.exp(x) - math.exp(root)),
    ):
        if function(-3.1) * function(3.1) < 0.0:
            assert bracketed_root(function, -3.1, 3.1) == brentq(function, -3.1, 3.1)


@pytest.mark.parametrize(("low", "high"), [(0.0, 1.0), (-1.0, 0.0)])
def test_a_root_at_an_end(low: float, high: float) -> None:
    assert bracketed_root(lambda x: x, low, high) == 0.0 == brentq(lambda x: x, low, high)
