"""Surfaces that have an offset: told from jammed ones by the commands that follow, and used on."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import ROOT
from short_flights import worst_errors
from vtail_setup import WEATHER, Records, records_of, vtail_setup

from testbed.controllers.inversion.estimator import adapt_weighted, expect_change, predict
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, MEAN_S
from testbed.controllers.inversion.jam_detection import detect_jam
from testbed.controllers.inversion.law import compensate, measured_error, reach, regressor
from testbed.controllers.inversion.offset_detection import (
    JAM_SIGMA,
    expect_offset,
    follow_offsets,
    follows,
    is_offset,
    keep_offsets,
    position_behind,
    time_to_stand_still,
)
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

SETUP = vtail_setup(WEATHER)
N = 4
FAILURE_S = 1.0
Position = Callable[[float, float], float]
"""True position of a surface at a time, if it is commanded to the second number [s, scaled]."""


def records() -> Records:
    made = records_of(SETUP)
    made.s.model_error_variance[:] = made.c.model_error_std**2
    made.c.filter_rate = 0.0
    return made


def estimated(made: Records, actuator: int, position: Position, start_s: float, end_s: float) -> None:
    """Estimate and diagnose while commands swing about the trim, and this surface goes where `position` says."""
    m, c, _, s, w = made
    for step in range(round(start_s / c.dt), round(end_s / c.dt)):
        t = step * c.dt
        s.position[:] = m.trim_position
        s.position[:2] += 0.4 * np.sin(np.array([5.0, 3.5]) * t)
        s.filtered_position[1] = s.position
        true = np.array(s.position)
        true[actuator] = position(t, true[actuator])
        w.z[:] = np.array(m.B) @ true
        regressor(1.0, m, s, w.phi)
        measured_error(w.z, w.phi, s, w.e)
        expect_change(w.e, w.phi, m, c, s, np.zeros(4))
        adapt_weighted(w.z, w.phi, w.P_h, m, c, s)
        detect_jam(1.0, m, c, s)


def healthy_first(actuator: int, position: Position, end_s: float) -> Records:
    made = records()
    estimated(made, actuator, lambda _, command: command, 0.0, FAILURE_S)
    estimated(made, actuator, position, FAILURE_S, end_s)
    return made


@pytest.mark.parametrize("actuator", [0, 1])
@pytest.mark.parametrize("offset", [-1.5, 0.7, 1.5])
def test_a_surface_that_follows_with_an_offset_is_not_given_up(actuator: int, offset: float) -> None:
    s = healthy_first(actuator, lambda _, command: command + offset, 5.0).s
    assert not s.failed.any() and not s.jammed.any()
    assert [bool(is_offset(i, s)) for i in (actuator, 1 - actuator)] == [True, False]
    assert s.shift[actuator] == pytest.approx(offset, rel=0.3)
    assert s.lambda_hat[actuator] == pytest.approx(1.0, abs=0.25)


@pytest.mark.parametrize("actuator", [0, 1])
@pytest.mark.parametrize("position", [-2.0, 1.0, 2.0])
def test_a_surface_that_does_not_follow_is_jammed_where_it_is(actuator: int, position: float) -> None:
    s = healthy_first(actuator, lambda _, __: position, 3.0).s
    assert s.jammed.tolist() == s.failed.tolist() == [int(i == actuator) for i in range(N)]
    assert not any(is_offset(i, s) for i in range(N)) and not s.shift.any()
    assert s.lambda_hat[actuator] == pytest.approx(position, abs=0.1)


def test_an_offset_that_stops_to_follow_is_a_jam() -> None:
    made = healthy_first(0, lambda _, command: command + 1.0, 4.0)
    assert is_offset(0, made.s)
    estimated(made, 0, lambda _, __: 1.2, 4.0, 8.0)
    assert made.s.jammed.tolist() == [1, 0, 0, 0] and not is_offset(0, made.s)
    assert made.s.lambda_hat[0] == pytest.approx(1.2, abs=0.2)


@pytest.mark.parametrize("turns", [1, 0])
def test_what_no_effectiveness_explains_is_an_offset_where_it_is_told_from_gusts(turns: int) -> None:
    """The variance goes to the model error along its column; of thrust that turns nothing, to its effectiveness."""
    m, c, _, s, _ = records()
    c.turns[1], before = turns, s.P.copy()
    phi = np.array(m.B) * 0.2
    error = phi[:, 1] * 6.0
    for _ in range(5):
        expect_change(30.0 * error, phi, m, c, s, np.zeros(4))
    grown = s.P - before
    along = np.outer(phi[:, 1], phi[:, 1])
    assert (grown[1, 1] == 0.0) == bool(turns)
    share = grown[N:, N:].sum() / along.sum()
    assert (share > 1.0) == bool(turns)
    assert grown[N:, N:] == pytest.approx(share * along)


def test_what_changes_after_a_move_is_position_too() -> None:
    """Half of its force is missing, which half of the effectiveness explains as well."""
    m, c, _, s, _ = records()
    phi = np.array(m.B) * 3.0
    for moved in (0.0, 1.0):
        s.moved[1], s.recent[:], before = moved, -0.5 * phi[:, 1], s.P.copy()
        expect_change(-0.5 * phi[:, 1], phi, m, c, s, np.zeros(4))
        grown = s.P - before
        assert (grown[1, 1] > 0.0, grown[N:, N:].any()) == (moved == 0.0, moved != 0.0)


def test_each_hypothesis_is_believed_when_the_other_is_out_of_question() -> None:
    m, c, _, s, _ = records()
    s.b[:] = 2.0 * np.array(m.B)[:, 0]
    for estimate, sigmas, still, moves in (
        (0.1, 1.05, True, False),
        (0.1, 0.95, False, False),
        (0.9, 1.05, False, True),
        (0.9, 0.95, False, False),
    ):
        s.lambda_hat[0], s.P[0, 0] = estimate, (0.9 / (sigmas * BEYOND_DOUBT)) ** 2
        assert (time_to_stand_still(0, 1.0, m, c, s) > 0.0, bool(follows(0, m, s))) == (still, moves)


@pytest.mark.parametrize(("sigmas", "time"), [(1.4, MEAN_S), (1.6, 0.0), (-2.9, MEAN_S), (-3.1, 0.1)])
def test_one_that_has_moved_with_a_small_force_is_jammed_if_its_effectiveness_is_about_0(
    sigmas: float, time: float
) -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[0], s.P[0, 0], s.moved[0] = sigmas * 0.15, 0.15**2, 1.0
    assert time_to_stand_still(0, 1.0, m, c, s) == pytest.approx(time)
    s.moved[0] = 0.0
    assert time_to_stand_still(0, 1.0, m, c, s) == 0.0


def test_a_lost_surface_without_a_force_in_the_model_error_does_not_look_jammed() -> None:
    m, c, _, s, _ = records()
    s.lambda_hat[0], s.P[0, 0] = 0.0, 1e-4
    assert time_to_stand_still(0, 1.0, m, c, s) == 0.0


def test_a_larger_force_takes_less_time_to_be_believed() -> None:
    m, c, _, s, _ = records()
    column, (s.lambda_hat[0], s.P[0, 0]) = np.array(m.B)[:, 0], (0.0, 1e-4)
    one = JAM_SIGMA * position_behind(s.b, 0, 1.0, m, c, s)[1]
    for size, time in ((0.99, 0.0), (2.0, c.persistence / 4.0), (-4.0, c.persistence / 16.0)):
        s.b[:] = size * one * column
        assert time_to_stand_still(0, 1.0, m, c, s) == pytest.approx(time)


@pytest.mark.parametrize("pressure_ratio", [0.8, 1.5])
def test_the_position_behind_rates_is_that_of_least_squares(pressure_ratio: float) -> None:
    """Each rate is weighed by what gusts leave of its mean and by the model's error."""
    m, c, _, s, _ = records()
    column = pressure_ratio * np.array(m.B)[:, 0]
    weight = 1.0 / (0.5 * np.array(c.noise) ** 2 / MEAN_S + s.model_error_variance)
    unlike = np.array([0.1, 0.0, -0.1, 0.0])
    position, sigma = position_behind(1.3 * column + unlike, 0, pressure_ratio, m, c, s)
    assert position == pytest.approx(1.3 + np.sum(column * weight * unlike) / np.sum(column**2 * weight))
    assert sigma**-2 == pytest.approx(float(np.sum(column**2 * weight)))


