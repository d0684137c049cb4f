"""What each failure does to its actuator, in words: the predicate of a sentence."""

from __future__ import annotations

import pytest

from testbed.failures import TABLE, Failure


def said(name: str, kind: str = "servo", **fields: object) -> str:
    """The words of a failure of this type, of an actuator of this kind."""
    failure: Failure = TABLE[name].model_validate({"type": name, "at_s": 1, **fields})
    return failure.words(kind, "deg" if kind == "servo" else "of throttle")


@pytest.mark.parametrize("name", TABLE)
def test_words_of_each_example(name: str) -> None:
    for kind, fields in (TABLE[name].examples or {"servo": {"set": {"fcs/rate": 0.5}}}).items():
        words = said(name, kind, **({"actuator": "a"} if TABLE[name].examples else {}), **fields)
        assert words[0].islower() and "None" not in words and not words.endswith(".")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0.0, "was lost completely"),
        (0.05, "was lost but for 5 % of its effect"),
        (0.2, "kept 20 % of its effect"),
        (1.0, "had its full effect"),
    ],
)
def test_words_of_an_effectiveness(value: float, words: str) -> None:
    assert said("effectiveness", actuator="a", value=value) == words


@pytest.mark.parametrize(
    ("shape", "words"), [("linear", "within 3.3 s"), ("exponential", "with a time constant of 3.3 s")]
)
def test_a_time_constant_is_not_called_an_end(shape: str, words: str) -> None:
    fields = {"actuator": "a", "value": 0.05, "over_s": 3.3, "shape": shape}
    assert said("decay", "motor", **fields) == f"began to lose its effect (to 5 % {words})"


@pytest.mark.parametrize(("value", "words"), [(0.4, "followed only 40 %"), (1.5, "followed 150 %")])
def test_more_than_all_of_a_command_is_not_called_only_so_much(value: float, words: str) -> None:
    assert said("command_scale", actuator="a", value=value) == f"{words} of its commands"
