"""The Aerosonde: its published coefficients are what JSBSim flies, and it is flown healthy and after losses."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import yaml

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.aircraft.shipped import data_root
from testbed.common.units import METRES_PER_FOOT, NEWTON_METRES_PER_FOOT_POUND, NEWTONS_PER_POUND
from testbed.flight.flight import Flight, Outcome
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, accelerations, trim
from testbed.scenario.model import Scenario
from testbed.simulation import fly

HZ = 200
FOLDER = data_root() / "aircraft" / "aerosonde"
BOOK: dict[str, Any] = yaml.safe_load((FOLDER / "coefficients.yaml").read_text(encoding="utf-8"))
ELEVATOR, AILERON, RUDDER, PROPELLER = range(4)
MISSION = [{"at_s": 10, "altitude_m": 220, "heading_deg": 120}]


@pytest.fixture(scope="module")
def aerosonde() -> Aircraft:
    return load_aircraft("aerosonde")


@pytest.fixture(scope="module")
def level(aerosonde: Aircraft) -> Trim:
    return trim(Plant(aerosonde, HZ), 25.0, 200.0)


def moments(aircraft: Aircraft, level: Trim, state: dict[str, float], commands: list[float]) -> np.ndarray:
    """Cl, Cm, Cn of the air's moments on the loaded model."""
    plant = Plant(aircraft, HZ)
    accelerations(plant, {**level.state, **state}, commands)
    pascal = plant["aero/qbar-psf"] * NEWTONS_PER_POUND / METRES_PER_FOOT**2
    wing = BOOK["wing"]
    lengths = np.array([wing["span_m"], wing["chord_m"], wing["span_m"]])
    torque = [plant[f"moments/{axis}-aero-lbsft"] * NEWTON_METRES_PER_FOOT_POUND for axis in "lmn"]
    return np.array(torque) / (pascal * wing["area_m2"] * lengths)


@pytest.mark.parametrize(
    ("index", "name"), [(ELEVATOR, "elevator"), (AILERON, "aileron"), (RUDDER, "rudder")]
)
def test_surfaces_have_their_published_power(aerosonde: Aircraft, level: Trim, index: int, name: str) -> None:
    ends = []
    for sign in (1.0, -1.0):
        commands = list(level.commands)
        commands[index] += sign * 0.05
        ends.append(moments(aerosonde, level, {}, commands))
    book = {**BOOK["longitudinal"], **BOOK["lateral"]}
    expected = [book.get(f"{axis}_{name}", 0.0) for axis in ("Cl", "Cm", "Cn")]
    np.testing.assert_allclose((ends[0] - ends[1]) / 0.1, expected, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize(
    ("name", "length"), [("alpha", None), ("beta", None), ("p", "span_m"), ("q", "chord_m"), ("r", "span_m")]
)
def test_derivatives_are_the_published_ones(
    aerosonde: Aircraft, level: Trim, name: str, length: str | None
) -> None:
    step = 0.01
    at = {"p": 0.0, "q": 0.0, "r": 0.0, **level.state}.get(name, 0.0)
    ends = [moments(aerosonde, level, {name: at + sign * step}, list(level.commands)) for sign in (1.0, -1.0)]
    unit = BOOK["wing"][length] / (2.0 * 25.0) if length else 1.0
    book = {**BOOK["longitudinal"], **BOOK["lateral"]}
    expected = [book.get(f"{axis}_{name}", 0.0) for axis in ("Cl", "Cm", "Cn")]
    np.testing.assert_allclose((ends[0] - ends[1]) / (2 * step * unit), expected, rtol=2e-3, atol=2e-3)


def test_thrust_and_torque_are_the_published_polynomials(aerosonde: Aircraft, level: Trim) -> None:
    plant = Plant(aerosonde, HZ)
    accelerations(plant, level.state, level.commands)
    density, n = (
        plant["atmosphere/rho-slugs_ft3"] * 515.378818393,
        plant["propulsion/engine[0]/propeller-rpm"] / 60,
    )
    d = BOOK["propeller"]["diameter_m"]
    advance = plant["velocities/u-aero-fps"] * METRES_PER_FOOT / (n * d)
    thrust, torque = (
        density * n**2 * d**power * sum(k * advance**i for i, k in enumerate(BOOK["propeller"][name]))
        for name, power in (("CT", 4), ("CQ", 5))
    )
    assert level.positions[PROPELLER] == pytest.approx(thrust, rel=0.01)
    measured = plant["propulsion/engine[0]/propeller-torque-ftlb"] * NEWTON_METRES_PER_FOOT_POUND
    assert abs(measured) == pytest.approx(torque, rel=0.01)


def test_its_files_are_those_of_its_coefficients() -> None:
    line = [sys.executable, str(FOLDER / "write.py"), "--check"]
    result = subprocess.run(line, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


def test_its_design_model_is_that_of_its_files(aerosonde: Aircraft) -> None:
    assert load_design_model(FOLDER / DESIGN_MODEL).identified_from == aerosonde.fingerprint()


def flown(*failures: dict[str, Any]) -> Flight:
    return fly(
        Scenario.model_validate(
            {
                "name": "test",
                "aircraft": "aerosonde",
                "duration_s": 60,
                "initial": {"altitude_m": 200, "airspeed_m_s": 25, "heading_deg": 90},
                "controller": {"type": "adaptive_inversion"},
                "commands": MISSION,
                "failures": list(failures),
            }
        )
    )


def errors(flight: Flight, from_s: float) -> tuple[float, float]:
    """Largest errors of altitude [m] and heading [deg] from a time on."""
    log = flight.log[flight.log.time_s >= from_s]
    heading = (log.heading_deg - log.heading_command_deg + 180) % 360 - 180
    return float((log.altitude_m - log.altitude_command_m).abs().max()), float(heading.abs().max())


def test_healthy_it_turns_and_climbs() -> None:
    flight = flown()
    assert flight.outcome is Outcome.completed
    altitude, heading = errors(flight, 0.0)
    print(f"worst {altitude:.2f} m, {heading:.2f} deg")
    assert altitude < 1.0
    assert heading < 5.0


@pytest.mark.parametrize("lost", ["aileron", "rudder"])
def test_one_of_aileron_and_rudder_is_enough(lost: str) -> None:
    """The turn is flown late where the loss and the manoeuvre meet; in the last 20 s everything is where it should be."""
    flight = flown({"type": "effectiveness", "actuator": lost, "at_s": 5, "value": 0.0})
    assert flight.outcome is Outcome.completed
    altitude, heading = errors(flight, 40.0)
    print(f"{lost} lost: settled to {altitude:.3f} m, {heading:.3f} deg")
    assert altitude < 0.2
    assert heading < 0.5
    if lost == "aileron":
        assert flight.log.aileron_failed.iloc[-1] == 1
