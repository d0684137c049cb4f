"""What the types do that take an actuator's force, torque or mass away, in numbers."""

from __future__ import annotations

import pytest
from broken_flights import AIRCRAFT, WINDOW, example, fly, healthy, on_left_ruddervator, without

from testbed.failures import TABLE


def test_effectiveness_scales_what_the_servo_does() -> None:
    flown, _ = on_left_ruddervator("effectiveness", value=0.3, until_s=2.0)
    assert set(flown.column("left_ruddervator_effectiveness")[WINDOW]) == {0.3}
    plant = flown.parts.plant
    servo = plant["fcs/left-ruddervator/servo-rad"]
    assert plant["fcs/left-ruddervator/effective-rad"] == pytest.approx(0.3 * servo) and servo != 0.0


def test_surface_lost_takes_mass_and_centre_of_gravity_along() -> None:
    well, lost = healthy().parts.plant, on_left_ruddervator("surface_lost")[0].parts.plant
    gone = well["inertia/pointmass-weight-lbs"]
    assert gone > 0
    assert well["inertia/weight-lbs"] - lost["inertia/weight-lbs"] == pytest.approx(gone)
    assert lost["inertia/cg-x-in"] < well["inertia/cg-x-in"]  # the tail is behind
    assert lost["inertia/cg-y-in"] > well["inertia/cg-y-in"]  # and the lost surface was on the left
    assert lost["inertia/iyy-slugs_ft2"] < well["inertia/iyy-slugs_ft2"]


def test_motor_stop_windmills_and_brakes() -> None:
    stop = without(example("motor_stop", "left_propeller"), "until_s")
    well, free, stopped = healthy(), fly(stop), fly({**stop, "braked": True})
    speeds = [f.parts.plant["propulsion/engine/propeller-rpm"] for f in (well, free, stopped)]
    assert speeds[0] > speeds[1] > speeds[2]
    assert free.parts.plant["propulsion/engine/current-amperes"] == pytest.approx(0.0, abs=0.6)
    assert free.column("left_propeller_position")[-1] < 0.5 * well.column("left_propeller_position")[-1]


def test_prop_loss_motor_still_tracks() -> None:
    plant = fly(example("prop_loss", "left_propeller")).parts.plant
    command = plant["fcs/left-propeller/command-norm"]
    assert plant["fcs/throttle-pos-norm"] == pytest.approx(min(max(command, 0), 1))
    assert plant["propulsion/engine/thrust-lbs"] + plant["fcs/left-propeller/lost-thrust-lbs"] == 0.0


def test_only_a_surface_with_a_mass_of_its_own_can_be_lost() -> None:
    lost = TABLE["surface_lost"].model_validate(
        {"type": "surface_lost", "actuator": "left_ruddervator", "at_s": 1.0}
    )
    assert list(lost.faults(AIRCRAFT, 200.0)) == []
    servo = AIRCRAFT.actuators["left_ruddervator"].model_copy(update={"pointmass": None})
    bare = AIRCRAFT.model_copy(update={"actuators": {**AIRCRAFT.actuators, "left_ruddervator": servo}})
    (fault,) = lost.faults(bare, 200.0)
    assert fault.path == ("actuator",) and "no mass that could be lost" in fault.what
