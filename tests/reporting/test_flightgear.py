"""FlightGear's packets over a real UDP socket, read by pymavlink's parser of the same protocol, field by field."""

from __future__ import annotations

import math
import socket
import struct
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pymavlink.fgFDM import fgFDM
from short_flights import scenario

from testbed.aircraft.description import Aircraft
from testbed.common.signals import STATE
from testbed.inputs.problems import BadInput
from testbed.plant.identification import stored
from testbed.reporting.export.place import Origin
from testbed.reporting.flightgear import LAYOUT, RATE_HZ, Facts, Viewer, address_of, facts_of
from testbed.simulation import fly

ACTUATORS = Facts(
    servo=np.array([True, True, False]),
    limits=np.array([[-25.0, 20.0], [-25.0, 20.0], [-1.0, 8.0]]),
    turning=np.array([[0.0, 0.0, 9.0], [-40.0, -40.0, 9.0], [-18.0, 18.0, 9.0]]),
)
"""Two tails, which are ruddervators, and a propeller."""
VALUES = {
    "north": 1000.0, "east": 500.0, "altitude": 310.0, "airspeed": 18.0, "climb_rate": 1.5,
    "roll": 0.2, "pitch": -0.1, "heading": 1.3, "alpha": 0.05, "beta": -0.03,
    "p": 0.4, "q": 0.3, "r": -0.2, "p_dot": 9.0, "q_dot": 9.0, "r_dot": 9.0, "u_dot": 0.7,
}  # fmt: skip
FT = 0.3048


@pytest.fixture
def receiver() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listening:
        listening.bind(("127.0.0.1", 0))
        listening.settimeout(10.0)
        yield listening


class Clock:
    """Time that passes only while somebody sleeps."""

    now = 100.0

    def sleep(self, seconds: float) -> None:
        self.now += seconds


def viewer(receiver: socket.socket, clock: Clock) -> Viewer:
    address = address_of(f"127.0.0.1:{receiver.getsockname()[1]}")
    return Viewer(address, ACTUATORS, Origin(47.0, 8.0), lambda: clock.now, clock.sleep)


def row(**changes: float) -> np.ndarray:
    state = {**VALUES, **changes}
    return np.array([*(state[name] for name in STATE), 10.0, -5.0, 6.0, 1.0, 1.0, 1.0])


def test_the_packet_is_as_long_as_the_specification_says(receiver: socket.socket) -> None:
    viewer(receiver, Clock())(0.0, row())
    data = receiver.recv(1000)
    assert len(data) == LAYOUT.size == 408
    assert data[:8] == struct.pack(">II", 24, 0)


def test_every_field_is_that_of_the_specification(receiver: socket.socket) -> None:
    show = viewer(receiver, Clock())
    show(0.0, row(north=1000.0 - 1.7, east=500.0 - 0.2, altitude=310.0 - 0.15))
    show(0.1, row())
    receiver.recv(1000)
    read = fgFDM()
    read.parse(receiver.recv(1000))
    speed = np.array([17.0, 2.0, -1.5])  # what the positions moved by in 0.1 s
    cr, sr, cp, sp = math.cos(0.2), math.sin(0.2), math.cos(-0.1), math.sin(-0.1)
    turn = (0.3 * sr - 0.2 * cr) / cp
    expected = {
        "version": 24,
        "longitude": math.radians(8.0 + 500.0 / 76100.0), "latitude": math.radians(47.0 + 1000.0 / 111176.0),
        "altitude": 310.0, "agl": 310.0,
        "phi": 0.2, "theta": -0.1, "psi": 1.3, "alpha": 0.05, "beta": -0.03,
        "phidot": 0.4 + turn * sp, "thetadot": 0.3 * cr + 0.2 * sr, "psidot": turn,
        "vcas": 18.0 / 0.514444, "climb_rate": 1.5 / FT,
        "v_north": speed[0] / FT, "v_east": speed[1] / FT, "v_down": speed[2] / FT,
        "A_X_pilot": 0.7 / FT, "A_Y_pilot": 0.0, "A_Z_pilot": -9.80665 / FT, "stall_warning": 0.0, "slip_deg": 0.0,
        "num_engines": 1, "num_tanks": 0, "num_wheels": 0, "cur_time": 0, "warp": 0, "visibility": 30000.0,
        "elevator": 0.5 * 10.0 / 20.0 - 0.5 * 5.0 / 25.0, "elevator_trim_tab": 0.0, "left_flap": 0.0, "right_flap": 0.0,
        "left_aileron": 0.0, "right_aileron": 0.0, "rudder": -0.5 * 10.0 / 20.0 - 0.5 * 5.0 / 25.0,
        "nose_wheel": 0.0, "speedbrake": 0.0, "spoilers": 0.0,
    }  # fmt: skip
    for name, value in expected.items():
        tolerance = 2e-6 if name in ("longitude", "latitude") else 1e-3
        assert read.get(name) == pytest.approx(value, abs=1e-6, rel=tolerance), name
    assert [read.get("eng_state", i) for i in range(4)] == [2, 0, 0, 0]
    assert [read.get("rpm", i) for i in range(4)] == [pytest.approx(4500.0), 0.0, 0.0, 0.0]
    u, v, w = (read.get(f"v_wind_body_{axis}") for axis in ("north", "east", "down"))
    assert u**2 + v**2 + w**2 == pytest.approx(float(speed @ speed) / FT**2, rel=1e-5)
    ahead = speed @ [cp * math.cos(1.3), cp * math.sin(1.3), -sp]  # along the nose
    assert u == pytest.approx(ahead / FT, rel=1e-4)
    named = {*expected, "eng_state", "rpm", *(f"v_wind_body_{axis}" for axis in ("north", "east", "down"))}
    for name in (
        set(read.mapping.vars) - named
    ):  # engines' temperatures, fuel, wheels: nothing is known of them
        assert all(read.get(name, i) == 0 for i in range(read.mapping.vars[name].arraylength)), name


