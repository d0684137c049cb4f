"""Robustness against the definition by brute force, and against rtamt, a library of signal temporal logic."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from testbed.flight.requirements import always, eventually, never_outside_for

DISTANCES = st.lists(st.floats(-10, 10), min_size=1, max_size=40).map(np.array)


@settings(deadline=None)
@given(DISTANCES, st.integers(1, 45))
def test_never_outside_for_is_the_least_of_the_largest(distances: np.ndarray, rows: int) -> None:
    starts = range(len(distances) - rows + 1)
    expected = min((max(distances[i : i + rows]) for i in starts), default=max(0.0, max(distances)))
    assert never_outside_for(distances, rows) == expected
    assert never_outside_for(distances, 1) == always(distances)


@settings(deadline=None)
@given(DISTANCES, st.integers(1, 40))
def test_is_negative_just_where_a_stretch_outside_is_as_long(distances: np.ndarray, rows: int) -> None:
    text = "".join("o" if distance < 0.0 else "." for distance in distances)
    assert (never_outside_for(distances, rows) < 0.0) == ("o" * rows in text)


@settings(deadline=None)
@given(DISTANCES, st.integers(1, 40), st.floats(0.0, 1.0))
def test_a_signal_that_moves_a_little_changes_it_no_more(
    distances: np.ndarray, rows: int, most: float
) -> None:
    moved = distances + most * np.cos(np.arange(len(distances)))
    for before, after in (
        (always(distances), always(moved)),
        (eventually(distances), eventually(moved)),
        (never_outside_for(distances, rows), never_outside_for(moved, rows)),
    ):
        assert abs(after - before) <= most + 1e-14  # the rounding of numbers up to 11


@pytest.mark.skipif(sys.version_info >= (3, 13), reason="rtamt's parser does not run on Python 3.13")
@pytest.mark.filterwarnings("ignore:typing.io:DeprecationWarning")
@pytest.mark.parametrize("seed", range(5))
def test_agrees_with_rtamt(seed: int) -> None:
    import rtamt

    distances = np.random.default_rng(seed).standard_normal(60).cumsum()

    def oracle(formula: str) -> float:
        specification = rtamt.StlDiscreteTimeSpecification()
        specification.declare_var("x", "float")
        specification.spec = formula
        specification.parse()
        signal = {"time": list(range(60)), "x": distances.tolist()}
        return float(specification.evaluate(signal)[0][1])

    assert always(distances) == oracle("always[0:59](x >= 0)")
    assert eventually(distances) == oracle("eventually[0:59](x >= 0)")
    for rows in (1, 2, 7, 30):
        formula = f"always[0:{60 - rows}](eventually[0:{rows - 1}](x >= 0))"
        assert never_outside_for(distances, rows) == oracle(formula)
    assert always(distances[20:]) == oracle("eventually[0:20](always[0:59](x >= 0))")  # settles by row 20
