"""A number is written in one way, and so is its absence."""

from __future__ import annotations

import math

import pytest

from testbed.reporting.words import interval, number


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.123456, "0.1235"), (1e-9, "1e-09"), (12345, "12345"), (0, "0"), ("none: flights were lost",) * 2],
)
def test_a_number_has_four_digits_and_a_count_all_of_them(value: object, text: str) -> None:
    assert number(value) == text


@pytest.mark.parametrize("absent", [None, math.nan, math.inf, -math.inf])
def test_what_is_absent_or_not_finite_is_a_dash_or_the_words_for_it(absent: float | None) -> None:
    assert number(absent) == "-"
    assert number(absent, ".3f", absent="too few") == "too few"


def test_an_interval_is_written_with_any_of_its_numbers_absent() -> None:
    assert interval({"estimate": 0.97, "low": 0.957, "high": 0.979}) == "0.970 (0.957 to 0.979)"
    assert interval({"estimate": None, "low": None, "high": 1.0}) == "- (- to 1.000)"
    assert interval({"difference": -0.1, "low": -0.2, "high": 0.0}, "difference", "+.3f") == (
        "-0.100 (-0.200 to +0.000)"
    )
