"""PX4 in a process of its own, in lockstep over its simulator's interface: MAVLink by TCP, the testbed as the server.

Written from the protocol (https://docs.px4.io/main/en/simulation/), and flown against a fake alone. Each HIL_SENSOR moves the
autopilot's clock, and is answered by HIL_ACTUATOR_CONTROLS of that time. It starts in the air: see `ardupilot`.

The parameters with which it flies an aircraft at first are written from the aircraft as those of ArduPilot are; none has flown. An
actuator has the output of its place. Its control allocation is told what each surface turns, so any layout flies.
"""

from __future__ import annotations

import contextlib
import math
import os
import select
import socket
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from testbed.common.angles import body_from_ned
from testbed.common.units import GRAVITY_M_S2
from testbed.common.writing import write_new
from testbed.controllers.config import PidSettings
from testbed.controllers.external import ardupilot_parameters as conventional
from testbed.controllers.external import mavlink_frames
from testbed.controllers.external.ardupilot_parameters import (
    SEA_LEVEL_KG_M3,
    P,
    Q,
    R,
    density_ratio,
    given,
    text,
)
from testbed.controllers.external.process import CONSOLE, START_S, STEP_S, Autopilot
from testbed.controllers.pid import suited

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.controllers.user.adapter import Reference, Sensed, State

WARM_UP_S = 30.0
_SETPOINTS_S, _ARM_S, _OFFBOARD_S = 3.0, 1.0, 0.5  # before the release
_EVERY_S = 0.1  # of setpoints, which it wants in a stream, and of its satellite receiver
_OFFBOARD = 6
_PORT, _LINK, _ITS_LINK, _MOST = 4560, 14540, 14580, 100  # each with the number of the instance
_BOOT_STEP_S = 0.02  # of wall clock for a step, until it answers
_ALL = 0x1FFF
_HOME_DEG = (45.0, 10.0)
_FIELD_GAUSS = np.array((0.2257, 0.0130, 0.4166))  # north, east, down at home
_EARTH_M = 6_371_000.0
_DITHER = 1e-3  # readings that stay the same to the last bit count as those of a broken sensor
_AIRFRAME = {"PX4_SIM_MODEL": "gazebo-classic_plane", "PX4_SYS_AUTOSTART": "1030"}
_MOTOR, _SERVO = 101, 201
_FIXED_WING, _CUSTOM = 1, 12
_AXES = {"R": P, "P": Q, "Y": R}
_FIXED = {
    "CA_AIRFRAME": _FIXED_WING, "COM_RC_IN_MODE": 4, "NAV_RCL_ACT": 0, "NAV_DLL_ACT": 0, "COM_OF_LOSS_T": 5, "COM_ARM_WO_GPS": 1,
    "CBRK_SUPPLY_CHK": 894281, "SIM_BAT_ENABLE": 1, "SIM_BAT_MIN_PCT": 100, "SYS_HAS_MAG": 1, "SDLOG_MODE": 1,
    "FW_R_TC": 0.4, "FW_P_TC": 0.4, "FW_R_LIM": 40, "FW_P_LIM_MAX": 20, "FW_P_LIM_MIN": -20, "FW_THR_MIN": 0, "FW_THR_MAX": 1,
    "FW_THR_SLEW_MAX": 0, "IMU_GYRO_RATEMAX": 400,
}  # fmt: skip
"""No radio, no battery that runs down, and no limits that the other controllers do not have."""


