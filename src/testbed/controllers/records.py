"""The records of the compiled control law, field by field: name, shape, unit, meaning, and the paper's equation.

A record is a block of memory with named fields. Compiled and uncompiled functions read it alike, so the law is written with
the paper's symbols: `m.B[i, j]`. The compiled functions name the records by one letter:

    y     measured state, `signals.STATE`             k     control mode in force, MODE
    ref   references, `signals.SETPOINT`              s     memory from step to step, MEMORY
    m     design model f_m, B_m, MODEL                w     working memory of one step, WORK: f, z, e, nu, phi, P_h
    c     settings, SETTINGS

Of the working memory, f, z, e, nu, phi and P_h are called by their names too. `pressure_ratio` is (V/V_0)^2, the dynamic
pressure divided by that at the reference condition [1], and `axial` the airspeed along the propellers' axis [m/s].

The unit "scaled" is an actuator's position [rad or N] divided by its `scale`. One scaled unit of a tail and one of a
propeller have about the same authority, so one epsilon serves all actuators in (14). The unit "x_c" is that of the
controlled rates, four rows by `signals.RATES`: [rad/s2] for p_dot, q_dot and r_dot, [m/s2] for u_dot. n is the number of
actuators.
"""

from __future__ import annotations

from functools import cache, partial
from typing import NamedTuple

import numpy as np

from testbed.aircraft.control_design import LOOP_GAINS
from testbed.aircraft.design_model import COLUMNS, PRODUCTS
from testbed.aircraft.propulsors import ENGINE_SPEEDS, ENGINE_THROTTLES, PROPELLER_POINTS
from testbed.common.signals import GUARDED

P_DOT, Q_DOT, R_DOT, U_DOT = range(4)
"""Rows by `signals.RATES`."""
D_ALPHA, D_BETA, D_P, D_Q, D_R = range(len(COLUMNS))
"""Columns of A: derivatives by `design_model.COLUMNS`."""

