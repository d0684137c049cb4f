"""Numbers are numbers, unknown keys are refused, and what is read does not change."""

from __future__ import annotations

from typing import Any

import pytest
from pydantic import TypeAdapter, ValidationError, field_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, Whole, refuse


class Example(Settings):
    number: Number = 1.0
    positive: Positive = 1.0
    not_negative: NonNegative = 0.0
    whole: Whole = 0
    text: Text = "x"

    @field_validator("text")
    @classmethod
    def _no_y(cls, text: str) -> str:
        if text == "y":
            raise refuse("is y", "x", "x")
        if text == "z":
            raise refuse("is z")
        return text


@pytest.mark.parametrize(
    ("field", "value"),
    [("number", -3), ("number", 1.5), ("positive", 1e-300), ("not_negative", 0), ("whole", 7)],
)
def test_accepted(field: str, value: Any) -> None:
    assert getattr(Example.model_validate({field: value}), field) == value


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("number", "1"),
        ("number", True),
        ("number", None),
        ("number", float("nan")),
        ("number", float("inf")),
        ("positive", 0),
        ("positive", -1),
        ("not_negative", -1e-9),
        ("whole", 1.0),
        ("whole", -1),
        ("whole", True),
        ("text", ""),
        ("text", 1),
        ("nunber", 1),
    ],
)
def test_refused(field: str, value: Any) -> None:
    with pytest.raises(ValidationError) as caught:
        Example.model_validate({field: value})
    assert [error["loc"] for error in caught.value.errors()] == [(field,)]


def test_frozen() -> None:
    with pytest.raises(ValidationError, match="frozen"):
        Example().number = 2.0  # type: ignore[misc]


def test_the_three_parts_of_a_refusal_arrive() -> None:
    with pytest.raises(ValidationError) as caught:
        Example(text="y")
    (error,) = caught.value.errors()
    assert (error["type"], error["msg"]) == ("refused", "is y, expected x")
    assert error["ctx"] == {"what": "is y", "expected": "x", "suggestion": "x"}
    with pytest.raises(ValidationError) as caught:
        Example(text="z")
    assert caught.value.errors()[0]["msg"] == "is z"


@pytest.mark.parametrize("text", ["x\nPASSED: 9 of 9 requirements met", "\n", "x\n"])
def test_a_name_of_several_lines_is_refused(text: str) -> None:
    """It could stand on the terminal as a verdict of ours; all other control characters are shown as escapes."""
    with pytest.raises(ValueError, match="has a line break"):
        TypeAdapter(Text).validate_python(text)
    assert TypeAdapter(Text).validate_python("x\u2028\x1b[2K") == "x\u2028\x1b[2K"
