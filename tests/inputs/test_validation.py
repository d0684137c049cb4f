"""Everything wrong with a tree at once: pydantic's, YAML's, and that of checks that need a whole, valid model."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from pydantic import Field

from testbed.inputs.base import Positive, Settings, Text
from testbed.inputs.problems import BadInput, Issue, Problem
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import parse


class Part(Settings):
    name: Text
    mass: Positive = 1.0


class Machine(Settings):
    name: Text
    limit: Positive
    parts: tuple[Part, ...] = ()
    spare: Part | None = None
    pair: tuple[Part, ...] = Field(default=(), max_length=2)


def heavy(machine: Machine) -> Iterator[Issue]:
    """A check of the whole: no part may weigh more than the limit."""
    for i, part in enumerate(machine.parts):
        if part.mass > machine.limit:
            yield Issue(("parts", i, "mass"), f"{part.mass:g} is too heavy", f"at most {machine.limit:g}")


def problems(text: str) -> list[tuple[int | None, str, str]]:
    with pytest.raises(BadInput) as caught:
        validated(Machine, parse(text, "f.yaml"), heavy, {"name": "?", "limit": 10.0})
    assert {p.file for p in caught.value.problems} == {"f.yaml"}
    return [(p.line, p.path, p.what) for p in caught.value.problems]


def test_a_valid_tree_is_the_model() -> None:
    source = parse("name: a\nlimit: 5\nparts: [{name: b, mass: 5}]\n", "f.yaml")
    tree = parse("name: a\nlimit: 5\nparts: [{name: b, mass: 5}]\n").tree
    assert validated(Machine, source, heavy).parts == (Part(name="b", mass=5.0),)
    assert source.tree == tree, "the tree is not touched"


def test_a_check_of_the_whole_runs_when_a_part_is_refused() -> None:
    """And its path is that of the file, although the entry before was taken out."""
    text = "name: a\nlimit: 5\nparts:\n  - {name: b, mass: -1}\n  - {nam: c}\n  - {name: d, mass: 7}\n"
    assert problems(text) == [
        (4, "parts.0.mass", "is -1"),
        (5, "parts.1.name", "is missing"),
        (5, "parts.1.nam", "unknown key"),
        (6, "parts.2.mass", "7 is too heavy"),
    ]


def test_a_stand_in_takes_the_place_of_a_refused_value() -> None:
    """limit is refused: its stand-in is 10, and 11 is too heavy for that as well."""
    assert problems("name: a\nlimit: 0\nparts: [{name: b, mass: 11}]\n") == [
        (2, "limit", "is 0"),
        (3, "parts.0.mass", "11 is too heavy"),
    ]


def test_a_missing_required_key() -> None:
    assert problems("parts: []\n") == [(1, "name", "is missing"), (1, "limit", "is missing")]


def test_a_later_error_that_the_removal_caused_is_not_told() -> None:
    """`spare` loses its only valid content by our own doing."""
    assert problems("name: a\nlimit: 5\nspare: {name: 3}\n") == [(3, "spare.name", "is 3")]


def test_two_problems_at_one_path_are_one() -> None:
    """YAML read text for a number, and complained; the model need not do so again."""
    source = parse("name: a\nlimit: 1e-3\n", "f.yaml")
    with pytest.raises(BadInput) as caught:
        validated(Machine, source, heavy, {"limit": 1.0})
    (problem,) = caught.value.problems
    assert (problem.path, "write 1.0e-3" in problem.what) == ("limit", True)


def test_problems_found_before_are_reported_with_a_valid_model() -> None:
    source = parse("name: a\nlimit: 5\n", "f.yaml")
    source.problems.append(Problem("is odd", "f.yaml", 1, "name"))
    with pytest.raises(BadInput, match=r"f\.yaml:1: name: is odd"):
        validated(Machine, source)


def test_they_come_in_the_order_of_the_file() -> None:
    text = "parts: [{name: '', mass: 1}]\npair: [{name: a}, {name: b}, {name: c}]\nlimit: -1\nname: 3\n"
    assert [line for line, _, _ in problems(text)] == [1, 2, 3, 4]


def test_nothing_usable_ends() -> None:
    """A tree that is no mapping at all is refused once, and checks do not run."""
    with pytest.raises(BadInput) as caught:
        validated(Machine, parse("[1, 2]", "f.yaml"), heavy)
    assert len(caught.value.problems) == 1


def test_a_file_with_thousands_of_problems_is_answered_with_the_first_hundred() -> None:
    source = parse("\n".join(f"k{i}: 1" for i in range(20_000)), "f.yaml")
    with pytest.raises(BadInput) as caught:
        validated(Machine, source)
    assert 100 <= len(caught.value.problems) < 200
