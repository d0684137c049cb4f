"""The parameters with which ArduPilot flies an aircraft at first: what follows from the aircraft, and what the lockstep needs.

A surface's function follows from the axes that it turns, a propeller's from its side. First gains: a rate loop crosses over at a
third of `pid`'s frequency, because the autopilot filters its rates; its feedforward holds a steady rate against the damping.
They are a starting point, which a file of the user's and `controller.parameters` override, in this order.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.aircraft.design_model import COLUMNS, ROWS
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import PidSettings
from testbed.controllers.pid import suited
from testbed.inputs.input_file import read_text
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup

P, Q, R = (ROWS.index(name) for name in ("p_dot", "q_dot", "r_dot"))
_AILERON, _ELEVATOR, _RUDDER = 4, 19, 21
_ELEVONS, _V_TAIL, _THROTTLES, _THROTTLE = (77, 78), (79, 80), (73, 74), 70  # left, right
_MIXED = 0.3  # of the largest effect of a surface about an axis, from which a surface counts as one for it
_LOW_US, _HIGH_US, _ITS_LOW_US, _ITS_HIGH_US = 1000.0, 2000.0, 1100.0, 1900.0
_FULL_DEG = 45.0  # the autopilot's measure of full deflection
SEA_LEVEL_KG_M3, _GAS_CONSTANT = 1.225, 287.05
_NAME = re.compile(r"[A-Z][A-Z0-9_]{1,15}")
_LARGEST_FILE = 1_000_000

_LOCKSTEP = {
    "ARMING_REQUIRE": 1, "ARMING_CHECK": 0, "INITIAL_MODE": 0, "THR_FAILSAFE": 0,
    "FS_SHORT_ACTN": 3, "FS_LONG_ACTN": 0, "FS_GCS_ENABL": 0, "BATT_MONITOR": 0, "TERRAIN_ENABLE": 0,
    "SERIAL1_PROTOCOL": -1, "SERIAL2_PROTOCOL": -1, "LOG_BACKEND_TYPE": 1, "LOG_DISARMED": 0,
    "ARSPD_TYPE": 100, "ARSPD_USE": 1, "ARSPD_SKIP_CAL": 1, "ARSPD_OFFSET": 0, "ARSPD_RATIO": 1.99,
    "SIM_ARSPD_RATIO": 1.99, "SIM_ARSPD_OFS": 0, "SIM_ARSPD_RND": 0, "SIM_BARO_RND": 0, "SIM_GPS_NOISE": 0,
    "SIM_ACC1_RND": 0, "SIM_GYR1_RND": 0, "SIM_MAG1_OFS_X": 0, "SIM_MAG1_OFS_Y": 0, "SIM_MAG1_OFS_Z": 0,
    "COMPASS_OFS_X": 0, "COMPASS_OFS_Y": 0, "COMPASS_OFS_Z": 0, "INS_GYR_CAL": 0,
    "AHRS_EKF_TYPE": 3, "EK2_ENABLE": 0, "EK3_ENABLE": 1, "EK3_GPS_CHECK": 0, "EK3_IMU_MASK": 1,
}  # fmt: skip
"""No radio, no ports, no errors but those of the scenario's sensors, and nothing calibrated in flight."""

_OUTER_LOOPS = {
    "SCHED_LOOP_RATE": 100, "INS_GYRO_FILTER": 150, "INS_ACCEL_FILTER": 100, "THR_MIN": 0, "THR_MAX": 100,
    "THR_SLEWRATE": 0, "ROLL_LIMIT_DEG": 40, "PTCH_LIM_MAX_DEG": 20, "PTCH_LIM_MIN_DEG": -20,
    "GUIDED_P": 15000, "GUIDED_I": 2500, "GUIDED_IMAX": 2000,
    "TECS_HDEM_TCONST": 0.2, "TECS_PTCH_DAMP": 0.8, "TECS_THR_DAMP": 0.5, "TECS_HGT_OMEGA": 5,
}  # fmt: skip
"""The same for every aircraft: GUIDED_IMAX is too small for an integral as it comes, filters assume five times the samples."""


