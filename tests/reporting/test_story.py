"""A flight is told right: what failed, when it was noticed, how far off it got, how it ended."""

from __future__ import annotations

import math

import numpy as np
import pytest
from handmade import at, flight_of, injection, level_log, lost

import testbed
from testbed.common.signals import BELIEFS, Belief
from testbed.flight.flight import Outcome
from testbed.reporting.panels import effectiveness
from testbed.reporting.story import diagnoses, story
from testbed.reporting.words import describe
from testbed.scenario.load import load_scenario
from testbed.simulation import fly


def told(log: dict[str, np.ndarray], *events: dict[str, object], outcome: Outcome = Outcome.completed) -> str:
    in_order = sorted(events, key=lambda event: float(str(event["time_s"])))
    return "\n".join(story(flight_of(log, in_order, outcome)))


def released(**axes: tuple[float, float]) -> dict[str, np.ndarray]:
    """Columns of axes that are given up from one time [s] to another."""
    time_s = level_log()["time_s"]
    return {
        f"{axis}_released": ((time_s >= from_s - 1e-9) & (time_s < until_s - 1e-9)).astype(float)
        for axis, (from_s, until_s) in axes.items()
    }


def test_what_failed_and_when_it_was_noticed() -> None:
    noticed = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    gave_up = {"time_s": 2.3, "kind": "release", "axis": "r_dot"}
    text = told(lost(2.0) | released(r_dot=(2.3, math.inf)), injection(2.0), noticed, gave_up)
    assert "At 2.0 s the elevon was lost completely." in text
    assert "noticed the elevon after 0.30 s and gave up yaw acceleration." in text


def test_what_was_given_up_before_or_for_a_moment_is_not_told() -> None:
    noticed = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    changes = [{"time_s": t, "kind": "release", "axis": axis} for t, axis in ((2.3, "r_dot"), (2.5, "p_dot"))]
    log = lost(2.0) | released(r_dot=(2.3, 2.5), p_dot=(0.0, 2.3))
    log["p_dot_released"][at(2.5) :] = 1.0
    text = told(log, injection(2.0), noticed, *changes)
    assert "noticed the elevon after 0.30 s." in text


def test_steady_sideslip_is_said_and_an_oscillating_one_is_not() -> None:
    noticed = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    log = lost(2.0)
    log["beta_deg"][at(3) :] = -1.3
    assert "flew on with 1.3 deg of sideslip" in told(log, injection(2.0), noticed)
    log["beta_deg"] = 3.0 * np.sin(20.0 * log["time_s"])
    assert "sideslip" not in told(log, injection(2.0), noticed)


def test_the_worst_error_and_when_it_settled() -> None:
    log = lost(2.0)
    log["altitude_m"] += np.where((log["time_s"] > 2) & (log["time_s"] < 4), 2.5, 0.05)
    text = told(log, injection(2.0))
    assert (
        "Worst since 2.0 s: 2.50 m of altitude, 0.00 deg of heading. Settled within 0.1 m by 4 s; heading stayed within 0.1 deg."
        in text
    )


def test_a_lasting_difference_of_airspeed_is_said_as_the_mean_it_is() -> None:
    log = lost(2.0)
    log["airspeed_m_s"] -= np.where(log["time_s"] > 2, 0.5 * (log["time_s"] - 2.0), 0.0)
    text = told(log, injection(2.0))
    end_s = float(log["time_s"][-1])
    last_s = 0.25 * (end_s - 2.0)
    mean = 0.5 * (end_s - 2.0 - 0.5 * last_s)
    assert f"On average it flew {mean:.1f} m/s slower than its reference in the last {last_s:.1f} s." in text


def test_too_short_a_time_since_the_failure_tells_no_mean_and_no_settling() -> None:
    log = lost(9.9)
    log["airspeed_m_s"] += 1.2
    log["altitude_m"][at(9.9) : at(9.92)] += 0.4
    text = told(log, injection(9.9))
    assert "Worst since 9.9 s: 0.40 m of altitude" in text
    assert "On average" not in text and "ettle" not in text


