"""Every controller of the table flies the healthy aircraft, and is made by the class that its settings name."""

from __future__ import annotations

from pathlib import Path

import pytest
from short_flights import scenario, worst_errors
from vtail_setup import vtail_setup

from testbed.controllers.config import FLAGS, TABLE, says
from testbed.controllers.make import CONSTRUCTORS, make_controller
from testbed.controllers.setup import ActuatorTruth
from testbed.simulation import fly


def test_every_kind_of_settings_has_a_class_that_flies_it() -> None:
    assert set(CONSTRUCTORS) == set(TABLE)


@pytest.mark.parametrize("name", TABLE)
def test_a_controller_has_the_protocol(name: str) -> None:
    truth = ActuatorTruth([1.0] * 4, [True] * 4, [0.0] * 4)  # for the informed alone
    controller = make_controller(vtail_setup(TABLE[name](), truth=lambda: truth))
    assert list(controller.reasons) == []
    assert callable(controller.bind) and callable(controller.step)


@pytest.mark.parametrize("name", TABLE)
def test_every_controller_flies_the_healthy_aircraft(tmp_path: Path, name: str) -> None:
    """A turn of 30 deg and a climb of 5 m in calm air: on its references, and on them to the digit once settled."""
    flight = fly(scenario(tmp_path, name))
    assert flight.outcome == "completed"
    altitude, heading, airspeed = worst_errors(flight)
    assert (altitude < 1.0, heading < 4.0, airspeed < 1.5) == (True, True, True), (
        altitude,
        heading,
        airspeed,
    )
    altitude, heading, airspeed = worst_errors(flight, 22.0)
    assert (altitude < 0.1, heading < 0.5, airspeed < 0.3) == (True, True, True), (
        altitude,
        heading,
        airspeed,
    )
    assert flight.metrics["false_alarms"] == 0 or FLAGS not in says(flight.scenario.controller)
