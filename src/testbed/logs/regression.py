"""The law's regression (10) of a whole log, averaged over bins of a tenth of a second: z = x_c_dot - f_m, and Phi.

The compiled functions of the law run over the log. Their letters: y measured state, m design model, s memory, f working memory;
fields, shapes and units are in `controllers.records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from testbed.common.jit import compiled
from testbed.common.signals import RATES, STATE, as_records
from testbed.controllers.actuator_model import advance_actuators, axial_speed
from testbed.controllers.commands import command_actuators
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.inversion.law import pressure_ratio_of, regressor, state_function
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import VARIANTS, Variant

BIN_S = 0.1
"""Long enough for the noise of sensors that was differentiated to cancel, and short against what a failure does."""
_SETTLE = 2.0  # s, of the actuators' model, with the first command


@dataclass(frozen=True)
class Regression:
    """Both sides of (10) in bins.

    Attributes:
        time_s: [bins] beginning of each.
        z: [bins, 4] x_c_dot - f_m.
        phi: [bins, 4, n] what each actuator adds if it works, for each of `VARIANTS`.
        unit: [bins, 4, n] what one scaled unit of its position adds.
        known: [bins] where the log has everything.
    """

    time_s: np.ndarray
    z: np.ndarray
    phi: dict[Variant, np.ndarray]
    unit: np.ndarray
    known: np.ndarray


def regression(
    log: FlightLog, setup: Setup, bin_s: float, variants: tuple[Variant, ...] = VARIANTS, block: int = 1
) -> Regression:
    """The regression of a log, with the design model of `setup`, in whole blocks of so many bins.

    A rate that the log has not is zero on both sides. What is missing of the state is filled with what does no harm.
    """
    usual = {"alpha": setup.model.alpha_rad, "airspeed": setup.model.airspeed_m_s}
    states = np.where(np.isfinite(log.states), log.states, [usual.get(name, 0.0) for name in STATE])
    width = max(round(bin_s / log.step_s), 1)
    rows = len(states) // width // block * block * width

    def binned(values: np.ndarray) -> np.ndarray:
        return np.asarray(values[:rows].reshape(-1, width, *values.shape[1:]).mean(axis=1))

    rates = ~np.isnan(log.states[:, [STATE.index(rate) for rate in RATES]]).all(axis=0)
    phi = {}
    for variant in variants:
        z, columns = _replayed(log, states, setup, variant)  # z is that of each
        phi[variant] = binned(columns) * rates[:, None]
    m = model_record(setup)[0]
    pressure = binned((states[:, STATE.index("airspeed")] / m.airspeed) ** 2)
    unit = m.B[None] * np.where(m.servo, pressure[:, None], 1.0)[:, None, :] * rates[:, None]
    known = binned(log.known.astype(float)) > 0.999
    return Regression(binned(log.time_s), binned(z) * rates, phi, unit, known)


def _replayed(
    log: FlightLog, states: np.ndarray, setup: Setup, variant: Variant
) -> tuple[np.ndarray, np.ndarray]:
    """z [rows, 4] and Phi [rows, 4, n], with the actuators' model as a variant has it."""
    m, s, n = model_record(setup), trimmed_memory(setup), len(setup.actuators)
    m[0].lag[:] *= variant.lag
    m[0].rate[:] *= variant.rate
    late = round(variant.delay_s / log.step_s)
    commands = np.where(np.isfinite(log.commands), log.commands, 0.0) / np.where(
        log.as_positions, setup.scale, 1.0
    )
    commands = np.concatenate([np.repeat(commands[:1], late, axis=0), commands])[: len(commands)]
    before = round(_SETTLE / log.step_s)
    rows = np.concatenate([np.arange(before) * 0, np.arange(len(states))])
    z, phi = np.zeros((len(rows), 4)), np.zeros((len(rows), 4, n))
    _replay(
        as_records(np.ascontiguousarray(states[rows]), STATE), np.ascontiguousarray(commands[rows]),
        log.as_positions.astype(float), log.step_s, m[0], s[0], np.zeros(4), z, phi,
    )  # fmt: skip
    return z[before:], phi[before:]


@compiled
def _replay(states, commands, thrusts, dt, m, s, f, z, phi):
    """Fill z [rows, 4] and Phi [rows, 4, n] of states [rows] and commands [rows, n].

    Commands are rad or throttle; where `thrusts` [n] is set, the commanded position in scaled units.
    """
    for k in range(len(states)):
        y = states[k]
        if k > 0:
            advance_actuators(dt, axial_speed(y), m, s)
        for i in range(len(s.u)):
            s.u[i] = commands[k, i]
        command_actuators(axial_speed(y), m, s)
        for i in range(len(s.u)):
            if not thrusts[i]:
                s.command[i] = commands[k, i]
        pressure_ratio = pressure_ratio_of(y, m)
        state_function(y, m, f)
        z[k, 0], z[k, 1], z[k, 2], z[k, 3] = y.p_dot - f[0], y.q_dot - f[1], y.r_dot - f[2], y.u_dot - f[3]
        for i in range(
            4
        ):  # both f and Phi contain the constant part of the propellers' torque: count it once
            z[k, i] += m.offset[i] * pressure_ratio
        regressor(pressure_ratio, m, s, phi[k])
