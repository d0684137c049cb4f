"""The server without a browser: who may connect, what it answers, and that nothing that comes to it stops the flight."""

from __future__ import annotations

import contextlib
import http.client
import json
import os
import signal
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from live_server import Page, serving
from websockets.exceptions import ConnectionClosed, InvalidStatus

import testbed
from testbed.cli.commands import main
from testbed.live.server import listening

SCENARIO = ("left_tail_fail.yaml", "--set", "failures=[]")
Server = tuple[str, Path, "subprocess.Popen[str]"]


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    folder = tmp_path_factory.mktemp("live")
    with serving(folder, *SCENARIO) as (address, process):
        yield address, folder, process


@pytest.fixture
def page(server: Server) -> Iterator[Page]:
    """The page that flies, at the beginning of the flight."""
    made = Page(server[0])
    made.until("role", flies=True)
    assert made.ask("restart")["note"] == "done"
    assert made.ask("pause", on=False)["note"] == "done"
    yield made
    made.close()


def got(address: str, path: str, **headers: str) -> http.client.HTTPResponse:
    connection = http.client.HTTPConnection(urlsplit(address).netloc, timeout=10)
    connection.request("GET", path, headers=headers)
    return connection.getresponse()


def test_the_page_is_for_those_who_know_the_token(server: Server) -> None:
    address = server[0]
    at = urlsplit(address)
    assert got(address, "/").status == 403
    assert got(address, f"/report.html?{at.query}").status == 404  # nothing has been saved
    assert got(address, f"/?token={'x' * 32}").status == 403
    assert got(address, f"/elsewhere?{at.query}").status == 404
    assert got(address, f"/?{at.query}", Host="example.org").status == 421
    assert got(address, "//[").status == 400
    answer = got(address, f"/?{at.query}")
    text = answer.read().decode()
    assert answer.status == 200 and "text/html" in answer.headers["Content-Type"]
    assert f"connect-src ws://{at.netloc}" in text and "script-src &#x27;sha256-" in text
    assert at.query.removeprefix("token=") not in text


@pytest.mark.parametrize("origin", ["http://example.org", "null", "http://127.0.0.1:1"])
def test_pages_from_elsewhere_are_refused(server: Server, origin: str) -> None:
    with pytest.raises(InvalidStatus):
        Page(server[0], origin)


def test_no_token_no_flight(server: Server) -> None:
    with pytest.raises(InvalidStatus):
        Page(server[0].partition("?")[0])


def test_it_flies_is_broken_saved_and_flown_again_to_the_same_bytes(
    server: Server, page: Page, tmp_path: Path
) -> None:
    failure = {"type": "effectiveness", "actuator": "right_ruddervator", "value": 0.3}
    assert page.ask("break", failure=failure)["note"] == "done"
    broken = page.until("state", broken={"right_ruddervator": ["kept 30 % of its effect"]})
    assert broken["ended"] == ""
    assert page.ask("speed", times=4.0)["note"] == "done"
    assert page.ask("order", command={"altitude_m": 305.0})["note"] == "done"
    assert page.ask("blow", air={"wind_m_s": [3.0, 0.0, 0.0]})["note"] == "done"
    assert page.ask("mend", actuator="right_ruddervator")["note"] == "done"
    page.until("state", broken={})
    assert page.ask("save")["note"] == "done"
    saved = page.until("saved")
    folder = server[1] / saved["folder"]
    assert saved["command"] == f"testbed run {saved['folder']}/scenario.yaml"
    report = got(server[0], f"/report.html?{urlsplit(server[0]).query}")
    assert report.status == 200 and "attachment" in report.headers["Content-Disposition"]
    assert report.read() == (folder / "report.html").read_bytes()
    assert got(server[0], "/report.html").status == 403
    again = testbed.fly(folder / "scenario.yaml").save(tmp_path / "again", figures=False)
    for name in ("log.csv", "summary.json", "scenario.yaml"):
        assert (again / name).read_bytes() == (folder / name).read_bytes()
    later = {"failures.0.at_s": testbed.load(folder).scenario.failures[0].at_s + 0.005}
    moved = testbed.fly(folder / "scenario.yaml", set=later).save(tmp_path / "moved", figures=False)
    assert (moved / "log.csv").read_bytes() != (folder / "log.csv").read_bytes()


