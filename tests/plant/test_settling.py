"""The test stand: what is waited for, and for how long."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from stock_aircraft import c172p

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.inputs.problems import BadInput
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import STEADY, servos_settle_s, settle_at, settle_s
from testbed.plant.trim import trim


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


def test_engines_settle_while_servos_do(tmp_path: Path) -> None:
    """What is left to change after waiting is what was asked for; rougher is sooner."""
    aircraft = load_aircraft(str(c172p(tmp_path / "made")))
    plant = Plant(aircraft, 120)
    at = aircraft.reference
    found = trim(plant, at.airspeed_m_s, at.altitude_m)
    moved = [command + 0.05 for command in found.commands]

    def positions() -> np.ndarray:
        return np.array([plant.position(i) / a.scale for i, a in enumerate(aircraft.actuators.values())])

    for steady in (1e-4, STEADY):
        settle_at(plant, found.state, found.commands)
        assert settle_at(plant, found.state, moved, steady=steady) >= servos_settle_s(aircraft, steady)
        now = positions()
        plant.settle(round(60 * plant.physics_hz))
        left = np.abs(now - positions())
        assert np.all(left[:3] < steady), "servos"
        assert left[3] < 10.0 * steady + 2e-6, (
            "the engine: its own guess of what is left, and the Earth's turning"
        )
    assert servos_settle_s(aircraft, 1e-4) < servos_settle_s(aircraft, STEADY) <= settle_s(aircraft)
