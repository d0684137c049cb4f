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
    ],
)
def test_refused(given: dict[str, Any], words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Requirement.model_validate(given)
