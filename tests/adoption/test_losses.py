"""What is kept of steady flight without an actuator, in words."""

import math

import pytest

from testbed.adoption.adopt import Kept, losses
from testbed.adoption.entry import adopted_card
from testbed.adoption.source import find_source, package_root
from testbed.aircraft.description import load_aircraft
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, trim


def test_the_v_tail_flies_level_without_any_one_actuator():
    aircraft = load_aircraft("vtail")
    reference = trim(Plant(aircraft, 120), aircraft.reference.airspeed_m_s, aircraft.reference.altitude_m)
    kept = losses(aircraft, reference)
    assert [each.actuator for each in kept] == list(aircraft.actuators)
    for each in kept:
        assert each.trim is not None and each.trim.residual < 1e-6
        assert abs(each.trim.state["path_angle"]) < 1e-9
        assert "level flight at" in str(each)


@pytest.mark.nightly
def test_a_flight_of_which_the_engine_is_not_steady_to_the_last_digit_is_found(tmp_path):
    """The elevator is lost near its middle: level flight, 0.3 m/s slower."""
    said = adopted_card(find_source("c172p", package_root()), tmp_path / "c172p")
    assert "without elevator: level flight at 40.26 m/s" in said


def test_what_is_kept_in_words():
    state = {"airspeed": 20.0, "path_angle": math.radians(-3.0), "roll": 0.0, "beta": math.radians(2.0)}
    assert str(Kept("engine", Trim(state, (), (), 0.0))) == (
        "engine: a path of -3.0 deg at 20 m/s, roll 0.0 deg, beta 2.0 deg"
    )
    assert str(Kept("elevator", None)) == "elevator: no steady flight was found"
