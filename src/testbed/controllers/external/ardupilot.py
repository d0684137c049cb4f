"""ArduPilot in a process of its own, in lockstep over its JSON interface: it sends pulse widths, and waits for one state.

Time goes on in the autopilot only by the states that it is given, so a flight is the same on every machine. It starts in the air:
its filters settle in a warm-up that holds the trim, in which it is armed and given its first setpoints. Interface:
docs/reference/any_language.md, and https://ardupilot.org/dev/docs/sitl-with-JSON.html.
"""

from __future__ import annotations

import contextlib
import json
import math
import select
import socket
import struct
import time
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from testbed.common.units import GRAVITY_M_S2
from testbed.common.writing import write_new
from testbed.controllers.external import mavlink_frames
from testbed.controllers.external.ardupilot_parameters import Outputs, density_ratio, given, text, written
from testbed.controllers.external.process import START_S, STEP_S, Autopilot
from testbed.inputs.problems import BadInput, Problem, did_you_mean

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.controllers.user.adapter import Reference, Sensed, State

WARM_UP_S = 20.0
"""Its filters need 12 s of steady flight; the length changes the flight."""
_ASK_S, _ARM_S, _GUIDED_S, _SETPOINTS_S = 18.0, 1.0, 0.2, 0.1  # before the release
_ASKING_S, _LISTING_S, _ANSWERS_US = (
    15.0,
    10.0,
    10_000,
)  # it looks up a hundred parameters in a second, and lists more
_SETPOINT_EVERY_S = 0.1  # a heading resets an integrator of the autopilot's, so it is sent no oftener
_LATERAL_LIMIT_M_S2 = 10.0  # of a commanded turn: its own limit of the bank is what counts
_GUIDED = 15
_PACKETS = {18458: struct.Struct("<HHI16H"), 29569: struct.Struct("<HHI32H")}
_POLL_S = 0.2
_PARAMETERS = "parameters.parm"
_HOME = "45,10"  # latitude and longitude of the start [deg]; 0,0 would be replaced by its own


