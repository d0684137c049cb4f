"""A model that feels air that rotates: the same bits without rotation, and as if the aircraft rotated the other way with it."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.model_files.rotating_air import put_rotation
from testbed.plant.jsbsim import Plant

LEVEL = {"airspeed": 18.0, "altitude": 300.0, "alpha": 0.03, "pitch": 0.03}


def plant(rotating_air: bool, name: str = "vtail") -> Plant:
    made = Plant(load_aircraft(name), 200, 1, rotating_air)
    made.place(LEVEL)
    return made


@pytest.mark.parametrize("name", ["vtail", "aerosonde"])
def test_without_rotation_nothing_changes(name: str) -> None:
    one, other = plant(False, name), plant(True, name)
    for _ in range(200):
        one.step()
        other.step()
    assert one.read().tobytes() == other.read().tobytes()


def moments(gust: dict[str, float], **own: float) -> np.ndarray:
    """[3] aerodynamic moments in air that rotates, for an aircraft that rotates [lbf ft]."""
    made = plant(True)
    made.place({**LEVEL, **own})
    made.blow([0.0, 0.0, 0.0, *(gust.get(rate, 0.0) for rate in "pqr")])
    made.settle(1)
    return np.array([made[f"moments/{m}-aero-lbsft"] for m in "lmn"])


@pytest.mark.parametrize("rate", ["p", "r"])
def test_rotating_air_acts_as_rotation_the_other_way(rate: str) -> None:
    still, gust, turning = moments({}), moments({rate: -0.2}), moments({}, **{rate: 0.2})
    np.testing.assert_allclose(gust - still, turning - still, rtol=1e-3, atol=1e-6)
    assert np.max(np.abs(gust - still)) > 0.01
    np.testing.assert_allclose(moments({rate: 0.2}, **{rate: 0.2}), still, atol=1e-4)


def test_air_that_rotates_nose_up_lifts_the_nose() -> None:
    """It is as if the aircraft rotated nose down, but for the moment of the rate of alpha, which is its own."""
    still, up, down = (moments({"q": rate}) for rate in (0.0, 0.2, -0.2))
    assert up[1] - still[1] > 0.1
    assert up[1] - still[1] == pytest.approx(still[1] - down[1], rel=1e-6)


def test_a_model_with_no_aerodynamics_of_its_own_stays_as_it_is() -> None:
    for text in ("<fdm_config/>", '<fdm_config><aerodynamics file="a"/></fdm_config>'):
        root = ElementTree.fromstring(text)
        before = ElementTree.tostring(root)
        put_rotation(root)
        assert ElementTree.tostring(root) == before
