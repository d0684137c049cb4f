"""`--set KEY=VALUE`: what it changes, where its problems are, and which of the file's own it takes away."""

from __future__ import annotations

from typing import Any

import pytest

from testbed.inputs.overrides import apply, is_override, set_value
from testbed.inputs.problems import Problem
from testbed.inputs.yaml_source import Source, parse

TEXT = "seed: 1\ncontroller: {gamma: 4.0}\nfailures:\n  - {value: 0.2}\n  - {value: 0.0}\nempty:\n"


def after(*overrides: str, text: str = TEXT) -> Source:
    source = parse(text, "f.yaml")
    apply(source, overrides)
    return source


@pytest.mark.parametrize(
    ("override", "key", "value"),
    [
        ("seed=2", "seed", 2),
        ("seed = 2", "seed", 2),
        ("name=a = b", "name", "a = b"),
        ("seed=", "seed", None),
        ("controller.gamma=1.0e-3", "controller", {"gamma": 1e-3}),
        (
            "controller.model_error.Cm_alpha=1.2",
            "controller",
            {"gamma": 4.0, "model_error": {"Cm_alpha": 1.2}},
        ),
        ("failures.1.value=0.5", "failures", [{"value": 0.2}, {"value": 0.5}]),
        ("failures.0={value: 1}", "failures", [{"value": 1}, {"value": 0.0}]),
        ("failures=[]", "failures", []),
        ("empty.a.b=1", "empty", {"a": {"b": 1}}),
        ("new.key=[1, x]", "new", {"key": [1, "x"]}),
    ],
)
def test_a_value_is_set(override: str, key: str, value: Any) -> None:
    source = after(override)
    assert source.problems == []
    assert source.tree[key] == value
    assert {k: v for k, v in source.tree.items() if k != key} == {
        k: v for k, v in parse(TEXT).tree.items() if k != key
    }, "and nothing else is changed"


@pytest.mark.parametrize(
    ("override", "path", "what", "expected"),
    [
        ("seed", "", "is not a setting", "KEY=VALUE, KEY a dotted path"),
        ("=1", "", "is not a setting", "KEY=VALUE, KEY a dotted path"),
        ("a..b=1", "", "is not a setting", "KEY=VALUE, KEY a dotted path"),
        ("failures.2.value=1", "failures", "has no entry 2", "an index from 0 to 1"),
        ("failures.-1.value=1", "failures", "has no entry -1", "an index from 0 to 1"),
        ("failures.x=1", "failures", "has no entry x", "an index from 0 to 1"),
        ("seed.x=2", "seed", "is 1", "a mapping or a list"),
        ("seed=[1", "seed", "is not YAML: expected ',' or ']', but got '<stream end>'", ""),
        ("seed=1e-3", "seed", "1e-3 is read as text by YAML, write 1.0e-3", ""),
        ("controller={gamma: .nan}", "controller.gamma", ".nan is not a finite number", ""),
    ],
)
def test_what_cannot_be_set_is_a_problem_of_the_override(
    override: str, path: str, what: str, expected: str
) -> None:
    assert after(override).problems == [Problem(what, f"--set {override}", None, path, expected)]


def test_an_empty_list_has_no_index() -> None:
    (problem,) = after("failures=[]", "failures.0.value=1").problems
    assert problem.expected == "no index, the list is empty"


def test_later_ones_build_on_earlier_ones() -> None:
    assert after("failures=[{}]", "failures.0.value=1", "seed=3", "seed=4").tree == {
        "seed": 4, "controller": {"gamma": 4.0}, "failures": [{"value": 1}], "empty": None
    }  # fmt: skip


def test_the_place_of_a_value_is_the_override() -> None:
    source = after("controller.gamma=2", "failures=[{value: 3}]")
    assert source.place(("controller", "gamma")) == ("--set controller.gamma=2", None)
    assert source.place(("failures", 0, "value")) == ("--set failures=[{value: 3}]", None)
    assert source.place(("controller",)) == ("f.yaml", 2)
    assert source.place(("seed",)) == ("f.yaml", 1)


def test_what_came_from_an_override() -> None:
    source = after("controller.gamma=2", "new.key=1")
    assert is_override(source, ("controller", "gamma"))
    assert is_override(source, ("new",)) and is_override(source, ("new", "key"))
    assert not is_override(source, ("controller",))
    assert not is_override(source, ("nothing",))


def test_it_mends_what_was_wrong_in_the_file() -> None:
    """Only what it replaces: the other problem stays, also one whose path begins with the same letters."""
    text = "a: {b: 1e-3}\nab: 1e-3\n"
    assert [p.path for p in after(text=text).problems] == ["a.b", "ab"]
    assert [p.path for p in after("a.b=1", text=text).problems] == ["ab"]
    assert [p.path for p in after("a={}", text=text).problems] == ["ab"]


def test_set_value_without_a_command_line() -> None:
    """As a sweep does for what it draws."""
    source = parse(TEXT, "f.yaml")
    set_value(source, ["failures", "0", "value"], 0.7, "drawn")
    assert source.tree["failures"][0]["value"] == 0.7
    assert source.place(("failures", 0, "value")) == ("drawn", None)


def test_a_path_of_thousands_of_keys_is_refused_at_once() -> None:
    """A header of a cases table may be one; to follow it took minutes."""
    (problem,) = after("a." * 5000 + "b=1").problems
    assert problem.what == "is a path of 5001 keys" and len(str(problem)) < 400
