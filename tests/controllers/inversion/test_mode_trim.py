"""Trims of degraded modes: nothing accelerates, within the stops; which is chosen after a jam; what has no trim."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import WEATHER, vtail_setup

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel, load_design_model
from testbed.controllers.inversion import mode_trim
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft, motion
from testbed.controllers.inversion.mode_trim import (
    NoSteadyFlight,
    airspeed_range,
    lost_thrust,
    margins,
    steady_flight,
)
from testbed.controllers.inversion.modes import Mode, enumerate_modes
from testbed.controllers.inversion.steady_flights import (
    SteadyFlight,
    at_path_angles,
    path_angles,
)
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, PITCH, REGULATOR_STATE, ROLL
from testbed.controllers.setup import Setup

SETUP = vtail_setup()
MODEL = SETUP.model
V = MODEL.airspeed_m_s
LOOPS = SETUP.control.loops


def remaining(*failed: int, jammed: dict[int, float] | None = None, setup: Setup = SETUP) -> DegradedAircraft:
    mode = enumerate_modes(setup.model, setup.scale, setup.control)[failed]
    return DegradedAircraft.after(setup, mode, jammed or {})


def assert_steady(degraded: DegradedAircraft, flight: SteadyFlight, path_angle: float = 0.0) -> None:
    """Nothing but heading and altitude changes, and the altitude by the path angle."""
    rates = degraded.motion(flight.state, flight.positions)
    assert rates[:9] == pytest.approx(np.zeros(9), abs=1e-7)
    assert rates[9] == pytest.approx(flight.state[0] * math.sin(path_angle), abs=1e-6)


def test_with_nothing_failed_it_is_the_reference_trim() -> None:
    flight, held = steady_flight(remaining(), LOOPS, "")
    assert flight.state[[0, ALPHA, PITCH]] == pytest.approx([V, MODEL.alpha_rad, MODEL.alpha_rad], abs=1e-6)
    assert flight.positions * SETUP.scale == pytest.approx(MODEL.trim, rel=1e-5)
    assert held == ("airspeed", "altitude", "heading")


@pytest.mark.parametrize("failed", [(), (0,), (1,), (2,), (3,), (0, 2), (0, 3), (0, 1), (2, 3)])
def test_a_trim_is_steady_within_the_stops(failed: tuple[int, ...]) -> None:
    degraded = remaining(*failed)
    flight, held = steady_flight(degraded, LOOPS, "")
    gamma = 0.0 if "altitude" in held else flight.state[PITCH] - flight.state[ALPHA]
    rates = degraded.motion(flight.state, flight.positions)
    assert rates[:9] == pytest.approx(np.zeros(9), abs=1e-6)
    assert rates[9] == pytest.approx(flight.state[AIRSPEED] * math.sin(gamma) if gamma else 0.0, abs=0.3)
    inside = mode_trim._BEYOND_STOPS * degraded.limits
    assert np.all((flight.positions >= inside[:, 0]) & (flight.positions <= inside[:, 1]))
    assert flight.positions[list(failed)] == pytest.approx((np.array(MODEL.trim) / SETUP.scale)[list(failed)])


def test_margins_are_to_the_nearest_stop_or_angle() -> None:
    """By hand, at the reference trim: angles count 0.1 rad a unit, stops one scaled unit."""
    degraded = remaining(0)
    flight, _ = steady_flight(degraded, LOOPS, "")

    def margin(stop_factor: float = 1.0, position: float | None = None, **changes: float) -> float:
        state, positions = flight.state.copy(), flight.positions.copy()
        for name, value in changes.items():
            state[REGULATOR_STATE.index(name)] = value
        positions[1] = positions[1] if position is None else position
        return float(margins(degraded, SteadyFlight(state[None], positions[None]), stop_factor)[0])

    top = degraded.limits[1, 1]
    assert margin(position=top - 0.3) == pytest.approx(0.3)
    assert margin(position=top + 0.1) == pytest.approx(-0.1)
    assert margin(position=top + 0.1, stop_factor=1.3) == pytest.approx(0.3 * top - 0.1)
    assert margin(alpha=MODEL.stall_alpha_rad - 0.02) == pytest.approx(0.2)
    assert margin(beta=-0.41) == pytest.approx(-0.1) == margin(beta=0.41)
    assert margin(position=0.0, airspeed=0.6 * V) < margin(position=0.0), "a slow propeller brakes less"
    assert margin(position=top - 0.3, airspeed=0.9 * V) == pytest.approx(0.27), (
        "a slow surface has less to oppose a gust"
    )


def test_a_newton_of_thrust_is_worth_less_when_fast_and_no_more_when_slow() -> None:
    degraded = remaining(0)
    flight, _ = steady_flight(degraded, LOOPS, "")

    def margin(airspeed: float) -> float:
        state, positions = flight.state.copy(), flight.positions.copy()
        state[AIRSPEED], positions[3] = airspeed, degraded.limits[3, 1] - 0.4
        return float(margins(degraded, SteadyFlight(state[None], positions[None]))[0])

    assert margin(1.1 * V) == pytest.approx(0.4 / 1.1)
    assert margin(V) == pytest.approx(0.4) == margin(0.9 * V)
    assert margin(1.5 * V) < 0.0, "full throttle gives less than this"


JAMS = [(i, share) for i in range(4) for share in (0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0)]


@pytest.mark.parametrize(("jammed", "share"), JAMS)
def test_every_jam_from_stop_to_stop_has_a_steady_flight(jammed: int, share: float) -> None:
    low, high = SETUP.limits[jammed]
    degraded = remaining(jammed, jammed={jammed: low + share * (high - low)})
    flight, held = steady_flight(degraded, LOOPS, "")
    angle = math.asin(degraded.motion(flight.state, flight.positions)[9] / flight.state[0])
    assert_steady(degraded, flight, angle)
    assert ("altitude" in held) == (abs(angle) < 1e-6)
    (margin,) = margins(degraded, SteadyFlight(*(x[None] for x in flight)))
    assert margin > 0.0


def test_a_tail_jammed_up_flies_slower_and_one_jammed_down_faster_or_climbs() -> None:
    """Speeds and path angles as a search on JSBSim itself finds them: see `benchmarks/jam_trims.py`."""
    scaled = math.radians(1.0) / SETUP.scale[0]
    up, _ = steady_flight(remaining(0, jammed={0: -25.8 * scaled}), LOOPS, "")
    down, _ = steady_flight(remaining(0, jammed={0: 15.0 * scaled}), LOOPS, "")
    stop, held = steady_flight(remaining(0, jammed={0: 25.8 * scaled}), LOOPS, "")
    assert 11.5 < up.state[AIRSPEED] < 13.5 and down.state[AIRSPEED] > V + 1.5
    assert held == ("airspeed", "heading") and stop.state[PITCH] - stop.state[ALPHA] > 0.06


def test_a_jam_near_the_trim_changes_no_airspeed() -> None:
    degraded = remaining(0, jammed={0: SETUP.model.trim[0] / SETUP.scale[0]})
    assert steady_flight(degraded, LOOPS, "")[0].state[AIRSPEED] == pytest.approx(V)


def test_a_jam_that_level_flight_meets_only_in_a_stall_is_not_flown_level() -> None:
    """Right surface lost, right propeller jammed at 6.1 N: the level trim would be at 9.8 m/s and 16 deg of alpha."""
    flight, held = steady_flight(remaining(1, 3, jammed={3: 3.038}), LOOPS, "")
    assert held == ("airspeed", "heading") and flight.state[ALPHA] < 0.15


@pytest.mark.parametrize("jammed", [2, 3])
def test_full_throttle_is_flown_level_also_on_a_model_20_percent_off(jammed: int) -> None:
    """With too much thrust and too little drag: there is more drag at a higher airspeed."""
    model = MODEL.with_error({"CX_left_propeller": 1.2, "CX_right_propeller": 1.2, "CX_alpha": 0.8})
    degraded = remaining(jammed, jammed={jammed: SETUP.limits[jammed, 1]}, setup=replace(SETUP, model=model))
    flight, held = steady_flight(degraded, LOOPS, "")
    assert held == ("airspeed", "altitude", "heading")
    assert_steady(degraded, flight)


def test_mirrored_failures_have_mirrored_trims() -> None:
    one, _ = steady_flight(remaining(2), LOOPS, "")
    other, _ = steady_flight(remaining(3), LOOPS, "")
    assert other.state[[0, ALPHA, PITCH]] == pytest.approx(one.state[[0, ALPHA, PITCH]], abs=1e-6)
    assert other.state[[BETA, ROLL]] == pytest.approx(-one.state[[BETA, ROLL]], abs=1e-6)
    assert other.positions[[1, 0]] == pytest.approx(one.positions[[0, 1]], abs=1e-5)


def test_one_propeller_left_flies_faster() -> None:
    """The yaw that its thrust makes has to be balanced by the tail, and falls with T/V^2."""
    flight, _ = steady_flight(remaining(2), LOOPS, "")
    assert flight.state[0] >= V + LOOPS.lost_thrust_faster_m_s - 1e-9
    assert steady_flight(remaining(0), LOOPS, "")[0].state[0] == pytest.approx(V)


def test_a_jammed_surface_is_balanced_by_the_others() -> None:
    degraded = remaining(0, jammed={0: 0.6})
    flight, _ = steady_flight(degraded, LOOPS, "")
    assert flight.positions[0] == 0.6
    assert_steady(degraded, flight)


def test_gliding_has_a_path_angle_and_does_not_hold_altitude() -> None:
    degraded = remaining(2, 3)
    flight, held = steady_flight(degraded, LOOPS, "")
    assert held == ("airspeed", "heading")
    assert_steady(degraded, flight, flight.state[PITCH] - flight.state[ALPHA])
    assert flight.state[PITCH] < flight.state[ALPHA]
    assert airspeed_range(degraded, flight, held) == (flight.state[AIRSPEED],) * 3  # whatever the reference


@pytest.mark.parametrize("failed", [(0, 2), (0, 3), (1, 2), (1, 3)])
def test_two_actuators_that_cannot_fly_level_descend_slowly_and_with_margin(failed: tuple[int, ...]) -> None:
    """At the reference airspeed a tail and the opposite propeller sink by 2.6 m/s, with a margin of 0.04."""
    degraded = remaining(*failed)
    flight, held = steady_flight(degraded, LOOPS, "")
    path_angle = float(path_angles(flight.only(None))[0])
    assert held == ("airspeed", "heading")
    assert_steady(degraded, flight, path_angle)
    assert -1.8 < flight.state[AIRSPEED] * math.sin(path_angle) < -1.0
    assert mode_trim.margins(degraded, flight.only(None))[0] > 0.5


def test_one_actuator_is_not_enough() -> None:
    with pytest.raises(NoSteadyFlight, match="two tails: one actuator cannot hold altitude and heading"):
        steady_flight(remaining(0, 1, 2), LOOPS, "two tails")


def test_stops_that_leave_nothing_are_said() -> None:
    degraded = replace(remaining(0), limits=np.tile([-1e-6, 1e-6], (4, 1)))
    with pytest.raises(NoSteadyFlight, match="no steady flight within the stops"):
        steady_flight(degraded, LOOPS, "left tail")


def reordered(order: list[int]) -> Setup:
    """The v-tail with its actuators listed in another order."""
    model = MODEL
    columns = {
        name: tuple(tuple(row[i] for i in order) for row in getattr(model, name))
        for name in ("input_matrix", "torque_matrix", "offset_matrix")
    }
    items = {
        name: tuple(getattr(model, name)[i] for i in order)
        for name in ("actuators", "kinds", "trim", "propulsors")
    }
    changed: DesignModel = replace(model, **columns, **items)  # type: ignore[arg-type]
    return replace(SETUP, model=changed, actuators=[SETUP.actuators[i] for i in order])


@pytest.mark.parametrize("order", [[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [2, 0, 3, 1]])
def test_redundant_actuators_share_the_work_in_whatever_order_they_are_listed(order: list[int]) -> None:
    """Level at another airspeed with all four, there is one unknown too many: both tails and both propellers move together."""
    setup = reordered(order)
    degraded = DegradedAircraft.after(setup, Mode((), (), np.zeros((4, 4)), 1.0), {})
    flight = at_path_angles(degraded, np.array([V - 2.0]), np.zeros(1)).only(0)
    tails = [order.index(0), order.index(1)]
    propellers = [order.index(2), order.index(3)]
    assert flight.positions[tails] == pytest.approx(np.full(2, flight.positions[tails[0]]), abs=1e-6)
    assert flight.positions[propellers] == pytest.approx(
        np.full(2, flight.positions[propellers[0]]), abs=1e-6
    )
    assert flight.state[[BETA, ROLL]] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert_steady(degraded, flight)


def test_motion_is_that_of_a_point_in_a_steady_turn() -> None:
    """Kinematics by hand: in a level, coordinated turn the heading changes at g tan(bank) / V and nothing climbs."""
    bank, alpha = 0.4, 0.1
    rate = 9.80665 * math.tan(bank) / V
    from testbed.common.angles import level_pitch

    pitch = level_pitch(alpha, 0.0, bank)
    p, q, r = (
        -rate * math.sin(pitch),
        rate * math.sin(bank) * math.cos(pitch),
        rate * math.cos(bank) * math.cos(pitch),
    )
    x = np.array([V, alpha, 0.0, p, q, r, bank, pitch, 0.0, 0.0])
    rates = motion(MODEL, x, np.array(MODEL.trim), np.ones(4))
    assert rates[6:8] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert rates[8] == pytest.approx(rate)
    assert rates[9] == pytest.approx(0.0, abs=1e-12)


def test_after_a_jam_airspeed_is_kept_where_level_flight_has_margin() -> None:
    """Every airspeed of the range has the trim's margin; just outside of it and above `too_fast` there is less."""
    degraded = remaining(0, jammed={0: -math.radians(10.0) / SETUP.scale[0]})
    flight, held = steady_flight(degraded, LOOPS, "")
    low, high, too_fast = airspeed_range(degraded, flight, held)
    assert 0.55 * V < low <= flight.state[AIRSPEED] <= high < too_fast < V

    def margin(airspeed: float) -> float:
        return float(margins(degraded, at_path_angles(degraded, np.array([airspeed]), np.zeros(1)))[0])

    needed = min(margin(float(flight.state[AIRSPEED])), 1.0)
    assert min(margin(low), margin(high)) >= needed - 1e-6
    assert margin(too_fast + 0.5) < 0.3 < margin(too_fast - 0.5)