class PX4(Autopilot):
    """Flies one flight."""

    def __init__(self, setup: Setup, path: str, parameters: str | None = None) -> None:
        super().__init__(setup, path, WARM_UP_S)
        self._rest, self._armed, self._airspeed = b"", False, math.nan
        self._travel = _travel(setup)
        values = {**written(setup), **given(setup, parameters)}
        write_new(self._folder / "parameters.parm", text(values))
        instance, server, self._link = self._ports()
        self._its_link = ("127.0.0.1", _ITS_LINK + instance)
        environment = {**_AIRFRAME, **os.environ, "PX4_SIM_HOSTNAME": "127.0.0.1"}
        environment |= {f"PX4_PARAM_{name}": f"{value:.9g}" for name, value in values.items()}
        command = [path, "-i", str(instance), "-d", str(Path(path).parents[1] / "etc")]
        self._start(command, (server, self._link), environment)
        try:
            self._stream = self._connected(server)
        except BaseException:
            self._end()
            raise

    def update(self, time_s: float, state: State, reference: Reference, sensed: Sensed) -> np.ndarray:
        """The commands that its controls stand for."""
        if self._frames == 0:
            self._warm_up(reference, sensed)
        self._time_s = time_s
        if self._due():
            self._set(reference, sensed)
        attitude = (sensed.roll, sensed.pitch, sensed.heading)
        force = (sensed.force_x, sensed.force_y, sensed.force_z)
        controls = self._controls(self._say(sensed, (sensed.p, sensed.q, sensed.r), force, attitude, 0.0))
        if not self._armed:
            raise self._problem("is not armed", f"the reason in {CONSOLE}")
        middle, half = self._travel
        return middle + half * np.clip(controls[: len(half)], -1.0, 1.0)

    def close(self) -> None:
        """End the autopilot, and keep its log."""
        if self._end.alive:
            self._tell_to_end()
            self._stream.close()
            self._end()
            for number, log in enumerate(sorted(self._folder.rglob("*.ulg"))):
                log.rename(self._folder / f"{number}.ulg")

    def _ports(self) -> tuple[int, socket.socket, socket.socket]:
        """The first instance whose two ports are free, with a server at the one and a socket at the other."""
        for instance in range(_MOST):
            server, link = socket.socket(), socket.socket(type=socket.SOCK_DGRAM)
            server.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                server.bind(("127.0.0.1", _PORT + instance))
                server.listen(1)
                link.bind(("127.0.0.1", _LINK + instance))
                return instance, server, link
            except OSError:
                server.close()
                link.close()
        raise self._problem(f"finds no free ports from {_PORT} and {_LINK} on")

    def _connected(self, server: socket.socket) -> socket.socket:
        until_s = time.monotonic() + START_S
        while not select.select([server], [], [], 0.2)[0]:
            self._living()
            if time.monotonic() > until_s:
                raise self._problem(f"has not connected within {START_S:g} s")
        return server.accept()[0]

    def _warm_up(self, reference: Reference, sensed: Sensed) -> None:
        """Hold the trim, and come up to the first position at the first velocity."""
        steps = round(WARM_UP_S / self._dt)
        self._first = (sensed.north, sensed.east, sensed.altitude)
        force = GRAVITY_M_S2 * math.sin(self._pitch), 0.0, -GRAVITY_M_S2 * math.cos(self._pitch)
        arm, offboard = (steps - round(each / self._dt) for each in (_ARM_S, _OFFBOARD_S))
        self._boot(sensed, force)
        for step in range(steps):
            self._time_s = (step - steps) * self._dt
            if -self._time_s <= _SETPOINTS_S and self._due():
                self._set(reference, sensed)
            if step in (arm, offboard):
                first = step == arm
                command = (
                    (mavlink_frames.ARM, 1, mavlink_frames.FORCE)
                    if first
                    else (mavlink_frames.SET_MODE, 1, _OFFBOARD)
                )
                self._send(mavlink_frames.command_long(self._sent, *command))
            still = (0.0, self._pitch, sensed.heading)
            self._controls(self._say(sensed, (0.0,) * 3, force, still, self._time_s))

    def _boot(self, sensed: Sensed, force: Sequence[float]) -> None:
        """Give it time until it answers: its modules start one after the other."""
        until_s = time.monotonic() + START_S
        while time.monotonic() < until_s:
            self._say(sensed, (0.0,) * 3, force, (0.0, self._pitch, sensed.heading), -WARM_UP_S)
            if any(number == mavlink_frames.HIL_ACTUATOR_CONTROLS for number, _ in self._heard(_BOOT_STEP_S)):
                return
        raise self._problem(f"has sent no controls within {START_S:g} s")

    def _due(self) -> bool:
        return round(self._time_s / self._dt) % max(round(_EVERY_S / self._dt), 1) == 0

    def _set(self, reference: Reference, sensed: Sensed) -> None:
        """Send a path through where it is: it flies a course, so the drift of the wind is added to the heading."""
        drift = math.atan2(sensed.velocity_east, sensed.velocity_north) - sensed.heading
        course, down = reference.heading + drift, self._first[2] - reference.altitude
        here = (sensed.north - self._first[0], sensed.east - self._first[1], down)
        speed = reference.airspeed
        velocity = (speed * math.cos(course), speed * math.sin(course), -reference.altitude_rate)
        self._send(mavlink_frames.heartbeat(self._sent))
        self._send(mavlink_frames.path_target(self._sent, *here, *velocity))
        if reference.airspeed != self._airspeed:
            self._airspeed = reference.airspeed
            equivalent = reference.airspeed * math.sqrt(density_ratio(sensed.pressure, sensed.temperature))
            self._send(mavlink_frames.command_long(self._sent, mavlink_frames.PLAIN_SPEED, 0, equivalent, -1))

    def _send(self, frame: bytes) -> None:
        self._link.sendto(frame, self._its_link)
        self._sent += 1

    def _controls(self, said_us: int) -> Sequence[float]:
        """The controls that answer the readings of this time [us]."""
        until_s = time.monotonic() + STEP_S
        while (left_s := until_s - time.monotonic()) > 0.0:
            for number, payload in self._heard(left_s):
                if number == mavlink_frames.HIL_ACTUATOR_CONTROLS:
                    at_us, self._armed, controls = mavlink_frames.actuator_controls(payload)
                    if at_us >= said_us and all(map(math.isfinite, controls)):
                        return controls
                    if at_us >= said_us:
                        raise self._problem(f"sent controls {controls}", "finite numbers")
        raise self._problem(f"has not answered within {STEP_S:g} s")

    def _say(
        self,
        sensed: Sensed,
        gyro: Sequence[float],
        force: Sequence[float],
        attitude: Sequence[float],
        before_s: float,
    ) -> int:
        """Send readings; their time [us]."""
        self._frames += 1
        time_us = round(self._frames * self._dt * 1e6)
        dither = _DITHER * (1 - 2 * (self._frames % 2)) if before_s else 0.0
        density = density_ratio(sensed.pressure, sensed.temperature) * SEA_LEVEL_KG_M3
        pressure = sensed.pressure + density * GRAVITY_M_S2 * sensed.velocity_down * before_s
        pitot = 0.5 * density * sensed.airspeed**2
        inertial = [each + dither for each in (*force, *gyro)]
        field = body_from_ned(*attitude) @ _FIELD_GAUSS + dither
        air = (
            pressure / 100.0 + dither,
            pitot / 100.0 + dither,
            sensed.altitude,
            sensed.temperature - 273.15,
        )
        said = mavlink_frames.hil_sensor(self._frames, time_us, *inertial, *field, *air, fields=_ALL)
        if self._frames % max(round(_EVERY_S / self._dt), 1) == 1:
            said = mavlink_frames.hil_gps(self._frames, time_us, *_fix(sensed, before_s)) + said
        with contextlib.suppress(OSError):  # its death is noticed when it is listened to
            self._stream.sendall(said)
        return time_us

    def _heard(self, within_s: float) -> Iterator[tuple[int, bytes]]:
        """Number and payload of the frames that have come, when there are any within this time."""
        if not select.select([self._stream], [], [], within_s)[0]:
            return
        try:
            read = self._stream.recv(1 << 16)
        except OSError:
            read = b""
        if not read:
            time.sleep(0.2)
            self._living()
            raise self._problem("closed its connection")
        self._rest += read
        end = 0
        try:
            for number, payload, ends in mavlink_frames.frames(self._rest):
                end = ends
                yield number, payload
        except ValueError as error:
            raise self._problem(f"sent {error}", "MAVLink 2") from None
        finally:
            self._rest = self._rest[end:]