REGULATOR_STATE = ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch", "heading", "altitude")
"""States that a mode's regulator feeds back, as deviations from the mode's trim or from the references."""
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
    Field("stall_alpha", (), "rad", "angle of attack beyond which lift grows at less than half its slope"),
    Field("zero_lift_alpha", (), "rad", "angle of attack below which the lift points down; not in the paper's preset"),
    Field("density", (), "kg/m3", "of the air at the reference condition"),
    Field("bias", (4,), "x_c", "f_m at the reference condition, gravity apart; it includes `offset`", "(2)"),
    Field("offset", (4,), "x_c", "effect of the part of propeller torque that does not vary with thrust"),
    Field("A", (4, len(COLUMNS)), "x_c per rad, rad/s", "derivatives of f_m, columns D_ALPHA to D_R", "(2)"),
    Field("sideslip", (4,), "x_c per rad", "effect of the size of sideslip, beta of either sign"),
    Field("side_slope", (), "m/s2 per rad", "v_dot by beta: the side force, which leans forward in a sideslip"),
    Field("forward_curvature", (), "m/s2 per rad^2", "u_dot by the square of alpha from its trim: lift leans forward", "(2)"),
    Field("gyroscopic", (3, len(PRODUCTS)), "1", "p_dot, q_dot, r_dot by products of p, q, r", "(2)"),
    Field("B", (4, _N), "x_c per scaled unit", "B_m, input matrix with rotors at steady speed", "(2)"),
    Field("B_inv", (_N, 4), "scaled units per x_c", "B_m^-1 (pseudo-inverse)", "(6)"),
    Field("B_torque", (4, _N), "x_c per N m", "effect of torque beyond `torque_slope` times thrust"),
    Field("servo", (_N,), "flag", "the actuator is a servo"),
    Field("engine", (_N,), "flag", "the actuator is an engine; without this and `servo`, a motor with a propeller"),
    Field("scale", (_N,), "rad or N", "size of one scaled unit"),
    Field("low", (_N,), "scaled", "lower stop"),
    Field("high", (_N,), "scaled", "upper stop"),
    Field("lag", (_N,), "rad/s", "corner of the first-order lag, for small changes"),
    Field("rate", (_N,), "scaled/s", "rate limit of a servo"),
    Field("trim_position", (_N,), "scaled", "position at the reference trim; a failed actuator is sent there"),
    Field("torque_slope", (_N,), "N m per scaled unit", "dQ/dT of steady motor torque, at the reference"),
    Field("diameter", (_N,), "m", "D of the propeller"),
    Field("advance_min", (_N,), "1", "first advance ratio J of the propeller's tables"),
    Field("advance_step", (_N,), "1", "interval of J in the propeller's tables"),
    Field("c_thrust", (_N, PROPELLER_POINTS), "1", "thrust coefficient C_T(J)"),
    Field("c_torque", (_N, PROPELLER_POINTS), "1", "torque coefficient C_Q(J)"),
    Field("rotor_inertia", (_N,), "kg m2", "of rotor and propeller"),
    Field("max_volts", (_N,), "V", "motor voltage at full throttle"),
    Field("k_v", (_N,), "rev/s per V", "speed constant of the motor"),
    Field("k_t", (_N,), "N m/A", "torque constant of the motor"),
    Field("resistance", (_N,), "ohm", "of the motor's winding"),
    Field("no_load_current", (_N,), "A", "i_0 of the motor"),
    Field("throttles", (_N, ENGINE_THROTTLES), "throttle", "of the columns of an engine's tables"),
    Field("speeds", (_N, ENGINE_SPEEDS), "m/s", "axial airspeeds of the rows of an engine's tables"),
    Field("thrust_map", (_N, ENGINE_SPEEDS, ENGINE_THROTTLES), "scaled", "steady thrust of an engine"),
    Field("rising_map", (_N, ENGINE_SPEEDS, ENGINE_THROTTLES), "scaled", "its monotone part, to look a throttle up in"),
    Field("engine_lag", (_N,), "rad/s", "corner of the lag with which an engine follows its throttle"),
    Field("rise", (_N,), "1/s", "fastest increase of the throttle that an engine follows"),
    Field("fall", (_N,), "1/s", "fastest decrease of it"),
)  # fmt: skip
"""m: the design model f_m, B_m, and the actuators' own dynamics."""

