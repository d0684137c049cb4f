"""The set-up of a flight: units, scaling, and settings as their own type."""

from __future__ import annotations

import math

import numpy as np
import pytest
from vtail_setup import vtail, vtail_setup

from testbed.controllers.config import AdaptiveInversionSettings, IndiSettings, PidSettings
from testbed.controllers.setup import setup_for


def test_degrees_become_radians_and_newtons_stay() -> None:
    aircraft, model = vtail()
    positions = [2.0, -3.0, 4.0, 5.0]
    setup = setup_for(aircraft, model, PidSettings(), 0.01, [0.1, 0.2, 0.3, 0.4], positions, 0.05)
    assert setup.trim_positions == pytest.approx([math.radians(2.0), math.radians(-3.0), 4.0, 5.0])
    tail, propeller = setup.actuators[0], setup.actuators[2]
    given = aircraft.actuators["left_ruddervator"]
    assert (tail.low, tail.high) == pytest.approx([math.radians(x) for x in given.limits])
    assert tail.rate == pytest.approx(math.radians(given.rate_limit))
    assert (propeller.low, propeller.high) == aircraft.actuators["left_propeller"].limits
    assert (setup.aircraft, setup.dt_s, setup.trim_pitch) == ("vtail", 0.01, 0.05)


def test_scaled_quantities() -> None:
    setup = vtail_setup()
    assert setup.scale == pytest.approx([0.2, 0.2, 2.0, 2.0], rel=1e-4)
    assert setup.limits[2] == pytest.approx([-0.75, 7.0])
    assert setup.lags[:2] == pytest.approx([30.0, 30.0])


def test_the_error_of_the_model_is_applied_once() -> None:
    aircraft, model = vtail()
    wrong = PidSettings(model_error={"Cm_alpha": 1.2})
    setup = setup_for(aircraft, model, wrong, 0.005, [0.0] * 4, [0.0] * 4, 0.0)
    assert setup.model.derivatives[1][0] == pytest.approx(1.2 * model.derivatives[1][0])
    assert np.array_equal(setup.model.input_matrix, model.input_matrix)


def test_settings_of_another_controller_give_the_defaults_of_this_one() -> None:
    """A controller flown in place of the scenario's: only what all controllers share is taken over."""
    own = IndiSettings(filter_rad_s=5.0, released=("p_dot",))
    setup = vtail_setup(own)
    assert setup.settings_as(IndiSettings) is own
    assert setup.settings_as(AdaptiveInversionSettings) == AdaptiveInversionSettings(released=("p_dot",))
