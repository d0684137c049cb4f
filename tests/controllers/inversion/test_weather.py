"""Broken in weather: what the weighted estimation, the diagnosis and the regulators promise, flown and read from the log."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from command_line import ROOT

from testbed.common.signals import STATE
from testbed.controllers.inversion.estimator import adapt_weighted, update_model_error_variance
from testbed.controllers.inversion.jam_detection import detect_jam, take_for_jammed
from testbed.controllers.inversion.law import monitor, regressor
from testbed.controllers.outer_loops import accumulate
from testbed.controllers.records import memory_dtype, model_dtype, settings_dtype
from testbed.flight.flight import Flight, Outcome
from testbed.inputs.yaml_source import parse
from testbed.simulation import fly
from testbed.sweeps.drawing.builder import Builder, Task, Variant

sys.path.insert(0, str(ROOT / "benchmarks"))
import hold_it

ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
W25 = 25.0


def flown(seed: int, values: Mapping[str, Any]) -> Flight:
    """The flight of the campaign `hold_it` with these settings."""
    text = hold_it.BASE.format(controller=hold_it.CONTROLLER)
    return fly(Builder(parse(text), (Variant("", {}),)).scenario(Task(0, 0, seed, values)))


def cell(group: str, *lost: tuple[str, float]) -> hold_it.Cell:
    return next(c for c in hold_it.cells([W25]) if (c.group, c.w20_ft_s, c.lost) == (group, W25, lost))


def worst(flight: Flight, from_s: float = 60.0) -> tuple[float, float]:
    """Largest errors of altitude [m] and heading [deg] against the references from a time on."""
    log = flight.log[flight.log.time_s >= from_s]
    heading = (log.heading_deg - log.heading_command_deg + 180.0) % 360.0 - 180.0
    return float((log.altitude_m - log.altitude_command_m).abs().max()), float(heading.abs().max())


def said(flight: Flight, kind: str) -> list[str]:
    return [str(e.get("actuator") or e.get("text")) for e in flight.events if e["kind"] == kind]


# Flights in which a false second flag, or no mode for what was left, once lost the flight.
HARD = [
    ("left_ruddervator", 90),
    ("right_ruddervator", 81),
    ("left_propeller", 94),
    ("left_propeller", 2005),
    ("right_propeller", 45),
    ("right_propeller", 49),
]


@pytest.mark.parametrize(("actuator", "seed"), HARD)
def test_a_total_loss_is_held_with_a_model_that_is_20_percent_off(actuator: str, seed: int) -> None:
    of = cell(hold_it.LOST_ERROR, (actuator, 0.0))
    flight = flown(seed, of.values(seed))
    altitude, heading = worst(flight)
    assert flight.outcome is Outcome.completed
    assert altitude <= of.altitude_m and heading <= of.heading_deg
    assert set(said(flight, "detection")) == {actuator}
    assert not said(flight, "false_alarm")


def test_sinking_air_costs_height_but_not_the_aircraft() -> None:
    """One propeller left while the air sinks at 3.5 m/s for 15 s: more than full throttle can climb against."""
    gust = {"at_s": 70.0, "magnitude_m_s": [0.0, 0.0, 3.5], "frame": "ned", "duration_s": 3.0, "hold_s": 9.0}
    lost = cell(hold_it.LOST, ("left_propeller", 0.0))
    calm = {"atmosphere.turbulence_w20_m_s": 0.0, "atmosphere.gusts": [gust]}
    flight = flown(3, {**lost.values(3), **calm})
    assert flight.outcome is Outcome.completed
    during = flight.log[flight.log.time_s.between(70.0, 90.0)]
    assert during.wind_down_m_s.max() == pytest.approx(3.5, abs=0.05)
    assert during.airspeed_m_s.min() > 14.5, "speed is what it must not lose"
    assert worst(flight, 105.0)[0] < 2.0, "height comes back"


BROKEN: dict[str, Mapping[str, Any]] = {
    "offset": {"type": "bias", "actuator": "left_ruddervator", "value": 5.0},
    "jammed": {"type": "stuck_at", "actuator": "left_ruddervator", "value": 10.0},
    "reversed": {"type": "reversal", "actuator": "left_ruddervator"},
    "propeller at full throttle": {"type": "hardover", "actuator": "right_propeller", "to": "max"},
}


@pytest.mark.parametrize("name", BROKEN)
def test_what_is_no_loss_of_effectiveness_is_called_so_and_held(name: str) -> None:
    failure = {**BROKEN[name], "at_s": hold_it.FAILURE_S}
    flight = flown(6, {"atmosphere.turbulence_w20_m_s": W25 * hold_it.FT_S, "failures": [failure]})
    altitude, heading = worst(flight)
    assert flight.outcome is Outcome.completed
    within = (
        (10.0, 20.0) if "propeller" in name else (5.0, 10.0)
    )  # 15 N and no way to have less: kept, not held
    assert altitude <= within[0] and heading <= within[1]
    jams = [text for text in said(flight, "diagnosis") if "not a loss of effectiveness" in text]
    assert [text.split(":")[0] for text in jams] == [failure["actuator"]]
    failed = {a for a in ACTUATORS if flight.log[f"{a}_failed"].iloc[-1] > 0.5}
    assert failed == {failure["actuator"]}


def test_a_loss_is_not_called_a_jam() -> None:
    """Negative control of the last: a lost surface, and one that keeps 30 %."""
    for value in (0.0, 0.3):
        of = cell(hold_it.LOST if value == 0.0 else hold_it.PARTIAL, ("left_ruddervator", value))
        flight = flown(6, of.values(6))
        assert not [text for text in said(flight, "diagnosis") if "not a loss" in text]


# ---- the estimator, alone


N = len(ACTUATORS)
RNG = np.random.default_rng(4)


def records() -> tuple[Any, Any, Any]:
    """Settings, model and memory of an estimator with round numbers."""
    c, m, s = (np.zeros(1, dtype(N))[0] for dtype in (settings_dtype, model_dtype, memory_dtype))
    c.dt, c.process_noise, c.model_error_rate, c.residual_time = 0.005, 0.1, 0.1, 1.0
    c.lambda_min, c.lambda_max, c.noise[:] = -10.0, 10.0, [2.0, 0.5, 0.15, 0.08]
    c.flag_std_max, c.threshold, c.recovery, c.persistence, c.recovery_time = 0.15, 0.15, 0.8, 0.2, 1.0
    m.low[:], m.high[:] = -3.0, 3.0
    s.lambda_hat[:], s.since_flag[:] = 1.0, math.inf
    s.P[:N, :N] = 0.01 * np.eye(N)
    s.model_error_variance[:] = [0.3, 0.4, 0.4, 0.05]
    return c, m, s


def test_the_weighted_gain_is_a_kalman_filters() -> None:
    """Against the filter in matrices, all four rows at once: they are the same filter when the noises are independent."""
    c, m, s = records()
    x, P = np.concatenate([s.lambda_hat, s.b]), s.P.copy()
    fade = np.diag([1.0] * N + [1.0 - c.model_error_rate * c.dt] * 4)
    Q = np.diag(
        [c.process_noise**2 * c.dt] * N + list(2.0 * c.model_error_rate * c.dt * s.model_error_variance)
    )
    R = np.diag(c.noise**2 / c.dt)
    for _ in range(200):
        phi, z = RNG.normal(size=(4, N)), RNG.normal(size=4)
        adapt_weighted(z, phi, np.zeros(N + 4), m, c, s)
        Hx = np.hstack([phi, np.eye(4)])
        x, P = fade @ x, fade @ P @ fade.T + Q
        K = P @ Hx.T @ np.linalg.inv(Hx @ P @ Hx.T + R)
        x, P = x + K @ (z - Hx @ x), P - K @ Hx @ P
    assert np.allclose(np.concatenate([s.lambda_hat, s.b]), x, rtol=1e-9, atol=1e-9)
    assert np.allclose(s.P, P, rtol=1e-9, atol=1e-9)


def estimate_after(phi: np.ndarray, missing: np.ndarray, doubts: bool) -> tuple[np.ndarray, np.ndarray]:
    """Estimates and their standard deviations after 20 s in which f_m leaves out a constant of each rate."""
    c, m, s = records()
    if not doubts:
        s.model_error_variance[:] = 0.0
    for _ in range(4000):
        adapt_weighted(phi @ np.ones(N) + missing, phi, np.zeros(N + 4), m, c, s)
    return s.lambda_hat.copy(), np.sqrt(np.diag(s.P)[:N])


def test_a_wrong_model_does_not_read_as_a_lost_actuator() -> None:
    """A propeller that hardly pulls, and 0.7 rad/s2 of yaw that the model does not know: the paper's filter is sure of
    a loss, with the model's own error estimated the estimate stays, or says that it is uncertain."""
    phi = np.diag([0.5, 5.0, 0.8, 0.6])
    missing = np.array([0.0, 0.0, -0.7, 0.0])
    bare, sure = estimate_after(phi, missing, doubts=False)
    assert bare[2] < 0.3 and sure[2] < 0.15
    doubting, unsure = estimate_after(phi, missing, doubts=True)
    assert doubting[2] > 0.4 and unsure[2] > 0.15
    assert np.allclose(doubting[[0, 1, 3]], 1.0, atol=0.05)


