"""Trims of degraded modes: nothing accelerates, within the stops; who is ganged; what has no trim."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from vtail_setup import ACTUATORS, vtail_setup

from testbed.aircraft.design_model import DesignModel
from testbed.controllers.inversion import mode_trim
from testbed.controllers.inversion.mode_trim import (
    NoSteadyFlight,
    Remaining,
    SteadyFlight,
    TrimProblem,
    motion,
    steady_flight,
)
from testbed.controllers.inversion.modes import Mode, enumerate_modes
from testbed.controllers.records import ALPHA, BETA, PITCH, REGULATOR_STATE, ROLL
from testbed.controllers.setup import Setup

SETUP = vtail_setup()
MODEL = SETUP.model
V = MODEL.airspeed_m_s
LOOPS = SETUP.control.loops


def remaining(*failed: int, jammed: dict[int, float] | None = None, setup: Setup = SETUP) -> Remaining:
    mode = enumerate_modes(setup.model, setup.scale, setup.control)[failed]
    return Remaining.after(setup, mode, jammed or {})


def assert_steady(left: Remaining, flight: SteadyFlight, path_angle: float = 0.0) -> None:
    """Nothing but heading and altitude changes, and the altitude by the path angle."""
    rates = left.motion(flight.state, flight.positions)
    assert rates[:9] == pytest.approx(np.zeros(9), abs=1e-7)
    assert rates[9] == pytest.approx(flight.state[0] * math.sin(path_angle), abs=1e-6)


def test_with_nothing_failed_it_is_the_reference_trim() -> None:
    flight, held = steady_flight(remaining(), LOOPS, "")
    assert flight.state[[0, ALPHA, PITCH]] == pytest.approx([V, MODEL.alpha_rad, MODEL.alpha_rad], abs=1e-6)
    assert flight.positions * SETUP.scale == pytest.approx(MODEL.trim, rel=1e-5)
    assert held == ("airspeed", "altitude", "heading")


@pytest.mark.parametrize("failed", [(), (0,), (1,), (2,), (3,), (0, 2), (0, 3), (0, 1), (2, 3)])
def test_a_trim_is_steady_within_the_stops(failed: tuple[int, ...]) -> None:
    left = remaining(*failed)
    flight, held = steady_flight(left, LOOPS, "")
    gamma = 0.0 if "altitude" in held else flight.state[PITCH] - flight.state[ALPHA]
    rates = left.motion(flight.state, flight.positions)
    assert rates[:9] == pytest.approx(np.zeros(9), abs=1e-6)
    assert rates[9] == pytest.approx(V * math.sin(gamma) if gamma else 0.0, abs=0.3)
    inside = mode_trim._BEYOND_STOPS * left.limits
    assert np.all((flight.positions >= inside[:, 0]) & (flight.positions <= inside[:, 1]))
    assert flight.positions[list(failed)] == pytest.approx((np.array(MODEL.trim) / SETUP.scale)[list(failed)])


def test_a_trim_beyond_the_stall_is_not_plausible() -> None:
    """The design model is linear and trims anywhere; alpha is limited to 0.25 rad, sideslip to 0.4 rad, bank not at all."""
    problem = TrimProblem(remaining())
    flight, _ = steady_flight(problem.remaining, LOOPS, "")

    def plausible(**changes: float) -> bool:
        state = flight.state.copy()
        for name, value in changes.items():
            state[REGULATOR_STATE.index(name)] = value
        return problem._plausible(SteadyFlight(state, flight.positions))

    assert plausible() and plausible(alpha=0.24) and plausible(beta=-0.39) and plausible(roll=0.6)
    assert not plausible(alpha=0.26) and not plausible(beta=0.41) and not plausible(airspeed=0.49 * V)


def test_a_jam_that_level_flight_meets_only_in_a_stall_descends() -> None:
    """Right surface lost, right propeller jammed at 6.1 N: the level trim would be at 9.8 m/s and 16 deg of alpha."""
    flight, held = steady_flight(remaining(1, 3, jammed={3: 3.038}), LOOPS, "")
    assert held == ("airspeed", "heading") and flight.state[ALPHA] < 0.1


def test_mirrored_failures_have_mirrored_trims() -> None:
    left, _ = steady_flight(remaining(2), LOOPS, "")
    right, _ = steady_flight(remaining(3), LOOPS, "")
    assert right.state[[0, ALPHA, PITCH]] == pytest.approx(left.state[[0, ALPHA, PITCH]], abs=1e-6)
    assert right.state[[BETA, ROLL]] == pytest.approx(-left.state[[BETA, ROLL]], abs=1e-6)
    assert right.positions[[1, 0]] == pytest.approx(left.positions[[0, 1]], abs=1e-5)


def test_one_propeller_left_flies_faster() -> None:
    """The yaw that its thrust makes has to be balanced by the tail, and falls with T/V^2."""
    flight, _ = steady_flight(remaining(2), LOOPS, "")
    assert flight.state[0] >= V + LOOPS.lost_thrust_faster_m_s - 1e-9
    assert steady_flight(remaining(0), LOOPS, "")[0].state[0] == pytest.approx(V)


def test_a_jammed_surface_is_balanced_by_the_others() -> None:
    left = remaining(0, jammed={0: 0.6})
    flight, _ = steady_flight(left, LOOPS, "")
    assert flight.positions[0] == 0.6
    assert_steady(left, flight)


def test_gliding_has_a_path_angle_and_does_not_hold_altitude() -> None:
    left = remaining(2, 3)
    flight, held = steady_flight(left, LOOPS, "")
    assert held == ("airspeed", "heading")
    assert_steady(left, flight, flight.state[PITCH] - flight.state[ALPHA])
    assert flight.state[PITCH] < flight.state[ALPHA]


def test_one_actuator_is_not_enough() -> None:
    with pytest.raises(NoSteadyFlight, match="two tails: one actuator cannot hold altitude and heading"):
        steady_flight(remaining(0, 1, 2), LOOPS, "two tails")


def test_stops_that_leave_nothing_are_said() -> None:
    left = replace(remaining(0), limits=np.tile([-1e-6, 1e-6], (4, 1)))
    with pytest.raises(NoSteadyFlight, match="no steady flight within the stops"):
        steady_flight(left, LOOPS, "left tail")
    assert TrimProblem(left).solve([V]) is None


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
def test_the_tails_are_ganged_in_whatever_order_they_are_listed(order: list[int]) -> None:
    setup = reordered(order)
    left = Remaining.after(setup, Mode((), (), np.zeros((4, 4)), 1.0), {})
    used, ganged = left.unknowns
    ((follower, leader),) = ganged
    assert {ACTUATORS[order[follower]], ACTUATORS[order[leader]]} == {"left_ruddervator", "right_ruddervator"}
    assert len(used) == 3 and follower not in used
    flight = TrimProblem(left).solve([V])
    assert flight is not None
    assert flight.positions * setup.scale == pytest.approx(np.array(MODEL.trim)[order], rel=1e-5)


def test_three_actuators_are_not_ganged() -> None:
    used, ganged = remaining(1).unknowns
    assert used.tolist() == [0, 2, 3] and not ganged


def test_motion_is_that_of_a_point_in_a_steady_turn() -> None:
    """Kinematics by hand: in a level, coordinated turn the heading changes at g tan(bank) / V and nothing climbs."""
    bank, alpha = 0.4, 0.1
    rate = 9.80665 * math.tan(bank) / V
    from testbed.common.frames import level_pitch

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
