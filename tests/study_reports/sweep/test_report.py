"""The report of a sweep: one file that says what summary.json says, whatever of it is absent."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command_line import in_this_process
from html_page import Page
from sweep_files import fly_here, written

import testbed
from testbed.api.sweep import answer as printed
from testbed.api.sweep import finish
from testbed.cli.commands import main
from testbed.reporting.html import joined
from testbed.studies.load import load_sweep
from testbed.study_reports.sweep.answer import answer
from testbed.study_reports.sweep.report import parts, write_sweep_report


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A sweep of enough made-up flights for every section of the report."""
    folder = tmp_path_factory.mktemp("answered")
    plan = load_sweep(written(folder), ["runs=150"])
    finish(plan, fly_here(plan, folder / "out"))
    return folder / "out"


@pytest.fixture
def summary(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return found


def test_it_is_one_file_that_fetches_nothing(folder: Path) -> None:
    page = Page((folder / "report.html").read_text(encoding="utf-8"))
    assert page.tags.count("img") >= 5 and not {"link", "iframe", "object"} & set(page.tags)
    assert all(reference.startswith("data:image/png;base64,") for reference in page.references)
    for words in (
        "all requirements", "exact McNemar", "99 % stay within", "PAWN", "How many runs a claim needs",
        "share of variance", "Every flight",
    ):  # fmt: skip
        assert words in page.text


def test_the_answer_comes_first(summary: dict[str, Any], tmp_path: Path) -> None:
    text = Page(joined(parts(summary, tmp_path))).text
    share = summary["variants"][0]["all_requirements"]
    first = f"adaptive_inversion meets all requirements in {share['successes']} of {share['n']} flights ("
    assert text.index(first) < text.index("How often the requirements are met")
    assert "better in no paired run, worse in none" in text  # the made-up flights do not know of controllers
    assert "depends most on failure 1: value" in text


Place = tuple[str | int, ...]


def may_be_absent(tree: Any, place: Place = ()) -> Iterator[Place]:
    """Places of all values of a summary that are None when there is nothing to say: its real numbers, and
    the number of runs for a claim that the present share does not support."""
    if isinstance(tree, dict | list):
        for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree):
            yield from may_be_absent(value, (*place, key))
    elif isinstance(tree, float) or tree is None or "claim_with_failures_as_now" in place:
        yield place


def without(summary: dict[str, Any], place: Place) -> dict[str, Any]:
    """A summary whose value at this place is None."""
    changed = inside = copy.deepcopy(summary)
    for key in place[:-1]:
        inside = inside[key]  # type: ignore[index]
    inside[place[-1]] = None  # type: ignore[index]
    return changed


def test_any_one_value_may_be_absent(summary: dict[str, Any], tmp_path: Path) -> None:
    """Each alone: a sensitivity index may be known while its half-width is not (few resampled values differ)."""
    places = list(may_be_absent(summary))
    named = {str(place[-1]) for place in places}
    assert {"estimate", "low", "high", "difference", "p_value", "median", "largest", "0.99", "pawn", "s1",
            "s1_half_width"} <= named  # fmt: skip
    for place in places:
        changed = without(summary, place)
        page = Page(joined(parts(changed, tmp_path)))
        assert not re.search(r"\b(None|nan)\b", page.text), place
        assert answer(changed)
        assert "None" not in "".join(printed(changed)), place


def test_all_values_may_be_absent(summary: dict[str, Any], tmp_path: Path) -> None:
    for place in may_be_absent(summary):
        summary = without(summary, place)
    (tmp_path / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    page = Page(write_sweep_report(tmp_path).read_text(encoding="utf-8"))
    assert "no runs" in page.text and not re.search(r"\b(None|nan)\b", page.text)


def test_an_index_without_its_half_width_says_so(summary: dict[str, Any], tmp_path: Path) -> None:
    summary["variants"][0]["sensitivity"]["passed"]["inputs"]["failures.0.value"] |= {
        "s1": 0.25,
        "s1_half_width": None,
    }
    assert "0.25 ± unknown" in joined(parts(summary, tmp_path))


@pytest.mark.nightly
def test_it_names_commands_that_work(tmp_path: Path) -> None:
    testbed.sweep(written(tmp_path), tmp_path / "out", runs=4, jobs=1, save_logs="none", figures=False)
    write_sweep_report(tmp_path / "out")
    text = (tmp_path / "out/report.html").read_text(encoding="utf-8")
    commands = re.findall(r"<code>python -m testbed (.*?)</code>", text)
    assert commands
    result = in_this_process(tmp_path, *commands[0].split(), "--out", "again", "--no-plots", "--jobs", "1")
    assert result.returncode == 1, result.stderr
    rows = (tmp_path / "again/results.csv").read_text().splitlines()[1:]
    assert set(rows) <= set((tmp_path / "out/results.csv").read_text().splitlines())


def test_report_rebuilds_the_same_table_and_summary(folder: Path) -> None:
    names = ("results.csv", "results.parquet", "summary.json")
    before = {name: (folder / name).read_bytes() for name in names}
    for name in before:
        (folder / name).unlink()
    assert main(["report", str(folder)]) == 1  # not every flight has passed
    assert before == {name: (folder / name).read_bytes() for name in before}
