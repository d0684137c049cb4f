"""Actuators that swing by themselves: told from lost and jammed ones while given up, and used again."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from command_line import ROOT
from short_flights import worst_errors
from vtail_setup import WEATHER, Records, records_of, vtail_setup

from testbed.controllers.inversion.estimator import HEALTHY_VARIANCE
from testbed.controllers.inversion.jam_detection import detect_jam
from testbed.controllers.inversion.swing_detection import (
    FORCE_TIME_S,
    SLOWEST_S,
    detect_swings,
    expect_swings,
    own_force,
)
from testbed.flight.breakage import RECOVERED
from testbed.flight.flight import Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

SETUP = vtail_setup(WEATHER)
N = 4


def given_up(actuator: int = 0) -> Records:
    """An actuator has been flagged as lost, and stands at its trim position."""
    made = records_of(SETUP)
    m, c, _, s, _ = made
    s.model_error_variance[:] = c.model_error_std**2
    detect_swings(np.zeros(4), 1.0, m, c, s)
    s.failed[actuator], s.lambda_hat[actuator], s.since_flag[actuator] = 1, 0.0, 0.0
    s.position[:] = m.trim_position
    return made


def seconds_until_used(made: Records, force: Callable[[float], float], most_s: float = 40.0) -> float:
    """When the given-up left ruddervator is used again, if its force is this function of time [scaled]; infinity for never."""
    m, c, _, s, _ = made
    column = np.array(m.B)[:, 0]
    for step in range(round(most_s / c.dt)):
        if detect_swings(column * force(step * c.dt), 1.0, m, c, s):
            return step * c.dt
    return math.inf


@pytest.mark.parametrize(("amplitude", "hz"), [(1.3, 0.5), (0.7, 1.0), (0.9, 0.2), (-0.9, 0.2)])
def test_a_swinging_actuator_is_used_again_within_two_periods(amplitude: float, hz: float) -> None:
    made = given_up()
    s = made.s
    used = seconds_until_used(made, lambda t: amplitude * math.sin(2.0 * math.pi * hz * t))
    assert used < 2.0 / hz
    assert not s.failed.any() and not s.jammed.any() and s.lambda_hat.tolist() == [1.0] * N
    assert np.diag(s.P)[:N].tolist() == [HEALTHY_VARIANCE] * N
    assert s.own_noise[0] == pytest.approx(2.0 * math.pi * hz * amplitude**2, rel=0.2)
    assert s.own_noise[1:].tolist() == [0.0] * (N - 1)


@pytest.mark.parametrize(
    "force",
    [
        pytest.param(lambda t: 2.0, id="jam"),
        pytest.param(lambda t: 2.0 - 2.0 * math.exp(-t) * math.cos(4.0 * t), id="comes to rest"),
        pytest.param(lambda t: min(0.2 * t, 2.0), id="runaway"),
        pytest.param(lambda t: math.sin(math.pi * t / (1.1 * SLOWEST_S)), id="too slow"),
        pytest.param(lambda t: 0.15 * math.sin(2.0 * math.pi * t), id="weak and strong by turns"),
    ],
)
def test_other_forces_are_no_swings(force: Callable[[float], float]) -> None:
    """The last is within what the effectiveness at the trim position explains."""
    made = given_up()
    assert seconds_until_used(made, force) == math.inf
    assert made.s.failed[0] and not made.s.own_noise.any()


def test_gusts_of_the_expected_density_are_no_swings() -> None:
    m, c, _, s, _ = given_up()
    rng = np.random.default_rng(5)
    sigma = c.noise / math.sqrt(c.dt)
    assert not any(detect_swings(sigma * rng.normal(size=4), 1.0, m, c, s) for _ in range(12000))


def test_the_deviation_of_the_force_is_that_of_its_mean_in_white_noise() -> None:
    """Negative control of the threshold's size, without model error."""
    m, c, _, s, _ = given_up()
    s.model_error_variance[:] = 0.0
    rng = np.random.default_rng(6)
    sigma = c.noise / math.sqrt(c.dt)
    forces = np.array([own_force(0, sigma * rng.normal(size=4), 1.0, m, c, s) for _ in range(20000)])
    a = c.dt / FORCE_TIME_S
    assert np.std(forces[:, 0]) * math.sqrt(a / (2.0 - a)) == pytest.approx(forces[0, 1], rel=0.03)


def test_flags_set_since_are_taken_back_and_older_ones_stay() -> None:
    made = given_up()
    s = made.s
    s.failed[2:], s.jammed[2] = 1, 1
    s.since_flag[:] = 10.0, math.inf, 9.0, 11.0
    assert seconds_until_used(made, lambda t: math.sin(4.0 * t)) < 10.0
    assert s.failed.tolist() == [0, 0, 0, 1] and not s.jammed.any()


def test_one_that_was_found_reversed_since_stays_so() -> None:
    """Its force went where no swing of another takes it."""
    made = given_up()
    s = made.s
    s.failed[2], s.reversed[2], s.lambda_hat[2] = 1, 1, -1.0
    s.since_flag[:] = 10.0, math.inf, 9.0, math.inf
    assert seconds_until_used(made, lambda t: math.sin(4.0 * t)) < 10.0
    assert s.failed[2] == s.reversed[2] == 1 and s.lambda_hat[2] == -1.0


def test_it_is_used_again_once_and_not_taken_for_jammed() -> None:
    """Should it turn out to be lost after all, it stays given up."""
    made = given_up()
    m, c, _, s, _ = made
    assert seconds_until_used(made, lambda t: math.sin(4.0 * t)) < math.inf
    column = np.array(m.B)[:, 0]
    assert not any(detect_jam(6.0 * column, 1.0, m, c, s) for _ in range(1000))
    s.failed[0], s.lambda_hat[0] = 1, 0.0
    assert seconds_until_used(made, lambda t: math.sin(4.0 * t)) == math.inf


def test_its_swings_are_noise_of_the_model_error_along_its_column() -> None:
    m, c, _, s, _ = given_up()
    before, s.own_noise[1] = s.P.copy(), 3.0
    expect_swings(1.2, m, c, s)
    column = 1.2 * np.array(m.B)[:, 1]
    assert s.P[N:, N:] - before[N:, N:] == pytest.approx(3.0 * c.dt * np.outer(column, column))
    assert (s.P[:N] == before[:N]).all()


@pytest.mark.parametrize(
    ("actuator", "frequency_hz"),
    [
        ("left_ruddervator", 0.5),
        ("left_ruddervator", 0.4),
        ("right_ruddervator", 0.4),
        ("right_ruddervator", 0.5),
    ],
)
def test_a_surface_that_swings_is_flown_with(actuator: str, frequency_hz: float) -> None:
    """It is given up for some seconds, and said to be used again."""
    swing = f"amplitude: 15, frequency_hz: {frequency_hz}"
    failure = f"failures=[{{type: oscillation, actuator: {actuator}, at_s: 5, {swing}}}]"
    more = ["controller={type: adaptive_inversion}", "requirements=[]", "duration_s=40"]
    flight = fly(load_scenario(ROOT / "scenarios" / "jammed_ruddervator.yaml", [failure, *more]))
    altitude, heading, _ = worst_errors(flight, 15.0)
    assert flight.outcome is Outcome.completed
    assert flight.log[f"{actuator}_failed"].max() == 1 and flight.log[f"{actuator}_failed"].iloc[-1] == 0
    assert altitude < RECOVERED["altitude"] and heading < RECOVERED["heading"]