@pytest.mark.parametrize(
    ("count", "words"),
    [(4, "1 more failure followed, at 5.0 s."), (5, "2 more failures followed, the last at 6.0 s.")],
)
def test_of_many_failures_the_last_is_told(count: int, words: str) -> None:
    assert words in told(lost(2.0), *(injection(2.0 + k) for k in range(count)))


def test_drift_of_what_did_not_settle() -> None:
    log = lost(2.0)
    log["heading_deg"] = np.mod(350.0 + 4.0 * np.maximum(log["time_s"] - 2.0, 0.0), 360.0)
    text = told(log, injection(2.0))
    assert "Heading did not settle: 32.0 deg right of it at the end, drifting by +4.00 deg/s." in text
    assert "Not recovered: it did not stay within 15 deg of heading." in text


def test_an_error_that_swings_does_not_drift() -> None:
    log = lost(2.0)
    log["altitude_m"] = log["altitude_m"] + 9.0 * np.sin(8.0 * log["time_s"])
    assert "at the end, swinging over a range of 18.0 m." in told(log, injection(2.0))


def test_a_part_of_a_slow_swing_is_no_drift() -> None:
    log = lost(0.0)
    log["altitude_m"] = log["altitude_m"] - 20.0 + 12.0 * np.sin(0.2 * math.pi * (log["time_s"] + 2.0))
    text = told(log, injection(0.0))
    assert "too low at the end." in text and "drift" not in text


def test_a_failure_shortly_before_the_end_is_not_called_unrecovered() -> None:
    held = "So far it held: altitude stayed within 5 m and heading within 15 deg of their references"
    assert f"{held}, but less than 5 s were flown after the failure." in told(lost(7.0), injection(7.0))
    log = lost(2.0)
    log["altitude_m"][at(2.5) : at(7)] += 6.0
    back = "Not recovered: it was back within 5 m of altitude and 15 deg of heading for less than 5 s before the end."
    assert back in told(log, injection(2.0))


def test_a_failure_after_the_last_row_that_was_logged_is_told() -> None:
    """With a low `log_hz` the log ends before the flight does."""
    log = {name: values[:900] for name, values in level_log().items()}
    assert "So far it held" in told(log, injection(9.5))


def test_an_estimate_is_told_only_where_there_is_one() -> None:
    log = level_log()
    log["elevon_effectiveness"][at(2) :] = 0.5
    assert "estimated" not in told(log, injection(2.0))
    log["elevon_effectiveness_estimate"][at(2) :] = math.nan
    assert "estimated" not in told(log, injection(2.0))
    log["elevon_effectiveness_estimate"][at(3) :] = 0.48
    assert "At the end it estimated 48 % for the elevon (true 50 %)." in told(log, injection(2.0))


def test_one_that_flags_nothing_and_one_that_says_nothing_are_told_apart() -> None:
    log = lost(2.0)
    assert "The controller flagged nothing as failed." in told(log, injection(2.0))
    for name in ("elevon", "fan"):
        log[f"{name}_failed"][:] = math.nan
    assert "This controller never flags an actuator." in told(log, injection(2.0))


def test_false_alarms() -> None:
    false = {"time_s": 4.0, "kind": "false_alarm", "actuator": "fan"}
    assert "It wrongly flagged the fan, first at 4.0 s." in told(lost(2.0), injection(2.0), false)


def test_what_was_given_up_for_a_false_alarm_is_not_told_of_the_failure() -> None:
    noticed = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    false = {"time_s": 4.0, "kind": "false_alarm", "actuator": "fan"}
    changes = [{"time_s": t, "kind": "release", "axis": axis} for t, axis in ((2.3, "r_dot"), (4.0, "p_dot"))]
    log = lost(2.0) | released(r_dot=(2.3, math.inf), p_dot=(4.0, math.inf))
    text = told(log, injection(2.0), noticed, false, *changes)
    assert "noticed the elevon after 0.30 s and gave up yaw acceleration." in text
    assert "It wrongly flagged the fan, first at 4.0 s and gave up roll acceleration." in text


