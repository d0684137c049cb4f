"""Show a flight in FlightGear while it is flown: its native FDM packets, in real time, over UDP.

A packet is the struct FGNetFDM of FlightGear's src/Network/net_fdm.hxx, version 24: 408 bytes in network byte order. Angles are
in rad, lengths in m, but speeds in ft/s and the calibrated airspeed in kt, as there. What a flight does not know is 0.

FlightGear's aircraft has an elevator, ailerons and a rudder, whatever surfaces the aircraft here has. They show how much of the
greatest pitching, rolling and yawing moment the surfaces give: an elevator down turns the nose down, a left aileron down rolls to
the right, and FlightGear's rudder is positive to the right.
"""

from __future__ import annotations

import contextlib
import math
import socket
import struct
import time
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np

from testbed.aircraft.description import AnyActuator
from testbed.aircraft.design_model import DesignModel
from testbed.common.angles import body_from_ned
from testbed.common.signals import STATE
from testbed.common.units import GRAVITY_M_S2, METRES_PER_FOOT, METRES_PER_SECOND_PER_KNOT
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.export.place import Origin, geodetic

VERSION = 24
LAYOUT = struct.Struct(
    ">I4x"  # version, padding
    "3d"  # longitude, latitude, altitude
    "6f"  # height above ground; phi, theta, psi; alpha, beta
    "11f"  # phidot, thetadot, psidot; calibrated airspeed, climb rate; velocity north, east, down; velocity body u, v, w
    "3f2f"  # pilot's acceleration x, y, z; stall warning, slip ball
    "I4I36f"  # engines; state of each; 9 quantities of 4 engines, rpm first
    "I4f"  # tanks; fuel in each
    "I3I9f"  # wheels; weight on each; 3 quantities of 3 wheels
    "Iif"  # unix time (0: FlightGear's own), warp, visibility
    "10f"  # elevator and its tab, flaps left and right, ailerons left and right, rudder, nose wheel, speed brake, spoilers
)
"""The packet: 408 bytes."""
RATE_HZ = 60.0
_RUNNING, _MOST_ENGINES = 2, 4
_RPM = 6000.0  # of a propeller at full thrust: only its picture turns
_VISIBILITY_M = 30000.0


class Facts(NamedTuple):
    """What a packet needs of n actuators."""

    servo: np.ndarray
    """[n] whether it moves a surface."""
    limits: np.ndarray
    """[n, 2] its least and greatest position."""
    turning: np.ndarray
    """[3, n] p_dot, q_dot and r_dot by half its travel."""


def facts_of(actuators: Mapping[str, AnyActuator], model: DesignModel) -> Facts:
    """What a packet needs of these actuators, in their order."""
    servo = np.array([actuator.kind == "servo" for actuator in actuators.values()])
    limits = np.array([actuator.limits for actuator in actuators.values()])
    return Facts(servo, limits, 0.5 * (limits[:, 1] - limits[:, 0]) * np.asarray(model.input_matrix[:3]))


def address_of(text: str) -> tuple[str, int]:
    """(host, port) of `HOST:PORT`; raises BadInput when it is none, or there is no such host."""
    host, colon, port = text.rpartition(":")
    if not colon or not host or not port.isascii() or not port.isdigit() or not 0 < int(port) < 65536:
        expected = "HOST:PORT, as localhost:5500"
        raise BadInput([Problem(f"is no address: {text}", "--flightgear", expected=expected)])
    try:
        found = socket.getaddrinfo(host.strip("[]"), int(port), socket.AF_INET, socket.SOCK_DGRAM)
    except OSError as error:
        raise BadInput([Problem(f"cannot find {host}: {error.strerror}", "--flightgear")]) from None
    return str(found[0][4][0]), int(found[0][4][1])


