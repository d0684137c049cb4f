"""One problem is one line with its place, and a mistyped word is answered."""

from __future__ import annotations

import pickle

import pytest

from testbed.inputs.problems import BadInput, Problem, did_you_mean, guess, one_of, unknown


def test_a_problem_prints_on_one_line() -> None:
    problem = Problem("unknown\nkey", "f.yaml", 3, "a.b", "one of c, d", "c")
    assert str(problem) == "f.yaml:3: a.b: unknown key, expected one of c, d, did you mean c?"


@pytest.mark.parametrize(
    ("problem", "text"),
    [
        (Problem("is wrong"), "is wrong"),
        (Problem("is wrong", "f.yaml"), "f.yaml: is wrong"),
        (Problem("is wrong", path="a.0"), "a.0: is wrong"),
        (Problem("is wrong", "--set a=1", None, "a", "2"), "--set a=1: a: is wrong, expected 2"),
    ],
)
def test_what_is_not_known_is_left_out(problem: Problem, text: str) -> None:
    assert str(problem) == text


def test_bad_input_lists_all_and_crosses_processes() -> None:
    error = BadInput([Problem("one"), Problem("two", "f.yaml", 2)])
    assert str(error) == "one\nf.yaml:2: two"
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), again.problems) == (BadInput, error.problems)


@pytest.mark.parametrize(("word", "meant"), [("gama", "gamma"), ("GAMMA", "gamma"), ("zzz", ""), (3, "")])
def test_did_you_mean(word: object, meant: str) -> None:
    assert did_you_mean(word, ["gamma", "epsilon"]) == meant


def test_a_word_that_was_not_ended_is_answered_by_one_that_begins_so() -> None:
    names = ["altitude_recovery_s", "altitude_excursion_healthy_m", "altitude_excursion_failed_m"]
    assert did_you_mean("altitude_exc", names) == "altitude_excursion_failed_m"
    assert did_you_mean("alt", names) == ""


def test_a_guess_is_the_likely_one_or_all() -> None:
    assert guess("gama", ["gamma", "epsilon"]) == ("", "gamma")
    assert guess("zzz", ["gamma", "epsilon"]) == ("one of gamma, epsilon", "")
    assert guess("zzz", iter(["gamma"])) == ("one of gamma", "")


def test_very_many_are_not_listed() -> None:
    assert one_of(map(str, range(25))).startswith("one of 0, 1")
    assert one_of(map(str, range(26))) == one_of([]) == ""


def test_an_unknown_word_is_an_issue_at_its_path() -> None:
    issue = unknown(("a", 0), "unknown key", "gama", ["gamma"])
    assert issue == (("a", 0), "unknown key", "", "gamma")