def started(setup: Setup, words: Sequence[str]) -> PX4:
    """The controller of one flight; raises BadInput when the executable or its parameters cannot be used."""
    return PX4(setup, *words[1:])


def _fix(sensed: Sensed, before_s: float) -> Iterator[int]:
    """What a satellite receiver says: place [1e-7 deg, mm], speed over the ground and velocity [cm/s]."""
    velocity = (sensed.velocity_north, sensed.velocity_east, sensed.velocity_down)
    north, east = sensed.north + velocity[0] * before_s, sensed.east + velocity[1] * before_s
    latitude = _HOME_DEG[0] + math.degrees(north / _EARTH_M)
    longitude = _HOME_DEG[1] + math.degrees(east / _EARTH_M / math.cos(math.radians(_HOME_DEG[0])))
    altitude = sensed.altitude - velocity[2] * before_s
    yield from (round(latitude * 1e7), round(longitude * 1e7), round(altitude * 1e3))
    yield from (round(each * 100.0) for each in (math.hypot(*velocity[:2]), *velocity))


def _travel(setup: Setup) -> tuple[np.ndarray, np.ndarray]:
    """Command at 0, and what 1 adds to it, of each actuator: stops of a servo at -1 and 1, throttle from 0 to 1."""
    ends = [
        ((a.high + a.low) / 2.0, (a.high - a.low) / 2.0) if kind == "servo" else (0.0, 1.0)
        for a, kind in zip(setup.actuators, setup.model.kinds, strict=True)
    ]
    middle, half = np.array(ends).T
    return middle, half


