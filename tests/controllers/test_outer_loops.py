"""Outer loops: zero at the trim, each through its own rate, limited; the regulator against its matrix form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vtail_setup import PAPER, WEATHER, records_of, setpoint, trim_state, vtail_setup

from testbed.aircraft.design_model import COLUMNS, ROWS
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.outer_loops import (
    accumulate,
    clip,
    given_up,
    left_to_thrust,
    pid_loops,
    regulate,
    traded,
    wrap,
)
from testbed.controllers.records import P_DOT, Q_DOT, R_DOT, REGULATOR_STATE, U_DOT
from testbed.controllers.scaling import PATH_LAG_S

SETUP = vtail_setup()
MODEL = SETUP.model
LEVEL = {"altitude": MODEL.altitude_m, "airspeed": MODEL.airspeed_m_s}


def desired(reference: dict[str, float], **state: float) -> np.ndarray:
    """x_dc_dot of one step of the paper's loops at the trim, with these changes."""
    m, c, k, s, w = records_of(SETUP)
    w.f[:] = [0.1, 0.2, 0.3, 0.4]
    pid_loops(trim_state(MODEL, **state), setpoint(**{**LEVEL, **reference}), m, c, k, s, w.f, w.nu)
    assert w.nu == pytest.approx(s.x_dc_dot - w.f), "nu is the bracket of (29)"
    return np.array(s.x_dc_dot)


def test_on_its_references_nothing_is_asked() -> None:
    assert desired({}) == pytest.approx(np.zeros(4), abs=1e-12)


@pytest.mark.parametrize(
    ("reference", "through"),
    [({"airspeed": 18.5}, U_DOT), ({"altitude": 301.0}, Q_DOT), ({"heading": 0.1}, P_DOT)],
)
def test_each_error_is_flown_through_its_own_rate(reference: dict[str, float], through: int) -> None:
    asked = desired(reference)
    assert asked[through] > 0.0
    assert np.delete(asked, through) == pytest.approx(np.zeros(3), abs=1e-12)


def test_sideslip_is_turned_into_and_the_cascade_has_its_gains() -> None:
    loops = SETUP.control.loops
    asked = desired({}, beta=0.05)
    integral = loops.sideslip_ki * 0.05 * SETUP.dt_s
    assert asked[R_DOT] == pytest.approx(loops.r_kp * (loops.sideslip_kp * 0.05 + integral))
    assert desired({}, p=0.2)[P_DOT] == pytest.approx(-loops.p_kp * 0.2)
    assert desired({}, q=0.2)[Q_DOT] == pytest.approx(-loops.q_kp * 0.2)


def test_a_coordinated_turn_is_steady() -> None:
    """At the bank, pitch rate and yaw rate of a level turn the loops ask for no rotation."""
    rate, v = 0.1, MODEL.airspeed_m_s
    bank = math.atan(v * rate / GRAVITY_M_S2)
    pitch = MODEL.alpha_rad
    r = GRAVITY_M_S2 / v * math.sin(bank) * math.cos(pitch)
    q = GRAVITY_M_S2 / v * math.tan(bank) * math.sin(bank)
    asked = desired({"heading_rate": rate}, roll=bank, q=q, r=r)
    assert asked[[P_DOT, Q_DOT, R_DOT]] == pytest.approx(np.zeros(3), abs=1e-9)


def test_errors_and_demands_are_limited() -> None:
    loops = SETUP.control.loops
    far = desired({"airspeed": 99.0, "heading": 3.0})
    assert far[U_DOT] == loops.u_dot_max
    assert far[P_DOT] == pytest.approx(desired({"heading": math.radians(loops.heading_error_max_deg)})[P_DOT])


def test_the_heading_is_reached_the_short_way() -> None:
    right, left = (
        desired({"heading": 0.1}, heading=2.0 * math.pi - 0.1),
        desired({"heading": 6.1}, heading=0.1),
    )
    assert right[P_DOT] > 0.0 > left[P_DOT]
    assert wrap(3.5) == pytest.approx(3.5 - 2.0 * math.pi)


def test_clip() -> None:
    assert [clip(x, 2.0) for x in (-3.0, -1.0, 0.0, 1.0, 3.0)] == [-2.0, -1.0, 0.0, 1.0, 2.0]


