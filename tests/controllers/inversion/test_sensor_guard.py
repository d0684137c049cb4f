"""Stuck sensors are found by their repetitions, and replaced by what the others say."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from command_line import ROOT
from short_flights import worst_errors
from vtail_setup import WEATHER, Records, records_of, setpoint, trim_state, vtail_setup

from testbed.common.signals import GUARDED, STATE, Belief, record_dtype
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.inversion.sensor_guard import (
    GYRO_REPEATS,
    RECALL_S,
    REPEATS_S,
    airspeed_by_lift,
    guard,
)
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

SETUP = vtail_setup(WEATHER)
MODEL = SETUP.model
RNG = np.random.default_rng(3)


def seen(made: Records, seconds: float, stuck: str = "", **state: float) -> tuple[np.record, int]:
    """The believed state after these seconds in which all readings but the stuck one have noise, and how often that changed."""
    m, c, k, s, _ = made
    believed, changes = np.zeros(1, record_dtype(STATE)), 0
    for _ in range(round(seconds / c.dt)):
        raw = trim_state(MODEL, **state)
        for name in GUARDED:
            if name != stuck:
                raw[name] += 1e-6 * RNG.normal()
        believed[0] = raw
        changes += guard(raw, setpoint(airspeed=MODEL.airspeed_m_s), believed[0], m, c, k, s)
    return believed[0], changes


@pytest.mark.parametrize("sensor", ["alpha", "airspeed"])
def test_a_reading_that_repeats_itself_is_stuck_until_it_lives(sensor: str) -> None:
    made = records_of(SETUP)
    assert seen(made, 1.0)[1] == 0 and not made.s.stuck.any()
    assert seen(made, 0.9 * REPEATS_S, sensor)[1] == 0
    assert seen(made, 0.3 * REPEATS_S, sensor)[1] == 1
    assert made.s.stuck.tolist() == [int(name == sensor) for name in GUARDED]
    assert seen(made, 0.05)[1] == 1 and not made.s.stuck.any()


def test_a_stuck_vane_is_replaced_by_pitch_less_the_path() -> None:
    made = records_of(SETUP)
    climb = 1.0
    y, _ = seen(made, 1.0, "alpha", alpha=0.3, climb_rate=climb, pitch=0.1)
    assert y.alpha == pytest.approx(0.1 - climb / MODEL.airspeed_m_s, abs=1e-3)


def test_a_stuck_pitot_tube_is_replaced_by_the_forward_acceleration() -> None:
    """1 m/s2 for 2 s, less what is drawn back meanwhile to the airspeed of the angle of attack, which is that of the trim."""
    made = records_of(SETUP)
    seen(made, 0.5)
    y, _ = seen(made, 2.0 + REPEATS_S, "airspeed", u_dot=1.0)
    assert y.airspeed - MODEL.airspeed_m_s == pytest.approx(
        RECALL_S * (1.0 - math.exp(-2.0 / RECALL_S)), abs=0.05
    )


def test_a_stuck_sideslip_vane_is_replaced_by_the_side_force() -> None:
    """With a bank and no turn the weight slips the aircraft sideways until the side force carries it; a yaw rate turns it away."""
    made = records_of(SETUP)
    m, v = made.m, MODEL.airspeed_m_s
    seen(made, 0.5)
    y, _ = seen(made, 60.0, "beta", roll=0.05, pitch=m.alpha)
    weight = GRAVITY_M_S2 * math.cos(m.alpha) * math.sin(0.05)
    assert y.beta == pytest.approx(weight / (v / RECALL_S - m.side_slope), rel=0.01)
    before = y.beta
    y, _ = seen(made, 0.1, "beta", roll=0.05, pitch=m.alpha, r=0.2)
    assert y.beta - before == pytest.approx(-0.1 * 0.2 * math.cos(m.alpha), rel=0.05)


def test_a_slow_flight_is_seen_in_its_angle_of_attack() -> None:
    """At four fifths of the airspeed the weight needs 1 / 0.64 of the lift, and of a turn at 60 deg of bank twice that."""
    made = records_of(SETUP)
    m, reference = made.m, setpoint(airspeed=MODEL.airspeed_m_s)
    weight_angle = m.alpha - m.zero_lift_alpha
    for share, roll, speed in ((1.0, 0.0, 1.0), (1.0 / 0.64, 0.0, 0.8), (2.0 / 0.64, math.pi / 3.0, 0.8)):
        y = trim_state(MODEL, alpha=m.zero_lift_alpha + share * weight_angle, roll=roll)
        assert airspeed_by_lift(y, reference, m) == pytest.approx(speed * MODEL.airspeed_m_s, rel=1e-6)
    slow, _ = seen(made, 60.0, "airspeed", alpha=m.zero_lift_alpha + weight_angle / 0.64)
    assert slow.airspeed == pytest.approx(0.8 * MODEL.airspeed_m_s, rel=0.01)


@pytest.mark.parametrize("axis", ["p", "q", "r"])
def test_a_stuck_gyro_is_replaced_by_the_attitude(axis: str) -> None:
    """In a bank the attitude's three rates belong to all three axes. The rate is late by one lag, and its change by nothing."""
    made = records_of(SETUP)
    m, c, k, s, _ = made
    believed, change = np.zeros(1, record_dtype(STATE)), np.array([0.3, -0.1, 0.2])
    roll, pitch, heading, rates = 0.5, 0.2, 6.2, np.zeros(3)
    for _ in range(round(1.5 / c.dt)):
        rates += change * c.dt
        p, q, r = rates
        across = q * math.sin(roll) + r * math.cos(roll)
        roll += c.dt * (p + across * math.tan(pitch))
        pitch += c.dt * (q * math.cos(roll) - r * math.sin(roll))
        heading = (heading + c.dt * across / math.cos(pitch)) % (2.0 * math.pi)
        raw = trim_state(MODEL, roll=roll, pitch=pitch, heading=heading, p=0.05, q=0.05, r=0.05)
        for name in GUARDED:
            raw[name] += 1e-6 * RNG.normal() * (name != axis)
        believed[0] = raw
        guard(raw, setpoint(airspeed=MODEL.airspeed_m_s), believed[0], m, c, k, s)
    i = "pqr".index(axis)
    assert believed[0][axis] == pytest.approx(rates[i] - change[i] / c.filter_rate, abs=5e-3)
    assert believed[0][f"{axis}_dot"] == pytest.approx(change[i], abs=5e-3)