def test_the_model_is_doubted_as_its_terms_are_large() -> None:
    """doubt: floor^2 + model_doubt^2 x sum of squared changes, since the trim, of the terms of f_m and Phi lambda."""
    c, m, s = records()
    c.coefficient_error, c.model_error_std[:] = 0.2, [0.3, 0.3, 0.1, 0.1]
    m.airspeed, m.alpha, m.A[:], m.B[:] = 18.0, 0.05, RNG.normal(size=(4, 5)), RNG.normal(size=(4, N))
    m.servo[:] = 1.0
    y = np.zeros(1, np.dtype((np.record, [(name, np.float64) for name in STATE])))[0]
    y.airspeed, y.alpha, y.beta, y.p, y.q, y.r = 20.0, 0.08, 0.04, 0.1, -0.2, 0.3
    s.position[:], m.trim_position[:] = [0.5, -0.4, 1.5, 2.0], [0.2, 0.2, 1.4, 1.4]
    phi, pressure, speed = np.zeros((4, N)), (20.0 / 18.0) ** 2, 20.0 / 18.0
    regressor(pressure, m, s, phi)
    for _ in range(8000):
        update_model_error_variance(y, pressure, phi, m, c, s)
    x = np.array([pressure * 0.03, pressure * 0.04, speed * 0.1, speed * -0.2, speed * 0.3])
    squares = ((m.A * x) ** 2).sum(1) + ((pressure * m.B * (s.position - m.trim_position)) ** 2).sum(1)
    assert np.allclose(s.model_error_variance, c.model_error_std**2 + 0.04 * squares, rtol=1e-9)
    y.airspeed, y.alpha, y.beta, y.p, y.q, y.r = 18.0, 0.05, 0.0, 0.0, 0.0, 0.0
    s.position[:] = m.trim_position
    regressor(1.0, m, s, phi)
    for _ in range(8000):
        update_model_error_variance(y, 1.0, phi, m, c, s)
    assert np.allclose(s.model_error_variance, c.model_error_std**2, rtol=1e-9), "the trim itself is known"