def test_an_integral_neither_winds_up_nor_latches() -> None:
    """Within its limit an error integrates; at it, only back towards zero, and no faster than at the limit."""
    assert accumulate(3.0, 1.5, 2.0, 0.1) == pytest.approx(3.15)
    assert accumulate(3.0, 2.0, 2.0, 0.1) == 3.0
    assert accumulate(0.0, -2.0, 2.0, 0.1) == 0.0
    assert accumulate(-45.0, 100.0, 5.0, 0.1) == pytest.approx(-44.5)
    assert accumulate(3.0, 9.0, 2.0, 0.1, True) == pytest.approx(3.2), "with nothing at a stop it may wind"


def test_the_regulator_is_its_state_feedback() -> None:
    """nu = -K dx - K_a da - K_i integral in matrices, about a trim that is not the reference's."""
    rng = np.random.default_rng(5)
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    c.sink_time = 0.0
    k.K[:], k.K_actuator[:], k.K_integral[:] = (
        rng.normal(size=x.shape) for x in (k.K, k.K_actuator, k.K_integral)
    )
    k.x_trim[:], k.r_trim[:], k.trim_effect[:] = 0.1 * rng.normal(size=10), *rng.normal(size=(2, 4))
    k.airspeed_offset, k.available[:] = 0.5, [1, 1, 0, 1]
    s.position[:], s.lambda_hat[:], s.integral[:] = (
        rng.normal(size=4),
        rng.uniform(0.2, 1.0, 4),
        [0.3, -0.2, 0.1],
    )
    w.f[:] = rng.normal(size=4)
    changes = dict(zip(REGULATOR_STATE, 0.05 * rng.normal(size=10), strict=True))
    ref = setpoint(**{**LEVEL, "heading": 0.02, "altitude_rate": 0.7, "heading_rate": 0.05})
    y = trim_state(MODEL, **{**changes, "airspeed": 18.3, "altitude": 300.4})
    regulate(y, ref, m, c, k, s, w.f, w.nu)

    bank = math.atan(y.airspeed * ref.heading_rate / GRAVITY_M_S2)
    target = k.x_trim.copy()
    target[0], target[8], target[9] = 18.5, 0.02, MODEL.altitude_m
    target[3:6] = 0.0, ref.heading_rate * math.sin(bank), ref.heading_rate * math.cos(bank)
    target[6] += bank
    target[7] += 0.7 / y.airspeed
    dx = np.array([y[name] for name in REGULATOR_STATE]) - target
    integral = np.array([0.3, -0.2, 0.1]) + SETUP.dt_s * dx[[0, 9, 8]]
    da = s.position * s.lambda_hat - k.r_trim
    assert s.integral == pytest.approx(integral)
    assert w.nu == pytest.approx(-k.K @ dx - k.K_actuator @ da - k.K_integral @ integral)
    assert s.x_dc_dot == pytest.approx(w.f + w.nu + m.B @ (k.trim_effect * k.available))
    s.jammed[2] = 1
    regulate(y, ref, m, c, k, s, w.f, w.nu)
    assert s.x_dc_dot == pytest.approx(w.f + w.nu + m.B @ k.trim_effect), (
        "a jammed actuator has its force too"
    )


def test_an_aircraft_that_is_too_fast_for_a_jam_climbs_and_does_not_descend() -> None:
    """At 0.4 m/s too fast, 60 % of an altitude that is too high still counts; at 1 m/s or more, none."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:] = 0.0, 0.0, 0.0
    k.K[0, 9] = -1.0  # nu of the first row is the altitude error that the regulator sees
    k.fast_climb = 0.5
    k.airspeed_high = k.airspeed_too_fast = MODEL.airspeed_m_s - 4.0
    for excess, height, altitude_error in (
        (0.0, 2.0, 2.0),
        (0.4, 2.0, 1.0),
        (3.0, 2.0, -1.5),
        (3.0, -1.0, -2.5),
    ):
        y = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - 4.0 + excess, altitude=MODEL.altitude_m + height)
        k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
        regulate(y, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        assert w.nu[0] == pytest.approx(altitude_error)


@pytest.mark.parametrize(
    ("airspeed", "height", "too_fast"),
    [
        (18.0, 0.0, 0.0),  # as fast as its reference, at its altitude: it stays there
        (16.0, 0.0, 0.0),  # slower, but faster than its glide: it stays there too
        (16.0, 1.0, -0.6016),  # 1 m too high: by hand, sqrt(16^2 + 2 g) is 16.6016
        (16.0, -1.0, 0.6251),  # 1 m too low: sqrt(16^2 - 2 g) is 15.3749
        (14.0, 0.0, -1.0),  # slower than its glide: altitude is given up
        (13.0, -50.0, -2.0),
        (18.0, 50.0, 0.0),  # far too high: never faster than the reference
    ],
)
def test_a_glide_stays_at_its_altitude_as_long_as_it_is_fast(
    airspeed: float, height: float, too_fast: float
) -> None:
    """Without it a glide of 15 m/s that begins at 18 m/s climbs by 5 m."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:], c.airspeed_error_max = 0.0, 0.0, 0.0, 9.0
    k.K[1, 0] = -1.0  # nu of the second row is the airspeed error that the regulator sees
    k.glides, k.airspeed_low, k.airspeed_high = 1, 15.0, 15.0
    y = trim_state(MODEL, airspeed=airspeed, altitude=MODEL.altitude_m + height)
    k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
    regulate(y, setpoint(**{**LEVEL, "airspeed": 18.0}), m, c, k, s, w.f, w.nu)
    assert w.nu[1] == pytest.approx(too_fast, abs=1e-4)


