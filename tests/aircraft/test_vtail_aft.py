"""The v-tail with its battery aft: as unstable as it says, otherwise the v-tail, and flown after losses."""

from __future__ import annotations

import importlib.util
import math
import subprocess
import sys

import numpy as np
import pytest

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.aircraft.shape import load_shape
from testbed.aircraft.shipped import data_root
from testbed.controllers.inversion.degraded_aircraft import motion
from testbed.controllers.inversion.steady_flights import jacobian
from testbed.controllers.records import REGULATOR_STATE
from testbed.flight.flight import Outcome
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import begin_at, trim
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

HZ = 200
DOUBLING_S = 0.505


@pytest.fixture(scope="module")
def aft() -> Aircraft:
    return load_aircraft("vtail_aft")


def test_a_disturbance_doubles_in_half_a_second(aft: Aircraft) -> None:
    """Let go in JSBSim from its trim with 0.03 deg/s of pitch rate; from 2.5 s on, when the other roots have died out."""
    plant = Plant(aft, HZ)
    level = trim(plant, 18.0, 300.0)
    begin_at(plant, level)
    plant.place({**level.state, "q": 0.0005})
    deviation = []
    for _ in range(4 * HZ):
        plant.step()
        deviation.append(plant["attitude/theta-rad"] - level.state["pitch"])
    growth = math.log(deviation[4 * HZ - 1] / deviation[round(2.5 * HZ) - 1]) / 1.5
    print(f"doubles in {math.log(2.0) / growth:.3f} s")
    assert deviation[-1] < math.radians(3.0), "still small"
    assert math.log(2.0) / growth == pytest.approx(DOUBLING_S, rel=0.02)


def test_the_design_model_is_as_unstable(aft: Aircraft) -> None:
    model = load_design_model(aft.folder / DESIGN_MODEL)
    level = {"airspeed": model.airspeed_m_s, "alpha": model.alpha_rad, "pitch": model.alpha_rad}
    x = np.array([{**level, "altitude": model.altitude_m}.get(name, 0.0) for name in REGULATOR_STATE])
    slopes = jacobian(lambda z: motion(model, z, np.array(model.trim), np.ones(4)), x)
    assert math.log(2.0) / max(np.linalg.eigvals(slopes).real) == pytest.approx(DOUBLING_S, rel=0.05)


def test_it_is_the_vtail_but_for_the_balance(aft: Aircraft, vtail: Aircraft) -> None:
    ours, theirs = Plant(aft, HZ), Plant(vtail, HZ)
    here, there = (trim(plant, 18.0, 300.0) for plant in (ours, theirs))
    assert ours["inertia/mass-slugs"] == pytest.approx(theirs["inertia/mass-slugs"], rel=1e-9)
    assert ours["inertia/cg-x-in"] - theirs["inertia/cg-x-in"] == pytest.approx(0.0971 / 0.0254, abs=0.05)
    assert here.positions[0] == pytest.approx(there.positions[0], abs=0.05)
    assert aft.actuators == vtail.actuators
    assert aft.control == vtail.control


@pytest.mark.parametrize("file", ["left_tail_fail", "left_propeller_fail"])
def test_it_is_flown_after_a_loss(file: str) -> None:
    flight = fly(
        load_scenario(f"scenarios/{file}.yaml", ["aircraft=vtail_aft", "duration_s=40", "requirements=[]"])
    )
    settled = flight.log[-200:]
    assert flight.outcome is Outcome.completed
    assert abs(settled.altitude_m - settled.altitude_command_m).max() < 0.2
    assert abs(settled.heading_deg - settled.heading_command_deg).max() < 0.5


@pytest.mark.skipif(
    importlib.util.find_spec("aerosandbox") is None,
    reason="the model is derived again only with AeroSandbox (pip install 'testbed[derive]')",
)
def test_it_can_be_derived_again() -> None:
    script = data_root() / "aircraft" / "vtail_aft" / "ballast.py"
    result = subprocess.run(
        [sys.executable, str(script), "--check"], capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stdout + result.stderr


def test_it_looks_like_the_v_tail(aft: Aircraft) -> None:
    """A replay would else show a conventional aircraft."""
    shape = load_shape(aft.folder)
    assert shape is not None and shape == load_shape(aft.folder.parent / "vtail")
    assert {part.actuator for part in (*shape.panels, *shape.propulsors)} - {None} == set(aft.actuators)
