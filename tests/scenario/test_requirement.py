"""What a requirement says in words, and what makes it one."""

from __future__ import annotations

from typing import Any

import pytest
from pydantic import ValidationError

from testbed.scenario.requirement import Requirement

SIGNAL = {"signal": "altitude_m"}


@pytest.mark.parametrize(
    ("given", "limit", "title"),
    [
        ({"metric": "m", "at_most": 5}, "at most 5", "m at most 5"),
        ({"metric": "m", "at_least": 0.5}, "at least 0.5", "m at least 0.5"),
        (
            {"metric": "m", "at_least": 1, "at_most": 2},
            "at least 1 and at most 2",
            "m at least 1 and at most 2",
        ),
        ({**SIGNAL, "within": 0.5, "of": 300}, "within 0.5 of 300", "altitude_m within 0.5 of 300"),
        (
            {**SIGNAL, "within": 1, "of": "altitude_command_m", "from_s": 15, "until_s": 60},
            "within 1 of altitude_command_m",
            "altitude_m within 1 of altitude_command_m, 15 to 60 s",
        ),
        ({**SIGNAL, "at_most": 5, "from_s": 3}, "at most 5", "altitude_m at most 5, 3 to the end"),
        ({**SIGNAL, "at_most": 5, "until_s": 3}, "at most 5", "altitude_m at most 5, 0 to 3 s"),
        (
            {**SIGNAL, "at_most": 5, "until_s": 3, "eventually": True},
            "at most 5 at least once",
            "altitude_m at most 5 at least once, 0 to 3 s",
        ),
        (
            {**SIGNAL, "at_most": 5, "settles_by_s": 3},
            "at most 5 from 3 s on at the latest",
            "altitude_m at most 5 from 3 s on at the latest",
        ),
        (
            {**SIGNAL, "at_most": 5, "never_for_longer_than_s": 2},
            "at most 5, never outside for longer than 2 s",
            "altitude_m at most 5, never outside for longer than 2 s",
        ),
        ({"name": "low", **SIGNAL, "at_most": 5, "until_s": 3}, "at most 5", "low"),
    ],
)
def test_in_words(given: dict[str, Any], limit: str, title: str) -> None:
    requirement = Requirement.model_validate(given)
    assert (requirement.limit, requirement.title) == (limit, title)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"at_most": 5}, "has no subject"),
        ({"metric": "m", "signal": "s", "at_most": 5}, "has both metric and signal"),
        ({"metric": "m"}, "has no limit"),
        ({**SIGNAL, "within": 5}, "only one of within and of"),
        ({**SIGNAL, "of": 5, "at_most": 3}, "only one of within and of"),
        ({"metric": "m", "within": 1, "of": 3}, "a window or a distance of a metric"),
        ({"metric": "m", "at_most": 1, "from_s": 3}, "a window or a distance of a metric"),
        ({**SIGNAL, "at_most": 1, "from_s": 3, "until_s": 3}, "3 s is not after from_s"),
        ({**SIGNAL, "within": 1, "of": True}, "neither a number nor a signal"),
        ({**SIGNAL, "within": -1, "of": 3}, "greater than or equal to 0"),
        ({**SIGNAL, "at_least": 5, "at_most": 4}, "5 is above at_most"),
        ({"metric": "m", "at_most": 1, "eventually": True}, "a window or a distance of a metric"),
        ({**SIGNAL, "at_most": 1, "eventually": 1}, "valid boolean"),
        ({**SIGNAL, "at_most": 1, "eventually": True, "settles_by_s": 1}, "has eventually and settles_by_s"),
        ({**SIGNAL, "at_most": 1, "from_s": 1, "settles_by_s": 2}, "both from_s and settles_by_s"),
        ({**SIGNAL, "at_most": 1, "until_s": 2, "settles_by_s": 2}, "until_s 2 is not after settles_by_s"),
        (
            {**SIGNAL, "at_most": 1, "from_s": 1, "until_s": 3, "never_for_longer_than_s": 2},
            "never_for_longer_than_s 2 is no shorter than its window",
        ),
        ({**SIGNAL, "at_most": 1, "scale": 0}, "greater than 0"),
    ],
)
def test_refused(given: dict[str, Any], words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Requirement.model_validate(given)


@pytest.mark.parametrize(
    ("given", "key", "scale"),
    [
        ({"within": 5, "of": 300}, "within", 5),
        ({"within": 0, "of": 300}, "within", 1),
        ({"at_most": -30}, "at_most", 30),
        ({"at_least": 14, "at_most": 22}, "at_least", 4),
        ({"at_least": 0, "at_most": 5, "within": 5, "of": 0}, "at_most", 2.5),
        ({"at_least": 14, "at_most": 14}, "at_most", 14),
        ({"at_most": 0}, "at_most", 1),
        ({"at_most": 300, "scale": 10}, "at_most", 10),
    ],
)
def test_scale_is_the_limit_or_half_the_width_unless_given(
    given: dict[str, Any], key: str, scale: float
) -> None:
    assert Requirement.model_validate({**SIGNAL, **given}).scale_of(key) == scale