def test_ghosts_fly_beside_it_and_another_flight_is_chosen(page: Page) -> None:
    assert page.ask("ghosts", controllers=["pid", "indi"])["note"] == "done"
    page.until("state", ghosts={"pid": "", "indi": ""})
    assert "did you mean pid?" in page.ask("ghosts", controllers=["pidd"])["why"]
    assert page.ask("ghosts", controllers=["pid", "indi", "mrac", "rls_inversion"])["note"] == "refused"
    assert "no flight" in page.ask("choose", flight="../secret.yaml", controller="pid")["why"]
    assert page.ask("choose", flight="aerosonde", controller="pid")["note"] == "done"
    page.until("other")
    page.until("state", ghosts={}, broken={})
    wanted = {"flight": "left_tail_fail.yaml", "controller": "as given"}
    assert "did you mean mems?" in page.ask("choose", **wanted, sensors="mem")["why"]
    assert page.ask("choose", **wanted)["note"] == "done"
    page.until("other")
    assert "are ideal" in page.ask("break", failure={"type": "stuck", "sensor": "alpha"})["why"]
    assert page.ask("choose", **wanted, sensors="mems")["note"] == "done"
    page.until("other")
    assert page.ask("break", failure={"type": "bias", "sensor": "gyro_q", "value_deg_s": 5})["note"] == "done"
    page.until("state", broken={"gyro": ["was off by 5 deg/s"]})
    assert page.ask("blow", air={"w20_m_s": 4})["note"] == "done"
    assert page.ask("mend", actuator="gyro")["note"] == "done"
    page.until("state", broken={})


def test_what_does_not_fit_is_refused_with_a_suggestion(page: Page) -> None:
    answer = page.ask("break", failure={"type": "stuk", "actuator": "left_ruddervator"})
    assert answer["note"] == "refused" and "did you mean stuck?" in answer["why"]
    assert page.ask("mend", actuator="left_ruddervator")["note"] == "refused"
    assert page.ask("order", command={})["note"] == "refused"
    assert page.ask("rewind", time_s=1e308)["note"] == "done"  # to where it is


def test_garbage_stops_nothing(page: Page) -> None:
    for garbage in ("", "{", "[" * 1000, b"\x00\xff", json.dumps({"id": 1, "do": "exec"})):
        page.socket.send(garbage)
        page.until("refused", id=None)
    before_s = page.see()
    while page.see() < before_s + 0.2:
        page.socket.send("{}")
        page.until("refused")


def test_too_long_a_message_ends_the_connection_and_not_the_flight(server: Server, page: Page) -> None:
    page.socket.send("x" * 100_000)
    with pytest.raises(ConnectionClosed):
        while True:
            page.hear()
    with_another = Page(server[0])
    with_another.until("role", flies=True)
    with_another.close()


def test_a_second_page_looks_on_until_the_first_has_gone(server: Server, page: Page) -> None:
    second = Page(server[0])
    second.until("role", flies=False)
    assert "looks on" in second.ask("pause", on=True)["why"]
    while second.see() == 0.0:  # it is told of the next frame
        pass
    page.socket.socket.shutdown(socket.SHUT_RDWR)  # a browser that dies
    second.until("role", flies=True)
    assert second.ask("pause", on=True)["note"] == "done"
    second.close()


def test_time_stands_still_while_nobody_looks(server: Server, page: Page) -> None:
    page.close()
    time.sleep(1.0)
    again = Page(server[0])
    assert again.see() < 0.9
    again.close()


def test_a_page_that_comes_while_it_is_paused_sees_the_flight(server: Server, page: Page) -> None:
    while not page.see():
        pass
    assert page.ask("pause", on=True)["note"] == "done"
    second = Page(server[0])
    while second.see() == 0.0:  # it is told of the next frame
        pass
    second.close()


def test_a_lost_aircraft_ends_the_flight_and_not_the_server(page: Page) -> None:
    page.ask("speed", times=16.0)
    for name in ("left_ruddervator", "right_ruddervator"):
        assert (
            page.ask("break", failure={"type": "hardover", "actuator": name, "to": "max"})["note"] == "done"
        )
    while not (ended := page.until("state")["ended"]):
        pass
    assert ended.startswith("the aircraft ")
    assert "over" in page.ask("order", command={"altitude_m": 310.0})["why"]
    assert page.ask("save")["note"] == "done"
    page.until("saved")
    assert page.ask("rewind", time_s=0.0)["note"] == "done"
    page.until("state", ended="", broken={})


def processes_of(process: subprocess.Popen[str]) -> set[int]:
    """The processes that a server has begun, and those that they have begun; a fork has the command line of its server."""
    line = Path(f"/proc/{process.pid}/cmdline").read_bytes()
    found = set()
    for each in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if (each / "cmdline").read_bytes() == line and (each / "cwd").samefile(
                f"/proc/{process.pid}/cwd"
            ):
                found.add(int(each.name))
    return found - {process.pid}


