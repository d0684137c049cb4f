"""A receipt says whether a failure was seen to act; each answer is also shown by a failure that does not."""

from __future__ import annotations

import math
import shutil
from pathlib import Path

import pytest
from broken_flights import START_S, example, fly

from testbed.aircraft.shipped import data_root
from testbed.injection.receipt import RECEIPT_STEPS, reads_back


def test_an_effect_is_told_in_numbers() -> None:
    flown = fly({**example("effectiveness", "left_ruddervator"), "value": 0.25})
    event = flown.event()
    effect = event["effect"]
    assert event["verified"] is True and effect["quantity"] == "effective_deg"
    assert effect["broken"] == pytest.approx(0.25 * effect["healthy"])
    assert effect["observed"] == pytest.approx(effect["broken"])
    assert effect["after_steps"] == 1


def test_a_property_outside_all_actuators_is_verified_by_reading_it_back() -> None:
    event = fly({"type": "property", "at_s": START_S, "set": {"atmosphere/wind-north-fps": 3.0}}).event()
    assert (event["verified"], event["effect"], event["actuator"]) == (True, None, None)


def test_an_overwritten_property_is_not_verified() -> None:
    """Negative control: the model computes this one anew in every step."""
    flown = fly({"type": "property", "at_s": START_S, "set": {"fcs/left-ruddervator/servo-rad": 0.1}})
    assert flown.event()["verified"] is False
    assert "did NOT stay as written" in flown.flight.summary["warnings"][0]


def test_an_unconnected_property_is_not_verified(tmp_path: Path) -> None:
    """Negative control: an aircraft that declares the properties and forgets to use them."""
    folder = tmp_path / "aircraft" / "vtail"
    shutil.copytree(data_root() / "aircraft" / "vtail", folder)
    model = folder / "vtail.xml"
    text = model.read_text()
    used = "<product><property>fcs/left-ruddervator/effectiveness</property>"
    assert text.count(used) == 1
    model.write_text(text.replace(used, "<product><value>1</value>"))
    flown = fly(example("effectiveness", "left_ruddervator"), aircraft=str(folder))
    event = flown.event()
    assert event["verified"] is False
    assert event["effect"]["observed"] == pytest.approx(event["effect"]["healthy"])
    assert str(RECEIPT_STEPS) in flown.flight.warnings[0]


def test_reading_back_allows_for_rounding_only() -> None:
    assert reads_back(1.0 + 1e-12, 1.0) and reads_back(1e-13, 0.0)
    assert not reads_back(1.0 + 1e-6, 1.0) and not reads_back(math.nan, 1.0)
