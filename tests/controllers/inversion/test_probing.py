"""Probing: what is given up is found to work again, and only then."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from command_line import ROOT
from short_flights import worst_errors
from vtail_setup import WEATHER, Records, records_of, vtail_setup

from testbed.controllers.inversion.estimator import REVERSAL_S
from testbed.controllers.inversion.law import lag_gain, lagged
from testbed.controllers.inversion.probing import (
    AT_LEAST_RAD,
    LARGEST,
    probe,
    probe_rate,
)
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly


def given_up(i: int, jammed: bool) -> Records:
    """Actuator i has been given up, and stands at its trim position."""
    made = records_of(vtail_setup(WEATHER))
    m, _, _, s, _ = made
    s.position[:], s.lambda_hat[:] = m.trim_position, 1.0
    s.failed[i], s.jammed[i], s.since_flag[i] = 1, jammed, 0.9 * REVERSAL_S
    s.lambda_hat[i] = m.trim_position[i] if jammed else 0.0
    return made


def seconds_until_used(made: Records, i: int, gain: float, within_s: float = 10.0) -> float:
    """Time until actuator i is used again, if its force moves by `gain` times its position; infinite if it is not."""
    m, c, _, s, _ = made
    held = s.lambda_hat[i] if s.jammed[i] else 0.0
    for k in range(round(within_s / c.dt)):
        s.since_flag[i] += c.dt
        s.position[i] = m.trim_position[i] + s.probe[i]
        lagged(s.position[i], s.filtered_position, i, lag_gain(c.filter_rate * c.dt))
        force = gain * s.filtered_position[1, i] + (held - gain * m.trim_position[i] if s.jammed[i] else 0.0)
        own = s.lambda_hat[i] * (1.0 if s.jammed[i] else s.filtered_position[1, i])
        if probe(np.array(m.B)[:, i] * (force - own), 1.0, m, c, s):
            return (k + 1) * c.dt
    return math.inf


@pytest.mark.parametrize("jammed", [False, True])
@pytest.mark.parametrize("i", [0, 1, 2])
def test_what_follows_its_probe_is_used_again(i: int, jammed: bool) -> None:
    made = given_up(i, jammed)
    time = seconds_until_used(made, i, 1.0)
    assert AT_LEAST_RAD / probe_rate(i, made[0]) <= time < 4.0
    s = made.s
    assert not s.failed[i] and not s.jammed[i] and abs(s.moved[i]) < 0.1
    assert s.lambda_hat[i] == pytest.approx(1.0, abs=0.1) and s.probe[i] == 0.0


@pytest.mark.parametrize("jammed", [False, True])
@pytest.mark.parametrize("gain", [0.0, 0.3])
def test_what_does_not_follow_stays_given_up(gain: float, jammed: bool) -> None:
    made = given_up(0, jammed)
    assert seconds_until_used(made, 0, gain) == math.inf
    assert made.s.failed[0]


@pytest.mark.parametrize("beside", [1.0, -1.0])
def test_a_hardover_does_not_work_whatever_its_gain(beside: float) -> None:
    """The motions of the aircraft with it have a gain, and one at its stop cannot move."""
    made = given_up(1, True)
    made.s.lambda_hat[1] = made.m.high[1] if beside > 0.0 else made.m.low[1]
    assert seconds_until_used(made, 1, 1.0) == math.inf
    assert made.s.jammed[1]


def test_a_held_surface_that_follows_beside_its_command_has_an_offset() -> None:
    made = given_up(0, True)
    made.s.lambda_hat[0] += 0.6
    assert seconds_until_used(made, 0, 1.0) < 4.0
    assert made.s.moved[0] == pytest.approx(0.6, abs=0.3)
    column = np.array(made.m.B)[:, 0]
    assert made.s.b == pytest.approx(column * made.s.moved[0]), (
        "the model error takes the offset's force over"
    )


@pytest.mark.parametrize("engine", [0, 1])
def test_the_sine_is_small_and_that_of_an_engine_slow(engine: int) -> None:
    made = given_up(0, False)
    m, c, _, s, _ = made
    m.engine[0] = engine
    moved = []
    for _ in range(1600):
        s.since_flag[0] += c.dt
        probe(np.zeros(4), 1.0, m, c, s)
        moved.append(float(s.probe[0]))
    assert 0.05 < max(moved) <= LARGEST and min(moved) == pytest.approx(-max(moved), rel=0.05)
    half_turns = np.count_nonzero(np.diff(np.sign(moved)))
    assert half_turns == (3 if engine else 11), "of 1 and of 4 rad/s in 8 s, and the first step"


def flown(failure: str, ablate: str = "", faults: str = "") -> Flight:
    changes = [
        f"sensors={{model: mems, faults: [{faults}]}}",
        "atmosphere={turbulence_w20_m_s: 5}",
        "seed=95004",
        f"controller={{type: adaptive_inversion, ablate: [{ablate}]}}",
        "commands=[]",
        f"failures=[{failure}]",
        "requirements=[]",
        "duration_s=40",
    ]
    return fly(load_scenario(ROOT / "scenarios" / "jammed_ruddervator.yaml", changes))


@pytest.mark.parametrize(
    ("actuator", "failure"),
    [
        ("left_ruddervator", "type: effectiveness, value: 0"),
        ("left_ruddervator", "type: stuck_at, value: 8"),
        ("right_ruddervator", "type: stuck_at, value: -6"),
        ("right_propeller", "type: effectiveness, value: 0"),
    ],
)
def test_what_works_again_is_used_within_two_seconds(actuator: str, failure: str) -> None:
    """Without probing it is not."""
    failure = f"{{{failure}, actuator: {actuator}, at_s: 5, until_s: 15}}"
    flight = flown(failure)
    flags = flight.log.set_index("time_s")[f"{actuator}_failed"]
    assert flight.outcome is Outcome.completed
    assert flags[10.0:14.9].min() == 1 and flags[17.0:].max() == 0
    altitude, heading, _ = worst_errors(flight, 5.0)
    assert altitude < 4.0 and heading < 15.0
    without = flown(failure, "probing").log.set_index("time_s")[f"{actuator}_failed"]
    assert without[:17.0].iloc[-1] == 1


@pytest.mark.nightly
def test_nearly_all_that_work_again_are_used_within_two_seconds() -> None:
    """On seeds that nothing was chosen on: 48 of 51 within 2 s, the last after 2.3 s, the median 1.1 s."""
    times = []
    actuators = ("left_ruddervator", "right_ruddervator", "left_propeller")
    failures = ("type: effectiveness, value: 0", "type: stuck")
    for actuator, failure, w20, seed in product(actuators, failures, (1.0, 5.0, 7.6), (11, 12, 13, 14)):
        end = 30.5 + 0.23 * seed + 0.17 * w20
        changes = [
            f"failures=[{{{failure}, actuator: {actuator}, at_s: 15, until_s: {end}}}]",
            f"atmosphere={{turbulence_w20_m_s: {w20}}}",
            f"seed={seed}",
            "commands=[]",
            "requirements=[]",
            "duration_s=50",
        ]
        log = fly(load_scenario(ROOT / "scenarios" / "mems_turbulence.yaml", changes)).log
        time, failed = log["time_s"].to_numpy(), log[f"{actuator}_failed"].to_numpy()
        if failed[(time > end - 3.0) & (time < end)].any():
            times.append(min(time[(time > end) & (failed == 0)], default=math.inf) - end)
    assert len(times) > 40 and np.median(times) < 1.5
    assert np.mean(np.array(times) <= 2.0) > 0.9 and max(times) < 2.5


@pytest.mark.parametrize("vane", ["alpha", "beta"])
def test_a_held_surface_is_probed_while_a_vane_is_stuck(vane: str) -> None:
    held = "{type: stuck_at, actuator: left_ruddervator, at_s: 5, until_s: 15, value: 8}"
    flight = flown(held, faults=f"{{type: stuck, sensor: {vane}, at_s: 10}}")
    flags = flight.log.set_index("time_s")["left_ruddervator_failed"]
    assert flags[10.0:14.9].min() == 1 and flags[25.0:].max() == 0


@pytest.mark.parametrize(("jammed_at", "moved"), [(2.0, 3.0), (-0.8, 0.0)])
def test_a_held_surface_is_first_commanded_to_where_a_reversed_one_is_at_its_trim(
    jammed_at: float, moved: float
) -> None:
    """One that is nearly there would not show it."""
    m, c, _, s, _ = given_up(1, True)
    m.trim_position[1], s.jammed_at[1] = -1.5, jammed_at
    probe(np.zeros(4), 1.0, m, c, s)
    assert m.trim_position[1] + s.probe[1] == -1.5 + moved
    s.since_flag[1] = REVERSAL_S
    probe(np.zeros(4), 1.0, m, c, s)
    assert s.probe[1] == 0.0, "the sine begins"
