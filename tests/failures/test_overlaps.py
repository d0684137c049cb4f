"""Failures share a property in windows that do not meet, or where one replaces another of its type."""

from __future__ import annotations

from typing import Any

import pytest
from broken_flights import AIRCRAFT, example, fly

from testbed.failures import TABLE, Failure, overlaps, same_property

LEFT = {"actuator": "left_ruddervator"}
FALLS = {"when": {"signal": "altitude_m", "below": 100}}
PROPERTY = "fcs/left-ruddervator/effectiveness"


def failure(type: str = "effectiveness", **fields: Any) -> Failure:
    values = {"value": 0.5} if type == "effectiveness" else {}
    return TABLE[type].model_validate({"type": type, **values, **fields})


@pytest.mark.parametrize(
    ("one", "other", "refused"),
    [
        ({"at_s": 1, "until_s": 3}, {"at_s": 2, "until_s": 4}, True),
        ({"at_s": 1, "until_s": 2}, {"at_s": 2, "until_s": 3}, False),  # they touch
        ({"at_s": 2, "until_s": 3}, {"at_s": 1, "until_s": 2}, False),
        ({"at_s": 1}, {"at_s": 2}, False),  # the later replaces the earlier
        ({"at_s": 1}, {"at_s": 1}, True),  # neither is later
        ({"at_s": 1}, {"at_s": 2, "until_s": 3}, False),  # after 3 s the actuator is healthy
        ({"at_s": 2, "until_s": 3}, {"at_s": 1}, False),
        ({"at_s": 1, "until_s": 3}, {"at_s": 2}, True),
        (FALLS, {"at_s": 2}, True),  # which is later is not known
        ({**FALLS, "until_s": 2}, {"at_s": 2}, False),
        ({**FALLS, "until_s": 3}, {"at_s": 2}, True),
    ],
)
def test_windows_on_one_property(one: dict[str, Any], other: dict[str, Any], refused: bool) -> None:
    both = [failure(**LEFT, **one), failure(**LEFT, **other)]
    assert list(overlaps(both, AIRCRAFT)) == ([(0, 1, PROPERTY)] if refused else [])


def test_only_a_failure_of_the_same_type_is_replaced() -> None:
    lost = failure("surface_lost", **LEFT, at_s=2)
    assert list(overlaps([failure(**LEFT, at_s=1), lost], AIRCRAFT)) == [(0, 1, PROPERTY)]


def test_what_got_worse_and_was_mended_is_over() -> None:
    """Another type may hold the property after it, but not while the last step of it lasts."""
    worse = [failure(**LEFT, at_s=1), failure(**LEFT, at_s=2, until_s=3)]
    for at_s, refused in ((2.5, [(1, 2, PROPERTY)]), (3, [])):
        assert list(overlaps([*worse, failure("surface_lost", **LEFT, at_s=at_s)], AIRCRAFT)) == refused


def test_different_properties_may_be_held_at_once() -> None:
    both = [
        failure(**LEFT, at_s=1),
        failure(actuator="right_ruddervator", at_s=1),
        failure("stuck", **LEFT, at_s=1),
    ]
    assert list(overlaps(both, AIRCRAFT)) == []


def test_of_many_that_meet_each_later_one_is_named_once() -> None:
    """Not each of the pairs, of which a thousand failures have half a million."""
    assert list(overlaps([failure(**LEFT, at_s=1)] * 4, AIRCRAFT)) == [(0, i, PROPERTY) for i in (1, 2, 3)]


def test_two_spellings_are_one_property() -> None:
    assert same_property("a[0]/b[1]") == same_property("a/b[1]") != same_property("a/b")
    spelled = [{"propulsion/engine[0]/x": 1.0}, {"propulsion/engine/x": 1.0}]
    both = [failure("property", at_s=1, set=held, until_s=2) for held in spelled]
    assert list(overlaps(both, AIRCRAFT)) == [(0, 1, "propulsion/engine/x")]


def test_failures_of_different_properties_act_at_once() -> None:
    one, other = example("effectiveness", "left_ruddervator"), example("effectiveness", "right_ruddervator")
    flown = fly(one, example("bias", "left_ruddervator"), other)
    assert [flown.event(failure=i)["verified"] for i in range(3)] == [True] * 3
