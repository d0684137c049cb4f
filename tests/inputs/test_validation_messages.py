"""Each kind of pydantic error, in the user's words and at the user's path."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import pytest
from pydantic import Field, ValidationError

from testbed.inputs.base import Positive, Settings, Text, Whole
from testbed.inputs.problems import Issue
from testbed.inputs.validation import issue_of


class Circle(Settings):
    kind: Literal["circle"] = "circle"
    radius: Positive


class Square(Settings):
    kind: Literal["square"] = "square"
    side: Positive | None = None


class Drawing(Settings):
    shapes: tuple[Annotated[Circle | Square, Field(discriminator="kind")], ...] = Field(
        default=(), max_length=3
    )
    by_name: dict[str, Annotated[Circle | Square, Field(discriminator="kind")]] = {}  # noqa: RUF012
    corner: tuple[float, float] = (0.0, 0.0)
    colour: Literal["red", "green"] = "red"
    copies: Whole = 1
    names: tuple[Text, ...] = Field(default=("x",), min_length=1)
    owner: None = None


def issue(**tree: Any) -> Issue:
    with pytest.raises(ValidationError) as caught:
        Drawing.model_validate(tree)
    (error,) = caught.value.errors()
    return issue_of(Drawing, tree, error)


CASES = [
    ({"colours": 1}, ("colours",), "unknown key", "", "colour"),
    ({"zzz": 1}, ("zzz",), "unknown key", "one of shapes, by_name, corner, colour, copies, names, owner", ""),
    ({"colour": "gren"}, ("colour",), "'gren' is not known", "", "green"),
    ({"colour": 3}, ("colour",), "3 is not known", "one of red, green", ""),
    ({"copies": 1.5}, ("copies",), "is 1.5", "a whole number", ""),
    ({"copies": -1}, ("copies",), "is -1", "greater than or equal to 0", ""),
    ({"copies": None}, ("copies",), "is empty", "a whole number", ""),
    ({"owner": "me"}, ("owner",), "is 'me'", "no such key here", ""),
    ({"corner": 3}, ("corner",), "is 3", "a list", ""),
    ({"corner": [1]}, ("corner", 1), "is missing", "", ""),
    ({"names": []}, ("names",), "has 0 entries", "at least 1", ""),
    ({"shapes": [{"kind": "square"}] * 4}, ("shapes",), "has 4 entries", "at most 3", ""),
    ({"shapes": [{"kind": "circle"}]}, ("shapes", 0, "radius"), "is missing", "", ""),
    ({"shapes": [{"kind": "square", "sid": 1}]}, ("shapes", 0, "sid"), "unknown key", "", "side"),
    ({"shapes": [{"kind": "sqare"}]}, ("shapes", 0, "kind"), "unknown kind 'sqare'", "", "square"),
    ({"shapes": [{"radius": 1}]}, ("shapes", 0, "kind"), "is missing", "", ""),
    ({"shapes": [{"knid": "square"}]}, ("shapes", 0, "kind"), "is missing", "", "it by 'knid'"),
    ({"shapes": [3]}, ("shapes", 0), "is 3", "a mapping", ""),
    (
        {"by_name": {"a": {"kind": "square", "side": -1}}},
        ("by_name", "a", "side"),
        "is -1",
        "greater than 0",
        "",
    ),
    (
        {"by_name": {"a": {"kind": "circle", "radius": "1"}}},
        ("by_name", "a", "radius"),
        "is '1'",
        "a number",
        "",
    ),
]


@pytest.mark.parametrize(("tree", "path", "what", "expected", "suggestion"), CASES)
def test_in_words(
    tree: dict[str, Any], path: tuple[Any, ...], what: str, expected: str, suggestion: str
) -> None:
    assert issue(**tree) == (path, what, expected, suggestion)