def test_the_variance_of_an_offset_is_along_its_column() -> None:
    m, _, _, s, _ = records()
    before, phi = s.P.copy(), np.arange(16.0).reshape(4, N)
    expect_offset(2, -3.0, phi, m, s)
    assert s.P[N:, N:] - before[N:, N:] == pytest.approx(9.0 * np.outer(phi[:, 2], phi[:, 2]))


def flown(value: float, gust: tuple[float, float]) -> Flight:
    """Ten seconds with an offset left ruddervator [deg], and a gust to the north and down [m/s] three seconds after it."""
    blown = f"{{at_s: 5, magnitude_m_s: [{gust[0]}, 0, {gust[1]}], frame: ned, duration_s: 0.5, hold_s: 2}}"
    changes = [
        f"failures=[{{type: bias, actuator: left_ruddervator, at_s: 2, value: {value}}}]",
        f"atmosphere={{gusts: [{blown}]}}",
        "controller={type: adaptive_inversion}",
        "commands=[]",
        "requirements=[]",
        "duration_s=10",
    ]
    return fly(load_scenario(ROOT / "scenarios" / "jammed_ruddervator.yaml", changes))


@pytest.mark.parametrize(
    ("value", "gust", "sure"),
    [
        (9.987, (-0.26, 0.35), True),
        (9.625, (-0.07, -0.009), True),
        (3.39, (2.34, 0.03), True),
        (7.46, (-1.88, 0.38), True),
        (13.5, (-1.11, 0.55), True),
    ],
)
def test_a_biased_surface_is_flown_with(value: float, gust: tuple[float, float], sure: bool) -> None:
    """Each was beyond 8 deg of heading when it was given up as jammed. It is used on before it is sure that it follows."""
    flight = flown(value, gust)
    altitude, heading, _ = worst_errors(flight, 2.0)
    assert flight.outcome is Outcome.completed
    assert altitude < 3.0 and heading < 8.0
    assert not flight.log["left_ruddervator_failed"].any()
    said = "left_ruddervator: its force follows its command with an offset: not jammed, used on"
    assert [e["text"] for e in flight.events if "with an offset" in e.get("text", "")] == [said] * sure


