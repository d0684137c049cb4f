"""The tables of a benchmark: first where the reference loses, each draw with the command that flies it again."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest
from html_page import Page
from suite_files import flown, tree, written

from testbed.cli.commands import parser
from testbed.study_reports.benchmark import again, markdown, write_benchmark_page
from testbed.study_reports.search.words import _flown_again
from testbed.study_reports.sweep.flight_page import only


@pytest.fixture
def summary(flown_suite: Path) -> dict:
    """Of four draws that two controllers flew, with draws that only the second is said to have held."""
    return json.loads((flown_suite / "summary.json").read_text())


def lost(draw: int) -> dict:
    said = dict.fromkeys(
        ("failures", "course", "aircraft", "truth", "weather", "gust", "sensors", "outcome"), "x"
    )
    return {"draw": draw, "of": 2, "inside": 0.25, "held_by": ["fixed"], **said}


def test_the_first_section_is_where_the_reference_loses(summary: dict) -> None:
    storm = {"draws": 40, "held": {"default": 10, "fixed": 30, "best of all": 31}}
    by = summary["by"] | {"weather": {"storm": storm}}
    summary = summary | {"lost": {"default": [lost(3), lost(1)], "fixed": []}, "by": by}
    lines = markdown(summary)
    assert (
        lines[0].startswith("Of 4 draws `default` holds ") and "The best other, `fixed`, holds " in lines[0]
    )
    assert lines[2] == "## Where `default` loses"
    assert "| storm | 40 | 0.250 | 0.750 | `fixed` |" in lines
    said = next(
        line
        for line in lines
        if line.startswith("It does not hold 2 of 4 draws that another, told nothing, holds.")
    )
    assert "--seed 5 --only DRAW --controller default` flies one again" in said
    assert "| 3 | x | x, x | x | 0.25 | 1 of 1 |" in lines


def test_where_all_are_told_the_truth_none_holds_more(summary: dict) -> None:
    storm = {"draws": 40, "held": {"default": 10, "fixed": 30, "best of all": 31}}
    told = summary | {"told": ["default", "fixed"], "by": summary["by"] | {"weather": {"storm": storm}}}
    assert not any("| storm | 40 | 0.250 |" in line for line in markdown(told))


def test_every_controller_has_its_line_in_the_order_flown(summary: dict) -> None:
    lines = markdown(summary)
    total = lines[lines.index("## All") :]
    names = [line.split(" | ")[0] for line in total[4:7]]
    assert names == ["| `default`", "| `fixed`", "| best of all"]


def test_of_one_controller_alone_nothing_is_said_of_others(tmp_path: Path) -> None:
    out = flown(written(tmp_path, tree()), tmp_path / "out", draws=1, controllers=["default"])
    lines = markdown(json.loads((out / "summary.json").read_text()))
    assert lines[0].startswith("Of 1 draw `default` holds ")
    text = "\n".join(lines)
    assert not any(word in text for word in ("best", "loses", "minus", "other"))


def test_the_command_to_fly_again_is_one(summary: dict) -> None:
    mine = summary | {"given": summary["given"] | {"mine": "mine.py:Mine", "less": "less={type: pid}"}}
    assert again(mine, 3, "less").endswith("--controller 'less={type: pid}'")
    mine["given"]["mine"] = "mine=mine.py:Mine"
    words = shlex.split(again(mine, 3, "mine"))
    options = parser().parse_args(words[1:])
    assert (options.only, options.seed, options.controller) == (3, 5, ["mine=mine.py:Mine"])
    assert options.suite == summary["file"]


def test_parts_that_are_switched_off_stand_apart_from_the_rivals(tmp_path: Path) -> None:
    less = "blind={type: adaptive_inversion, ablate: [monitor]}"
    out = flown(written(tmp_path, tree()), tmp_path / "out", draws=2, controllers=["default", "fixed", less])
    summary = json.loads((out / "summary.json").read_text())
    assert (summary["ablated"], list(summary["halves"][0])) == (["blind"], ["default", "fixed"])
    lines = markdown(summary)
    parts = lines.index("## What the parts of `default` bring")
    assert lines[parts + 6].startswith("| `blind` | monitor | ")
    assert sum(line.startswith("| `blind` |") for line in lines) == 1, "it is no rival"


@pytest.mark.parametrize(
    "name", ["x; touch own", "$(touch own)", "`touch own`", "a b", "it's", "x\ntouch own"]
)
def test_a_name_does_not_become_a_command_of_the_shell(summary: dict, name: str) -> None:
    """Whoever copies the command gives the name to the testbed, and nothing to the shell."""
    other = summary | {"given": {name: f"{name}={name}"}, "file": name}
    options = parser().parse_args(shlex.split(again(other, 3, name))[1:])
    assert (options.suite, options.controller, options.only) == (name, [f"{name}={name}"], 3)
    assert shlex.split(only(3, name, f"{name}.yaml"))[4:] == [
        f"{name}.yaml",
        "--only",
        "3",
        "--variant",
        name,
    ]
    part = {"folder": name, "own_controller": name}
    assert shlex.split(_flown_again(part).split("`", 1)[1].rpartition("`")[0])[2:] == [
        f"{name}/scenario.yaml",
        "--controller",
        name,
    ]


def score(low: float, high: float) -> dict:
    return {"estimate": (low + high) / 2, "low": low, "high": high}


def half(held: tuple[float, float], rank: tuple[int, int]) -> dict:
    one = {"held": score(*held), "inside": score(0.1, 0.9), "rank": score(*rank)}
    return {"default": one, "fixed": one | {"held": score(0.4, 0.6)}}


def test_halves_of_the_draws_are_compared(summary: dict) -> None:
    summary = summary | {"draws": 40, "halves": [half((0.1, 0.2), (1, 2)), half((0.3, 0.4), (2, 2))]}
    said = next(line for line in markdown(summary) if line.startswith("Of those that are told nothing"))
    assert "*held* of all but `default`; *inside* of all 2; *rank* of all 2." in said


def test_halves_of_few_draws_are_not(summary: dict) -> None:
    assert "## Two halves of the draws" not in markdown(summary)


def test_the_page_has_the_tables_and_no_markup_of_strangers(summary: dict, tmp_path: Path) -> None:
    bad = "<img src=x onerror=alert(1)>"
    scores = summary["scores"] | {"fixed": summary["scores"]["fixed"] | {"without_result": {bad: 1}}}
    summary = summary | {"scores": scores}
    page = Page(write_benchmark_page(summary, tmp_path).read_text())
    assert "img" not in page.tags and bad in page.text
    rules = [line for line in markdown(summary) if line.startswith("| --- |")]
    assert page.tags.count("table") == len(rules) == 4