def flown(sensor: str, ablate: str = "", kind: str = "stuck") -> Flight:
    changes = [
        f"sensors={{model: mems, faults: [{{type: {kind}, sensor: {sensor}, at_s: 20}}]}}",
        "atmosphere={turbulence_w20_m_s: 7.62}",
        "seed=95003",
        f"controller={{type: adaptive_inversion, ablate: [{ablate}]}}",
        "commands=[{at_s: 30, airspeed_m_s: 20}]",
        "failures=[]",
        "requirements=[]",
        "duration_s=120",
    ]
    return fly(load_scenario(ROOT / "scenarios" / "jammed_ruddervator.yaml", changes))


@pytest.mark.parametrize("sensor", ["alpha", "beta", "airspeed", "gyro_p"])
def test_a_stuck_sensor_is_said_and_flown_without(sensor: str) -> None:
    flight = flown(sensor)
    altitude, heading, _ = worst_errors(flight, 20.0)
    assert flight.outcome is Outcome.completed and altitude < 6.0 and heading < 15.0
    said = [e["text"] for e in flight.events if e["kind"] == "diagnosis"]
    assert said and said[0].startswith(sensor.removeprefix("gyro_")) and "taken for stuck" in said[0]
    if sensor != "alpha":  # without it gusts are sometimes taken for a weak surface
        assert not [e for e in flight.events if e["kind"] == "false_alarm"]


@pytest.mark.parametrize("sensor", ["airspeed", "gyro", "beta"])
def test_a_sensor_that_reads_zero_is_no_surface_that_failed(sensor: str) -> None:
    """Nor does a law divide by an airspeed that is zero."""
    flight = flown(sensor, kind="dropout")
    altitude, heading, _ = worst_errors(flight, 20.0)
    assert flight.outcome is Outcome.completed and altitude < 6.0 and heading < 15.0
    assert not [e for e in flight.events if e["kind"] == "false_alarm"]


def test_what_has_always_been_zero_is_not_stuck() -> None:
    """Rates and sideslip in calm air; once they have moved, a zero that stays is none."""
    made = records_of(SETUP)
    m, c, k, s, _ = made
    believed, reference = np.zeros(1, record_dtype(STATE)), setpoint(airspeed=MODEL.airspeed_m_s)
    for p, stuck in ((0.0, 0), (1e-3, 0), (0.0, 1)):
        for _ in range(2 * GYRO_REPEATS if p == 0.0 else 1):
            believed[0] = raw = trim_state(MODEL, p=p)
            guard(raw, reference, believed[0], m, c, k, s)
        assert s.stuck[GUARDED.index("p")] == stuck