@pytest.mark.parametrize(
    ("surface", "value"), [("rudder", 8.0), ("rudder", -5.0), ("elevator", 4.0), ("aileron", 8.0)]
)
def test_commands_make_up_for_an_offset(tmp_path: Path, surface: str, value: float) -> None:
    """Without it, the integrals of the outer loops take seconds: the rudder's offset turned the aircraft by 40 deg."""
    file = tmp_path / "offset.yaml"
    file.write_text(
        f"""
name: offset
aircraft: aerosonde
duration_s: 60
controller: {{type: adaptive_inversion}}
commands: [{{at_s: 0, altitude_m: 200, airspeed_m_s: 25, heading_deg: 0}}]
failures: [{{type: bias, actuator: {surface}, at_s: 10, value: {value}}}]
"""
    )
    flight = fly(load_scenario(file))
    altitude, heading, _ = worst_errors(flight, 10.0)
    assert flight.outcome is Outcome.completed
    assert altitude < 2.0 and heading < 12.0
    assert not flight.log[f"{surface}_failed"].any()


@pytest.mark.parametrize(("seen", "size"), [(0.3, 0.3), (-0.3, 0.3), (2.0, 0.8)])
def test_until_it_is_known_what_it_does_an_offset_varies_by_no_more_than_was_seen(
    seen: float, size: float
) -> None:
    m, c, _, s, _ = records()
    column, variance = np.array(m.B)[:, 0], s.P[N:, N:].copy()
    s.moved[0], s.b[:] = seen, 0.8 * column
    keep_offsets(1.0, m, c, s)
    grown = 2.0 * c.model_error_rate * c.dt * size**2 * np.outer(column, column)
    assert s.P[N:, N:] - variance == pytest.approx(grown)


def test_an_offset_does_not_fade() -> None:
    """While nothing is measured it stays what it is, and its variance grows by twice its square in each correlation time."""
    m, c, _, s, _ = records()
    s.moved[0], s.offset_timer[0], s.b[:] = 1.0, 99.0, 0.8 * np.array(m.B)[:, 0]
    column, variance = np.array(m.B)[:, 0], s.P[N:, N:].copy()
    keep_offsets(1.0, m, c, s)
    grown = 2.0 * c.model_error_rate * c.dt * 0.8**2 * np.outer(column, column)
    assert s.P[N:, N:] - variance == pytest.approx(grown)
    for _ in range(round(60.0 / c.dt)):
        predict(m, c, s)
        keep_offsets(1.0, m, c, s)
        follow_offsets(1.0, m, c, s)
    assert s.shift[0] == pytest.approx(0.8, rel=0.01)


