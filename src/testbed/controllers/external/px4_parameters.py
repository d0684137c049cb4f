"""The parameters with which PX4 flies an aircraft at first, written from the aircraft as those of ArduPilot are; none has flown.

An actuator has the output of its place. Its control allocation is told what each surface turns, so any layout flies.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from testbed.controllers.config import PidSettings
from testbed.controllers.external import ardupilot_parameters as conventional
from testbed.controllers.external.ardupilot_parameters import P, Q, R
from testbed.controllers.pid import suited

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup

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


def written(setup: Setup) -> dict[str, float]:
    """The parameters that follow from the aircraft."""
    return {**_FIXED, **_allocation(setup), **_speeds(setup), **_gains(setup)}


def _allocation(setup: Setup) -> dict[str, float]:
    """The output of each actuator, and of each surface its trim and its share of the moment about each axis."""
    effect, servo = np.array(setup.model.input_matrix), np.array([k == "servo" for k in setup.model.kinds])
    half = np.array([(a.high - a.low) / 2.0 for a in setup.actuators])
    share = (
        effect[: R + 1]
        * half
        / np.maximum(np.abs(effect[: R + 1] * half)[:, servo].sum(axis=1), 1e-9)[:, None]
    )
    said: dict[str, float] = {"CA_ROTOR_COUNT": int((~servo).sum()), "CA_SV_CS_COUNT": int(servo.sum())}
    for i, actuator in enumerate(setup.actuators):
        place = int((servo[:i] == servo[i]).sum())
        said[f"PWM_MAIN_FUNC{i + 1}"] = (_SERVO if servo[i] else _MOTOR) + place
        if servo[i]:
            name = f"CA_SV_CS{place}"
            middle = (actuator.high + actuator.low) / 2.0
            said |= {
                f"{name}_TYPE": _CUSTOM,
                f"{name}_TRIM": (setup.trim_commands[i] - middle) / half[i],
            }
            said |= {f"{name}_TRQ_{axis}": share[row, i] for axis, row in _AXES.items()}
    return said


def _speeds(setup: Setup) -> dict[str, float]:
    speeds = conventional.speeds(setup)
    return {
        "FW_AIRSPD_TRIM": speeds["AIRSPEED_CRUISE"],
        "FW_AIRSPD_MIN": speeds["AIRSPEED_MIN"],
        "FW_AIRSPD_STALL": speeds["AIRSPEED_MIN"] / 1.1,
        "FW_AIRSPD_MAX": speeds["AIRSPEED_MAX"],
        "FW_PSP_OFF": speeds["PTCH_TRIM_DEG"],
        "FW_THR_TRIM": speeds["TRIM_THROTTLE"] / 100.0,
        "FW_T_CLMB_MAX": speeds["TECS_CLMB_MAX"],
        "FW_T_SINK_MAX": speeds["TECS_SINK_MAX"],
        "FW_T_SINK_MIN": speeds["TECS_SINK_MIN"],
    }


def _gains(setup: Setup) -> dict[str, float]:
    """Rate loops in a whole deflection per rad/s: the crossover is a third of `pid`'s, and feedforward meets the damping."""
    loops = suited(setup.settings_as(PidSettings), setup)
    effect = np.abs(np.array(setup.model.input_matrix))
    servo = np.array([kind == "servo" for kind in setup.model.kinds])
    half = np.array([(a.high - a.low) / 2.0 for a in setup.actuators])
    said: dict[str, float] = {}
    for axis, row, crossover in (("R", P, loops.p_kp), ("P", Q, loops.q_kp), ("Y", R, loops.r_kp)):
        whole = max(float((effect[row] * half)[servo].sum()), 1e-6)
        p = float(crossover or 0.0) / 3.0 / whole
        said |= {f"FW_{axis}R_P": p, f"FW_{axis}R_I": 2.0 * p, f"FW_{axis}R_IMAX": 1.0}
        said[f"FW_{axis}R_FF"] = 0.0 if axis == "Y" else conventional.damping(setup, row) / whole
    return {name: value for name, value in said.items() if math.isfinite(value)}