class ArduPilot(Autopilot):
    """Flies one flight; it repeats a packet that is not answered after one second."""

    def __init__(self, setup: Setup, path: str, parameters: str | None = None) -> None:
        super().__init__(setup, path, WARM_UP_S)
        self._count, self._line = -1, b""
        self._last_sent = dict.fromkeys(("altitude", "airspeed", "heading"), math.nan)
        mine = given(setup, parameters)
        values = {**written(setup), **mine}
        self._asks, self._asked, self._has = [*mine], 0, set[str]()
        self._outputs = Outputs(setup, values)
        write_new(self._folder / _PARAMETERS, text(values))
        self._states, self._link = _bound(), _bound()
        self._link.setblocking(False)  # it is listened to between two states
        self._link_address: tuple[str, int] | None = None
        command = [path, "--model", "JSON", "--sim-port-out", str(_port(self._states))]
        command += ["--home", f"{_HOME},0,0", "--defaults", _PARAMETERS]
        command += ["--serial0", f"udpclient:127.0.0.1:{_port(self._link)}"]
        self._start(command, (self._states, self._link))
        try:
            self._packet(START_S)
            self._states.connect(self._sender)
        except BaseException:
            self._end()
            raise

    def update(self, time_s: float, state: State, reference: Reference, sensed: Sensed) -> np.ndarray:
        """The commands that its pulse widths stand for."""
        self._time_s = time_s
        if self._frames == 0:
            self._warm_up(reference, sensed)
        elif round(time_s / self._dt) % max(round(_SETPOINT_EVERY_S / self._dt), 1) == 0:
            self._set(reference)
        return self._outputs.commands(self._exchange(_flying(sensed)))

    def close(self) -> None:
        """End the autopilot: a signal, which it heeds when it has a state; its log stays in the folder."""
        if self._end.alive:
            self._tell_to_end()
            with contextlib.suppress(OSError):
                self._states.send(self._line)
            self._end()
            for log in self._folder.glob("logs/*.BIN"):
                log.rename(self._folder / log.name)

    def _warm_up(self, reference: Reference, sensed: Sensed) -> None:
        """Hold the trim, and come up to the first position at the first velocity."""
        self._to_equivalent = math.sqrt(density_ratio(sensed.pressure, sensed.temperature))
        steps = round(WARM_UP_S / self._dt)
        arm, guided, setpoints = (
            steps - round(each / self._dt) for each in (_ARM_S, _GUIDED_S, _SETPOINTS_S)
        )
        for step in range(steps):
            self._time_s = (step - steps) * self._dt
            if step < arm:
                self._ask()
            if step == arm:
                self._refuse_unknown(sensed)
                self._command(mavlink_frames.ARM, 1, mavlink_frames.FORCE)
            if step == guided:
                self._command(mavlink_frames.SET_MODE, 1, _GUIDED)
            if step == setpoints:
                self._set(reference)
            self._exchange(_holding(sensed, self._pitch, self._time_s))
        self._time_s = 0.0

    def _ask(self) -> None:
        """Ask for the next of the parameters that the user gave: it ignores one that it does not have in silence."""
        due = math.ceil(len(self._asks) * min((self._time_s + _ASK_S) / _ASKING_S, 1.0))
        for name in self._asks[self._asked : max(due, 0)]:
            if not self._asked:
                self._command(mavlink_frames.SET_INTERVAL, mavlink_frames.PARAM_VALUE, _ANSWERS_US)
            self._send(mavlink_frames.parameter_request(self._sent, name))
            self._asked += 1
        if self._asked:
            self._has.update(self._named())

    def _refuse_unknown(self, sensed: Sensed) -> None:
        """Raise BadInput if it has not answered for a parameter; it is asked for all that it has, to say which was meant."""
        if not (unknown := [name for name in self._asks if name not in self._has]):
            return
        self._send(mavlink_frames.parameter_list(self._sent))
        for _ in range(round(_LISTING_S / self._dt)):
            self._exchange(_holding(sensed, self._pitch, self._time_s))
            self._has.update(self._named())
        raise BadInput(
            Problem(f"it has no parameter {name}", self._name, suggestion=did_you_mean(name, self._has))
            for name in unknown
        )

    def _named(self) -> Iterator[str]:
        """The parameters whose values it has sent since."""
        with contextlib.suppress(OSError):  # there is no more
            while data := self._link.recv(1 << 16):
                with contextlib.suppress(ValueError):  # nothing else that it says counts
                    for number, payload, _ in mavlink_frames.frames(data):
                        if number == mavlink_frames.PARAM_VALUE:
                            yield mavlink_frames.parameter_name(payload)

    def _command(self, command: int, *parameters: float) -> None:
        self._send(mavlink_frames.command_long(self._sent, command, *parameters))

    def _set(self, reference: Reference) -> None:
        """Send the setpoints that have moved."""
        for name, old in self._last_sent.items():
            if (value := getattr(reference, name)) != old:
                self._last_sent[name] = value
                self._send(self._setpoint(name, value))

    def _setpoint(self, name: str, value: float) -> bytes:
        if name == "altitude":
            return mavlink_frames.command_int(self._sent, mavlink_frames.CHANGE_ALTITUDE, z=value)
        if name == "airspeed":
            return mavlink_frames.command_int(
                self._sent, mavlink_frames.CHANGE_SPEED, 0, value * self._to_equivalent
            )
        degrees = math.degrees(value) % 360.0
        return mavlink_frames.command_int(
            self._sent, mavlink_frames.CHANGE_HEADING, 1, degrees, _LATERAL_LIMIT_M_S2
        )

    def _send(self, frame: bytes) -> None:
        """Send a MAVLink frame to where the autopilot's own come from."""
        if self._link_address is None:
            if not select.select([self._link], [], [], STEP_S)[0]:
                raise self._problem("has sent nothing on its MAVLink link (serial 0)")
            self._link_address = self._link.recvfrom(1 << 16)[1]
        self._link.sendto(frame, self._link_address)
        self._sent += 1

    def _exchange(self, state: dict[str, object]) -> Sequence[int]:
        """Send one state; the pulse widths [us] that it answers with."""
        # Its clock is the wall's until the first state, and must not have to catch up: what it does as it starts would take
        # other steps. It cuts differences of time to whole microseconds: a nanosecond keeps 4.999999 ms from losing one.
        state["timestamp"] = START_S + self._frames * (self._dt + 1e-9)
        self._frames += 1
        self._line = b"\n" + json.dumps(state, separators=(",", ":")).encode() + b"\n"
        with contextlib.suppress(OSError):  # its death is noticed below
            self._states.send(self._line)
        return self._packet(STEP_S)

    def _packet(self, within_s: float) -> Sequence[int]:
        """The pulse widths of the next packet; those that it has sent before are dropped."""
        until_s = time.monotonic() + within_s
        while time.monotonic() < until_s:
            data = self._received()
            if data is None:
                self._living()
                continue
            count, pulses = self._unpacked(data)
            if self._count < 0 or count == self._count + 1:
                self._count = count
                return pulses
            if count != self._count:
                raise self._problem(f"sent packet {count} after packet {self._count}")
        raise self._problem(f"has not answered within {within_s:g} s")

    def _received(self) -> bytes | None:
        """A datagram; None if there is none for a while, or if nobody can send one."""
        try:
            data, self._sender = self._states.recvfrom(1 << 16)
        except TimeoutError:
            return None
        except OSError:
            time.sleep(_POLL_S / 10)  # the other side has no socket, so it is ending
            return None
        return data

    def _unpacked(self, data: bytes) -> tuple[int, Sequence[int]]:
        layout = _PACKETS.get(int.from_bytes(data[:2], "little"))
        if layout is None or len(data) != layout.size:
            what = f"sent {len(data)} bytes that begin with {data[:8]!r}"
            raise self._problem(what, "a servo packet: 40 bytes of magic 18458, or 72 of 29569")
        _, _, count, *pulses = layout.unpack(data)
        return count, pulses

    def _before(self) -> str:
        return (
            f"in its warm-up, {-self._time_s:.3f} s before the flight, "
            if self._frames
            else super()._before()
        )