def test_each_surface_is_shown_by_what_it_turns(vtail: Aircraft, receiver: socket.socket) -> None:
    """Both tails up by half their travel: half an elevator up, no rudder. Left down and right up: nose to the left."""
    facts = facts_of(vtail.actuators, stored(vtail))
    show = Viewer(address_of(f"127.0.0.1:{receiver.getsockname()[1]}"), facts, Origin(0.0, 0.0))
    stop = vtail.actuators["left_ruddervator"].limits[1]
    wanted = {(-0.5, -0.5): (-0.5, 0.0, 0.0), (1.0, -1.0): (0.0, -1.0, 1.0)}
    for i, ((left, right), (elevator, rudder, aileron)) in enumerate(wanted.items()):
        state = row()[: len(STATE)]
        show(0.1 * i, np.array([*state, left * stop, right * stop, 3.0, 3.0]))
        read = fgFDM()
        read.parse(receiver.recv(1000))
        assert read.get("elevator") == pytest.approx(elevator, abs=1e-6)
        assert read.get("rudder") == pytest.approx(rudder, abs=1e-6)
        assert read.get("left_aileron") == pytest.approx(aileron, abs=1e-6) == -read.get("right_aileron")


def test_packets_come_in_real_time(receiver: socket.socket) -> None:
    clock = Clock()
    show = viewer(receiver, clock)
    for step in range(401):
        show(step / 200.0, row())
    assert clock.now == pytest.approx(102.0, abs=1.0 / RATE_HZ), "two seconds of flight take two seconds"
    receiver.setblocking(False)
    count = 0
    with pytest.raises(BlockingIOError):
        while receiver.recv(1000):
            count += 1
    assert 2.0 * 50.0 <= count <= 2.0 * RATE_HZ + 1


def test_a_watched_flight_is_the_same_flight(receiver: socket.socket, tmp_path: Path) -> None:
    flown = scenario(tmp_path, "pid", 1.0)
    watched = fly(flown, watch=viewer(receiver, Clock()))
    assert watched.data.tobytes() == fly(flown).data.tobytes()
    read = fgFDM()
    read.parse(receiver.recv(1000))
    assert read.get("psi", units="degrees") == pytest.approx(90.0, abs=1e-3)
    assert read.get("altitude", units="meters") == pytest.approx(watched.log["altitude_m"][0])
    assert read.get("longitude", units="degrees") == pytest.approx(8.0)


def test_a_viewer_that_has_gone_costs_nothing() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as gone:
        gone.bind(("127.0.0.1", 0))
        port = gone.getsockname()[1]
    show = Viewer(("127.0.0.1", port), ACTUATORS, Origin(0.0, 0.0), lambda: 0.0, lambda _: None)
    for step in range(20):
        show(step / 10.0, row())


@pytest.mark.parametrize("text", ["", "localhost", ":5500", "localhost:", "localhost:x", "localhost:70000"])
def test_what_is_no_address_is_refused(text: str) -> None:
    with pytest.raises(BadInput, match="expected HOST:PORT"):
        address_of(text)


def test_an_unknown_host_is_refused() -> None:
    with pytest.raises(BadInput, match="cannot find nowhere"):
        address_of("nowhere.invalid:5500")
