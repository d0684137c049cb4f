"""A file of another kind is told apart by the keys that only one kind has."""

from __future__ import annotations

import pytest

from testbed.inputs.kinds import refuse_other
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import parsed

SCENARIO, SWEEP, SEARCH = "{aircraft: vtail}", "{vary: {}, scenario: a}", "{goal: smallest, scenario: a}"


@pytest.mark.parametrize(
    ("text", "wanted", "words"),
    [
        (SWEEP, "scenario", "f:1: is a sweep, expected a scenario; `testbed sweep` takes this file"),
        (SEARCH, "scenario", "f:1: is a search, expected a scenario; `testbed search` takes this file"),
        (SCENARIO, "sweep", "f:1: is a scenario, expected a sweep; `testbed run` takes this file"),
        (SEARCH, "sweep", "f:1: is a search, expected a sweep; `testbed search` takes this file"),
        (SCENARIO, "search", "f:1: is a scenario, expected a search; `testbed run` takes this file"),
        (SWEEP, "search", "f:1: is a sweep, expected a search; `testbed sweep` takes this file, "
                          "and so does `testbed search --goal`"),
    ],
)  # fmt: skip
def test_another_kind_is_refused_with_its_command(text: str, wanted: str, words: str) -> None:
    with pytest.raises(BadInput) as error:
        refuse_other(parsed(text, "f"), wanted)
    assert str(error.value) == words


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (SCENARIO, "scenario"),
        (SWEEP, "sweep"),
        (SEARCH, "search"),
        ("{a: 1}", "scenario"),
        ("{a: 1}", "sweep"),
        ("{aircraft: vtail, goal: 1}", "scenario"),  # whose one wrong key is refused by itself
    ],
)
def test_its_own_kind_and_what_is_none_pass(text: str, wanted: str) -> None:
    refuse_other(parsed(text, "f"), wanted)