def test_after_a_jam_airspeed_is_kept_with_little_margin_where_the_best_is_hardly_better() -> None:
    """The v-tail with ballast aft has 0.05 at the reference and 0.24 at 14 m/s; one degree further, none at the reference."""
    aft = load_design_model(load_aircraft("vtail_aft").folder / DESIGN_MODEL)
    setup = vtail_setup(WEATHER, model=aft)

    def chosen(degrees: float) -> tuple[float, float]:
        degraded = remaining(0, jammed={0: math.radians(degrees) / setup.scale[0]}, setup=setup)
        flight, held = steady_flight(degraded, LOOPS, "")
        assert "altitude" in held
        return float(flight.state[AIRSPEED]), float(margins(degraded, flight.only(np.newaxis))[0])

    airspeed, margin = chosen(-10.0)
    assert airspeed == pytest.approx(V) and 0.0 < margin < mode_trim._MARGIN_OF_LEVEL_FLIGHT
    slower, more = chosen(-11.0)
    assert slower < 0.8 * V and more > mode_trim._MARGIN_OF_LEVEL_FLIGHT


def test_without_a_jam_any_airspeed_is_flown_and_a_mode_that_cannot_hold_it_has_one() -> None:
    for failed in ((), (0,), (2,)):
        degraded = remaining(*failed)
        assert airspeed_range(degraded, *steady_flight(degraded, LOOPS, "")) == (0.0, math.inf, math.inf)
    degraded = remaining(0, 1)
    flight, held = steady_flight(degraded, LOOPS, "")
    assert "airspeed" not in held
    assert airspeed_range(degraded, flight, held) == (flight.state[AIRSPEED],) * 3


