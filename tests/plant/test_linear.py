"""The linear model against the flown aircraft, and in python-control."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import expm

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.common.signals import STATE
from testbed.inputs.problems import BadInput
from testbed.plant.jsbsim import Plant
from testbed.plant.linear import LinearModel
from testbed.plant.trim import begin_at, trimmed_start

RATE_HZ, STEPS = 400, 800


@pytest.fixture(scope="module")
def model() -> LinearModel:
    return testbed.linearise("vtail")


def flown(actuator: int, change: float) -> np.ndarray:
    """[STEPS, states] truth of the open loop from the trim on, with one command changed."""
    aircraft = load_aircraft("vtail")
    plant = Plant(aircraft, RATE_HZ)
    start = trimmed_start(aircraft, RATE_HZ, 18.0, 300.0, math.pi / 2)
    begin_at(plant, start)
    commands, rows = np.array(start.commands), []
    commands[actuator] += change
    for _ in range(STEPS):
        plant.command(commands)
        plant.sample()
        rows.append(plant.read().copy())
        plant.step()
    return np.array(rows)


def predicted(model: LinearModel, actuator: int, change: float) -> np.ndarray:
    n = len(model.A)
    whole = np.zeros((n + 1, n + 1))
    whole[:n, :n], whole[:n, n] = model.A, model.B[:, actuator] * change
    step, x = expm(whole / RATE_HZ), np.eye(n + 1)[n]
    rows = [x := step @ x for _ in range(STEPS - 1)]
    return np.array([np.zeros(n), *(row[:n] for row in rows)])


@pytest.mark.parametrize(("actuator", "change", "tolerance"), [(0, 0.005, 0.025), (2, 0.01, 0.15)])
def test_it_flies_as_the_truth_does(
    model: LinearModel, actuator: int, change: float, tolerance: float
) -> None:
    """Two seconds after a step. The torque of a propeller acts before its thrust, which one lag for both leaves out."""
    truth = flown(actuator, change) - flown(actuator, 0.0)
    linear = predicted(model, actuator, change)
    for name in ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch", "altitude"):
        true, found = truth[:, STATE.index(name)], linear[:, list(model.states).index(name)]
        assert np.abs(true - found).max() < tolerance * np.abs(true).max(), name
    still = np.abs(linear[:, list(model.states).index("q")]).max()
    assert still > 1e-4  # negative control: it moves


def test_names_units_and_trim(model: LinearModel) -> None:
    n = len(model.inputs)
    assert model.A.shape == (10 + n, 10 + n) and model.B.shape == (10 + n, n)
    assert model.C.shape == (len(model.outputs), 10 + n) and model.D.shape == (len(model.outputs), n)
    assert list(model.inputs.values()) == ["rad", "rad", "throttle", "throttle"]
    assert model.trim["airspeed"] == 18.0 and 0.4 < model.trim["left_propeller"] < 0.7
    slower = testbed.linearise("vtail", {"airspeed_m_s": 16.0})
    q, tail = list(model.states).index("q"), list(model.states).index("left_ruddervator_position")
    ratio = slower.A[q, tail] / model.A[q, tail]
    assert ratio == pytest.approx((16 / 18) ** 2, rel=0.05)  # dynamic pressure


def test_bad_conditions_are_refused() -> None:
    with pytest.raises(BadInput, match="did you mean airspeed_m_s"):
        testbed.linearise("vtail", {"airspeed": 18.0})
    with pytest.raises(BadInput, match="no steady flight"):
        testbed.linearise("vtail", {"airspeed_m_s": 3.0})


def test_it_is_a_state_space_of_python_control(model: LinearModel) -> None:
    control = pytest.importorskip("control", reason="the linear extra")
    system = model.state_space()
    assert system.input_labels == list(model.inputs) and system.output_labels == list(model.outputs)
    assert np.allclose(np.sort_complex(control.poles(system)), np.sort_complex(np.linalg.eigvals(model.A)))
