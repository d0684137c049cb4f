"""Names become file names, and values what JSON can hold."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from testbed.common.files import plain, slug


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("Left tail, failure!", "left-tail-failure"),
        ("a/../b", "a-b"),
        ("--x--", "x"),
        ("5 m", "5-m"),
        ("äö", "other"),
    ],
)
def test_slug(name: str, expected: str) -> None:
    assert slug(name, otherwise="other") == expected


def test_numpy_and_tuples_become_pythons_own_types() -> None:
    value = {
        "numbers": (np.float64(0.1), np.int32(2), np.bool_(True)),
        "array": np.arange(3.0),
        7: "text",
    }
    found = plain(value)
    assert found == {"numbers": [0.1, 2, True], "array": [0.0, 1.0, 2.0], "7": "text"}
    assert [type(item) for item in found["numbers"]] == [float, int, bool]


def test_what_is_not_finite_is_none_at_any_depth() -> None:
    value = {"a": math.nan, "b": [math.inf, {"c": np.float64(-math.inf)}], "d": np.array([1.0, math.nan])}
    found = plain(value)
    assert found == {"a": None, "b": [None, {"c": None}], "d": [1.0, None]}
    json.dumps(found, allow_nan=False)
