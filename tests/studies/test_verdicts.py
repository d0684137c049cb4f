"""How a flight of a sweep ended, and the requirement that it missed by most."""

from __future__ import annotations

import math

import pytest

from testbed.scenario.requirement import Requirement
from testbed.studies.verdicts import margin, missed, state

NEAR = Requirement(signal="altitude_m", within=5.0, of="altitude_command_m")
FEW = Requirement(metric="false_alarms", at_most=0.0)
SOME = Requirement(metric="survived", at_least=1.0)


@pytest.mark.parametrize(
    ("outcome", "passed", "expected"),
    [
        ("completed", True, "passed"),
        ("completed", False, "missed"),
        ("ground_contact", False, "lost"),
        ("diverged", False, "lost"),
        ("timeout", False, "no result"),
        ("invalid", False, "no result"),
    ],
)
def test_endings(outcome: str, passed: bool, expected: str) -> None:
    assert state(outcome, passed) == expected


def test_margins_are_negative_outside_of_the_limit() -> None:
    assert (margin(NEAR, 3.0), margin(NEAR, 7.0)) == (2.0, -2.0)
    assert (margin(FEW, 2.0), margin(SOME, 0.0)) == (-2.0, -1.0)
    assert math.isnan(margin(NEAR, math.nan))
    both = Requirement(metric="altitude_error_max_m", at_least=1.0, at_most=4.0)
    assert (margin(both, 6.0), margin(both, 0.5)) == (-2.0, -0.5)


@pytest.mark.parametrize("key", ["settles_by_s", "never_for_longer_than_s"])
def test_the_margin_of_a_time_is_a_time(key: str) -> None:
    timed = Requirement.model_validate({"signal": "altitude_m", "within": 1, "of": 300, key: 4.0})
    assert (margin(timed, 3.0), margin(timed, 5.0)) == (1.0, -1.0)
    found = missed([timed], row((False, 6.0)))
    assert found is not None and found.margin == -2.0


def row(*verdicts: tuple[bool | None, float | None]) -> dict[str, object]:
    told: dict[str, object] = {}
    for j, (passed, value) in enumerate(verdicts):
        told |= {f"requirements.{j}.passed": passed, f"requirements.{j}.value": value}
    return told


def test_missed_by_most_is_as_a_share_of_the_limit() -> None:
    found = missed([NEAR, SOME], row((False, 7.0), (False, 0.0)))
    assert found == (1, 0.0, -1.0, 1)  # by all of its limit, and not by 2 of 5
    assert missed([NEAR, SOME], row((True, 3.0), (True, 1.0))) is None
    assert missed([NEAR, SOME], row((None, None), (None, None))) is None  # not flown


def test_one_without_a_value_comes_last() -> None:
    late = missed([NEAR, SOME], row((False, math.nan), (False, 0.9)))
    assert late is not None and late.number == 1
    alone = missed([NEAR], row((False, math.nan)))
    assert alone is not None and math.isnan(alone.margin)