def given(setup: Setup, file: str | None) -> dict[str, float]:
    """What the user gives: the values of a file, then those of `controller.parameters`; raises BadInput."""
    scenario = _checked(setup.parameters.items(), "controller.parameters")
    return {**(_read(file) if file else {}), **scenario}


def text(values: Mapping[str, float]) -> str:
    """The parameter file."""
    return "".join(f"{name} {value:.9g}\n" for name, value in values.items())


def density_ratio(pressure_pa: float, temperature_k: float) -> float:
    """Density of the air over that at sea level in the standard atmosphere."""
    return pressure_pa / (_GAS_CONSTANT * temperature_k * SEA_LEVEL_KG_M3)


def written(setup: Setup) -> dict[str, float]:
    """The parameters that follow from the aircraft."""
    functions = _functions(setup)
    return {
        **_LOCKSTEP,
        **_OUTER_LOOPS,
        **_servos(setup, functions),
        **speeds(setup),
        **_gains(setup, functions),
    }


class Outputs:
    """Makes commands of pulse widths: of each actuator, the channel that has its function in the parameters.

    A channel's SERVOn_MIN is one stop of a surface and SERVOn_MAX the other, by the sign of the function; of a throttle, 0 and 1.
    A pulse of 0 is none: then the surface stays at its trim, and the propeller is without power.
    """

    def __init__(self, setup: Setup, values: Mapping[str, float]) -> None:
        functions = _functions(setup)
        self._channels = _channels(functions, values, setup.model.actuators)
        pulses = [
            (values.get(f"SERVO{n + 1}_MIN", _ITS_LOW_US), values.get(f"SERVO{n + 1}_MAX", _ITS_HIGH_US))
            for n in self._channels
        ]
        self._low, self._range = np.array(pulses)[:, 0], np.array(pulses) @ (-1.0, 1.0)
        if (self._range <= 0.0).any():
            raise BadInput([Problem("SERVOn_MIN is not below SERVOn_MAX", "parameters")])
        ends = np.array([_ends(setup, i) for i in range(len(functions))])
        self._start, self._travel = ends[:, 0], ends @ (-1.0, 1.0)
        self._none = np.where(is_servo(setup), setup.trim_commands, 0.0)

    def commands(self, pulses_us: Any) -> np.ndarray:
        """[n] commands, rad or throttle, of all channels' pulse widths."""
        pulses = np.array([pulses_us[n] for n in self._channels], dtype=float)
        fraction = np.clip((pulses - self._low) / self._range, 0.0, 1.0)
        return np.where(pulses > 0.0, self._start + fraction * self._travel, self._none)


def _channels(functions: list[int], values: Mapping[str, float], names: Iterable[str]) -> list[int]:
    """The channel of each actuator from 0: of those with its function, the first that is free."""
    found: list[int] = []
    for function, name in zip(functions, names, strict=True):
        free = (n for n in range(16) if values.get(f"SERVO{n + 1}_FUNCTION") == function and n not in found)
        if (channel := next(free, None)) is None:
            what = f"no SERVOn_FUNCTION is {function}, of which {name} is one"
            raise BadInput([Problem(what, "parameters")])
        found.append(channel)
    return found


def _functions(setup: Setup) -> list[int]:
    """SERVOn_FUNCTION of each actuator, by what the design model says of it."""
    effects, servo = np.array(setup.model.input_matrix), is_servo(setup)
    largest = np.abs(effects[:, servo]).max(axis=1, initial=1e-9)
    about = np.abs(effects) > _MIXED * largest[:, None]
    yaw = effects[R, ~servo]
    sides = len(yaw) > 1 and yaw.min() < 0.0 < yaw.max()
    return [
        _surface(effects[:, i], about[:, i]) if servo[i]
        else _THROTTLES[int(effects[R, i] < 0.0)] if sides else _THROTTLE
        for i in range(len(servo))
    ]  # fmt: skip


