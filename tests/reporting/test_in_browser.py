"""The flight's report in a real browser: quiet, complete, quick, and right about signs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from chromium import Window, drawn, unreadable
from html_page import write_report

from testbed.flight.folder import write_run_folder
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

pytestmark = pytest.mark.nightly
_CORNERS = [[-1, 0, 0], [-1, 1, 0], [-1.2, 1, 0], [-1.2, 0, 0]]  # of a right elevator


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of the shipped flight in turbulence: 110 s with noise on every column."""
    flight = fly(load_scenario("scenarios/mems_turbulence.yaml"))
    folder = write_run_folder(flight, tmp_path_factory.mktemp("browser") / "run")
    return write_report(folder)


@pytest.fixture
def window(browser: Any, report: Path) -> Iterator[Window]:
    with drawn(browser, report) as made:
        yield made


@pytest.fixture(scope="module")
def untouched(browser: Any, report: Path) -> Iterator[Window]:
    """A window for tests that only read."""
    with drawn(browser, report) as made:
        yield made


def value(window: Window, expression: str) -> Any:
    return window.page.evaluate(f"(() => {{ const r = window.flightReport; return {expression}; }})()")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400, 1600])
def test_quiet_and_no_wider_than_the_window(browser: Any, report: Path, width: int, scheme: str) -> None:
    with drawn(browser, report, width, scheme) as made:
        made.picture(f"report-{width}-{scheme}", full_page=True)
        assert made.page.locator("#replay canvas").count() == 1
        made.page.locator("#panels-actuators").scroll_into_view_if_needed()
        made.page.locator(
            "#panels-actuators canvas"
        ).first.wait_for()  # panels are shown when they are first seen


def test_small_enough_for_a_mail(report: Path) -> None:
    assert report.stat().st_size < 1_500_000


def test_the_columns_are_those_of_the_log(untouched: Window, report: Path) -> None:
    """Every column of the log is there, and a smooth one is right to 16 bits of its range."""
    log = np.genfromtxt(report.parent / "log.csv", delimiter=",", names=True)
    assert set(log.dtype.names) <= set(value(untouched, "Object.keys(r.columns)"))
    time, altitude = (np.array(value(untouched, f"[...r.columns.{c}]")) for c in ("time_s", "altitude_m"))
    true = np.interp(time, log["time_s"], log["altitude_m"])
    assert np.abs(altitude - true).max() <= 2e-4 * np.ptp(true)
    assert time[-1] == pytest.approx(log["time_s"][-1])
    rate = np.array(
        value(untouched, "[...r.columns.p_dot_deg_s2]")
    )  # dense, from a gyro: its extremes are kept
    true = log["p_dot_deg_s2"]
    assert (rate.min(), rate.max()) == pytest.approx((true.min(), true.max()), rel=1e-3)


def test_the_replay_plays(window: Window) -> None:
    before = value(window, "r.clock.now")
    window.page.locator("[data-do=play]").click()
    for _ in range(100):  # a busy machine draws late, and the page forbids `wait_for_function`
        window.page.wait_for_timeout(100)
        if value(window, "r.clock.now") > before:
            break
    window.page.keyboard.press("Escape")
    window.page.locator("[data-do=play]").click()
    assert value(window, "r.clock.now") > before
    assert not value(window, "r.clock.playing")


def test_a_click_on_a_phase_moves_panels_and_replay(window: Window) -> None:
    phase = value(
        window, "r.flight.phases.find(p => ['flagged', 'noticed', 'held', 'recovered'].includes(p.name))"
    )
    window.page.locator(f".phase[data-phase={phase['name']}]").first.click(position={"x": 1, "y": 5})
    assert value(window, "r.clock.now") == pytest.approx(phase["from_s"])
    first = window.page.locator(".panel").first
    first.scroll_into_view_if_needed()
    first.locator("canvas").first.wait_for()
    low, high = (
        value(window, "r.panels.made[0].plot.scales.x.min"),
        value(window, "r.panels.made[0].plot.scales.x.max"),
    )
    assert low < phase["from_s"] < high
    assert high - low < value(window, "r.clock.end")
    window.page.get_by_role("button", name="Whole flight").click()
    assert value(window, "r.clock.range[1]") == value(window, "r.clock.end")


