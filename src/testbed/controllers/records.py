"""The records of the compiled control law, field by field: name, shape, unit, meaning, and the paper's equation.

A record is a block of memory with named fields that numba reads as Python does, so the law's pages say `m.B[i, j]` as
the paper does, compiled or not. The letters on those pages:

    y     measured state, `signals.STATE`             k     control mode in force, MODE
    ref   references, `signals.SETPOINT`              s     memory from step to step, MEMORY
    m     design model f_m, B_m, MODEL                w     working memory of one step, WORK: f, z, e, nu, phi, P_h
    c     settings, SETTINGS

Actuator quantities are scaled: a position divided by the actuator's `scale`, so that one unit is about the same authority
for a tail as for a propeller, and one epsilon serves all in (14). Where the unit is "scaled", this is meant. n is the
number of actuators; rows of four are `signals.RATES`, [rad/s2] for p_dot, q_dot and r_dot and [m/s2] for u_dot ("x_c" as
a unit).
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from testbed.aircraft.design_model import COLUMNS, PROPELLER_POINTS

P_DOT, Q_DOT, R_DOT, U_DOT = range(4)
"""Rows by `signals.RATES`."""
D_ALPHA, D_BETA, D_P, D_Q, D_R = range(len(COLUMNS))
"""Columns of A: derivatives by `design_model.COLUMNS`."""

REGULATOR_STATE = ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch", "heading", "altitude")
"""State that a mode's regulator feeds back, as deviations from the mode's trim and the references."""
AIRSPEED, ALPHA, BETA, P, Q, R, ROLL, PITCH, HEADING, ALTITUDE = range(len(REGULATOR_STATE))
INTEGRALS = ("airspeed", "altitude", "heading")
"""Errors that a mode's regulator integrates."""
AIRSPEED_INTEGRAL, ALTITUDE_INTEGRAL, HEADING_INTEGRAL = range(len(INTEGRALS))


class Field(NamedTuple):
    """One field of a record.

    Attributes:
        shape: of numbers, and of "n" or "n+4" with n the number of actuators.
        unit: [1] for a number without one; "flag" for 0 or 1.
        equation: of the paper, where the field is one of its symbols.
    """

    name: str
    shape: tuple[int | str, ...]
    unit: str
    meaning: str
    equation: str = ""


_N, _X = "n", len(REGULATOR_STATE)

MODEL = (
    Field("airspeed", (), "m/s", "V_0 of the reference condition"),
    Field("alpha", (), "rad", "alpha_0 of the reference condition"),
    Field("density", (), "kg/m3", "of the air at the reference condition"),
    Field("bias", (4,), "x_c", "f_m at the reference, without gravity, with all propellers healthy", "(2)"),
    Field("offset", (4,), "x_c", "what healthy propellers add to `bias`: their torque is affine in thrust"),
    Field("A", (4, len(COLUMNS)), "x_c per rad, rad/s", "derivatives of f_m, columns D_ALPHA to D_R", "(2)"),
    Field("B", (4, _N), "x_c per scaled unit", "B_m, input matrix with rotors at steady speed", "(2)"),
    Field("B_inv", (_N, 4), "scaled units per x_c", "B_m^-1 (pseudo-inverse)", "(6)"),
    Field("B_torque", (4, _N), "x_c per N m", "effect of motor torque beyond that of the steady rotor in B"),
    Field("servo", (_N,), "flag", "the actuator is a servo; else a motor with a propeller"),
    Field("scale", (_N,), "rad or N", "size of one scaled unit"),
    Field("low", (_N,), "scaled", "lower stop"),
    Field("high", (_N,), "scaled", "upper stop"),
    Field("lag", (_N,), "rad/s", "corner of the first-order lag of a servo"),
    Field("rate", (_N,), "scaled/s", "rate limit of a servo"),
    Field(
        "trim_position", (_N,), "scaled", "position at the reference trim; a failed actuator is sent there"
    ),
    Field("torque_slope", (_N,), "N m per scaled unit", "steady motor torque over thrust, at the reference"),
    Field("diameter", (_N,), "m", "D of the propeller"),
    Field("advance_min", (_N,), "1", "first advance ratio J of the propeller's tables"),
    Field("advance_step", (_N,), "1", "step of J in the propeller's tables"),
    Field("c_thrust", (_N, PROPELLER_POINTS), "1", "thrust coefficient C_T(J)"),
    Field("c_torque", (_N, PROPELLER_POINTS), "1", "torque coefficient C_Q(J)"),
    Field("rotor_inertia", (_N,), "kg m2", "of rotor and propeller"),
    Field("max_volts", (_N,), "V", "motor voltage at full throttle"),
    Field("k_v", (_N,), "rev/s per V", "speed constant of the motor"),
    Field("k_t", (_N,), "N m/A", "torque constant of the motor"),
    Field("resistance", (_N,), "ohm", "of the motor's winding"),
    Field("no_load_current", (_N,), "A", "i_0 of the motor"),
)
"""m: the design model f_m, B_m, and the actuators' own dynamics."""