def test_only_a_sure_estimate_condemns() -> None:
    c, _, s = records()
    s.lambda_hat[0] = 0.05
    for variance, failed in ((0.16**2, 0.0), (0.14**2, 1.0)):
        s.P[0, 0] = variance
        changed = [monitor(c, s) for _ in range(41)]
        assert s.failed[0] == failed and sum(changed) == failed
    assert s.jammed[0] == 0.0


def test_a_sure_negative_estimate_is_a_reversal() -> None:
    c, m, s = records()
    s.lambda_hat[1], s.position[1] = -0.9, 0.5
    c.jam_sigma, c.jam_time = 4.0, 1.0
    assert not any(detect_jam(np.zeros(4), 1.0, m, c, s) for _ in range(40))
    assert detect_jam(np.zeros(4), 1.0, m, c, s) == 1
    assert s.jammed[1] == 1.0 and s.failed[1] == 1.0
    assert s.lambda_hat[1] == pytest.approx(-0.45), "from now on its position"


def test_a_jam_takes_back_what_it_did_to_the_others() -> None:
    """Flags of just before are taken back and estimates begin again; an older failure stays one."""
    _, m, s = records()
    s.lambda_hat[:] = [0.1, 0.4, 0.02, 0.9]
    s.failed[:], s.since_flag[:] = [1.0, 0.0, 1.0, 0.0], [0.5, math.inf, 30.0, math.inf]
    s.b[:] = 1.0
    take_for_jammed(3, 2.5, m, s)
    assert s.failed.tolist() == [0.0, 0.0, 1.0, 1.0] and s.jammed.tolist() == [0.0, 0.0, 0.0, 1.0]
    assert s.lambda_hat.tolist() == [1.0, 1.0, 0.02, 2.5]
    assert not s.b.any() and np.allclose(np.diag(s.P)[N:], s.model_error_variance)


def test_an_integral_neither_winds_up_nor_latches() -> None:
    """Within its limit an error integrates; at it, only back towards zero, and no faster than at the limit."""
    assert accumulate(3.0, 1.5, 2.0, 0.1) == pytest.approx(3.15)
    assert accumulate(3.0, 2.0, 2.0, 0.1) == 3.0
    assert accumulate(0.0, -2.0, 2.0, 0.1) == 0.0
    assert accumulate(-45.0, 100.0, 5.0, 0.1) == pytest.approx(-44.5)