def test_a_propeller_that_brakes_is_flown_as_fast_as_a_lost_one() -> None:
    forces = np.zeros(4)
    assert lost_thrust(MODEL, (2,), forces)
    assert not lost_thrust(MODEL, (0,), forces) and not lost_thrust(MODEL, (2, 3), forces)
    assert not lost_thrust(MODEL, (2,), np.array(MODEL.trim)), (
        "a propeller that is jammed at its trim still pulls"
    )
    flight, held = steady_flight(remaining(3, jammed={3: -0.75}), LOOPS, "")
    assert held == ("airspeed", "altitude", "heading")
    assert flight.state[AIRSPEED] == pytest.approx(V + LOOPS.lost_thrust_faster_m_s, abs=0.5)


def test_a_jam_that_needs_bank_keeps_its_airspeed_where_pitch_is_controlled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A T-6's rudder jammed by a degree needs 4 deg of bank; with level wings it flew at two thirds of its airspeed, near the
    stall. Without pitch control the one airspeed is flown at which the jam itself balances pitch, and it is not held."""
    degraded = remaining(0, jammed={0: -0.3})
    monkeypatch.setattr(mode_trim, "_WINGS_LEVEL", 1e-3)
    flight, held = steady_flight(degraded, LOOPS, "")
    assert held == ("airspeed", "altitude", "heading") and flight.state[AIRSPEED] == pytest.approx(V)
    assert abs(flight.state[ROLL]) > 1e-3
    monkeypatch.undo()
    flight, held = steady_flight(replace(degraded, pitch_controlled=False), LOOPS, "")
    assert held == ("altitude", "heading") and 0.9 * V < flight.state[AIRSPEED] < V