def test_a_failure_that_ends_is_told_with_its_end_and_a_flag_after_it_is_no_detection() -> None:
    false = {"time_s": 4.5, "kind": "false_alarm", "actuator": "elevon"}
    text = told(lost(2.0, 4.0), injection(2.0), injection(4.0, active=False), false)
    assert "At 2.0 s the elevon was lost completely, until 4.0 s." in text
    assert "flagged nothing while it was broken. It wrongly flagged the elevon, first at 4.5 s." in text
    assert "flagged nothing as failed" not in text


def test_what_did_not_stay_as_written_is_not_said_to_have_had_no_effect() -> None:
    high = {"type": "property", "at_s": 0.5, "set": {"position/h-sl-ft": 1500.0}}
    still = {"duration_s": 1, "requirements": [], "commands": []}
    text = story(testbed.fly("left_tail_fail.yaml", set={**still, "failures": [high]}))[0]
    assert text == "At 0.5 s position/h-sl-ft was held at 1500. This did not stay as written."
    nothing = injection(2.0, verified=False, effect={"quantity": "effective_deg"})
    assert "completely. This had no effect on the aircraft." in told(lost(2.0), nothing)


def test_nothing_broken() -> None:
    assert story(flight_of(level_log()))[0] == "Nothing was broken."


def test_a_lost_flight_names_the_limit_and_what_was_asked() -> None:
    event = {
        "time_s": 9.9,
        "kind": "lost",
        "outcome": "envelope_exceeded",
        "limits": [{"limit": "beta_max_deg", "value": 40.3, "allowed": 40, "unit": "deg"}],
        "at_stop": [{"actuator": "elevon", "stop": "high", "share": 0.9}],
    }
    text = told(lost(2.0), injection(2.0), event, outcome=Outcome.envelope_exceeded)
    assert "Lost at 9.9 s: sideslip of 40.3 deg passed its limit of 40 deg." in text
    assert "asked the elevon for its highest" in text and "bank" not in text
    assert "ecovered" not in text and "ettled" not in text


def test_the_attitude_of_a_dive_and_a_heading_that_went_round() -> None:
    log = lost(2.0)
    log["pitch_deg"][at(3) :], log["roll_deg"][at(3) :] = -70.0, 95.0
    log["heading_deg"] = np.mod(log["heading_deg"] + 60.0 * np.maximum(log["time_s"] - 2.0, 0.0), 360.0)
    event = {"time_s": 9.9, "kind": "lost", "outcome": "ground_contact", "limits": [], "at_stop": []}
    text = told(log, injection(2.0), event, outcome=Outcome.ground_contact)
    assert "at 95 deg of bank and 70 deg nose down." in text and "(it turned all the way round)" in text


def test_the_shipped_flight_is_told_as_it_was() -> None:
    flight = fly(load_scenario("scenarios/left_tail_fail.yaml"))
    text = "\n".join(story(flight))
    detection = next(e for e in flight.events if e["kind"] == "detection")
    assert "At 5.0 s the left ruddervator kept 20 % of its effect." in text
    assert "At 15.0 s the left ruddervator was lost completely." in text
    assert f"noticed the left ruddervator {detection['delay_s']:.2f} s after its failure at 15.0 s" in text
    assert f"{flight.metrics['altitude_error_max_m']:.2f} m of altitude" in text
    assert (
        "It held since the last failure: altitude stayed within 5 m and heading within 15 deg of their references."
        in text
    )
    assert "wrongly" not in text
    assert [e for e in flight.events if e["kind"] == "recovered"][-1]["time_s"] == pytest.approx(15.0)
    assert len(story(flight)) <= 4


