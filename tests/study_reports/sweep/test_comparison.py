"""Two sweeps compared flight by flight: what changed, what chance explains, and what cannot be compared."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from html_page import Page
from sweep_files import fly_here, written
from sweep_flights import quick

from testbed.cli.commands import main
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario
from testbed.studies.load import load_sweep
from testbed.study_reports.sweep.comparison import compared, sentences


def weaker(scenario: Scenario) -> Flight:
    """As `quick`, but passes only when more than 0.8 is left."""
    flight = quick(scenario)
    value = scenario.failures[0].value  # type: ignore[attr-defined]
    verdict = {**flight.requirements[0], "passed": value > 0.8, "margin": value - 0.8}
    return Flight(*[getattr(flight, name) for name in ("scenario", "outcome", "end_time_s", "columns", "data", "events")],
                  {**flight.metrics, "altitude_error_max_m": flight.metrics["altitude_error_max_m"] + 1.0},
                  (verdict,))  # fmt: skip


@pytest.fixture(scope="module")
def sweeps(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """`first`, `same` and `worse`, of 40 runs with two variants; `other` has other draws."""
    folder = tmp_path_factory.mktemp("sweeps")
    file = written(folder)
    for name, settings, fly in (
        ("first", ["runs=40"], "sweep_flights:quick"),
        ("same", ["runs=30"], "sweep_flights:quick"),
        ("worse", ["runs=40"], f"{__name__}:weaker"),
        ("other", ["runs=40", "seed=9"], "sweep_flights:quick"),
    ):
        fly_here(load_sweep(file, settings), folder / name, fly)
    return folder


def test_a_change_is_that_of_the_paired_flights(sweeps: Path) -> None:
    changes = compared(sweeps / "first", sweeps / "worse")
    assert [change.label for change in changes] == ["adaptive_inversion", "fixed_inversion"]
    for change in changes:
        values = change.pairs["failures.0.value_before"]
        expected = change.pairs["run"][(values > 0.5) & (values <= 0.8)]
        assert list(change.changed["run"]) == list(expected) and len(expected) > 6
        discordant = len(
            expected
        )  # all of them worse: the exact McNemar test is that of as many tosses of a coin
        assert change.passes.p_value == pytest.approx(2 * 0.5**discordant) and change.is_worse
        moved = change.metrics["altitude_error_max_m"]
        assert math.isclose(moved.estimate, 1.0) and math.isclose(moved.low, moved.high)


def test_the_same_flights_differ_in_nothing(sweeps: Path) -> None:
    changes = compared(sweeps / "first", sweeps / "same")
    lines = list(sentences(changes, sweeps / "same"))
    assert lines[0] == "adaptive_inversion: no difference in 30 paired flights"
    assert lines[1] == "  10 flights of one sweep only, not compared" and not any(c.is_worse for c in changes)


def test_other_draws_are_refused(sweeps: Path) -> None:
    with pytest.raises(BadInput, match="has other draws of seed"):
        compared(sweeps / "first", sweeps / "other")


def test_the_command_writes_a_page_and_says_worse_by_its_status(
    sweeps: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.html"
    assert main(["compare", str(sweeps / "first"), str(sweeps / "worse"), "--out", str(page)]) == 1
    out = capsys.readouterr().out
    assert "more than chance explains" in out and "completed, passed -> completed, not passed" in out
    rows = sum(len(change.changed) for change in compared(sweeps / "first", sweeps / "worse"))
    assert Page(page.read_text()).tags.count("tr") > rows
    assert main(["compare", str(sweeps / "worse"), str(sweeps / "first"), "--out", str(page)]) == 0
