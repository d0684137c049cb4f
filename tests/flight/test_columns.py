"""Each column of the log is taken from its place in what was recorded, in the log's unit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from testbed.air.config import COLUMNS as WIND
from testbed.aircraft.description import load_aircraft
from testbed.common.signals import (
    BELIEFS,
    GUARDED,
    RATES,
    SETPOINT,
    STATE,
    TELEMETRY,
    Belief,
    telemetry_width,
)
from testbed.flight.columns import (
    Recorded,
    all_columns,
    beliefs,
    columns,
    reader,
    row_at,
    row_spacing_s,
    stays_from,
    stretches,
    stuck_column,
    stuck_sensors,
    table,
    unsaid,
)
from testbed.scenario.load import load_scenario
from testbed.sensors.channels import log_columns as sensor_columns

AIRCRAFT, RATE_HZ, STEPS = load_aircraft("vtail"), 200.0, 3000
ACTUATORS = list(AIRCRAFT.actuators)
_random = np.random.default_rng(1)
RECORDED = Recorded(
    truth=_random.standard_normal((STEPS, len(STATE) + 2 * len(ACTUATORS))),
    measured=_random.standard_normal((STEPS, len(STATE))),
    references=_random.standard_normal((STEPS, len(SETPOINT))),
    telemetry=_random.standard_normal((STEPS, telemetry_width(len(ACTUATORS)))),
)
LOG = dict(zip(columns(AIRCRAFT), table(AIRCRAFT, RATE_HZ, RECORDED), strict=True))


def telemetry(what: str, actuator: str) -> np.ndarray:
    return RECORDED.telemetry[:, len(ACTUATORS) * TELEMETRY.index(what) + ACTUATORS.index(actuator)]


def expected(name: str) -> np.ndarray:
    """The column as its name says it, from what was recorded."""
    truth = dict(zip(STATE, RECORDED.truth.T, strict=False))
    first_rate = len(TELEMETRY) * len(ACTUATORS)
    beliefs = dict(
        zip(
            BELIEFS,
            np.split(RECORDED.telemetry[:, first_rate + 2 * len(RATES) : -len(GUARDED)], 2, axis=1),
            strict=True,
        )
    )
    return {
        "time_s": np.arange(STEPS) / RATE_HZ,
        "altitude_m": truth["altitude"],
        "heading_deg": np.degrees(truth["heading"]),
        "r_deg_s": np.degrees(truth["r"]),
        "altitude_command_m": RECORDED.references[:, SETPOINT.index("altitude")],
        "heading_command_deg": np.degrees(RECORDED.references[:, SETPOINT.index("heading")]) % 360.0,
        "q_dot_deg_s2": np.degrees(RECORDED.measured[:, STATE.index("q_dot")]),
        "u_dot_m_s2": RECORDED.measured[:, STATE.index("u_dot")],
        "u_dot_desired_m_s2": RECORDED.telemetry[:, first_rate + RATES.index("u_dot")],
        "p_dot_released": RECORDED.telemetry[:, first_rate + len(RATES) + RATES.index("p_dot")],
        "left_propeller_position": RECORDED.truth[:, len(STATE) + 2],
        "left_propeller_effectiveness": RECORDED.truth[:, len(STATE) + len(ACTUATORS) + 2],
        "right_ruddervator_command": telemetry("command", "right_ruddervator")
        * AIRCRAFT.actuators["right_ruddervator"].scale,
        "right_ruddervator_effectiveness_estimate": telemetry("effectiveness_estimate", "right_ruddervator"),
        "right_propeller_failed": telemetry("failed", "right_propeller"),
        "right_propeller_belief": beliefs["belief"][:, 3],
        "left_ruddervator_believed_position": beliefs["believed_position"][:, 0]
        * AIRCRAFT.actuators["left_ruddervator"].scale,
    }[name]


NAMES = [
    "time_s", "altitude_m", "heading_deg", "r_deg_s", "altitude_command_m", "heading_command_deg", "q_dot_deg_s2",
    "u_dot_m_s2", "u_dot_desired_m_s2", "p_dot_released", "left_propeller_position", "left_propeller_effectiveness",
    "right_ruddervator_command", "right_ruddervator_effectiveness_estimate", "right_propeller_failed",
    "right_propeller_belief", "left_ruddervator_believed_position",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_a_column_is_what_its_name_says(name: str) -> None:
    assert LOG[name] == pytest.approx(expected(name), rel=1e-14)


def test_what_is_said_of_nothing_is_unsaid() -> None:
    nothing, known = np.full(3, np.nan), np.zeros(3)
    log = {"a_failed": nothing, "b_failed": known, "a_belief": known, "a_believed_position": nothing,
           "b_belief": nothing, "b_believed_position": nothing, "altitude_m": nothing, "p_dot_released": nothing}  # fmt: skip
    # Where a is held is not unsaid: nothing is held. The altitude is not the controller's to say.
    assert unsaid(log) == {"a_failed", "b_belief", "b_believed_position", "p_dot_released"}
    assert unsaid({"a_failed": np.array([np.nan, 1.0])}) == set()


def test_columns_are_the_contract() -> None:
    found = columns(AIRCRAFT)
    assert len(set(found)) == len(found)
    assert found[:6] == ("time_s", "north_m", "east_m", "altitude_m", "airspeed_m_s", "climb_rate_m_s")
    per_actuator = (
        "reference", "command", "position", "effectiveness", "effectiveness_estimate", "failed", "belief", "believed_position",
    )  # fmt: skip
    assert found[-8 * len(ACTUATORS) :] == tuple(f"{a}_{of}" for a in ACTUATORS for of in per_actuator)


@pytest.mark.parametrize("name", ["time_s", "heading_command_deg", "left_propeller_effectiveness"])
def test_a_reader_gives_the_logs_numbers(name: str) -> None:
    read = reader(AIRCRAFT, RATE_HZ, RECORDED, name)
    assert [read(step) for step in (0, 1023, 1024, 2999)] == list(LOG[name][[0, 1023, 1024, 2999]])


def test_more_columns_come_last_and_each_is_contiguous() -> None:
    more = np.arange(STEPS, dtype=float)
    data = table(AIRCRAFT, RATE_HZ, RECORDED, [more])
    assert data.shape == (len(LOG) + 1, STEPS) and data.flags.c_contiguous
    assert np.array_equal(data[-1], more)


def test_columns_of_sensors_and_moving_air_only_where_there_are_such() -> None:
    file = "scenarios/left_tail_fail.yaml"
    calm = all_columns(AIRCRAFT, load_scenario(file))
    assert calm == columns(AIRCRAFT)
    windy = all_columns(AIRCRAFT, load_scenario(file, ["atmosphere.turbulence_w20_m_s=7"]))
    assert windy == (*calm, *WIND)
    sensed = all_columns(AIRCRAFT, load_scenario(file, ["sensors=mems"]))
    assert sensed == (*calm, *sensor_columns(), *map(stuck_column, GUARDED))


def test_flags_of_stuck_sensors_are_the_last_of_telemetry() -> None:
    found = stuck_sensors(RECORDED)
    assert list(found) == [f"{name}_stuck" for name in GUARDED]
    assert np.array_equal(np.array(list(found.values())).T, RECORDED.telemetry[:, -len(GUARDED) :])


def test_beliefs_are_told_in_words() -> None:
    nothing = np.full(6, math.nan)
    log = {
        "time_s": np.arange(6.0),
        "fan_belief": np.array([0, 0, Belief.lost, 0, 0, 0.0]),
        "fan_believed_position": nothing,
        "elevon_belief": np.array([0, Belief.doubted, Belief.held, Belief.held, Belief.held, math.nan]),
        "elevon_believed_position": np.array([math.nan, math.nan, -3.0, 4.5, 5.0, math.nan]),
        "flap_belief": nothing,
        "flap_believed_position": nothing,
        "slat_belief": np.full(6, 99.0),  # no word for it
    }
    told = beliefs(log, ["fan", "elevon", "flap", "slat", "written before there were beliefs"])
    found = [(b["time_s"], b["until_s"], b["actuator"], b["belief"]) for b in told]
    assert found == [
        (0.0, 0.0, "elevon", "works"), (0.0, 1.0, "fan", "works"), (1.0, 1.0, "elevon", "doubted"),
        (2.0, 4.0, "elevon", "held"), (2.0, 2.0, "fan", "lost"), (3.0, 5.0, "fan", "works"),
    ]  # fmt: skip
    assert told[3]["position"] == 4.5 and math.isnan(told[4]["position"])


TIME = np.arange(100) / 200.0


@pytest.mark.parametrize(
    ("instant_s", "row"), [(0.0, 0), (0.3, 60), (0.3001, 61), (0.2999, 60), (-1.0, 0), (9.0, 100)]
)
def test_first_row_at_or_after_an_instant(instant_s: float, row: int) -> None:
    assert row_at(TIME, instant_s) == row


def test_every_step_has_its_own_row_at_any_rate() -> None:
    """Times that decimal numbers and quotients write differently are one."""
    for rate in (50, 120, 200, 1000):
        time_s = np.arange(2000) / rate
        assert [row_at(time_s, k * (1.0 / rate)) for k in range(2000)] == list(range(2000))


def test_spacing() -> None:
    assert row_spacing_s(TIME) == 0.005
    assert row_spacing_s(TIME[:1]) == 0.0


@pytest.mark.parametrize(
    ("flag", "found"),
    [
        ([], []),
        ([0, 0], []),
        ([1, 1], [(0, 2)]),
        ([0, 1, 1, 0, 1], [(1, 3), (4, 5)]),
        ([1, 0, 1, 0], [(0, 1), (2, 3)]),
    ],
)
def test_stretches(flag: list[int], found: list[tuple[int, int]]) -> None:
    assert stretches(np.array(flag, dtype=bool)) == found


@pytest.mark.parametrize(
    ("outside", "start", "row"),
    [([0, 0, 0], 1, 1), ([1, 0, 0], 0, 1), ([1, 0, 1, 0], 0, 3), ([1, 0, 0], 1, 1), ([0, 0, 1], 0, None)],
)
def test_stays_from(outside: list[int], start: int, row: int | None) -> None:
    assert stays_from(~np.array(outside, dtype=bool), start, len(outside)) == row