SETTINGS = (
    Field("dt", (), "s", "control step"),
    Field("adapts", (), "flag", "estimate effectiveness and monitor it"),
    Field("estimates", (), "flag", "the estimates are logged: they are the law's, or of the diagnosis beside it"),
    Field("uncompensated", (), "flag", "references are not divided by the estimates"),
    Field("ideal_actuators", (), "flag", "positions are taken for the commands r / lambda_hat", "(10)"),
    Field("monitors", (), "flag", "flag actuators whose estimate is low", "section 2.3"),
    Field("tests_jams", (), "flag", "look for jammed, offset and reversed actuators"),
    Field("tests_offsets", (), "flag", "tell an offset of a surface from a jam"),
    Field("probes", (), "flag", "actuators that are given up are probed"),
    Field("guards", (), "flag", "readings that repeat themselves are not believed"),
    Field("weighted", (), "flag", "estimate with a Kalman gain in place of (13)"),
    Field("gamma", (_N,), "1/s", "adaptation rate", "(13)"),
    Field("epsilon", (_N,), "scaled", "half-width of g", "(14)"),
    Field("lambda_min", (), "1", "lower bound of the estimates"),
    Field("lambda_max", (), "1", "upper bound of the estimates"),
    Field("divisor_min", (), "1", "least lambda_hat by which r is divided", "section 2.2.1"),
    Field("filter_rate", (), "rad/s", "corner of the two lags on both sides of the regression; 0 for none"),
    Field("channel_rate", (), "rad/s", "k, corner of the low-pass in the control channel of `l1_inversion`"),
    Field("threshold", (), "1", "an actuator is flagged if its estimate stays below this", "section 2.3"),
    Field("threshold_rise", (_N,), "1", "added to `threshold` for a motor or engine, whose estimate is more certain"),
    Field("persistence", (), "s", "how long the estimate must stay below `threshold`", "section 2.3"),
    Field("recovery", (), "1", "a flag is removed when the estimate stays above this"),
    Field("recovery_time", (), "s", "how long the estimate must stay above `recovery`"),
    Field("flag_std_max", (), "1", "largest standard deviation of an estimate that may raise a flag"),
    Field("process_noise", (), "1/sqrt(s)", "of effectiveness, modelled as a random walk"),
    Field("forgetting_time", (), "s", "time constant of forgetting in recursive least squares"),
    Field("turns", (_N,), "flag", "a change of its position is told from gusts: of a surface, or thrust that turns the aircraft"),
    Field("noise", (4,), "x_c/sqrt(Hz)", "disturbance by gusts, root of its two-sided spectral density"),
    Field("model_error_std", (4,), "x_c", "standard deviation of the model error at the model's own trim"),
    Field("model_error_rate", (), "1/s", "one over the correlation time of the model's error"),
    Field("coefficient_error", (), "1", "relative error to expect of each coefficient of f_m and B_m"),
    Field("late_noise", (), "1/sqrt(s)", "process noise of lateness, modelled as a random walk"),
    *(
        Field(name, (), "as in `Loops`", f"gain of the {gain.axis} loops")
        for name, gain in LOOP_GAINS.items()
    ),
    Field("u_dot_max", (), "m/s2", "largest u_dot that airspeed may ask for"),
    Field("climb_max", (), "m/s", "largest climb rate that altitude may ask for"),
    Field("roll_max", (), "rad", "largest bank that heading may ask for"),
    Field("climb_kp", (), "1", "climb rate asked for beyond that wanted, for each m/s of its error"),
    Field("sink_time", (), "s", "time constant of the estimated sink of the air; 0 for none"),
    Field("give_up_time", (), "s", "time constant with which a regulator gives altitude up for airspeed"),
    Field("heading_error_max", (), "rad", "heading error is limited to this"),
    Field("altitude_error_max", (), "m", "altitude error is limited to this"),
    Field("airspeed_error_max", (), "m/s", "airspeed error is limited to this"),
)  # fmt: skip
"""c: what the control designer and the scenario chose."""

MODE = (
    Field("regulated", (), "flag", "the outer loop is the mode's regulator, because axes are released"),
    Field("available", (_N,), "flag", "the actuator is used; a failed one is not"),
    Field("released", (4,), "flag", "the rate is given up", "section 2.3"),
    Field("B_hat_inv", (_N, 4), "scaled per x_c", "inverse of the modified input matrix", "(29)"),
    Field("row_weight", (4,), "1 per x_c^2", "weight of each kept rate in the allocation; 0 if released"),
    Field("hessian", (_N, _N), "1 per scaled^2", "B' diag(row_weight) B + deviation weight, of the allocation"),
    Field("slow_descent", (), "s", "altitude to give up per m/s beyond `slow_descent_from`"),
    Field("slow_descent_from", (), "m/s", "missing airspeed at which altitude begins to be given up"),
    Field("glides", (), "flag", "thrust cannot be commanded: pitch holds airspeed, and altitude only while there is energy"),
    Field("fast_climb", (), "s", "altitude to gain per m/s above `airspeed_too_fast`, 0 for none"),
    Field("airspeed_offset", (), "m/s", "how much faster than its reference the mode is flown"),
    Field("airspeed_low", (), "m/s", "lowest airspeed that the mode is flown at"),
    Field("airspeed_high", (), "m/s", "highest airspeed that the mode is flown at"),
    Field("airspeed_too_fast", (), "m/s", "airspeed above which the mode has no level flight with a margin"),
    Field("r_trim", (_N,), "scaled", "position at the mode's own trim"),
    Field("trim_effect", (_N,), "scaled", "r_trim, of surfaces times (V/V_0)^2 of that trim"),
    Field("x_trim", (_X,), "m/s, rad, rad/s, m", "state at the mode's own trim, by REGULATOR_STATE"),
    Field("K", (4, _X), "x_c per state", "regulator gains on the state"),
    Field("K_actuator", (4, _N), "x_c per scaled unit", "regulator gains on the actuators' effective positions"),
    Field("K_integral", (4, len(INTEGRALS)), "x_c per integral", "regulator gains on the integrals"),
)  # fmt: skip
"""k: the control mode in force: which actuators are used, and the modified inverse."""

