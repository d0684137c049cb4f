"""The test stand: what is waited for, and for how long."""

from __future__ import annotations

import pytest

from testbed.aircraft.description import Aircraft
from testbed.inputs.problems import BadInput
from testbed.plant.settling import settle_s


def test_an_actuator_too_slow_to_wait_for_is_refused(vtail: Aircraft) -> None:
    """Found by a mutant whose rotor has an inertia of 2 kg m2: looking for its trim took minutes."""
    slow = vtail.actuators["left_propeller"].model_copy(
        update={
            "motor": vtail.actuators["left_propeller"].motor.model_copy(update={"rotor_inertia_kg_m2": 2.0})
        }
    )
    aircraft = vtail.model_copy(update={"actuators": {**vtail.actuators, "left_propeller": slow}})
    with pytest.raises(
        BadInput, match=r"actuators.left_propeller: follows its command at .*, expected at least"
    ):
        settle_s(aircraft)