def _surface(effect: np.ndarray, about: np.ndarray) -> int:
    """The function of a surface. The left one of a v-tail yaws right as it pitches up; the left elevon then rolls right."""
    if about[Q] and about[R]:
        return _V_TAIL[int(effect[Q] * effect[R] < 0.0)]
    if about[Q] and about[P]:
        return _ELEVONS[int(effect[Q] * effect[P] > 0.0)]
    return _ELEVATOR if about[Q] else _AILERON if about[P] else _RUDDER


def _ends(setup: Setup, i: int) -> tuple[float, float]:
    """Command of an actuator at the shortest and at the longest pulse, which turns in the function's positive sense."""
    if setup.model.kinds[i] != "servo":
        return 0.0, 1.0
    low, high = setup.actuators[i].low, setup.actuators[i].high
    axis = {_AILERON: P, _RUDDER: R}.get(_functions(setup)[i], Q)
    positive = setup.model.input_matrix[axis][i] > 0.0
    return (low, high) if positive else (high, low)


def is_servo(setup: Setup) -> np.ndarray:
    """[n] which actuators are servos."""
    return np.array([kind == "servo" for kind in setup.model.kinds])


def _servos(setup: Setup, functions: list[int]) -> dict[str, float]:
    """Function, pulses and trim of each actuator's channel, in the aircraft's order."""
    said: dict[str, float] = {}
    for i, function in enumerate(functions):
        start, end = _ends(setup, i)
        at_trim = (setup.trim_commands[i] - start) / (end - start) if setup.model.kinds[i] == "servo" else 0.0
        said |= {
            f"SERVO{i + 1}_FUNCTION": function,
            f"SERVO{i + 1}_MIN": _LOW_US,
            f"SERVO{i + 1}_MAX": _HIGH_US,
            f"SERVO{i + 1}_TRIM": round(_LOW_US + at_trim * (_HIGH_US - _LOW_US)),
        }
    return said


def speeds(setup: Setup) -> dict[str, float]:
    """Airspeeds [m/s, equivalent] and the trim. The lowest is 1.1 of that at which the lift stops to grow.

    Height and speed are exchanged in a time that grows with the speed; `benchmarks/tune_ardupilot.py` chose it.
    """
    model = setup.model
    lift = -model.derivatives[ROWS.index("w_dot")][COLUMNS.index("alpha")] / GRAVITY_M_S2
    most = 1.0 + lift * max(model.stall_alpha_rad - model.alpha_rad, 0.0)
    cruise = model.airspeed_m_s * math.sqrt(model.density_kg_m3 / SEA_LEVEL_KG_M3)
    throttles = np.array(setup.trim_commands)[~is_servo(setup)]
    climb = 2.0 * float(setup.control.loops.climb_max)
    return {
        "AIRSPEED_CRUISE": cruise,
        "AIRSPEED_MIN": 1.1 * cruise / math.sqrt(most),
        "AIRSPEED_MAX": 1.55 * cruise,
        "SCALING_SPEED": cruise,
        "PTCH_TRIM_DEG": math.degrees(setup.trim_pitch),
        "TRIM_THROTTLE": 100.0 * float(throttles.mean()) if len(throttles) else 0.0,
        "TECS_TIME_CONST": cruise / 3.75,
        "TECS_INTEG_GAIN": 9.0 / cruise,
        "TECS_CLMB_MAX": climb,
        "TECS_SINK_MIN": cruise / 12.0,
        "TECS_SINK_MAX": max(cruise / 3.6, climb),
    }


