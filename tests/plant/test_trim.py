"""Trim: nothing accelerates, the aircraft flies itself from there, and what has no steady flight is said."""

from __future__ import annotations

import math

import numpy as np
import pytest

from testbed.aircraft.description import Aircraft
from testbed.common.signals import STATE
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import accelerations
from testbed.plant.trim import NoTrim, Trim, TrimProblem, begin_at, trim, trimmed_start

HZ = 200
GIVEN = {"airspeed": 18.0, "altitude": 300.0, "heading": math.pi / 2}


@pytest.mark.parametrize("airspeed", [16.0, 18.0, 20.0])
@pytest.mark.parametrize("heading", [0.0, 90.0, 217.0])
def test_trim_flies_itself(vtail: Aircraft, airspeed: float, heading: float) -> None:
    """Open loop for 2 s from trim, through servos and motors: no rate above 0.2 deg/s, altitude within 5 cm."""
    start = trim(Plant(vtail, HZ), airspeed, 300.0, math.radians(heading))
    rate, altitude = open_loop(vtail, start)
    assert start.residual < 1e-6
    assert rate <= 0.2
    assert altitude < 0.05


def test_a_bad_trim_does_not_fly_itself(vtail: Aircraft, level: Trim) -> None:
    """The negative control: a tenth of a degree of one tail is seen."""
    commands = np.array(level.commands) + np.radians([0.1, 0.0, 0.0, 0.0])
    rate, _ = open_loop(vtail, Trim(level.state, tuple(commands), level.positions, 0.0))
    assert rate > 0.2


def open_loop(vtail: Aircraft, start: Trim) -> tuple[float, float]:
    """Largest rate [deg/s] and change of altitude [m] in 2 s."""
    plant = Plant(vtail, HZ)
    begin_at(plant, start)
    rows = []
    for _ in range(2 * HZ):
        plant.step()
        rows.append(plant.read())
    flown = np.array(rows)
    rates = np.degrees(flown[:, [STATE.index(name) for name in "pqr"]])
    return float(np.abs(rates).max()), float(np.abs(flown[:, STATE.index("altitude")] - 300.0).max())


def test_level_flight_is_level(level: Trim) -> None:
    """Wings level and no sideslip: pitch is the angle of attack."""
    assert level.state["pitch"] == pytest.approx(level.state["alpha"], abs=1e-9)
    assert level.state["roll"] == pytest.approx(0.0, abs=1e-9)
    assert (level.state["airspeed"], level.state["altitude"]) == (18.0, 300.0)


def test_the_plant_is_left_in_the_trim(vtail: Aircraft) -> None:
    plant = Plant(vtail, HZ)
    found = trim(plant, 20.0, 500.0, heading_rad=1.0)
    now = dict(zip(STATE, plant.read(), strict=False))
    for name in ("airspeed", "altitude", "heading", "alpha", "pitch"):
        assert now[name] == pytest.approx(found.state[name], abs=1e-6), name
    assert [plant.position(i) for i in range(2)] == pytest.approx(np.radians(found.positions[:2]), abs=1e-9)


def test_a_glide_has_the_path_angle_that_physics_gives(vtail: Aircraft) -> None:
    """Both propellers lost, throttles held: tan(gamma) = -D/L. The README states -6.9 deg at 18 m/s."""
    plant = Plant(vtail, HZ)
    for side in ("left", "right"):
        plant[f"fcs/{side}-propeller/effectiveness"] = 0.0
    found = trim(plant, 18.0, 300.0, held={2: 0.5, 3: 0.5}, free=("alpha", "beta", "roll", "path_angle"))
    drag, lift = (abs(plant[f"forces/fw{axis}-aero-lbs"]) for axis in "xz")
    assert math.tan(found.state["path_angle"]) == pytest.approx(-drag / lift, rel=1e-3)
    assert math.degrees(found.state["path_angle"]) == pytest.approx(-6.9, abs=0.05)


