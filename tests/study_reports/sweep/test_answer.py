"""The answer of a sweep in sentences, against hand-made summaries."""

from __future__ import annotations

from typing import Any

import pytest

from testbed.common.statistics import paired, proportion
from testbed.study_reports.sweep.answer import answer


def variant(label: str, passed: int, n: int = 60, **more: Any) -> dict[str, Any]:
    known = {"label": label, "all_requirements": proportion(passed, n).plain, "outcomes": {"completed": n}}
    missed = {"name": "heading held", **proportion(passed, n).plain}
    return known | {"requirements": [missed], "sensitivity": {"passed": {"reason": "nothing varies"}}} | more


def summary(
    *variants: dict[str, Any], pairs: list[dict[str, Any]] | None = None, **more: Any
) -> dict[str, Any]:
    return {"variants": list(variants), "pairs": pairs or [], "probabilistic": True, **more}


def compared(better: int, worse: int, first: str, second: str, n: int = 60) -> dict[str, Any]:
    one = [True] * better + [False] * worse + [True] * (n - better - worse)
    other = [False] * better + [True] * worse + [True] * (n - better - worse)
    return {"first": first, "second": second, "n": n, **paired(one, other).plain}


def test_without_requirements_it_says_how_often_it_flew_to_the_end() -> None:
    told = answer(summary(variant("fixed", 58, requirements=[])))
    assert told[0] == "fixed flies to the end in 58 of 60 flights (89 to 99 %); nothing more is asked of it."


def test_the_best_is_named_first_with_its_interval_and_its_pairs() -> None:
    told = answer(
        summary(variant("fixed", 42), variant("adaptive", 58), pairs=[compared(0, 16, "fixed", "adaptive")])
    )
    assert told[0] == "adaptive meets all requirements in 58 of 60 flights (89 to 99 %)."
    assert (
        told[1]
        == "Compared with fixed (42 of 60 flights, 57 to 80 %): better in 16 paired runs, worse in none."
    )
    assert (
        told[2] == "adaptive missed most often: heading held (in 2 of 60). adaptive never lost the aircraft."
    )


def test_a_difference_that_chance_may_explain_is_called_so() -> None:
    told = answer(summary(variant("a", 31), variant("b", 29), pairs=[compared(5, 3, "a", "b")]))
    assert told[1].endswith("better in 5 paired runs, worse in 3; chance may explain this (p = 0.73).")


def test_one_variant_alone_and_lost_flights() -> None:
    told = answer(summary(variant("", 50, outcomes={"completed": 55, "ground_contact": 4, "error": 1})))
    assert told[0] == "All requirements are met in 50 of 60 flights (72 to 91 %)."
    assert told[1].endswith("It lost the aircraft in 4 flights. 1 flight gave no result.")


def test_cases_have_no_interval() -> None:
    assert answer(summary(variant("", 50), probabilistic=False))[0].endswith("50 of 60 flights.")


@pytest.mark.parametrize(("indicative", "words"), [(True, " This is indicative: 60 runs."), (False, "")])
def test_what_drives_it(indicative: bool, words: str) -> None:
    index = {"pawn": 0.5, "matters": True}
    inputs = {"speed": {"pawn": 0.1, "matters": False}, "wind": index, "value": index | {"pawn": 0.6}}
    driven = variant("", 50, sensitivity={"passed": {"inputs": inputs, "indicative": indicative}})
    assert answer(summary(driven))[-1] == f"Whether it passes depends most on value, then on wind.{words}"


def test_nothing_has_finished() -> None:
    assert answer(summary(variant("", 0, 0) | {"all_requirements": {"estimate": None}})) == [
        "No flight has finished."
    ]


def test_losses_of_the_others_are_said() -> None:
    other = variant("pid", 10, outcomes={"completed": 40, "envelope_exceeded": 20})
    told = answer(summary(variant("a", 58), other, pairs=[compared(48, 0, "a", "pid")]))
    assert told[1].startswith("Compared with pid (10 of 60 flights, 9 to 28 %, 20 lost): better in 48")