def test_times_of_failures_in_quick_succession_do_not_stand_in_each_other(
    browser: Any, tmp_path: Path
) -> None:
    failure = {"type": "effectiveness", "actuator": "left_ruddervator"}
    failures = [{**failure, "at_s": at, "value": left} for at, left in ((0.5, 0.5), (0.51, 0.2), (0.8, 0.1))]
    settings = {"duration_s": 1, "failures": failures, "requirements": []}
    folder = write_run_folder(fly(load_scenario("scenarios/left_tail_fail.yaml", settings)), tmp_path / "run")
    with drawn(browser, write_report(folder), 390) as made:
        shown = made.page.locator(".times span:visible")
        boxes = [shown.nth(i).bounding_box() for i in range(shown.count())]
        assert len(boxes) == 4 and "0.5 s" in shown.all_inner_texts()
        assert all(a["x"] + a["width"] < b["x"] for a, b in pairwise(sorted(boxes, key=lambda b: b["x"])))


def test_any_column_can_be_drawn(window: Window) -> None:
    window.page.get_by_text("Any column of the log").click()
    window.page.locator("#any-column select").select_option("climb_rate_m_s")
    window.page.locator("#any-column .panel canvas").wait_for()
    assert "climb_rate_m_s" in window.page.locator("#any-column figcaption").inner_text()


def test_without_webgl_the_track_is_drawn_flat(browser: Any, report: Path) -> None:
    with drawn(browser, report, query="?webgl=0") as made:
        shown = "document.querySelector('#replay canvas').getContext('2d') !== null"
        assert made.page.evaluate(shown)


def rotated(window: Window, roll: float, pitch: float, heading: float, body: list[float]) -> list[float]:
    """A body vector in the picture's axes: north, up, east."""
    angles = ",".join(str(math.radians(a)) for a in (roll, pitch, heading))
    moved = f"r.geometry.fromBody({body}).applyQuaternion(r.geometry.attitude({angles}))"
    return list(value(window, f"(v => [v.x, v.y, v.z])({moved})"))


@pytest.mark.parametrize(
    ("angles", "body", "north_up_east"),
    [
        ((0, 0, 0), [1, 0, 0], (1, 0, 0)),  # level to the north: the nose points north
        ((0, 0, 0), [0, 1, 0], (0, 0, 1)),  # and the right wing east
        ((0, 0, 0), [0, 0, 1], (0, -1, 0)),  # and z down
        ((0, 0, 90), [1, 0, 0], (0, 0, 1)),  # heading 90: the nose points east
        ((0, 90, 0), [1, 0, 0], (0, 1, 0)),  # pitch 90: the nose points up
        ((90, 0, 0), [0, 1, 0], (0, -1, 0)),  # bank 90: the right wing points down
        ((0, 30, 90), [1, 0, 0], (0, 0.5, math.sqrt(0.75))),  # first heading, then pitch, then bank
        ((30, 0, 90), [0, 1, 0], (-math.sqrt(0.75), -0.5, 0)),
    ],
)
def test_signs_of_attitude(
    untouched: Window, angles: tuple[float, ...], body: list[float], north_up_east: tuple[float, ...]
) -> None:
    assert rotated(untouched, *angles, body) == pytest.approx(north_up_east, abs=1e-9)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("angle", "up"), [(10, -1), (-10, 1)])
def test_a_positive_deflection_moves_the_trailing_edge_down(
    untouched: Window, side: int, angle: float, up: int
) -> None:
    a, b, _, trailing = [[x, side * y, z] for x, y, z in _CORNERS]
    matrix = f"r.geometry.deflection({a}, {b}, {trailing}, {math.radians(angle)})"
    y = value(untouched, f"r.geometry.fromBody({trailing}).applyMatrix4({matrix}).y")
    assert y == pytest.approx(up * 0.2 * math.sin(math.radians(10)), abs=1e-9)


def test_a_positive_rudder_moves_its_trailing_edge_to_the_left(untouched: Window) -> None:
    a, b, trailing = [-1, 0, 0], [-1, 0, -1], [-1.2, 0, 0]
    matrix = f"r.geometry.deflection({a}, {b}, {trailing}, {math.radians(10)})"
    z = value(untouched, f"r.geometry.fromBody({trailing}).applyMatrix4({matrix}).z")
    assert z == pytest.approx(-0.2 * math.sin(math.radians(10)), abs=1e-9)


