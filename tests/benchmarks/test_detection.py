"""How soon a loss could be seen, against the formula and in a flight."""

from __future__ import annotations

import detection
import numpy as np
import pytest
from mission_list import BASE, Condition

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, DesignModel, load_design_model
from testbed.controllers.scaling import gust_density
from testbed.inputs.yaml_source import parse
from testbed.studies.drawing.builder import Builder, Task, Variant


@pytest.fixture(scope="module")
def model() -> DesignModel:
    return load_design_model(load_aircraft("vtail").folder / DESIGN_MODEL)


def test_evidence_is_missing_acceleration_over_gusts(model: DesignModel) -> None:
    rows, dt = 400, 0.005
    column = np.array(model.input_matrix)[:4, list(model.actuators).index("left_ruddervator")]
    gusts = gust_density(model)
    fast = np.full(rows, 2.0 * model.airspeed_m_s)  # four times the pressure of the reference flight
    found = detection.evidence(model, "left_ruddervator", np.full(rows, 3.0), fast, dt)
    missing = 4.0 * column * np.radians(3.0)
    assert found[-1] == pytest.approx(rows * dt * np.sum((missing / gusts) ** 2))
    assert np.all(np.diff(found) > 0)


def test_a_surface_at_neutral_shows_nothing(model: DesignModel) -> None:
    still = detection.evidence(model, "left_ruddervator", np.zeros(10), np.full(10, 18.0), 0.005)
    assert np.all(still == 0.0)


def test_a_flight_is_flagged_after_its_loss_is_visible() -> None:
    mission = next(m for m in detection.losses() if m.name == "fast_left_propeller_lost")
    values = {"controller": {"type": "adaptive_inversion"}, **Condition().values(mission, 42001)}
    builder = Builder(parse(BASE, "mission"), (Variant("", {}),))
    flight = detection.fly_and_weigh(builder.scenario(Task(0, 0, 42001, values)))
    metrics = flight.metrics
    assert 0.0 < metrics["visible_s"] < metrics["detection_delay_s"]
    assert metrics["visible_s"] < metrics["sure_s"]