def test_no_trim_is_said(vtail: Aircraft) -> None:
    """Both propellers lost: no level flight at any airspeed."""
    plant = Plant(vtail, HZ)
    for side in ("left", "right"):
        plant[f"fcs/{side}-propeller/effectiveness"] = 0.0
    with pytest.raises(NoTrim, match=r"no steady flight of vtail was found at 18 m/s, 300 m, with alpha"):
        trim(plant, 18.0, 300.0, held={2: 0.5, 3: 0.5}, free=("alpha", "beta", "roll", "airspeed"))


def test_a_trim_beyond_the_stops_is_none(vtail: Aircraft) -> None:
    """Faster than full throttle: a root may exist, but the motors cannot give it."""
    with pytest.raises(NoTrim):
        trim(Plant(vtail, HZ), 39.0, 300.0)


# The problem that is solved ---------------------------------------------------------------------------------------


def test_fewer_unknowns_than_accelerations_suffice_where_the_aircraft_is_symmetric(vtail: Aircraft) -> None:
    """Five unknowns: without roll there is the same flight, wings level. Without alpha there is none."""
    problem = TrimProblem(Plant(vtail, HZ), GIVEN, ("alpha",), {})
    found = problem.solution()
    assert found is not None
    assert found.state["alpha"] == pytest.approx(trim(Plant(vtail, HZ), 18.0, 300.0).state["alpha"], abs=1e-9)
    assert TrimProblem(Plant(vtail, HZ), GIVEN, ("roll",), {}).solution() is None


def test_the_first_guess_is_what_it_says(vtail: Aircraft) -> None:
    """Scaled and back: 0.05 rad of alpha, tails in the middle of their travel, 60 % throttle, the airspeed asked for."""
    problem = TrimProblem(Plant(vtail, HZ), GIVEN, ("alpha", "airspeed", "roll"), {3: 0.7})
    state, commands = problem.condition(problem.first_guess())
    assert (state["alpha"], state["airspeed"], state["roll"]) == pytest.approx((0.05, 18.0, 0.0))
    assert commands == pytest.approx([0.0, 0.0, 0.6, 0.7])
    assert list(problem.free) == [0, 1, 2]


def test_the_solution_solves_the_problem(vtail: Aircraft, level: Trim) -> None:
    problem = TrimProblem(Plant(vtail, HZ), GIVEN, ("alpha", "roll"), {})
    at = np.array([level.state["alpha"], level.state["roll"], *level.commands]) / problem.sizes
    assert np.abs(problem.residual(at)).max() < 1e-6
    assert np.abs(problem.residual(at + 0.01)).max() > 1e-3, "and what is beside it does not"


# A flight's start -------------------------------------------------------------------------------------------------


def test_a_start_is_found_once_and_is_the_trim(vtail: Aircraft) -> None:
    one = trimmed_start(vtail, HZ, 17.0, 250.0, 1.0)
    assert trimmed_start(vtail, HZ, 17.0, 250.0, 1.0) is one
    assert one == trim(Plant(vtail, HZ), 17.0, 250.0, 1.0)
    for other in (
        (400, 17.0, 250.0, 1.0),
        (HZ, 17.5, 250.0, 1.0),
        (HZ, 17.0, 251.0, 1.0),
        (HZ, 17.0, 250.0, 1.1),
    ):
        assert trimmed_start(vtail, *other) != one


def test_accelerations_are_of_the_held_state(vtail: Aircraft, level: Trim) -> None:
    """More throttle on both sides pushes forward: thrust over mass."""
    plant = Plant(vtail, HZ)
    more = [*level.commands[:2], *(c + 0.05 for c in level.commands[2:])]
    rates = accelerations(plant, level.state, more)
    thrust = sum(plant.position(i) for i in (2, 3)) - sum(level.positions[2:])
    assert rates[0] == pytest.approx(thrust / 5.0, rel=1e-2)
    assert np.abs(rates[[1, 3, 5]]).max() < 1e-3, "symmetric: no side force, roll or yaw"