def test_however_fast_it_is_it_climbs_as_for_the_largest_altitude_error() -> None:
    m, c, k, s, _ = records_of(SETUP)
    k.fast_climb, k.airspeed_too_fast = 0.5, MODEL.airspeed_m_s
    for fast, height in ((2.0, -1.0), (100.0, -c.altitude_error_max)):
        y = trim_state(MODEL, airspeed=MODEL.airspeed_m_s + fast)
        assert traded(0.0, MODEL.airspeed_m_s, y, m, c, k, s) == pytest.approx(height)


def test_too_much_airspeed_does_not_wind_up_before_a_slow_trim() -> None:
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    for fast_climb, before, grows in ((0.5, 0.0, False), (0.5, -1.0, True), (0.0, 0.0, True)):
        k.fast_climb, s.integral[0] = fast_climb, before
        regulate(
            trim_state(MODEL, airspeed=MODEL.airspeed_m_s + 1.0), setpoint(**LEVEL), m, c, k, s, w.f, w.nu
        )
        assert (s.integral[0] > before) == grows


def test_beyond_the_stall_the_nose_goes_down() -> None:
    """By hand: 0.01 rad beyond the stall asks for 4 pitch_kp q_kp 0.01 rad/s2 more, nose down, and nothing else."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:], c.sink_time = 0.0, 0.0, 0.0, 0.0
    for beyond in (-0.01, 0.01):
        y = trim_state(MODEL, alpha=MODEL.stall_alpha_rad + beyond)
        regulate(y, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        wanted = -0.04 * c.pitch_kp * c.q_kp if beyond > 0.0 else 0.0
        assert w.nu == pytest.approx([0.0, wanted, 0.0, 0.0])


@pytest.mark.parametrize(("settings", "pulls"), [(WEATHER, True), (PAPER, False)])
def test_below_the_angle_of_no_lift_the_nose_goes_up_but_in_the_preset_of_the_paper(
    settings: AdaptiveInversionSettings, pulls: bool
) -> None:
    """By hand: the lift of 1 g is g over its slope of angle; 0.01 rad below no lift pulls as much as the stall pushes."""
    m, c, k, s, w = records_of(vtail_setup(settings, released=()))
    lift = -MODEL.derivatives[ROWS.index("w_dot")][COLUMNS.index("alpha")]
    no_lift = MODEL.alpha_rad - GRAVITY_M_S2 / lift
    assert -0.1 < no_lift < 0.0 < MODEL.alpha_rad
    asked = []
    for beyond in (0.01, -0.01):
        pid_loops(trim_state(MODEL, alpha=no_lift + beyond), setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        asked.append(float(s.x_dc_dot[Q_DOT]))
    assert asked[1] - asked[0] == pytest.approx(0.04 * c.pitch_kp * c.q_kp if pulls else 0.0)


@pytest.mark.parametrize(
    ("e_speed", "beyond_m", "left"),
    [
        (-2.0, 0.0, -2.0),
        (-2.0, 1.0, -1.0),
        (-2.0, 5.0, 0.0),
        (-2.0, -5.0, -2.0),
        (2.0, -1.0, 1.0),
        (2.0, 5.0, 2.0),
    ],
)
def test_airspeed_whose_energy_altitude_has_is_not_left_to_thrust(
    e_speed: float, beyond_m: float, left: float
) -> None:
    """At g m/s a metre is worth 1 m/s. Only what is beyond the limit of altitude errors counts."""
    _, c, *_ = records_of(vtail_setup(WEATHER))
    high = (
        beyond_m + math.copysign(c.altitude_error_max, beyond_m) if beyond_m else 0.9 * c.altitude_error_max
    )
    found = left_to_thrust(e_speed, high, trim_state(MODEL, airspeed=GRAVITY_M_S2), c)
    assert found == pytest.approx(left)


def test_an_aircraft_that_gives_up_altitude_asks_for_more_than_the_largest_u_dot() -> None:
    """A healthy OV-10, whose largest u_dot is 0.15 m/s2, was throttled down 25 m/s below its reference, and stalled."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER, released=()))
    for missing in (k.slow_descent_from, k.slow_descent_from + 3.0):
        slow = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - missing)
        c.u_dot_max, s.airspeed_integral = 0.1, 0.0
        pid_loops(slow, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        assert s.x_dc_dot[U_DOT] == pytest.approx(0.1 + c.airspeed_kp * (missing - k.slow_descent_from))


@pytest.mark.parametrize("sink", [0.0, 2.0])
def test_sinking_air_is_met_with_pitch_and_thrust_while_all_motors_work(sink: float) -> None:
    """After many time constants pitch is asked for by sink / V, and thrust for the weight along that slope. Two negative controls:
    still air, and a motor that has failed."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:] = 0.0, 0.0, 0.0
    k.K[1, 7] = 1.0
    k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
    y = trim_state(MODEL, climb_rate=-sink)
    for _ in range(round(10.0 * c.sink_time / c.dt)):
        regulate(y, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    slope = sink / MODEL.airspeed_m_s
    assert w.nu == pytest.approx([0.0, slope, 0.0, GRAVITY_M_S2 * slope], abs=1e-4)
    k.available[2] = 0
    regulate(y, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    assert w.nu == pytest.approx(np.zeros(4), abs=1e-12) and s.sink == 0.0


def test_a_slow_wing_is_made_to_follow_by_more_pitch() -> None:
    """With `climb_kp` 1 a climb rate that is 1 m/s too low asks for 1 m/s of path more, and none where it is as wanted."""
    m, c, k, s, w = records_of(SETUP)
    asked = []
    for kp in (0.0, 1.0):
        c.climb_kp = kp
        s.pitch_integral = MODEL.alpha_rad
        pid_loops(trim_state(MODEL, climb_rate=-1.0), setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        asked.append(float(s.x_dc_dot[Q_DOT]))
    assert asked[1] - asked[0] == pytest.approx(c.q_kp * c.pitch_kp / MODEL.airspeed_m_s)


def test_a_climb_that_begins_is_no_climb_rate_that_is_missing() -> None:
    """Its rate alone is asked for at once, and after many lags the path that does not follow is asked for more. A T-38 whose climb
    ended threw its elevator by 8 deg, which was then taken for reversed."""
    m, c, k, s, w = records_of(SETUP)
    c.climb_kp, c.altitude_kp = 3.0, 0.0
    asked = []
    for steps in (1, round(20.0 * PATH_LAG_S / c.dt)):
        for _ in range(steps):
            s.pitch_integral = MODEL.alpha_rad
            pid_loops(trim_state(MODEL), setpoint(**LEVEL | {"altitude_rate": 1.0}), m, c, k, s, w.f, w.nu)
        asked.append(float(s.x_dc_dot[Q_DOT]) * MODEL.airspeed_m_s / (c.q_kp * c.pitch_kp))
    assert asked == pytest.approx([1.0, 4.0], abs=0.03)


def test_an_error_beyond_the_climb_limit_does_not_wind_up_pitch() -> None:
    m, c, k, s, w = records_of(SETUP)
    for error, integrated in ((1.0, 1.0), (100.0, c.climb_max / c.altitude_kp)):
        s.pitch_integral = 0.0
        altitude = MODEL.altitude_m - min(error, c.altitude_error_max)
        pid_loops(trim_state(MODEL, altitude=altitude), setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        assert s.pitch_integral == pytest.approx(c.altitude_ki * integrated * c.dt)


@pytest.mark.parametrize(
    ("settings", "missing", "waits"), [(WEATHER, 1.0, True), (WEATHER, -1.0, False), (PAPER, 1.0, False)]
)
def test_the_integral_of_altitude_waits_while_the_elevator_is_at_its_stop(
    settings: AdaptiveInversionSettings, missing: float, waits: bool
) -> None:
    """Too low, it asks for more pitch than there is; too much pitch may be taken back, and the preset winds up."""
    m, c, k, s, w = records_of(vtail_setup(settings, released=()))
    s.pitch_beyond_stop, before = missing, float(s.pitch_integral)
    pid_loops(trim_state(MODEL, altitude=MODEL.altitude_m - 1.0), setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    assert (s.pitch_integral == before) == waits


def test_an_aircraft_that_is_too_slow_gives_up_altitude() -> None:
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:] = 0.0, 0.0, 0.0
    k.K[0, 9] = -1.0  # nu of the first row is the altitude error that the regulator sees
    k.slow_descent, k.slow_descent_from, c.give_up_time = 2.0, 1.5, 0.0
    for missing, altitude_error in ((1.0, 0.0), (1.5, 0.0), (2.5, 2.0)):
        y = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - missing)
        k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
        regulate(y, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
        assert w.nu[0] == pytest.approx(altitude_error)


@pytest.mark.parametrize(
    ("settings", "missing", "given_m"), [(WEATHER, 4.0, 4.0), (WEATHER, 1.0, 0.0), (PAPER, 4.0, 0.0)]
)
def test_the_loops_of_the_paper_give_up_altitude_but_in_its_preset(
    settings: AdaptiveInversionSettings, missing: float, given_m: float
) -> None:
    """2 m for each m/s beyond the 2 m/s of V/9: what is asked is what an aircraft so much higher asks for."""
    m, c, k, s, w = records_of(vtail_setup(settings, released=()))
    c.altitude_ki = 0.0
    slow = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - missing)
    for _ in range(round(10.0 * max(c.give_up_time, c.dt) / c.dt)):
        pid_loops(slow, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    asked, c.give_up_time = float(s.x_dc_dot[Q_DOT]), 0.0
    higher = trim_state(MODEL, airspeed=MODEL.airspeed_m_s - missing, altitude=MODEL.altitude_m + given_m)
    pid_loops(higher, setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    assert asked == pytest.approx(float(s.x_dc_dot[Q_DOT]), abs=1e-3)
    assert (asked < -1e-2) == (given_m > 0.0)


@pytest.mark.parametrize(("commanded", "given_m"), [(0.0, 2.0), (6.0, 2.0), (-1.0, 0.0)])
def test_no_altitude_is_given_up_for_an_airspeed_above_that_of_the_design(
    commanded: float, given_m: float
) -> None:
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:] = 0.0, 0.0, 0.0
    k.K[0, 9] = -1.0
    k.slow_descent, k.slow_descent_from, c.give_up_time = 2.0, 1.5, 0.0
    k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
    ref = setpoint(**{**LEVEL, "airspeed": MODEL.airspeed_m_s + commanded})
    regulate(trim_state(MODEL, airspeed=MODEL.airspeed_m_s - 2.5), ref, m, c, k, s, w.f, w.nu)
    assert w.nu[0] == pytest.approx(given_m)


def test_altitude_is_given_up_with_a_lag() -> None:
    """A first-order lag: after its time constant 63 % of a step. The paper's preset has none."""
    _, c, _, s, _ = records_of(vtail_setup(WEATHER))
    for _ in range(round(c.give_up_time / c.dt)):
        given_up(2.0, c, s)
    assert s.given_up == pytest.approx(2.0 * (1.0 - math.exp(-1.0)), rel=1e-2)
    assert given_up(20.0, c, s) == 20.0 - 0.5 * c.altitude_error_max, "much is given up at once"
    _, c, _, s, _ = records_of(vtail_setup(PAPER))
    assert given_up(3.0, c, s) == 3.0 and given_up(0.0, c, s) == 0.0


def test_no_altitude_is_given_up_for_an_airspeed_that_a_jam_asks_for() -> None:
    """A propeller at full thrust needs 25 m/s. At 18 m/s the airspeed error counts, and the altitude error is zero."""
    m, c, k, s, w = records_of(vtail_setup(WEATHER))
    k.K[:], k.K_actuator[:], k.K_integral[:] = 0.0, 0.0, 0.0
    k.K[0, 9] = k.K[3, 0] = -1.0
    k.slow_descent, c.give_up_time, k.airspeed_low = 2.0, 0.0, 25.0
    k.x_trim[1], k.x_trim[7] = MODEL.alpha_rad, MODEL.alpha_rad
    regulate(trim_state(MODEL), setpoint(**LEVEL), m, c, k, s, w.f, w.nu)
    assert w.nu[0] == 0.0 and w.nu[3] == pytest.approx(-c.airspeed_error_max)