def test_an_airspeed_that_falls_to_nothing_at_once_is_not_believed() -> None:
    made = records_of(SETUP)
    seen(made, 0.5)
    y, changes = seen(made, 1.0, airspeed=0.3)  # alive, so not stuck
    assert changes == 0 and y.airspeed == pytest.approx(MODEL.airspeed_m_s, abs=0.01)
    y, _ = seen(made, 0.01, airspeed=0.6 * MODEL.airspeed_m_s)
    assert y.airspeed == pytest.approx(0.6 * MODEL.airspeed_m_s, abs=0.01)


@pytest.mark.parametrize(
    "kind", ["indi", "l1_inversion", "imm_inversion", "rls_inversion", "mrac", "fixed_inversion"]
)
def test_no_law_divides_by_an_airspeed_of_zero(kind: str) -> None:
    changes = [
        "sensors={model: mems, faults: [{type: dropout, sensor: airspeed, at_s: 0.5, until_s: 0.52}]}",
        f"controller={{type: {kind}}}", "failures=[]", "requirements=[]", "duration_s=2", "commands=[]",
    ]  # fmt: skip
    flight = fly(load_scenario(ROOT / "scenarios" / "left_tail_fail.yaml", changes))
    assert flight.outcome is Outcome.completed
    assert np.isfinite(flight.log.filter(regex="_command$")).all(axis=None)


@pytest.mark.parametrize("kind", ["adaptive_inversion", "indi, monitor: true", "indi"])
def test_the_log_says_which_sensor_is_taken_for_stuck(kind: str) -> None:
    """The diagnosis beside another law, too; and nothing of a law that looks for none."""
    changes = [
        "sensors={model: mems, faults: [{type: stuck, sensor: beta, at_s: 0.5, until_s: 1.5}]}",
        f"controller={{type: {kind}}}", "failures=[]", "requirements=[]", "duration_s=2", "commands=[]",
    ]  # fmt: skip
    log = fly(load_scenario(ROOT / "scenarios" / "left_tail_fail.yaml", changes)).log
    assert (kind == "indi") == log.beta_stuck.isna().all()
    if kind != "indi":
        assert log.time_s[log.beta_stuck == 1].agg(["min", "max"]).tolist() == pytest.approx(
            [0.7, 1.5], abs=0.03
        )
        assert not log.alpha_stuck.any()


def test_with_a_stuck_vane_an_aileron_that_moves_again_is_used_again() -> None:
    """Probing goes on, and the elevator is not blamed for gusts that the vane would have shown."""
    flight = fly(load_scenario(Path(__file__).with_name("stuck_vane.yaml")))
    log = flight.log
    later = log.time_s > 42.0
    assert flight.outcome is Outcome.completed and worst_errors(flight, 20.0)[0] < 5.0
    used = [Belief.works, Belief.doubted, Belief.offset]
    assert log.aileron_belief[later].isin(used).all()
    assert (log.elevator_effectiveness_estimate[later] > 0.5).all()


def test_without_the_guard_an_airspeed_that_is_asked_for_is_never_seen() -> None:
    """The throttle goes on opening or closing: an error that stays is integrated."""
    errors = []
    for ablate in ("", "sensor_guard"):
        log = flown("airspeed", ablate).log
        errors.append(float((log.airspeed_m_s - log.airspeed_command_m_s)[log.time_s > 60.0].abs().mean()))
    assert errors[1] > 3.0 * errors[0]


@pytest.mark.parametrize(("surface", "vane"), [("rudder", "alpha"), ("aileron", "beta")])
def test_an_offset_is_made_up_for_once_with_a_stuck_vane(surface: str, vane: str) -> None:
    """Its force is in the model's error, which is inverted then, and in what its commands are shifted by."""
    start = "altitude_m: 250, airspeed_m_s: 25, heading_deg: 90"
    changes = [
        "aircraft=aerosonde", f"initial={{{start}}}", f"commands=[{{at_s: 0, {start}}}, {{at_s: 15, heading_deg: 110}}]",
        f"failures=[{{type: bias, actuator: {surface}, at_s: 12, value: 6}}]", "requirements=[]",
        "controller={type: adaptive_inversion}",
        f"sensors={{model: mems, faults: [{{type: stuck, sensor: {vane}, at_s: 30}}]}}",
        "atmosphere={turbulence_w20_m_s: 3.1}", "seed=5", "duration_s=60",
    ]  # fmt: skip
    flight = fly(load_scenario(ROOT / "scenarios" / "left_tail_fail.yaml", changes))
    assert worst_errors(flight, 31.0)[1] < 5.0