class Viewer:
    """Sends a packet RATE_HZ times a second of flight, each when its time has come on the clock.

    Call it with the time [s] and the row of truth of each control step (see `flight.columns.Recorded`).
    """

    def __init__(
        self,
        address: tuple[str, int],
        actuators: Facts,
        origin: Origin,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], object] = time.sleep,
    ) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._address, self._actuators, self._origin = address, actuators, origin
        self._clock, self._sleep = clock, sleep
        self._start: float | None = None
        self._due_s, self._before = 0.0, (0.0, np.zeros(0))

    def __call__(self, time_s: float, truth: np.ndarray) -> None:
        """Wait until it is time for this control step, and show it; does nothing while the next packet is not due."""
        if time_s < self._due_s - 1e-9:
            return
        self._due_s = max(self._due_s + 1.0 / RATE_HZ, time_s)
        if self._start is None:
            self._start = self._clock() - time_s
        if (wait := self._start + time_s - self._clock()) > 0.0:
            self._sleep(wait)
        data = packet(truth, self._velocity(time_s, truth), self._actuators, self._origin)
        with contextlib.suppress(OSError):  # a viewer that has gone must not cost the flight
            self._socket.sendto(data, self._address)

    def _velocity(self, time_s: float, truth: np.ndarray) -> np.ndarray:
        """[3] velocity north, east, down since the last packet [m/s]; at first along the nose."""
        (then, before), now = self._before, truth[:3].copy()
        self._before = (time_s, now)
        if not len(before):
            speed, heading = truth[STATE.index("airspeed")], truth[STATE.index("heading")]
            climb = truth[STATE.index("climb_rate")]
            return np.array([speed * math.cos(heading), speed * math.sin(heading), -climb])
        north, east, up = (now - before) / (time_s - then)
        return np.array([north, east, -up])


def packet(truth: np.ndarray, velocity: np.ndarray, actuators: Facts, origin: Origin) -> bytes:
    """The packet of one control step.

    Args:
        truth: [17 + 2 n] `signals.STATE` in SI and radians, then the position of each of n actuators in its unit.
        velocity: [3] over the ground, north, east, down [m/s].
        actuators: their facts, in the order of `truth`.
        origin: where the flight starts; its altitude is not used here: sea level stays sea level.
    """
    s = dict(zip(STATE, truth.tolist(), strict=False))
    low, high = actuators.limits.T
    position = truth[len(STATE) : len(STATE) + len(low)]
    # Of the travel on its side of zero.
    share = _part(position, np.where(position >= 0.0, high, -low)).clip(-1.0, 1.0)
    turning = np.where(actuators.servo, actuators.turning, 0.0)
    roll, pitch, yaw = _part(turning @ share, np.abs(turning).sum(axis=1))
    latitude, longitude = geodetic(origin, np.array([s["north"]]), np.array([s["east"]]), s["altitude"])
    feet = 1.0 / METRES_PER_FOOT
    body = body_from_ned(s["roll"], s["pitch"], s["heading"]) @ velocity
    engines = np.abs(share[~actuators.servo])[:_MOST_ENGINES]
    idle = _MOST_ENGINES - len(engines)
    return LAYOUT.pack(
        VERSION,
        *(math.radians(longitude[0]), math.radians(latitude[0]), s["altitude"]),
        *(s["altitude"], s["roll"], s["pitch"], s["heading"], s["alpha"], s["beta"]),
        *_euler_rates(s),
        *(s["airspeed"] / METRES_PER_SECOND_PER_KNOT, s["climb_rate"] * feet),
        *(velocity * feet),
        *(body * feet),
        *(s["u_dot"] * feet, 0.0, -GRAVITY_M_S2 * feet),
        *(0.0, 0.0),
        len(engines),
        *([_RUNNING] * len(engines) + [0] * idle),
        *(_RPM * engines),
        *[0.0] * (idle + 32),
        *(0, *[0.0] * 4),
        *(0, *[0] * 3, *[0.0] * 9),
        *(0, 0, _VISIBILITY_M),
        *(-pitch, 0.0, 0.0, 0.0, roll, -roll),
        *(yaw, 0.0, 0.0, 0.0),
    )


def _euler_rates(s: Mapping[str, float]) -> tuple[float, float, float]:
    """Rates of roll, pitch and heading [rad/s] from the body rates (Stevens, Lewis and Johnson, eq. 1.4-4)."""
    sine, cosine = math.sin(s["roll"]), math.cos(s["roll"])
    turn = (s["q"] * sine + s["r"] * cosine) / max(math.cos(s["pitch"]), 1e-6)
    return s["p"] + turn * math.sin(s["pitch"]), s["q"] * cosine - s["r"] * sine, turn


def _part(values: np.ndarray, greatest: np.ndarray) -> np.ndarray:
    """Values as parts of the greatest that there can be; 0 where there can be none."""
    return np.divide(values, greatest, out=np.zeros(len(values)), where=greatest > 0.0)
