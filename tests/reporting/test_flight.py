"""What a flight does with itself: figures, a page, a run folder, a file for another program, and what a notebook shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from figure_flights import broken

import testbed
from testbed.inputs.problems import BadInput
from testbed.reporting.figures import TABLE as FIGURES


@pytest.mark.parametrize("name", FIGURES)
def test_every_figure_can_be_asked_for_and_is_shown(name: str) -> None:
    figure = broken().plot(name)
    assert figure.axes and figure._repr_png_().startswith(b"\x89PNG")


def test_an_unknown_figure_is_refused_with_what_was_meant() -> None:
    with pytest.raises(BadInput, match="did you mean actuators"):
        broken().plot("actuator")


def test_a_saved_flight_is_a_run_folder(tmp_path: Path) -> None:
    folder = broken().save(tmp_path / "saved")
    names = {file.name for file in folder.iterdir()}
    assert names == {"scenario.yaml", "log.csv", "summary.json", "report.html", "figures"}
    with pytest.raises(BadInput, match="exists already"):
        broken().save(folder)
    assert not (broken().save(tmp_path / "plain", figures=False) / "figures").exists()


def test_a_report_is_one_file_and_is_replaced(tmp_path: Path) -> None:
    for _ in range(2):
        page = broken().report(tmp_path / "flight.html").read_text(encoding="utf-8")
    assert "<title>handmade" in page and "data:image/png" in page
    assert [file.name for file in tmp_path.iterdir()] == ["flight.html"]


def test_a_flight_is_exported(tmp_path: Path) -> None:
    assert broken().export("mat", tmp_path / "flight.mat").stat().st_size > 1000


def test_a_notebook_shows_the_story_first() -> None:
    html = broken()._repr_html_()
    assert html.index("<strong>handmade") < html.index("the elevon was lost completely")
    assert "<table>" not in html[: html.index("the elevon was lost completely")]


@pytest.mark.parametrize("given", ["file", "scenario"])
def test_settings_are_changed_by_their_paths(given: str, tmp_path: Path) -> None:
    from testbed.scenario.load import load_scenario

    file = "scenarios/left_tail_fail.yaml"
    short = {"duration_s": 0.1, "failures": [], "requirements": [], "controller": {"type": "pid"}}
    flight = testbed.fly(
        file if given == "file" else load_scenario(file), set={**short, "initial.altitude_m": 250}
    )
    assert flight.log["altitude_m"][0] == pytest.approx(250.0)
    assert flight.scenario.failures == () and flight.controller == "pid"


@pytest.mark.parametrize("given", ["file", "scenario"])
def test_a_wrong_setting_is_refused_with_what_was_meant(given: str) -> None:
    from testbed.scenario.load import load_scenario

    file = "scenarios/left_tail_fail.yaml"
    with pytest.raises(BadInput, match=r"set initial.altitude: .*did you mean altitude_m"):
        testbed.fly(file if given == "file" else load_scenario(file), set={"initial.altitude": 250})