def written(setup: Setup) -> dict[str, float]:
    """The parameters that follow from the aircraft."""
    return {**_FIXED, **_allocation(setup), **_speeds(setup), **_gains(setup)}


def _allocation(setup: Setup) -> dict[str, float]:
    """The output of each actuator, and of each surface its trim and its share of the moment about each axis."""
    effect, servo = np.array(setup.model.input_matrix), conventional.is_servo(setup)
    middle, half = _travel(setup)
    share = (
        effect[: R + 1]
        * half
        / np.maximum(np.abs(effect[: R + 1] * half)[:, servo].sum(axis=1), 1e-9)[:, None]
    )
    said: dict[str, float] = {"CA_ROTOR_COUNT": int((~servo).sum()), "CA_SV_CS_COUNT": int(servo.sum())}
    for i in range(len(servo)):
        place = int((servo[:i] == servo[i]).sum())
        said[f"PWM_MAIN_FUNC{i + 1}"] = (_SERVO if servo[i] else _MOTOR) + place
        if servo[i]:
            name = f"CA_SV_CS{place}"
            said |= {
                f"{name}_TYPE": _CUSTOM,
                f"{name}_TRIM": (setup.trim_commands[i] - middle[i]) / half[i],
            }
            said |= {f"{name}_TRQ_{axis}": share[row, i] for axis, row in _AXES.items()}
    return said


def _speeds(setup: Setup) -> dict[str, float]:
    told = conventional.speeds(setup)
    return {
        "FW_AIRSPD_TRIM": told["AIRSPEED_CRUISE"],
        "FW_AIRSPD_MIN": told["AIRSPEED_MIN"],
        "FW_AIRSPD_STALL": told["AIRSPEED_MIN"] / 1.1,
        "FW_AIRSPD_MAX": told["AIRSPEED_MAX"],
        "FW_PSP_OFF": told["PTCH_TRIM_DEG"],
        "FW_THR_TRIM": told["TRIM_THROTTLE"] / 100.0,
        "FW_T_CLMB_MAX": told["TECS_CLMB_MAX"],
        "FW_T_SINK_MAX": told["TECS_SINK_MAX"],
        "FW_T_SINK_MIN": told["TECS_SINK_MIN"],
    }


def _gains(setup: Setup) -> dict[str, float]:
    """Rate loops in a whole deflection per rad/s: the crossover is a third of `pid`'s, and feedforward meets the damping."""
    loops = suited(setup.settings_as(PidSettings), setup)
    effect, servo = np.abs(np.array(setup.model.input_matrix)), conventional.is_servo(setup)
    half = _travel(setup)[1]
    said: dict[str, float] = {}
    for axis, row, crossover in (("R", P, loops.p_kp), ("P", Q, loops.q_kp), ("Y", R, loops.r_kp)):
        whole = max(float((effect[row] * half)[servo].sum()), 1e-6)
        p = float(crossover or 0.0) / 3.0 / whole
        said |= {f"FW_{axis}R_P": p, f"FW_{axis}R_I": 2.0 * p, f"FW_{axis}R_IMAX": 1.0}
        said[f"FW_{axis}R_FF"] = 0.0 if axis == "Y" else conventional.damping(setup, row) / whole
    return {name: value for name, value in said.items() if math.isfinite(value)}
