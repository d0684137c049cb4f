"""The tables of a benchmark: first where the reference loses, each draw with the command that flies it again."""

from __future__ import annotations

import json
import shlex

import pytest
from suite_files import flown, tree, written

from testbed.cli.parser import parser
from testbed.study_reports.benchmark import again, page


@pytest.fixture(scope="module")
def summary(tmp_path_factory: pytest.TempPathFactory) -> dict:
    """Of four draws that two controllers flew, with draws that only the second is said to have held."""
    folder = tmp_path_factory.mktemp("page")
    out = flown(written(folder, tree()), folder / "out")
    return json.loads((out / "summary.json").read_text())


def lost(draw: int) -> dict:
    said = dict.fromkeys(
        ("failures", "course", "aircraft", "truth", "weather", "gust", "sensors", "outcome"), "x"
    )
    return {"draw": draw, "of": 2, "inside": 0.25, "held_by": ["fixed"], **said}


def test_the_first_section_is_where_the_reference_loses(summary: dict) -> None:
    summary = summary | {"lost": {"default": [lost(3), lost(1)], "fixed": []}}
    summary["by"]["weather"] = {
        "storm": {"draws": 40, "held": {"default": 10, "fixed": 30, "best of all": 31}}
    }
    lines = page(summary)
    assert lines[0] == "## Where `default` loses"
    assert "| storm | 40 | 0.250 | 0.750 | `fixed` |" in lines
    assert "It does not hold 2 of 4 draws that another holds. The longest outside:" in lines
    assert any(line.startswith("| 3 | x | x, x | x | 0.25 | fixed | `testbed benchmark ") for line in lines)


def test_every_controller_has_its_line_in_the_order_flown(summary: dict) -> None:
    lines = page(summary)
    total = lines[lines.index("## All") :]
    names = [line.split(" | ")[0] for line in total[4:7]]
    assert names == ["| `default`", "| `fixed`", "| best of all"]


def test_the_command_to_fly_again_is_one(summary: dict) -> None:
    mine = summary | {"controllers": summary["controllers"] | {"mine": "mine.py:Mine"}}
    words = shlex.split(again(mine, 3, "mine"))
    options = parser().parse_args(words[1:])
    assert (options.only, options.seed, options.controller) == (3, 5, ["mine=mine.py:Mine"])
    assert options.suite == summary["file"]