SETTINGS = (
    Field("dt", (), "s", "control step"),
    Field("adapts", (), "flag", "estimate effectiveness and monitor it"),
    Field("weighted", (), "flag", "estimate with a Kalman gain in place of (13)"),
    Field("gamma", (_N,), "1/s", "adaptation rate", "(13)"),
    Field("epsilon", (_N,), "scaled", "half-width of g", "(14)"),
    Field("lambda_min", (), "1", "lower bound of the estimates"),
    Field("lambda_max", (), "1", "upper bound of the estimates"),
    Field("divisor_min", (), "1", "least estimate that a reference is divided by: u = r / lambda_hat", "(5)"),
    Field("filter_rate", (), "rad/s", "corner of the two lags on both sides of the regression; 0 for none"),
    Field("threshold", (), "1", "an estimate that stays below it flags its actuator", "section 2.3"),
    Field("persistence", (), "s", "how long it must stay below", "section 2.3"),
    Field("recovery", (), "1", "an estimate that stays above it takes the flag back"),
    Field("recovery_time", (), "s", "how long it must stay above"),
    Field("flag_std_max", (), "1", "largest standard deviation of an estimate at which it may flag"),
    Field("process_noise", (), "1/sqrt(s)", "of effectiveness, modelled as a random walk"),
    Field(
        "jam_process_noise",
        (),
        "scaled/sqrt(s)",
        "of a jammed actuator's position, modelled as a random walk",
    ),
    Field("noise", (4,), "x_c/sqrt(Hz)", "root of the spectral density of what gusts do to each rate"),
    Field("model_error_std", (4,), "x_c", "standard deviation of the model's error at its own trim"),
    Field("model_error_rate", (), "1/s", "one over the correlation time of the model's error"),
    Field("coefficient_error", (), "1", "relative error to expect of each coefficient of f_m and B_m"),
    Field("residual_time", (), "s", "averaging time of the residual and of the model-error variance"),
    Field("jam_sigma", (), "1", "standard deviations of residual beyond which an actuator may be jammed"),
    Field("jam_time", (), "s", "how long it must stay beyond `jam_sigma`"),
    Field("airspeed_kp", (), "1/s", "u_dot for airspeed error"),
    Field("airspeed_ki", (), "1/s2", "its integral gain"),
    Field("u_dot_max", (), "m/s2", "largest u_dot that airspeed may ask for"),
    Field("altitude_kp", (), "1/s", "climb rate for altitude error"),
    Field("altitude_ki", (), "rad/(m s)", "its integral gain, on pitch"),
    Field("climb_max", (), "m/s", "largest climb rate that altitude may ask for"),
    Field("pitch_kp", (), "1/s", "pitch rate for pitch error"),
    Field("q_kp", (), "1/s", "q_dot for pitch-rate error"),
    Field("heading_kp", (), "1/s", "turn rate for heading error"),
    Field("heading_ki", (), "1/s2", "its integral gain"),
    Field("roll_max", (), "rad", "largest bank that heading may ask for"),
    Field("roll_kp", (), "1/s", "roll rate for bank error"),
    Field("p_kp", (), "1/s", "p_dot for roll-rate error"),
    Field("sideslip_kp", (), "1/s", "yaw rate for sideslip"),
    Field("sideslip_ki", (), "1/s2", "its integral gain"),
    Field("r_kp", (), "1/s", "r_dot for yaw-rate error"),
    Field("heading_error_max", (), "rad", "heading error is limited to this"),
    Field("altitude_error_max", (), "m", "altitude error is limited to this"),
    Field("airspeed_error_max", (), "m/s", "airspeed error is limited to this"),
)
"""c: what the control designer and the scenario chose."""

MODE = (
    Field("regulated", (), "flag", "axes are released, and the outer loop is the mode's regulator"),
    Field("redundant", (), "flag", "there are more available actuators than kept axes"),
    Field("available", (_N,), "flag", "the actuator is used; a failed one is not"),
    Field("released", (4,), "flag", "the rate is given up", "section 2.3"),
    Field("B_hat_inv", (_N, 4), "scaled per x_c", "inverse of the modified input matrix", "(29)"),
    Field(
        "B_hat_inv_at_stop",
        (_N, _N, 4),
        "scaled per x_c",
        "the same while actuator [first index] is at a stop",
    ),
    Field("slow_descent", (), "s", "altitude to give up for each m/s of missing airspeed"),
    Field("slow_descent_from", (), "m/s", "missing airspeed at which that begins"),
    Field("airspeed_offset", (), "m/s", "airspeed of the mode's trim over the reference condition's"),
    Field("r_trim", (_N,), "scaled", "r at the mode's own trim"),
    Field("x_trim", (_X,), "m/s, rad, rad/s, m", "state at the mode's own trim, by REGULATOR_STATE"),
    Field("K", (4, _X), "x_c per state", "regulator gains on the state"),
    Field(
        "K_actuator", (4, _N), "x_c per scaled unit", "regulator gains on the actuators' effective positions"
    ),
    Field("K_integral", (4, len(INTEGRALS)), "x_c per integral", "regulator gains on the integrals"),
)
"""k: the control mode in force: which actuators are left, and the modified inverse."""