def started(setup: Setup, words: Sequence[str]) -> ArduPilot:
    """The controller of one flight; raises BadInput when the executable or its parameters cannot be used."""
    return ArduPilot(setup, *words[1:])


def _flying(sensed: Sensed) -> dict[str, object]:
    """The state as the sensors read it, in the words of the interface."""
    return _said(
        (sensed.p, sensed.q, sensed.r),
        (sensed.force_x, sensed.force_y, sensed.force_z),
        (sensed.north, sensed.east, -sensed.altitude),
        (sensed.roll, sensed.pitch, sensed.heading),
        sensed,
    )


def _holding(sensed: Sensed, pitch: float, time_s: float) -> dict[str, object]:
    """Steady flight at this time before the first reading, without the errors that one reading has."""
    start = (sensed.north, sensed.east, -sensed.altitude)
    velocity = (sensed.velocity_north, sensed.velocity_east, sensed.velocity_down)
    return _said(
        (0.0, 0.0, 0.0),
        (GRAVITY_M_S2 * math.sin(pitch), 0.0, -GRAVITY_M_S2 * math.cos(pitch)),
        tuple(at + v * time_s for at, v in zip(start, velocity, strict=True)),
        (0.0, pitch, sensed.heading),
        sensed,
    )


def _said(
    gyro: Sequence[float],
    force: Sequence[float],
    position: Sequence[float],
    attitude: Sequence[float],
    sensed: Sensed,
) -> dict[str, object]:
    return {
        "no_time_sync": 1,
        "imu": {"gyro": gyro, "accel_body": force},
        "position": position,
        "attitude": attitude,
        "velocity": (sensed.velocity_north, sensed.velocity_east, sensed.velocity_down),
        "airspeed": sensed.airspeed,
    }


def _bound() -> socket.socket:
    """A UDP socket of this machine alone, at a port that is free."""
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.bind(("127.0.0.1", 0))
    made.settimeout(_POLL_S)
    return made


def _port(bound: socket.socket) -> int:
    port: int = bound.getsockname()[1]
    return port
