"""The page of a flight by hand in a real browser: break, mend, order, go back, and save what flies to the same bytes."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from adopted_aircraft import adopted
from chromium import Window, unreadable
from live_server import serving

import testbed
from testbed.aircraft.description import load_aircraft

pytestmark = pytest.mark.nightly
SURFACES = {
    "vtail": "left_ruddervator",
    "vtail_aft": "left_ruddervator",
    "aerosonde": "elevator",
    "./c172p": "elevator",
}
"""Aircraft, the last one adopted from JSBSim's, with what is broken of each."""


class LiveWindow(Window):
    """A window that may ask its own server."""

    def _asked(self, request: Any) -> None:
        if not request.url.startswith("http://127.0.0.1:"):
            super()._asked(request)

    def value(self, expression: str) -> Any:
        return self.page.evaluate(f"(() => {{ const live = window.flightLive; return {expression}; }})()")

    def wait(self, met: Callable[[], bool]) -> None:
        end = time.monotonic() + 30.0
        while not met():
            assert time.monotonic() < end, self.page.locator("#status").text_content()
            time.sleep(0.05)

    def text(self, selector: str) -> str:
        return str(self.page.locator(selector).text_content())

    def row(self, actuator: str) -> str:
        return self.text(f"#actuators tr[data-actuator={actuator}]")


@contextmanager
def live(browser: Any, address: str, width: int = 1400, scheme: str = "light") -> Iterator[LiveWindow]:
    window = LiveWindow(browser, width, scheme)
    window.page.goto(address)
    try:
        window.wait(lambda: window.value("live ? live.frames : 0") > 0)
        yield window
    finally:
        window.context.close()
    assert not window.wrong


@pytest.fixture(scope="module", params=SURFACES)
def served(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[str, Path, str]]:
    folder = tmp_path_factory.mktemp("live")
    aircraft = request.param
    if aircraft.startswith("./"):
        adopted(aircraft.removeprefix("./"), folder)
    with contextlib.chdir(folder):
        initial = load_aircraft(aircraft).reference.model_dump()
    scenario = {"name": "by hand <b>&amp;", "aircraft": aircraft, "duration_s": 20, "initial": initial}
    (folder / "mine.yaml").write_text(json.dumps(scenario))
    with serving(folder, "mine.yaml") as (address, _):
        yield address, folder, SURFACES[aircraft]


def test_break_mend_order_save_and_fly_again(
    browser: Any, served: tuple[str, Path, str], tmp_path: Path
) -> None:
    address, folder, surface = served
    with live(browser, address) as window:
        page = window.page
        page.locator(f"#actuators tr[data-actuator={surface}] button").first.click()
        page.locator("#break select[name=type]").select_option("effectiveness")
        page.locator("#break input[name=value]").fill("0.4")
        page.locator("#break button", has_text="Break").click()
        window.wait(lambda: "kept 40 % of its effect" in window.row(surface))
        window.wait(lambda: "kept 40 %" in window.text("#story"))
        page.locator("#order input[name=heading_deg]").fill("20")
        page.locator("#order button").click()
        window.wait(lambda: window.value("live.past.now.heading_command_deg[1]") not in (0, 90))
        page.locator("#gust button").press("Enter")  # not by mouse: a row that grows may move it away
        page.locator(f"#actuators tr[data-actuator={surface}] button", has_text="Mend").click()
        window.wait(lambda: "kept 40 %" not in window.row(surface))
        page.locator("[data-do=save]").click()
        page.wait_for_selector("#saved pre", timeout=60_000)
        saved = folder / window.text("#saved pre").split()[-1]
        with page.expect_download() as shared:
            page.get_by_text("Share").click()
        shared.value.save_as(tmp_path / "shared.html")
    assert (tmp_path / "shared.html").read_bytes() == (saved.parent / "report.html").read_bytes()
    kept = testbed.load(saved.parent)
    assert len(kept.scenario.failures) == len(kept.scenario.atmosphere.gusts) == 1
    again = testbed.fly(saved).save(tmp_path / "again", figures=False)
    for name in ("log.csv", "summary.json", "scenario.yaml"):
        assert (again / name).read_bytes() == (saved.parent / name).read_bytes()
    moved = testbed.fly(saved, set={"failures.0.value": 0.41}).save(tmp_path / "moved", figures=False)
    assert (moved / "log.csv").read_bytes() != (saved.parent / "log.csv").read_bytes()


