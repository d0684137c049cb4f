"""Every figure: made, not blank, axes with units, every event marked in every panel and labelled once."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path

import pytest
from figure_flights import EVENTS, broken, panels
from handmade import ACTUATORS, flight_of, level_log

from testbed.flight.flight import Outcome
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.figures import draw, plot


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """The files of all figures of a flight."""
    return draw(broken(), tmp_path_factory.mktemp("drawn"))


@pytest.mark.parametrize("name", FIGURES)
def test_axes_have_units_and_lines(name: str) -> None:
    shown = panels(plot(broken(), name))
    assert shown
    for axes in shown:
        assert axes.get_ylabel().endswith("]") and "[" in axes.get_ylabel()
        assert any(len(line.get_xdata()) > 2 for line in axes.lines)
    assert shown[-1].get_xlabel() == "time [s]"
    if name in ("actuators", "effectiveness"):
        assert len(shown) == len(ACTUATORS)


@pytest.mark.parametrize("name", FIGURES)
def test_events_are_marked_everywhere_and_labelled_once(name: str) -> None:
    figure = plot(broken(), name)
    for axes in panels(figure):
        upright = {line.get_xdata()[0] for line in axes.lines if len(set(line.get_xdata())) == 1}
        assert {3.0, 3.4, 6.0} <= upright
    words = [text.get_text() for axes in figure.axes for text in axes.texts]
    for label in ("elevon was lost completely", "elevon flagged", "p_dot released", "FALSE ALARM: fan"):
        assert sum(label in word for word in words) == 1


@pytest.mark.parametrize("name", FIGURES)
def test_lines_are_told_apart_without_colour(name: str) -> None:
    for axes in panels(plot(broken(), name)):
        signals = [line for line in axes.lines if len(set(line.get_xdata())) > 2]
        looks = {(str(line._dash_pattern), line.get_linewidth()) for line in signals}
        assert len(looks) == len(signals)


@pytest.mark.parametrize(
    ("name", "label"),
    [("rates", "axis released"), ("effectiveness", "flagged failed"), ("actuators", "flagged failed")],
)
def test_released_and_flagged_times_are_shaded(name: str, label: str) -> None:
    first, *rest = panels(plot(broken(), name))
    (patch,) = (p for p in first.patches if p.get_label() == label)
    box = patch.get_path().get_extents(patch.get_patch_transform())
    assert (box.x0, box.x1) == pytest.approx((3.4, 10.0))
    assert not any(axes.patches for axes in rest)


@pytest.mark.parametrize("rows", [1, 2, 500], ids=str)
def test_flights_that_ended_early_are_drawn(rows: int, tmp_path: Path) -> None:
    log = {name: column[:rows].copy() for name, column in level_log().items()}
    log["altitude_m"][-1] = math.nan
    log["pitch_deg"][-1] = 1e30
    files = draw(flight_of(log, EVENTS[:1], Outcome.diverged), tmp_path)
    assert all(file.stat().st_size > 5000 for file in files)


@pytest.mark.parametrize("name", ["$\\frac{1}{$", "$", "a $x$ b", "\\alpha_{"])
def test_a_name_is_no_formula(name: str, tmp_path: Path) -> None:
    assert len(draw(flight_of(level_log(), EVENTS[:1], name=name), tmp_path)) == len(FIGURES)


def test_files_are_there_and_not_blank(drawn: list[Path]) -> None:
    from matplotlib.image import imread

    assert [file.name for file in drawn] == [f"{name}.png" for name in FIGURES]
    for file in drawn:
        ink = imread(file)[..., :3].min(axis=2) < 0.5
        assert 0.001 < ink.mean() < 0.5
        assert ink[ink.shape[0] // 2 :].any() and ink[: ink.shape[0] // 2].any()


def test_drawing_twice_gives_the_same_bytes(drawn: list[Path], tmp_path: Path) -> None:
    again = draw(broken(), tmp_path)
    assert [file.read_bytes() for file in drawn] == [file.read_bytes() for file in again]


def test_reading_side_needs_no_simulator() -> None:
    code = (
        "import sys, testbed.reporting.run_report, testbed.metrics, testbed.reporting.figures.sheet, testbed.flight.requirements;"
        "bad = {'jsbsim', 'numba', 'matplotlib.pyplot', 'testbed.plant.jsbsim', 'testbed.simulation'}"
        " & set(sys.modules);"
        "sys.exit(', '.join(bad) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", FIGURES)
def test_a_sheet_drawn_again_shows_nothing_of_what_it_showed_before(name: str, drawn: list[Path]) -> None:
    """All figures of a flight are drawn on one sheet; each is what a sheet of its own shows."""
    from testbed.reporting.figures.sheet import plain_text, png

    with plain_text():
        alone = png(plot(broken(), name))
    (file,) = (each for each in drawn if each.stem == name)
    assert file.read_bytes() == alone
