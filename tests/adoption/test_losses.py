"""What is kept of steady flight without an actuator, in words."""

import math

from testbed.adoption.adopt import Kept, losses
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


def test_what_is_kept_in_words():
    state = {"airspeed": 20.0, "path_angle": math.radians(-3.0), "roll": 0.0, "beta": math.radians(2.0)}
    assert str(Kept("engine", Trim(state, (), (), 0.0))) == (
        "engine: a path of -3.0 deg at 20 m/s, roll 0.0 deg, beta 2.0 deg"
    )
    assert str(Kept("elevator", None)) == "elevator: no steady flight was found"
