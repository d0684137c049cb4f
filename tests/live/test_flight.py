"""A flight by hand goes on, is flown again up to any time, and is saved as a scenario that flies to the same bytes."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from testbed.inputs.problems import BadInput
from testbed.live import flight as flights
from testbed.live import messages
from testbed.live.flight import LiveFlight
from testbed.live.messages import Blow, Break, Mend, Order
from testbed.scenario.load import changed, load_scenario
from testbed.sensors.settings import SENSORS
from testbed.simulation import fly

STUCK = Break(id=1, do="break", failure={"type": "stuck", "actuator": "left_ruddervator"})
MENDED = Mend(id=2, do="mend", actuator="left_ruddervator")
TURN = Order(id=3, do="order", command={"heading_deg": 120.0})
NOISY = {
    "sensors": {
        "model": "mems",
        "faults": [{"type": "noise", "sensor": "airspeed", "at_s": 1.0, "noise_m_s_rthz": 0.1}],
    },
    "atmosphere": {"turbulence_w20_m_s": 7.62},
}
GUST = Blow(id=4, do="blow", air={"magnitude_m_s": [0.0, 3.0, 0.0], "duration_s": 0.5, "hold_s": 1.0})


@pytest.fixture
def live() -> Iterator[LiveFlight]:
    scenario = load_scenario("scenarios/left_tail_fail.yaml")
    made = LiveFlight(
        changed(scenario, {"duration_s": 6.0, "failures": [], "requirements": [], "commands": []})
    )
    yield made
    made.close()


def log(live: LiveFlight) -> np.ndarray:
    return live.session.flight().data


def test_it_goes_on_and_what_is_saved_flies_to_the_same_bytes(live: LiveFlight) -> None:
    for steps, act in ((400, STUCK), (300, TURN), (500, MENDED), (200, GUST)):
        live.fly(steps)
        live.do(act)
    live.fly(2000)
    assert live.session.ended is None and live.session.time_s > 16.0  # six seconds were planned
    kept = live.session.flight()
    again = fly(kept.scenario)
    assert again.data.tobytes() == kept.data.tobytes()
    assert again.summary == kept.summary
    later = [{**each.model_dump(exclude_none=True)} for each in kept.scenario.failures]
    later[0]["at_s"] += 1.0 / live.rate_hz
    assert fly(changed(kept.scenario, {"failures": later})).data.tobytes() != kept.data.tobytes()


def test_it_is_flown_again_up_to_a_time_and_goes_on_differently(live: LiveFlight) -> None:
    live.fly(400)
    live.do(STUCK)
    live.fly(400)
    before = log(live)
    live.do(TURN)
    live.fly(800)
    live.rewind(801 / live.rate_hz)
    assert [act for _, act in live.acts] == [STUCK]  # what was done at that time is gone too
    assert log(live).tobytes() == before.tobytes()
    live.do(MENDED)
    live.fly(100)
    assert not messages.broken(live.session)


def test_an_earlier_flight_flies_again_what_was_done_since(live: LiveFlight) -> None:
    """As a frozen copy does that is woken: it knows what was done until it was frozen."""
    live.fly(400)
    live.do(STUCK)
    live.fly(200)
    live.do(GUST)
    live.fly(600)
    acts, kept = list(live.acts), log(live)
    live.rewind(500 / live.rate_hz)
    assert live.acts == acts[:1]
    live.fly_again(acts, 1201, [])
    assert live.acts == acts and log(live).tobytes() == kept.tobytes()
    assert live.can_be_copied


def test_what_is_refused_is_not_done_again(live: LiveFlight) -> None:
    with pytest.raises(BadInput, match="no failure now"):
        live.do(MENDED)
    assert not live.acts


def test_going_back_can_be_given_up(live: LiveFlight) -> None:
    live.fly(600)
    session = live.session
    live.rewind(2.0, lambda: False)
    assert live.session is session and session.time_s > 3.0


def test_a_ghost_flies_the_same_past_by_another_controller(live: LiveFlight) -> None:
    live.fly(400)
    live.do(STUCK)
    live.fly(200)
    live.accompany(["pid"])
    live.do(TURN)
    live.fly(200)
    ghost = live.ghosts["pid"]
    assert ghost.time_s == live.session.time_s
    kept = ghost.flight()
    assert kept.scenario.controller.type == "pid"
    assert len(kept.scenario.failures) == 1 and len(kept.scenario.commands) == 2
    assert fly(kept.scenario).data.tobytes() == kept.data.tobytes()
    assert kept.data.tobytes() != log(live).tobytes()
    live.rewind(3.0)
    assert live.ghosts["pid"].time_s == live.session.time_s == 3.0
    live.accompany([])
    assert not live.ghosts


def test_a_ghost_that_cannot_fly_changes_nothing(live: LiveFlight) -> None:
    live.accompany(["pid"])
    with pytest.raises(BadInput, match="pidd"):
        live.accompany(["indi", "pidd"])
    assert list(live.ghosts) == ["pid"]


def test_a_ghost_that_is_lost_does_not_hold_the_flight(live: LiveFlight) -> None:
    live.accompany(["pid"])
    ghost = live.ghosts["pid"]
    ghost.inject({"type": "hardover", "actuator": "left_ruddervator", "to": "max"})
    ghost.inject({"type": "hardover", "actuator": "right_ruddervator", "to": "max"})
    live.fly(6000)
    assert ghost.ended is not None and live.session.ended is None
    live.do(STUCK)
    live.fly(100)


def test_a_frame_has_a_row_for_each_flight(live: LiveFlight) -> None:
    live.accompany(["pid", "indi"])
    live.fly(300)
    sent = np.frombuffer(messages.frame(live.session, *live.ghosts.values()), "<f4").reshape(3, -1)
    at = messages.facts(live.session)["columns"].index("altitude_m")
    flown = [live.session, *live.ghosts.values()]
    np.testing.assert_allclose(sent[:, at], [each.truth["altitude_m"] for each in flown], rtol=1e-6)


def test_it_ends_where_memory_would(live: LiveFlight, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flights, "LONGEST_S", 10.0)
    for _ in range(5):
        live.fly(700)
    assert live.session.time_s == 10.0 and live.session.loop.steps == 10 * live.rate_hz


@pytest.mark.skipif(sys.platform != "linux", reason="rows stay in memory there")
def test_rows_that_are_put_away_are_the_same(live: LiveFlight, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flights, "_KEPT_S", 1.0)
    live.fly(1)
    noisy = changed(live.session.scenario, {"duration_s": 2.0, **NOISY})
    found = []
    for folder in (flights._FOLDER, "/nowhere"):
        old = set(files().values())  # of rows that were freed: their memory is used again
        monkeypatch.setattr(flights, "_FOLDER", folder)
        flight = LiveFlight(noisy)
        for steps, act in ((700, STUCK), (900, TURN), (700, MENDED), (1700, GUST), (500, TURN)):
            flight.fly(steps)
            flight.do(act)
        parts, rows = flight.session.parts, flight.session.loop.rows
        assert parts.sensors is not None
        long_ones = (*rows, parts.weather.wind, *parts.sensors.table)
        where = [file_of(each) not in {"", *old} for each in long_ones]
        told = messages.told(flight.session.so_far())  # before the log: what it left has to be there still
        assert told == messages.told(flight.session.flight())
        found.append((log(flight).tobytes(), where))
        flight.close()
    assert found[0][0] == found[1][0]
    assert all(found[0][1]) and not any(found[1][1])


def test_a_story_is_that_of_the_logged_rows(live: LiveFlight) -> None:
    live.fly(1)
    flight = LiveFlight(changed(live.session.scenario, {"duration_s": 2.0, "log_hz": 50}))
    for steps, act in ((301, STUCK), (702, TURN)):
        flight.fly(steps)
        flight.do(act)
    flight.fly(1203)
    session = flight.session
    assert len(session.so_far().signals["time_s"]) == len(session.flight().data) == 552
    for name, values in session.so_far().signals.items():
        assert values.tobytes() == session.flight().column(name).tobytes(), name
    assert messages.told(session.so_far()) == messages.told(session.flight())
    flight.close()


def files() -> dict[tuple[int, int], str]:
    """Files that have no name any more, by the addresses from which and up to which they are in memory."""
    lines = [
        line.split()
        for line in Path("/proc/self/maps").read_text().splitlines()
        if line.endswith("(deleted)")
    ]
    return {(int(low, 16), int(high, 16)): each[4] for each in lines for low, high in [each[0].split("-")]}


def file_of(rows: np.ndarray) -> str:
    """The file in which a row in the middle begins; "" if there is none."""
    at = rows[1000].ctypes.data
    return next((file for (low, high), file in files().items() if low <= at < high), "")


def test_numbers_are_those_of_the_log(live: LiveFlight) -> None:
    live.fly(399)
    live.do(STUCK)
    live.fly(200)
    numbers, kept = messages.numbers(live.session), live.session.flight()
    for name in kept.columns:
        assert numbers[name][0] == pytest.approx(kept.column(name)[-1], nan_ok=True), name
    assert np.isnan(numbers["left_ruddervator_response"][0])
    told = np.frombuffer(messages.frame(live.session), "<f4")
    assert len(told) == len(messages.facts(live.session)["columns"])


def test_faults_of_sensors_are_those_that_fit(live: LiveFlight) -> None:
    """Each type can be sent as it is offered; ideal sensors offer none."""
    live.fly(1)
    assert messages.facts(live.session)["sensors"] == {}
    flight = LiveFlight(changed(live.session.scenario, {"duration_s": 2.0, "sensors": "mems"}))
    offers = messages.facts(flight.session)["sensors"]
    assert offers.keys() == SENSORS.keys()
    for name, sensor in offers.items():
        for offered in sensor["failures"]:
            values = [key for key in offered["settings"] if key.startswith(("value", "rate", "noise"))]
            assert all(offered["settings"][value]["title"].endswith("]") for value in values)
            assert len(values) == (offered["type"] != "dropout") and set(offered["example"]) <= set(values)
            fault = {"type": offered["type"], "sensor": name, **offered["example"]}
            flight.do(Break(id=1, do="break", failure=fault))
            assert messages.broken(flight.session).keys() == {name}
            flight.fly(2)
            flight.do(Mend(id=2, do="mend", actuator=name))
            assert not messages.broken(flight.session)
    flight.close()


def test_failures_are_those_that_fit(live: LiveFlight) -> None:
    """Each type that a page offers can be sent as it is offered."""
    for name, actuator in messages.facts(live.session)["actuators"].items():
        for offered in actuator["failures"]:
            live.rewind(0.0)
            needed = {key for key, schema in offered["settings"].items() if "default" not in schema}
            assert needed <= set(offered["example"])
            failure = {"type": offered["type"], "actuator": name, **offered["example"]}
            live.do(Break(id=1, do="break", failure=failure))
            live.fly(2)
            assert messages.broken(live.session).keys() == {name}