def _gains(setup: Setup, functions: list[int]) -> dict[str, float]:
    """First gains, and how surfaces and propellers are mixed."""
    loops = suited(setup.settings_as(PidSettings), setup)
    ailerons = bool({_AILERON, *_ELEVONS} & {*functions})
    pitch, against = _per_degree(setup, functions, Q), damping(setup, Q)
    gains = {"PTCH2SRV_TCONST": 0.3, "PTCH2SRV_RMAX_UP": 60, "PTCH2SRV_RMAX_DN": 60, "PTCH2SRV_RLL": 1}
    gains |= _rate("PTCH", against / pitch, float(loops.q_kp or 0.0) / 3.0 / pitch)
    gains |= {"RLL2SRV_TCONST": 0.3, "RLL2SRV_RMAX": 60}
    if ailerons:
        roll = _per_degree(setup, functions, P)
        gains |= _rate("RLL", damping(setup, P) / roll, float(loops.p_kp or 0.0) / 3.0 / roll)
    else:
        gains |= _by_rudder(setup, functions)
    mixing = {"MIXING_GAIN": 1.0, "RUDD_DT_GAIN": 50.0}
    direct = (
        {"KFF_RDDRMIX": 0.2, "YAW2SRV_DAMP": 0.1} if ailerons else {"KFF_RDDRMIX": 1.0, "YAW2SRV_DAMP": 0.2}
    )
    return gains | mixing | direct


def _by_rudder(setup: Setup, functions: list[int]) -> dict[str, float]:
    """Without ailerons the rudder rolls by sideslip and dihedral: a third of the feedforward for the steady rate of roll."""
    beta = np.array(setup.model.derivatives)[:, COLUMNS.index("beta")]
    yaw = _per_degree(setup, functions, R)
    steady = yaw * max(-beta[P] / max(beta[R], 1e-6), 1e-3) / damping(setup, P)  # rad/s per deg
    return _rate("RLL", 0.3 / steady, 0.1 / steady)


def _per_degree(setup: Setup, functions: list[int], axis: int) -> float:
    """Angular acceleration [rad/s2] per degree of the autopilot's demand, of all surfaces that heed it."""
    mixed = {Q: {_ELEVATOR, *_V_TAIL, *_ELEVONS}, P: {_AILERON, *_ELEVONS}, R: {_RUDDER, *_V_TAIL}}
    effect = np.abs(setup.model.input_matrix[axis])
    half = np.array([(a.high - a.low) / 2.0 for a in setup.actuators])
    heeds = [function in mixed[axis] for function in functions]
    return max(float((effect * half)[heeds].sum()) / _FULL_DEG, 1e-6)


def damping(setup: Setup, axis: int) -> float:
    """The model's damping of this rotation [1/s]."""
    return max(-setup.model.derivatives[axis][COLUMNS.index("pqr"[axis])], 0.1)


def _rate(name: str, feedforward: float, proportional: float) -> dict[str, float]:
    """The gains of a rate loop, per rad/s as given; its integral is as fast as that of the set that was tuned for the v-tail."""
    p = proportional / math.degrees(1.0)
    gains = {"FF": feedforward / math.degrees(1.0), "P": p, "I": 2.0 * p, "D": 0.0, "IMAX": 1.0}
    return {f"{name}_RATE_{key}": value for key, value in gains.items()}


def _read(file: str) -> dict[str, float]:
    """A parameter file: a name and a number in each line, between them a space or a comma; the last of a name counts."""
    lines = read_text(file, _LARGEST_FILE, "a parameter file").splitlines()
    return _checked(_pairs(lines, file), file)


def _pairs(lines: list[str], file: str) -> Iterator[tuple[str, Any]]:
    for number, line in enumerate(lines, 1):
        if words := line.partition("#")[0].replace(",", " ").split():
            if len(words) != 2:
                raise BadInput([Problem(f"is {line!r:.80}", file, number, expected="NAME VALUE")])
            yield words[0], words[1]


def _checked(pairs: Iterable[tuple[str, Any]], place: str) -> dict[str, float]:
    """The pairs as names and finite numbers; raises BadInput for anything else."""
    values: dict[str, float] = {}
    for name, value in pairs:
        try:
            values[name] = float(value)
        except (TypeError, ValueError):
            values[name] = math.nan
        if not _NAME.fullmatch(name) or not math.isfinite(values[name]):
            what = f"{name!r:.40} is {value!r:.40}"
            raise BadInput([Problem(what, place, expected="a parameter's name in capitals, and a number")])
    return values