MEMORY = (
    Field("lambda_hat", (_N,), "1", "effectiveness estimates; for a jammed actuator its estimated position [scaled]", "(13)"),
    Field("r", (_N,), "scaled", "reference actuator position", "(6), (29)"),
    Field("u", (_N,), "scaled", "commanded position, r / lambda_hat within the stops", "section 2.2.1"),
    Field("correction", (_N,), "scaled", "v, what the control channel of `l1_inversion` adds to r"),
    Field("x_dc_dot", (4,), "x_c", "desired rates", "(6)"),
    Field("command", (_N,), "rad or throttle", "last command"),
    Field("position", (_N,), "scaled", "a, modelled position: servo deflection or thrust if fully effective"),
    Field("servo_input", (_N,), "scaled", "command of the step before, for the bilinear lag"),
    Field("servo_lagged", (_N,), "scaled", "output of the servo's lag, before rate limit and stops"),
    Field("rotor", (_N,), "rev/s", "modelled rotor speed"),
    Field("followed", (_N,), "throttle", "throttle that an engine has followed so far"),
    Field("torque", (_N,), "N m", "modelled motor torque"),
    Field("failed", (_N,), "flag", "the actuator is flagged: lost, held or reversed", "section 2.3"),
    Field("flag_timer", (_N,), "s", "how long the estimate has been beyond threshold or recovery"),
    Field("early", (_N,), "flag", "the flag was the first, and may be taken back; the next then waits (`loss_detection`)"),
    Field("lambda_slow", (_N,), "1", "slow estimate: `lambda_hat` through a lag of `evidence.SLOW_S`"),
    Field("since_flag", (_N,), "s", "time since the flag was set or taken back, or the actuator taken for jammed"),
    Field("jammed", (_N,), "flag", "the force of the actuator does not follow its command, so its position is estimated"),
    Field("pitch_beyond_stop", (), "rad/s2", "what the last allocation left of q_dot for the stop of its strongest surface"),
    Field("saturated", (), "flag", "in the last step an actuator would have had to pass a stop"),
    Field("jam_timer", (_N,), "s", "how long the actuator has looked jammed"),
    Field("designed_position", (_N,), "scaled", "position of a jammed actuator that the mode was designed for"),
    Field("jammed_at", (_N,), "scaled", "position from which a jammed actuator may turn out to be reversed"),
    Field("reversed", (_N,), "flag", "the force of the actuator follows minus its command"),
    Field("moved", (_N,), "scaled", "how far an actuator has moved from its command, at V_0, as seen at first; 0 for others"),
    Field("offset_timer", (_N,), "s", "how long it was sure that what has moved follows its command, less how long it was not"),
    Field("shift", (_N,), "scaled", "offset that commands make up for: of an actuator that has moved"),
    Field("beside", (4,), "x_c", "`b` less the force of surfaces that have moved"),
    Field("repeated", (len(GUARDED),), "s", "how long each of GUARDED has read the same"),
    Field("last_reading", (len(GUARDED),), "rad, m/s, rad/s", "what each of them read in the last step"),
    Field("stuck", (len(GUARDED),), "flag", "each of them is taken for stuck"),
    Field("inertial_airspeed", (), "m/s", "airspeed by the forward acceleration, while the pitot tube is stuck"),
    Field("modelled_sideslip", (), "rad", "sideslip in still air by the design model's side force, while its vane is stuck"),
    Field("last_attitude", (3,), "rad", "roll, pitch and heading in the last step"),
    Field("attitude_rate", (3,), "rad/s", "p, q and r that their changes show"),
    Field("attitude_dot", (3,), "rad/s2", "how fast those change"),
    Field("lagged_rate", (3,), "rad/s", "those rates through one lag of the regression"),
    Field("probe", (_N,), "scaled", "position beyond its trim to which one that is given up is commanded"),
    Field("filtered_position", (2, _N), "scaled", "state of the two lags of the regression on the modelled position"),
    Field("probe_mean", (_N,), "scaled", "mean of that position"),
    Field("probe_rest", (_N, 4), "x_c", "mean of what the other actuators leave of each rate"),
    Field("works", (_N,), "1", "logarithm of the likelihood ratio of a gain of 1 of its moves to none, summed up from 0"),
    Field("at_stop", (_N,), "flag", "in the last allocation at a stop: -1 at the lower, 1 at the upper, 0 at none"),
    Field("late", (_N,), "1", "how late the actuator acts after its model, in time constants of the filter"),
    Field("late_variance", (_N,), "1", "variance of `late`"),
    Field("late_rate", (_N, 2, 4), "x_c", "rate of filtered columns of Phi over the corner, after one and two lags of `late`"),
    Field("recent", (4,), "x_c", "running mean of the innovation e - b, with time constant `CHANGE_TIME_S`"),
    Field("b", (4,), "x_c", "estimate of the model's error: what f_m and B_m leave out of each rate"),
    Field("model_error_variance", (4,), "x_c^2", "variance of b that is expected"),
    Field("P", ("n+4", "n+4"), "1, scaled, x_c", "covariance of (lambda_hat, b)"),
    Field("filtered", (2, 4), "x_c", "state of the two lags on z, the left side of the regression"),
    Field("filtered_phi", (2, 4, _N), "x_c", "state of the two lags on Phi"),
    Field("airspeed_integral", (), "m/s2", "integral term of the airspeed loop"),
    Field("climb_wanted", (), "m/s", "climb rate of the reference, through the lag with which the flight path is to follow"),
    Field("pitch_integral", (), "rad", "integral term of the altitude loop; at first the trim's pitch"),
    Field("heading_integral", (), "rad/s", "integral term of the heading loop"),
    Field("sideslip_integral", (), "rad/s", "integral term of the sideslip loop"),
    Field("sink", (), "m/s", "estimated sink of the air"),
    Field("given_up", (), "m", "altitude that is given up for airspeed"),
    Field("integral", (len(INTEGRALS),), "m, m s, rad s", "integrals of the regulator, by INTEGRALS"),
)  # fmt: skip
"""s: what the law remembers from step to step."""

