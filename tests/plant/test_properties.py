"""JSBSim's names and units of the signals: each exists in the model, and the factors are SI."""

from __future__ import annotations

import pytest

from testbed.aircraft.description import Aircraft
from testbed.common.signals import STATE
from testbed.failures import same_property
from testbed.plant.first_load import property_catalog
from testbed.plant.properties import (
    ACCELERATIONS,
    AIR_DATA,
    INTEGRATORS,
    SET_WIND_FPS,
    STATE_PROPERTIES,
    TOTAL_WIND_FPS,
    command_property,
    position_property,
)


def test_all_exist_and_what_is_commanded_can_be_written(vtail: Aircraft) -> None:
    catalog = {same_property(name): can for name, can in property_catalog(vtail).items()}
    read = [name for name, _ in (*STATE_PROPERTIES, *ACCELERATIONS, *AIR_DATA)]
    read += [position_property(actuator)[0] for actuator in vtail.actuators.values()]
    assert [name for name in (*read, *TOTAL_WIND_FPS) if same_property(name) not in catalog] == []
    written = [*SET_WIND_FPS, *INTEGRATORS, *map(command_property, vtail.actuators.values())]
    assert [name for name in written if not catalog.get(name)] == []


def test_each_of_the_state_has_its_own() -> None:
    assert len(STATE_PROPERTIES) == len(STATE)
    assert len({name for name, _ in STATE_PROPERTIES}) == len(STATE)


@pytest.mark.parametrize(
    ("ending", "factor"), [("-fps", 0.3048), ("-ft", 0.3048), ("_sec2", None), ("-rad", None)]
)
def test_feet_become_metres(ending: str, factor: float | None) -> None:
    """A unit in JSBSim's name decides the factor: feet or radians; latitude and longitude become metres on the ground."""
    for name, found in (*STATE_PROPERTIES, *ACCELERATIONS):
        if not name.endswith(ending) or name.startswith("position/l"):
            continue
        assert found == (factor or (0.3048 if "ft" in name else 1.0)), name


def test_a_minute_of_arc_is_a_sea_mile_on_the_ground() -> None:
    """Within 1 %: 1852 m along the meridian and the equator."""
    for _, factor in STATE_PROPERTIES[:2]:
        assert factor * 2.908882e-4 == pytest.approx(1852.0, rel=0.01)