def pilot_of(process: subprocess.Popen[str]) -> int:
    """The process that flies: the child of a server. The others are its copies."""
    text = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
    return int(text.split()[0])


def soon(met: Callable[[], bool]) -> bool:
    """Whether something comes true within some seconds: copies that tell the story come and go."""
    end = time.monotonic() + 20.0
    while not met() and time.monotonic() < end:
        time.sleep(0.02)
    return met()


def alive(pid: int) -> bool:
    with contextlib.suppress(OSError):
        return bool(Path(f"/proc/{pid}/cmdline").read_bytes())
    return False


@pytest.mark.nightly
def test_going_back_wakes_a_frozen_copy_and_nothing_is_left_in_the_end(tmp_path: Path) -> None:
    """Three frozen copies, at the start, 80 and 160 s; going back wakes each; what is saved flies to the same bytes."""
    with serving(tmp_path, *SCENARIO) as (address, process):
        page = Page(address)
        page.until("role", flies=True)
        page.ask("speed", times=16.0)
        failure = {"type": "effectiveness", "actuator": "right_ruddervator", "value": 0.5}
        for until_s, act in (
            (63.0, ("break", {"failure": failure})),
            (195.0, ("order", {"command": {"altitude_m": 310.0}})),
        ):
            while page.see() < until_s:
                pass
            assert page.ask(act[0], **act[1])["note"] == "done"
        assert soon(lambda: len(processes_of(process)) >= 4)
        for time_s, frozen in ((190.0, 3), (100.0, 2), (70.0, 1)):
            before = processes_of(process)
            assert page.ask("rewind", time_s=time_s)["note"] == "done"
            page.until("state", broken={"right_ruddervator": ["kept 50 % of its effect"]})
            assert time_s - 0.01 < page.see() < time_s + 10.0
            assert soon(lambda before=before, frozen=frozen: len(processes_of(process) & before) == frozen)
        assert page.ask("speed", times=1.0)["note"] == "done"
        assert page.ask("mend", actuator="right_ruddervator")["note"] == "done"
        page.ask("save")
        folder = tmp_path / page.until("saved")["folder"]
        page.close()
        left = processes_of(process)
    assert soon(lambda: not any(map(alive, left)))
    kept = testbed.load(folder)
    assert [each.type for each in kept.scenario.failures] == ["effectiveness"]
    again = testbed.fly(folder / "scenario.yaml").save(tmp_path / "again", figures=False)
    assert (again / "log.csv").read_bytes() == (folder / "log.csv").read_bytes()


@pytest.mark.nightly
def test_a_killed_pilot_is_said(tmp_path: Path) -> None:
    with serving(tmp_path, *SCENARIO) as (address, process):
        page = Page(address)
        page.until("role", flies=True)
        os.kill(pilot_of(process), signal.SIGKILL)
        while "has ended" not in page.until("state").get("ended", ""):
            pass
        assert "has ended" in page.ask("pause", on=True)["why"]
        page.close()


@pytest.mark.nightly
def test_a_killed_server_leaves_what_was_saved(tmp_path: Path) -> None:
    with serving(tmp_path, *SCENARIO) as (address, process):
        page = Page(address)
        page.until("role", flies=True)
        page.ask("save")
        saved = page.until("saved")
        process.send_signal(signal.SIGKILL)
        with pytest.raises(ConnectionClosed):
            while True:
                page.hear()
    assert testbed.load(tmp_path / saved["folder"]).end_time_s > 0.0


@pytest.mark.parametrize(
    "by",
    [
        signal.SIGINT,
        *(pytest.param(each, marks=pytest.mark.nightly) for each in (signal.SIGTERM, signal.SIGHUP)),
    ],
)
def test_a_signal_ends_it(tmp_path: Path, by: signal.Signals) -> None:
    with serving(tmp_path, *SCENARIO) as (address, process):
        page = Page(address)
        page.until("role", flies=True)
        process.send_signal(by)
        assert process.wait(20) == 130
        page.close()


def test_a_port_that_is_taken(capsys: pytest.CaptureFixture[str]) -> None:
    with listening(0) as taken:
        port = str(taken.getsockname()[1])
        assert main(["live", "--no-browser", "--port", port, "--set", "nonsense=1"]) == 2
    said = capsys.readouterr().err
    assert f"--port: port {port} cannot be had" in said and "nonsense" in said
