"""The law's regression (10) of a whole log, averaged over bins of a tenth of a second."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from testbed.common.signals import RATES, STATE, as_records
from testbed.controllers.initial_records import model_record, trimmed_memory
from testbed.controllers.setup import Setup
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import VARIANTS, Variant
from testbed.logs.replay import replay

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


def regression(log: FlightLog, setup: Setup, bin_s: float = BIN_S) -> Regression:
    """The regression of a log, with the design model of `setup`. A rate that the log has not is zero on both sides."""
    states = _completed(log, setup)
    width = max(round(bin_s / log.step_s), 1)
    made = {variant: _replayed(log, states, setup, variant) for variant in VARIANTS[:1]}
    z, nominal = made.pop(VARIANTS[0])
    rates = ~np.isnan(log.states[:, [STATE.index(rate) for rate in RATES]]).all(axis=0)
    phi = {VARIANTS[0]: _binned(nominal, width) * rates[:, None]}
    for variant in VARIANTS[1:]:
        phi[variant] = _binned(_replayed(log, states, setup, variant)[1], width) * rates[:, None]
    m = model_record(setup)[0]
    pressure = _binned((states[:, STATE.index("airspeed")] / m.airspeed) ** 2, width)
    unit = m.B[None] * np.where(m.servo, pressure[:, None], 1.0)[:, None, :] * rates[:, None]
    known = _binned(log.known.astype(float), width) > 0.999
    return Regression(_binned(log.time_s, width), _binned(z, width) * rates, phi, unit, known)


def _completed(log: FlightLog, setup: Setup) -> np.ndarray:
    """[rows, 17] states, with the trim's angles where the log has none, and what is missing filled with what does no harm."""
    states, model = log.states.copy(), setup.model
    usual = {"alpha": model.alpha_rad, "airspeed": model.airspeed_m_s}
    for column, name in enumerate(STATE):
        states[:, column] = np.where(np.isfinite(states[:, column]), states[:, column], usual.get(name, 0.0))
    return states


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
    replay(
        as_records(np.ascontiguousarray(states[rows]), STATE), np.ascontiguousarray(commands[rows]),
        log.as_positions.astype(float), log.step_s, m[0], s[0], np.zeros(4), z, phi,
    )  # fmt: skip
    return z[before:], phi[before:]


def _binned(values: np.ndarray, width: int) -> np.ndarray:
    count = len(values) // width
    return np.asarray(values[: count * width].reshape(count, width, *values.shape[1:]).mean(axis=1))