@pytest.mark.parametrize("estimate", [0.5, 1.0])
def test_commands_are_shifted_by_what_the_surface_has_moved(estimate: float) -> None:
    m, c, k, s, _ = records()
    s.lambda_hat[0], s.shift[0] = estimate, 0.3
    s.r[:] = [0.2, 0.2, 1.0, 1.0]
    compensate(m, c, k, s)
    assert s.lambda_hat * s.u + s.shift == pytest.approx(s.r)
    low, high = reach(0, m, c, s)
    assert (low, high) == pytest.approx((m.low[0] * estimate + 0.3, m.high[0] * estimate + 0.3))


@pytest.mark.parametrize("pressure_ratio", [0.8, 1.5])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_an_offset_is_a_gust_when_what_was_seen_at_first_is_out_of_question(
    pressure_ratio: float, sign: float
) -> None:
    """What is seen at first has not reached the model error yet: while little is known of that, the surface counts as moved."""
    m, c, _, s, _ = records()
    column, seen = np.array(m.B)[:, 0], 0.8
    for sigma, found, moved in (
        (0.1, 0.45, 0),
        (0.1, 0.55, 1),
        (0.1, 2.0, 1),
        (0.1, -0.2, 0),
        (0.3, 0.0, 1),
        (0.25, 0.0, 0),
    ):
        s.moved[0], s.P[:], s.b[:] = 0.0, 0.0, 0.0
        phi = pressure_ratio * np.array(m.B) * 0.2
        expect_offset(0, sign * seen / 0.2, phi, m, s)
        assert s.moved[0] == pytest.approx(sign * pressure_ratio * seen)
        s.P[N:, N:] = sigma**2 * pressure_ratio**2 * np.outer(column, column)
        s.b[:] = sign * found * pressure_ratio * column
        follow_offsets(pressure_ratio, m, c, s)
        assert (s.moved[0] != 0.0) == moved and s.shift[0] == pytest.approx(sign * found)


@pytest.mark.parametrize("duration_s", [0.6, 1.0])
def test_a_force_that_passes_was_a_gust(duration_s: float) -> None:
    def blown(t: float, command: float) -> float:
        return command + 0.25 * (1.0 - math.cos(2.0 * math.pi * (t - FAILURE_S) / duration_s))

    made, end_s = records(), FAILURE_S + duration_s
    estimated(made, 0, lambda _, command: command, 0.0, FAILURE_S)
    estimated(made, 0, blown, FAILURE_S, end_s)
    assert made.s.moved[0] > 0.0
    estimated(made, 0, lambda _, command: command, end_s, 8.0)
    assert made.s.moved[0] == 0.0 and not made.s.failed.any()


def test_of_a_surface_that_has_moved_a_small_force_is_enough() -> None:
    m, c, _, s, _ = records()
    s.P[0, 0] = 0.01
    for moved, estimate, time in (
        (0, -1.0, 0.0),
        (1, -1.0, c.persistence),
        (1, 0.1, MEAN_S),
        (1, 0.4, 0.0),
    ):
        s.moved[0], s.lambda_hat[0] = moved, estimate
        assert time_to_stand_still(0, 1.0, m, c, s) == time


@pytest.mark.parametrize("surface", ["left", "right"])
@pytest.mark.parametrize("value", [-20.0, 11.0, 20.0])
def test_a_jam_in_flight_is_not_taken_for_an_offset(surface: str, value: float) -> None:
    name = f"{surface}_ruddervator"
    changes = [
        f"failures=[{{type: stuck_at, actuator: {name}, at_s: 2, value: {value}}}]",
        "controller={type: adaptive_inversion}",
        "commands=[]",
        "requirements=[]",
        "duration_s=6",
    ]
    flight = fly(load_scenario(ROOT / "scenarios" / "jammed_ruddervator.yaml", changes))
    assert flight.log[f"{name}_failed"].iloc[-1] == 1
    assert not any("with an offset" in e.get("text", "") for e in flight.events)
