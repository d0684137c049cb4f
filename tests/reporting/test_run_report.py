"""The report: everything in one file, the verdict first, nothing left out."""

from __future__ import annotations

import re
from html import escape
from pathlib import Path

import pytest
from handmade import flight_of, injection, level_log
from html_page import Page, write_report

from testbed.cli.commands import main
from testbed.flight.flight import Outcome
from testbed.flight.folder import write_run_folder
from testbed.metrics import TABLE, measure, readings
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.figures import draw

REQUIREMENTS = [
    {"name": "altitude <kept>", "passed": True, "value": 0.5, "limit": "", "margin": 0.25, "reason": ""},
    {
        "name": "settled",
        "passed": False,
        "value": None,
        "limit": "",
        "margin": None,
        "reason": "ended before",
    },
]


def void(_: object) -> None:
    """Drop a value."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    flight = flight_of(level_log(), [injection(3.0)], requirements=REQUIREMENTS, name="tail & <fan>")
    flight = flight_of(
        level_log(),
        [injection(3.0)],
        Outcome.completed,
        REQUIREMENTS,
        measure(readings(flight)),
        "tail & <fan>",
    )
    made = write_run_folder(
        flight, tmp_path_factory.mktemp("report") / "run", lambda f: void(draw(flight, f))
    )
    write_report(made)
    return made


@pytest.fixture(scope="module")
def text(folder: Path) -> str:
    return (folder / "report.html").read_text(encoding="utf-8")


def test_self_contained(text: str) -> None:
    page = Page(text)
    assert page.fetches_and_runs_nothing()
    assert len(page.references) == len(FIGURES)
    without_data = re.sub(r"data:[^\"]+", "", text)
    assert not re.search(r"https?:|url\(|@import", without_data)


def test_says_everything(text: str) -> None:
    for requirement in ("altitude &lt;kept&gt;", "settled", "NOT MET", "ended before", "0.5"):
        assert requirement in text
    for name, metric in TABLE.items():
        assert name in text
        assert escape((metric.__doc__ or "").partition("\n")[0]) in text
    assert "elevon was lost completely" in text
    assert "python -m testbed run scenario.yaml" in text
    assert "tail &amp; &lt;fan&gt;" in text and "<fan>" not in text


def test_verdict_comes_first(text: str) -> None:
    verdict = text.index("Not passed")
    assert verdict < text.index("<img") < text.index("Requirements") < text.index("Events")
    assert "1 of 2 requirements met" in text


def test_report_command_rebuilds(folder: Path, text: str, capsys: pytest.CaptureFixture[str]) -> None:
    for file in (folder / "figures").iterdir():
        file.unlink()
    (folder / "report.html").unlink()
    assert main(["report", str(folder)]) == 1  # a requirement is not met
    assert "NOT MET  settled" in capsys.readouterr().out
    assert (folder / "report.html").read_text(encoding="utf-8") == text
    assert {file.stem for file in (folder / "figures").iterdir()} == set(FIGURES)


def test_without_figures(tmp_path: Path) -> None:
    made = write_run_folder(flight_of(level_log()), tmp_path / "run", lambda f: void(write_report(f)))
    page = Page((made / "report.html").read_text(encoding="utf-8"))
    assert "img" not in page.tags and not list(made.glob(".*"))