MEMORY = (
    Field(
        "lambda_hat",
        (_N,),
        "1",
        "effectiveness estimates; of a jammed actuator its position [scaled]",
        "(13)",
    ),
    Field("r", (_N,), "scaled", "reference actuator position", "(6), (29)"),
    Field("u", (_N,), "scaled", "commanded actuator position, r / lambda_hat within the stops", "(5)"),
    Field("x_dc_dot", (4,), "x_c", "desired rates", "(6)"),
    Field("command", (_N,), "rad or throttle", "last command"),
    Field("position", (_N,), "scaled", "a, modelled position: servo deflection or thrust if fully effective"),
    Field("servo_input", (_N,), "scaled", "command of the step before, for the servo's lag"),
    Field("servo_lagged", (_N,), "scaled", "the servo's lag before rate limit and stops"),
    Field("rotor", (_N,), "rev/s", "modelled rotor speed"),
    Field("torque", (_N,), "N m", "modelled motor torque"),
    Field("failed", (_N,), "flag", "the monitor has flagged the actuator", "section 2.3"),
    Field("flag_timer", (_N,), "s", "how long the estimate has been beyond threshold or recovery"),
    Field("since_flag", (_N,), "s", "time since the flag was set or taken back"),
    Field("jammed", (_N,), "flag", "the actuator acts against its command: jammed, offset or reversed"),
    Field("jam_timer", (_N,), "s", "how long the residual has pointed at the actuator"),
    Field(
        "reversal_timer",
        (_N,),
        "s",
        "how long the estimate has been negative, with a small standard deviation",
    ),
    Field(
        "designed_position", (_N,), "scaled", "position of a jammed actuator that the mode was designed for"
    ),
    Field("residual", (4,), "x_c", "mean of e over `residual_time`"),
    Field("b", (4,), "x_c", "estimate of the model's error: what f_m and B_m leave out of each rate"),
    Field("model_error_variance", (4,), "x_c^2", "variance to expect of b"),
    Field("P", ("n+4", "n+4"), "1, scaled, x_c", "covariance of (lambda_hat, b)"),
    Field("filtered", (2, 4), "x_c", "state of the two lags on the left side of the regression"),
    Field("filtered_phi", (2, 4, _N), "x_c", "state of the two lags on Phi"),
    Field("airspeed_integral", (), "m/s2", "integral term of the airspeed loop"),
    Field("pitch_integral", (), "rad", "integral term of the altitude loop, the trim's pitch angle"),
    Field("heading_integral", (), "rad/s", "integral term of the heading loop"),
    Field("sideslip_integral", (), "rad/s", "integral term of the sideslip loop"),
    Field("integral", (len(INTEGRALS),), "m, m s, rad s", "integrals of the regulator, by INTEGRALS"),
)
"""s: what the law remembers from step to step."""

WORK = (
    Field("f", (4,), "x_c", "f_m at the measured state", "(2)"),
    Field("z", (4,), "x_c", "x_c_dot - f_m, as measured", "(10)"),
    Field("e", (4,), "x_c", "measured error z - Phi lambda_hat", "(10)"),
    Field("nu", (4,), "x_c", "virtual control, the bracket x_dc_dot - f_m", "(6), (29)"),
    Field("phi", (4, _N), "x_c", "Phi = B_m diag(a): effect of each actuator if fully effective", "(12)"),
    Field("P_h", ("n+4",), "1, scaled, x_c", "P times a row of (Phi, I), in the Kalman update"),
)
"""w: working memory of one step, so that nothing is allocated in flight."""


def _dtype(fields: tuple[Field, ...], n: int) -> np.dtype:
    sizes = {"n": n, "n+4": n + 4}
    columns = [
        (
            field.name,
            np.int8 if field.unit == "flag" else np.float64,
            tuple(sizes[d] if isinstance(d, str) else d for d in field.shape),
        )
        for field in fields
    ]
    return np.dtype((np.record, np.dtype(columns, align=True)))


@cache
def model_dtype(n: int) -> np.dtype:
    """MODEL for n actuators; kept, as the others, because numba knows a call's types by their dtype objects."""
    return _dtype(MODEL, n)


@cache
def settings_dtype(n: int) -> np.dtype:
    """SETTINGS for n actuators."""
    return _dtype(SETTINGS, n)


@cache
def mode_dtype(n: int) -> np.dtype:
    """MODE for n actuators."""
    return _dtype(MODE, n)


@cache
def memory_dtype(n: int) -> np.dtype:
    """MEMORY for n actuators."""
    return _dtype(MEMORY, n)


@cache
def work_dtype(n: int) -> np.dtype:
    """WORK for n actuators."""
    return _dtype(WORK, n)
