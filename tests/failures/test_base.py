"""What every failure has: when it starts and ends, and values in the actuator's own unit."""

from __future__ import annotations

import math
from typing import Any

import pytest
from broken_flights import AIRCRAFT
from pydantic import ValidationError

from testbed.failures import TABLE, Failure, When


def failure(type: str = "stuck", actuator: str = "left_ruddervator", **fields: Any) -> Failure:
    return TABLE[type].model_validate({"type": type, "actuator": actuator, **fields})


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        ({}, "has no start"),
        ({"at_s": 1.0, "when": {"signal": "altitude_m", "below": 100}}, "has two starts"),
        ({"at_s": 1.0, "until_s": 1.0}, "is not after at_s"),
        ({"when": {"signal": "altitude_m"}}, "needs one limit"),
        ({"when": {"signal": "altitude_m", "below": 1, "above": 2}}, "needs one limit"),
    ],
)
def test_start_and_end_have_to_make_sense(fields: dict[str, Any], text: str) -> None:
    with pytest.raises(ValidationError, match=text):
        failure(**fields)


def test_the_limit_itself_is_neither_above_nor_below() -> None:
    above, below = When(signal="altitude_m", above=5.0), When(signal="altitude_m", below=0.0)
    assert [above.met(v) for v in (5.0, math.nextafter(5.0, 6.0))] == [False, True]
    assert [below.met(v) for v in (0.0, -1e-300)] == [False, True]
    assert not above.met(math.nan) and not below.met(math.nan)
    assert [str(above), str(below)] == ["altitude_m above 5", "altitude_m below 0"]


def test_window() -> None:
    assert failure(at_s=2.0, until_s=3.0).window_s == (2.0, 3.0)
    assert failure(at_s=2.0).window_s == (2.0, math.inf)
    assert failure(when={"signal": "altitude_m", "below": 100}, until_s=4.0).window_s == (0.0, 4.0)


@pytest.mark.parametrize(
    ("actuator", "property_value", "unit"),
    [("left_ruddervator", math.radians(5.0), "deg"), ("left_propeller", 0.5, "throttle")],
)
def test_values_are_in_the_actuators_own_unit(actuator: str, property_value: float, unit: str) -> None:
    value = 5.0 if unit == "deg" else 0.5
    stuck_at: Any = failure("stuck_at", actuator, at_s=1.0, value=value)
    held = stuck_at.properties(AIRCRAFT)
    (override,) = (v for name, v in held.items() if name.endswith(("override-rad", "override-norm")))
    assert override == property_value
    assert list(stuck_at.faults(AIRCRAFT, 200.0)) == []
    too_far: Any = failure("stuck_at", actuator, at_s=1.0, value=30.0)
    (fault,) = too_far.faults(AIRCRAFT, 200.0)
    assert fault.path == ("value",) and f"30 {unit} is outside" in fault.what