def test_the_camera_turns_and_zooms_and_a_view_brings_it_back(window: Window) -> None:
    eye = "r.scene.camera.position.toArray()"
    start = value(window, eye)
    box = window.page.locator("#replay canvas").bounding_box()
    window.page.mouse.move(box["x"] + 100, box["y"] + 100)
    window.page.mouse.down()
    window.page.mouse.move(box["x"] + 300, box["y"] + 150, steps=4)
    window.page.mouse.up()
    turned = value(window, eye)
    distance = "r.scene.camera.position.distanceTo(r.scene.one.craft.group.position)"
    before = value(window, distance)
    assert turned != pytest.approx(start, abs=0.5)
    window.page.mouse.wheel(0, 400)  # in a picture that was clicked into
    window.page.wait_for_timeout(200)
    assert value(window, distance) > 1.5 * before
    window.page.locator("[data-view=chase]").click()
    assert value(window, eye) == pytest.approx(start, abs=1e-6)


def test_the_wheel_scrolls_the_page_where_nobody_has_clicked(window: Window) -> None:
    box = window.page.locator("#replay canvas").bounding_box()
    window.page.mouse.move(box["x"] + 100, box["y"] + 100)
    window.page.mouse.wheel(0, 300)
    window.page.wait_for_timeout(300)
    assert window.page.evaluate("scrollY") > 0 and value(window, "r.scene.orbit.distance") == 2


def test_a_held_surface_has_a_ghost_and_a_lost_propeller_is_gone(browser: Any, tmp_path: Path) -> None:
    failures = [
        {"type": "hardover", "actuator": "left_ruddervator", "at_s": 1.0, "to": "max"},
        {"type": "prop_loss", "actuator": "left_propeller", "at_s": 1.0},
    ]
    settings = {"duration_s": 4, "failures": failures, "requirements": []}
    flight = fly(load_scenario("scenarios/left_tail_fail.yaml", settings))
    folder = write_run_folder(flight, tmp_path / "run")
    with drawn(browser, write_report(folder)) as made:
        parts = "r.scene.one.craft.parts.filter(p => p.actuator)"
        ghosts = f"Object.fromEntries({parts}.filter(p => p.ghost).map(p => [p.actuator, p.ghost.visible]))"
        blades = f"{parts}.filter(p => p.blades).map(p => [p.blades.visible, p.blades.rotation.z])"
        value(made, "r.clock.go(0.9)")
        assert value(made, ghosts) == {"left_ruddervator": False, "right_ruddervator": False}
        value(made, "r.clock.go(2.5)")
        before = value(made, blades)
        value(made, "r.clock.go(2.55)")
        after = value(made, blades)
        assert value(made, ghosts) == {"left_ruddervator": True, "right_ruddervator": False}
        (there, left), (stays, right) = before
        assert not there and stays and after[0] == [False, left] and after[1][1] != right


def test_what_was_ordered_is_drawn_as_far_as_it_was_flown(window: Window) -> None:
    ordered = "r.scene.one.trail.ordered.array"
    assert value(window, f"{ordered}[1] + r.scene.origin.y") == pytest.approx(
        value(window, "r.columns.altitude_command_m[0]"), abs=1e-3
    )
    value(window, "r.clock.go(10)")
    ten = value(window, "r.scene.one.trail.path.geometry.drawRange.count")
    value(window, "r.clock.go(20)")
    assert value(window, "r.scene.one.trail.path.geometry.drawRange.count") == pytest.approx(
        2 * ten, rel=0.02
    )
    assert value(window, "r.scene.ground.plane.position.y + r.scene.origin.y") == pytest.approx(0.0)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(browser: Any, report: Path, scheme: str) -> None:
    assert unreadable(browser, report.as_uri(), scheme) == []


def test_axe_would_find_what_cannot_be_read(browser: Any, tmp_path: Path) -> None:
    """Negative control."""
    page = tmp_path / "bad.html"
    page.write_text("<html><body data-drawn=yes><img src='data:,'><p style='color:#ddd'>pale")
    found = {each.partition(":")[0] for each in unreadable(browser, page.as_uri(), "light")}
    assert {"image-alt", "color-contrast", "html-has-lang"} <= found