def believed(code: Belief, position: float, since_s: float) -> dict[str, np.ndarray]:
    """A log in which the elevon is taken for something from a time [s] on."""
    log = {
        **level_log(),
        **{f"elevon_{what}": np.full(len(level_log()["time_s"]), np.nan) for what in BELIEFS},
    }
    log["elevon_belief"][at(since_s) :], log["elevon_believed_position"][at(since_s) :] = code, position
    return log


def test_what_a_noticed_actuator_was_taken_for_is_said() -> None:
    log = believed(Belief.held, 8.1, 4.3)
    notice = {"time_s": 4.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    assert "noticed the elevon after 0.30 s (as held at 8.1 deg)." in told(log, injection(4.0), notice)
    jam = injection(4.0, type="stuck")
    assert "after 0.30 s (as held at 8.1 deg, true 1.0 deg)." in told(log, jam, notice)
    log["elevon_belief"][at(4.3) : at(4.33)] = Belief.reversed  # too brief to be told
    log["elevon_belief"][at(4.33) : at(5)] = Belief.lost
    log["elevon_believed_position"][: at(5)] = math.nan
    changed = "(as lost, from 5.0 s on as held at 8.1 deg, true 1.0 deg)"
    assert f"after 0.30 s {changed}." in told(log, jam, notice)
    log = believed(Belief.held, 8.1, 4.3)
    (panel, *_) = effectiveness(flight_of(log, [injection(4.0), notice]))
    assert [(since, words) for since, _, words in panel.notes] == [
        (pytest.approx(4.3), "believed held at 8.1 deg")
    ]


def test_which_of_the_failures_of_an_actuator_was_noticed_is_said() -> None:
    notice = {"time_s": 4.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    first, second = injection(2.0), injection(4.0)
    assert "noticed the elevon 0.30 s after its failure at 4.0 s" in told(lost(4.0), first, second, notice)
    assert "noticed the elevon 0.50 s after its loss at 3.8 s" in told(
        lost(3.8), first, second, notice | {"delay_s": 0.5}
    )
    again = notice | {"time_s": 6.0, "delay_s": 2.0}
    text = told(lost(4.0), first, second, notice, injection(5.0, "fan", "prop_loss"), again)
    assert "noticed the elevon 0.30 s after" in text and "flagged the elevon again at 6.0 s." in text
    for other in (injection(2.0, "fan", "prop_loss"), injection(5.0)):
        assert "noticed the elevon after 0.30 s" in told(lost(4.0), other, second, notice)


def test_what_the_controller_said_of_a_mode_that_it_soon_left_is_told_with_how_long_it_was_in_force() -> None:
    def said(text: str = "elevon failed: flies at 12.2 m/s", **more: np.ndarray) -> str:
        event = {"time_s": 4.3, "kind": "diagnosis", "text": text}
        return diagnoses(flight_of(log | more, [injection(4.0), event]))[0]

    log = believed(Belief.lost, math.nan, 4.3)
    flags = np.where(log["time_s"] >= 4.3 - 1e-9, 1.0, 0.0)
    log["elevon_failed"] = flags
    as_ever = "controller at 4.3 s: elevon failed: flies at 12.2 m/s"
    assert said() == as_ever
    reverses = log["elevon_belief"].copy()
    reverses[at(4.5) :] = Belief.reversed
    assert said(elevon_belief=reverses) == as_ever.replace("4.3 s", "4.3 s, for 0.2 s")
    also = np.where(log["time_s"] >= 5.8 - 1e-9, 1.0, 0.0)
    assert said(fan_failed=also) == as_ever.replace("4.3 s", "4.3 s, for 1.5 s")
    late = np.where(log["time_s"] >= 9.5, 1.0, 0.0)
    assert said(fan_failed=late) == as_ever  # it was flown so for more than 5 s
    assert said("elevon: reversed", elevon_belief=reverses) == "controller at 4.3 s: elevon: reversed"
    assert "for" not in said("tail failed: flies on", elevon_belief=reverses)


def test_a_failure_that_was_not_noticed_is_said_beside_one_that_was() -> None:
    log = level_log()
    log["fan_failed"][at(5.2) :] = 1.0
    slow, gone = injection(2.0, type="lag"), injection(5.0, "fan", "prop_loss")
    notice = {"time_s": 5.2, "kind": "detection", "actuator": "fan", "delay_s": 0.2}
    missed = "It did not notice the failure of the elevon at 2.0 s."
    assert missed in told(log, slow, gone, notice)
    assert "did not notice" not in told(log, {**slow, "verified": None}, gone, notice)
    believes = log | believed(Belief.late, math.nan, 3.0) | {"fan_failed": log["fan_failed"]}
    assert "did not notice" not in told(believes, slow, gone, notice)


def test_a_flag_that_outlasts_its_failure_is_said() -> None:
    log = lost(2.0, 4.0)
    log["elevon_failed"][at(2.3) :] = 1.0
    notice = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    events = (injection(2.0), notice, injection(4.0, active=False))
    said = "At the end it still flagged the elevon, which worked again."
    assert said in told(log, *events)
    assert said not in told(log, *events[:2])
    log["elevon_failed"][at(5) :] = 0.0
    assert said not in told(log, *events)


def test_a_flag_that_was_taken_back_is_said_with_when() -> None:
    log = lost(2.0, 4.0)
    log["elevon_failed"][at(2.3) : at(5)] = 1.0
    assert "It used the elevon again from 5.0 s on." in told(log, injection(2.0))
    log["elevon_failed"][at(6) : at(6.5)] = log["elevon_failed"][at(6.52) :] = 1.0
    text = told(log, injection(2.0))
    assert "It used the elevon again from 5.0 s to 6.0 s." in text and text.count("again") == 1
    assert "again" not in told(lost(2.0), injection(2.0))


def test_sideslip_of_a_moment_before_the_next_failure_is_not_told() -> None:
    log = lost(2.0)
    log["beta_deg"][at(2) : at(4)] = -8.0
    notice = {"time_s": 2.3, "kind": "detection", "actuator": "elevon", "delay_s": 0.3}
    assert "sideslip" not in told(log, injection(2.0), notice, injection(4.0, "fan", "prop_loss"))


def test_half_a_turn_is_not_called_a_whole_one_and_a_bank_is_said_once() -> None:
    log = lost(2.0)
    log["heading_deg"] = np.mod(350.0 + 22.6 * np.maximum(log["time_s"] - 2.0, 0.0), 360.0)
    log["roll_deg"][at(9) :] = -111.0
    bank = {"limit": "roll_max_deg", "value": -111.0, "allowed": 110, "unit": "deg"}
    event = {"time_s": 9.9, "kind": "lost", "outcome": "envelope_exceeded", "limits": [bank], "at_stop": []}
    text = told(log, injection(2.0), event, outcome=Outcome.envelope_exceeded)
    assert "180 deg of heading." in text
    assert "bank of -111.0 deg passed its limit of 110 deg." in text


def test_what_is_used_on_is_said_where_nothing_was_flagged() -> None:
    text = told(believed(Belief.late, math.nan, 6.0), injection(4.0))
    assert "It took the elevon for late from 6.0 s on, and used it." in text
    log = believed(Belief.late, math.nan, 6.0)
    log["elevon_belief"][log["time_s"] >= 7.0] = Belief.works
    assert "It took the elevon for late from 6.0 s to 7.0 s, and used it." in told(log, injection(4.0))


BY_HAND = {"failures": [], "requirements": [], "commands": [], "controller": {"type": "adaptive_inversion"}}


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ({"type": "stuck", "sensor": "alpha"}, "the sensor alpha stuck at its last reading"),
        ({"type": "stuck", "sensor": "alpha", "value_deg": 2}, "the sensor alpha stuck at 2 deg"),
        ({"type": "dropout", "sensor": "gyro"}, "the sensor gyro read zero"),
        (
            {"type": "dropout", "sensor": "gyro_q", "fraction": 0.5, "reads": "last"},
            "the sensor gyro q repeated its last reading in 50 % of the control steps",
        ),
        ({"type": "bias", "sensor": "altitude", "value_m": 3}, "the sensor altitude was off by 3 m"),
        (
            {"type": "drift", "sensor": "gyro_p", "rate_deg_s2": 0.5},
            "the sensor gyro p drifted by 0.5 deg/s^2",
        ),
        (
            {"type": "noise", "sensor": "airspeed", "noise_m_s_rthz": 0.2},
            "the sensor airspeed had more noise, of 0.2 m/s/sqrt(Hz)",
        ),
    ],
)
def test_what_happened_to_a_sensor_is_told(fault: dict[str, object], said: str) -> None:
    faults = [
        {**fault, "at_s": 0.5, "until_s": 0.9},
        {"type": "bias", "sensor": "beta", "value_deg": 0, "at_s": 0.6},
    ]
    flight = testbed.fly(
        "left_tail_fail.yaml",
        set={"duration_s": 1, "sensors.faults": faults, "requirements": [], "failures": [], "commands": []},
    )
    first = story(flight)[0]
    assert first.startswith(
        f"No actuator was broken. At 0.5 s {said}, until 0.9 s. At 0.6 s the sensor beta was off by 0 deg."
    )
    assert first.endswith("This changed no reading.")
    begins, _, ends = (describe(e, flight) for e in flight.events if e["kind"] == "sensor_fault")
    assert begins == said.removeprefix("the ")
    assert ends == f"sensor {str(fault['sensor']).replace('_', ' ')}: {fault['type']} ends"


