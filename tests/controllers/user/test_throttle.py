"""The throttle of a controller of one's own: what the design model's rotor needs for a thrust."""

from __future__ import annotations

import math

import pytest
from vtail_setup import vtail_setup

from testbed.controllers.user.adapter import State
from testbed.controllers.user.throttle import Throttle
from testbed.inputs.problems import BadInput

SETUP = vtail_setup()


def at(airspeed: float, alpha: float = 0.05) -> State:
    return State(**{**dict.fromkeys(State._fields, 0.0), "airspeed": airspeed, "alpha": alpha})


@pytest.mark.parametrize("thrust", [1.0, 3.0, 8.0])
@pytest.mark.parametrize("airspeed", [15.0, 20.0])
def test_it_is_the_steady_motor_equation(thrust: float, airspeed: float) -> None:
    """V = n / K_v + R (Q / K_t + i_0), with the rotor speed and torque at which the propeller gives the thrust."""
    axial, p = airspeed * math.cos(0.05), SETUP.model.propulsors[2]
    assert p is not None
    n, (torque, _) = (f(thrust, axial, SETUP.model.density_kg_m3) for f in (p.speed_at, p.torque_at))
    volts = n / p.velocity_constant_rps_v + p.resistance_ohm * (
        torque / p.torque_constant_n_m_a + p.no_load_current_a
    )
    found = Throttle(SETUP)("left_propeller", thrust, at(airspeed))
    assert found == pytest.approx(volts / p.max_volts, rel=1e-3)


def test_it_stays_within_the_range_and_knows_its_motors() -> None:
    throttle = Throttle(SETUP)
    assert throttle("right_propeller", 1e3, at(18.0)) == 1.0
    least = throttle("right_propeller", -1e3, at(18.0))
    assert (
        0.0
        < least
        == throttle("right_propeller", -2e3, at(18.0))
        < throttle("right_propeller", 0.0, at(18.0))
    )
    with pytest.raises(BadInput, match="did you mean right_propeller"):
        throttle("right_propellor", 1.0, at(18.0))
    with pytest.raises(BadInput, match="no motor of this aircraft"):
        throttle("left_ruddervator", 1.0, at(18.0))
