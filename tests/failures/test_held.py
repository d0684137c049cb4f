"""What the types do that hold properties at fixed values, in numbers."""

from __future__ import annotations

import numpy as np
import pytest
from broken_flights import END_S, START_S, WINDOW, example, fly, on_left_ruddervator

from testbed.failures import TABLE

PROPERTY = {"type": "property", "set": {"fcs/left-ruddervator/command-scale": 0.5}}


def test_stuck_does_not_move() -> None:
    assert len(set(on_left_ruddervator("stuck")[1][WINDOW])) == 1


def test_hardover_reaches_the_stop_at_the_servos_rate() -> None:
    position = on_left_ruddervator("hardover", to="min")[1]
    assert position[239] == pytest.approx(-25.8, abs=1e-4)
    assert np.max(np.abs(np.diff(position[101:240]))) <= 401.07 / 200 * 1.0001


def test_bias_is_behind_the_servo() -> None:
    plant = on_left_ruddervator("bias", value=3.0, until_s=2.0)[0].parts.plant
    off = plant["fcs/left-ruddervator/effective-rad"] - plant["fcs/left-ruddervator/servo-rad"]
    assert np.degrees(off) == pytest.approx(3.0)


def test_command_scale_is_before_the_servo() -> None:
    plant = on_left_ruddervator("command_scale", value=0.5, until_s=2.0)[0].parts.plant
    command = plant["fcs/left-ruddervator/command-rad"]
    assert plant["fcs/left-ruddervator/demand-rad"] == 0.5 * command != 0.0


def test_rate_limit() -> None:
    position = on_left_ruddervator("rate_limit", value=2.0)[1][WINDOW]
    assert np.max(np.abs(np.diff(position))) == pytest.approx(2.0 / 200, rel=1e-6)


def test_position_limit() -> None:
    position = on_left_ruddervator("position_limit", low=-1.0, high=1.0)[1][101:240]
    assert np.max(np.abs(position)) == pytest.approx(1.0, abs=1e-9)


def test_float_trails_with_the_local_flow() -> None:
    flown, position = on_left_ruddervator("float")
    gain = flown.parts.plant["fcs/left-ruddervator/float-gain"]
    assert np.std(position[WINDOW]) > 0 and 0 < gain <= 1


def test_reversal_reverses() -> None:
    plant = on_left_ruddervator("reversal", at_s=1.0, until_s=2.0)[0].parts.plant
    assert plant["fcs/left-ruddervator/demand-rad"] == -plant["fcs/left-ruddervator/command-rad"]


def test_property_by_name_is_the_same_as_the_type_that_holds_it() -> None:
    by_name = fly({**PROPERTY, "at_s": START_S, "until_s": END_S})
    by_type = fly(example("command_scale", "left_ruddervator"))
    assert np.array_equal(by_name.flight.data, by_type.flight.data, equal_nan=True)
    for of in ("effect", "actuator", "verified"):
        assert by_name.event()[of] == by_type.event()[of]


def test_a_property_is_held_once_whatever_its_spelling() -> None:
    spelled = {"inertia/pointmass-weight-lbs": 1.0, "inertia/pointmass-weight-lbs[0]": 2.0}
    with pytest.raises(ValueError, match="twice"):
        TABLE["property"].model_validate({"type": "property", "at_s": 1.0, "set": spelled})