LEFT = "left_ruddervator"


def test_what_it_was_taken_for_is_that_of_before_it_was_mended() -> None:
    """And what was given up meanwhile is told as long as the flight goes on."""
    with testbed.Session("left_tail_fail.yaml", set=BY_HAND) as session:
        session.run_to(3.0)
        session.inject({"type": "stuck_at", "actuator": LEFT, "value": 9.0})
        session.run_to(5.0)
        session.order({"heading_deg": 110})
        session.run_to(10.0)
        session.mend(LEFT)
        for until_s in (13.0, 30.0):
            session.run_to(until_s)
            text = "\n".join(story(session.flight()))
            assert "(as held at 9.1 deg, true 9.0 deg) and gave up yaw acceleration" in text


def test_what_is_flagged_already_was_noticed() -> None:
    with testbed.Session("left_tail_fail.yaml", set=BY_HAND) as session:
        session.run_to(1.0)
        session.order({"heading_deg": 110})
        for from_s, until_s in ((3.0, 8.0), (8.2, 24.0)):
            session.run_to(from_s)
            session.inject({"type": "stuck_at", "actuator": LEFT, "value": 9.0})
            session.run_to(until_s)
            session.mend(LEFT)
        flight = session.flight()
    assert flight.log[f"{LEFT}_failed"].iloc[-1] > 0.0
    assert "not noticed" not in "\n".join(story(flight))


def test_failures_and_faults_are_told_in_order_of_time() -> None:
    bias = {"type": "bias", "sensor": "beta", "value_deg": 1, "at_s": 0.5}
    weak = {"type": "effectiveness", "actuator": LEFT, "value": 0.5, "at_s": 0.7}
    changes = {**BY_HAND, "duration_s": 1, "failures": [weak], "sensors.faults": [bias]}
    first = story(testbed.fly("left_tail_fail.yaml", set=changes))[0]
    assert first.startswith(
        "At 0.5 s the sensor beta was off by 1 deg. At 0.7 s the left ruddervator kept 50 %"
    )