WORK = (
    Field("f", (4,), "x_c", "f_m at the measured state", "(2)"),
    Field("z", (4,), "x_c", "x_c_dot - f_m, as measured", "(10)"),
    Field("e", (4,), "x_c", "measured error z - Phi lambda_hat", "(10)"),
    Field("nu", (4,), "x_c", "virtual control, the bracket [x_dc_dot - f_m]", "(6), (29)"),
    Field("phi", (4, _N), "x_c", "Phi = B_m diag(a): effect of each actuator if fully effective", "(12)"),
    Field("weight", (4,), "1 per x_c^2", "one over the variance of the mean innovation of each rate"),
    Field("P_h", ("n+4",), "1, scaled, x_c", "P times a row of (Phi, I), in the Kalman update"),
    Field("d", (_N,), "scaled", "effective positions beyond the mode's trim, in the allocation"),
    Field("g", (_N,), "1 per scaled", "right-hand side of the allocation's normal equations"),
    Field("low", (_N,), "scaled", "lower stop of d"),
    Field("high", (_N,), "scaled", "upper stop of d"),
    Field("factor", (_N, _N), "1 per scaled", "Cholesky factor, in the allocation"),
    Field("step", (_N,), "scaled", "change of d, in the allocation"),
)  # fmt: skip
"""w: working memory of one step, so that nothing is allocated in flight."""


@cache
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


model_dtype, settings_dtype, mode_dtype, memory_dtype, work_dtype = (
    partial(_dtype, table) for table in (MODEL, SETTINGS, MODE, MEMORY, WORK)
)
"""Dtype of each record for n actuators. It is made once: numba recognises the types of a call by their dtype objects."""