def test_a_sensor_is_broken_and_mended_in_turbulence(browser: Any, served: tuple[str, Path, str]) -> None:
    address, folder, _ = served
    with live(browser, address) as window:
        page = window.page
        page.locator(".choose summary").click()
        page.locator("#choose select[name=sensors]").select_option("mems")
        with page.expect_navigation():
            page.locator("#choose button").click()
        window.wait(lambda: window.value("live ? live.frames : 0") > 0)
        page.locator(".choose summary").click()
        page.locator("summary", has_text="Sensors").click()
        for kind, said in (("bias", "was off by 3 deg"), ("dropout", "read zero")):
            page.locator("#sensors tr[data-actuator=alpha] button").first.click()
            page.locator("#break select[name=type]").select_option(kind)
            page.locator("#break button", has_text="Break").click()
            window.wait(lambda said=said: said in window.text("#sensors tr[data-actuator=alpha]"))
        window.wait(lambda: "the sensor alpha was off by 3 deg, until" in window.text("#story"))
        page.locator("#turbulence button").click()
        page.locator("#sensors tr[data-actuator=alpha] button", has_text="Mend").click()
        window.wait(lambda: "works" in window.text("#sensors tr[data-actuator=alpha]"))
        window.wait(lambda: abs(window.value("live.past.now.wind_down_m_s[1]")) > 0.0)
        page.locator("[data-do=save]").click()
        page.wait_for_selector("#saved pre", timeout=60_000)
        saved = folder / window.text("#saved pre").split()[-1]
        page.locator("#choose select[name=sensors]").select_option("as given")
        with page.expect_navigation():  # the next tests have the flight as it was
            page.locator("#choose button").click()
    kept = testbed.load(saved.parent)
    assert [fault.type for fault in kept.scenario.sensors.faults] == ["bias", "dropout"]
    assert [change.w20_m_s for change in kept.scenario.atmosphere.turbulence_changes] == [5.0]
    assert testbed.fly(saved).data.tobytes() == kept.data.tobytes()


def test_go_back_pause_and_speed(browser: Any, served: tuple[str, Path, str]) -> None:
    with live(browser, served[0]) as window:
        window.page.locator("#speed").select_option("16")
        window.wait(lambda: window.value("live.past.time") > 15.0)
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.text("#status") == "paused")
        back = "const b = document.getElementById('back'); b.value = 4; b.dispatchEvent(new Event('change'));"
        window.page.evaluate(f"(() => {{ {back} }})()")
        window.wait(lambda: abs(window.value("live.past.time") - 4.0) < 0.02)
        assert window.value("live.past.view().time_s.at(-1)") <= 4.02
    with live(browser, served[0]) as window:  # that which comes while time stands still
        assert abs(window.value("live.past.time") - 4.0) < 0.02
        window.page.locator("#speed").select_option("1")
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.value("live.past.time") > 4.2)


def test_a_ghost_flies_beside_it_and_goes_back_with_it(browser: Any, served: tuple[str, Path, str]) -> None:
    with live(browser, served[0]) as window:
        window.page.locator(".choose summary").click()
        window.page.locator("#ghosts input[value=pid]").check()
        window.wait(lambda: window.value("live.scene.seen.length") == 2)
        times = "live.scene.seen.map(({craft}) => craft.columns.time_s[1])"
        window.wait(lambda: window.value(times)[0] > 2.0)
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.text("#status") == "paused")
        back = "const b = document.getElementById('back'); b.value = 1; b.dispatchEvent(new Event('change'));"
        window.page.evaluate(f"(() => {{ {back} }})()")
        window.wait(lambda: max(window.value(times)) < 1.02)
        assert len(set(window.value(times))) == 1
        assert window.text(".picture .craft") == "pid"
        window.page.locator("#ghosts input[value=pid]").uncheck()
        window.wait(lambda: window.value("live.scene.seen.length") == 1)
        assert window.page.locator(".picture .craft").count() == 0
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.text("#status") == "flying")


def test_aircraft_and_controller_are_chosen_on_the_page(browser: Any, tmp_path: Path) -> None:
    with serving(tmp_path) as (address, _), live(browser, address) as window:
        window.page.locator(".choose summary").click()
        window.page.locator("#choose select[name=flight]").select_option("aerosonde")
        window.page.locator("#choose select[name=controller]").select_option("pid")
        with window.page.expect_navigation():
            window.page.locator("#choose button").click()
        window.wait(lambda: window.value("live ? live.frames : 0") > 0)
        assert window.text("h1") == "aerosonde by hand, live" and "pid" in window.text(".chips")
        assert window.value("live.flies")
        window.page.locator("#actuators tr[data-actuator=elevator] button").first.click()
        assert window.text("#break strong") == "Break the elevator"


def test_a_click_in_the_picture_opens_what_it_hits(browser: Any, served: tuple[str, Path, str]) -> None:
    with live(browser, served[0]) as window:
        window.wait(lambda: window.value("live.scene.seen[0].times.length") > 2)
        window.page.locator("[data-do=pause]").click()  # so that what was found stays where it is
        window.wait(lambda: window.text("#status") == "paused")
        behind_m = "live.scene.place(live.past.now, 1).distanceTo(live.scene.seen[0].craft.group.position)"
        window.wait(lambda: window.value(behind_m) < 1e-3)
        find = """(() => { const {scene} = live, found = {};
            for (let x = 0; x < scene.canvas.clientWidth; x += 3) for (let y = 0; y < scene.canvas.clientHeight; y += 3) {
                const name = scene.at(x, y); if (name) (found[name] ??= []).push([x, y]); }
            return found; })()"""
        found = window.value(find)
        assert served[2] in found
        for name, points in found.items():
            x, y = points[len(points) // 2]
            window.page.locator(".picture canvas").click(position={"x": x, "y": y})
            assert window.text("#break strong") == f"Break the {name.replace('_', ' ')}"
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.text("#status") == "flying")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
def test_quiet_and_no_wider_than_the_window(
    browser: Any, served: tuple[str, Path, str], width: int, scheme: str
) -> None:
    with live(browser, served[0], width, scheme) as window:
        window.page.locator("#actuators button").first.click()
        window.picture(f"live-{served[2]}-{width}-{scheme}", full_page=True)
        wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        assert window.page.evaluate(wide) <= 0
        assert window.page.locator("h1 b").count() == 0  # a name is text


def test_a_page_whose_server_is_killed_says_so(browser: Any, tmp_path: Path) -> None:
    with serving(tmp_path) as (address, process), live(browser, address) as window:
        process.kill()
        window.wait(lambda: "server has gone" in window.text("#status"))
        assert window.page.locator("[data-do=save]").is_disabled()


PAD = """() => { window.pad = {connected: true, axes: [0, 0, 0, 0], buttons: [{pressed: false}]};
    navigator.getGamepads = () => [null, window.pad]; }"""


def test_a_gamepad_turns_climbs_and_pauses(browser: Any, served: tuple[str, Path, str]) -> None:
    """A fake of the hardware alone, by the Gamepad API: axes from -1, up and left, to 1."""
    with live(browser, served[0]) as window:
        ordered = "[live.past.now.heading_command_deg[1], live.past.now.altitude_command_m[1]]"
        heading, height = window.value(ordered)
        window.page.evaluate(PAD)
        window.page.evaluate("window.pad.axes = [1, -1, 0, 0]")
        window.wait(lambda: window.value(ordered)[1] > height + 1.0)
        window.page.evaluate("window.pad.axes = [0, 0, 0, 0]")
        assert 0.0 < (window.value(ordered)[0] - heading) % 360.0 < 180.0
        window.page.evaluate("window.pad.buttons[0].pressed = true")
        window.wait(lambda: window.text("#status") == "paused")
        window.page.evaluate("window.pad.buttons[0].pressed = false")
        window.page.locator("[data-do=pause]").click()
        window.wait(lambda: window.text("#status") == "flying")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(browser: Any, served: tuple[str, Path, str], scheme: str) -> None:
    assert unreadable(browser, served[0], scheme) == []
