"""From positions to commands, and the order of the telemetry."""

from __future__ import annotations

import numpy as np
import pytest
from vtail_setup import WEATHER, axial, records_of, vtail_setup

from testbed.common.signals import GUARDED, RATES, TELEMETRY, Belief, telemetry_rows
from testbed.controllers.actuator_model import throttle_for
from testbed.controllers.commands import command_actuators, write_diagnosis, write_guard, write_telemetry
from testbed.controllers.inversion.evidence import MEAN_S


def test_servos_get_angles_and_motors_the_throttle_for_their_thrust() -> None:
    setup = vtail_setup()
    m, _, _, s, _ = records_of(setup)
    s.u[:] = [0.3, -0.4, 2.0, 3.0]
    command_actuators(axial(setup.model), m, s)
    assert s.command[:2] == pytest.approx(np.array([0.3, -0.4]) * setup.scale[:2])
    for i, thrust in ((2, 4.0), (3, 6.0)):
        assert s.command[i] == throttle_for(i, thrust, axial(setup.model), m, s)


def test_the_row_has_the_order_of_the_signals() -> None:
    s = records_of(vtail_setup()).s
    s.r[:], s.u[:], s.lambda_hat[:] = [1, 2, 3, 4], [5, 6, 7, 8], [0.1, 0.2, 0.3, 0.4]
    s.failed[:], s.x_dc_dot[:] = [0, 1, 0, 0], [10, 20, 30, 40]
    _, c, *_ = records_of(vtail_setup(WEATHER))
    (row,) = telemetry_rows(1, 4)
    write_telemetry(row, np.array([0, 0, 1, 0], np.int8), s)
    s.stuck[:] = [0, 1, 0, 0, 1, 0]
    beliefs = len(row) - len(GUARDED) - 8
    assert np.isnan(row[8:16]).all() and np.isnan(row[beliefs:]).all()  # what not every law says
    write_diagnosis(row, c, s)
    write_guard(row, s)
    of = {name: row[4 * i : 4 * i + 4].tolist() for i, name in enumerate(TELEMETRY)}
    assert of["reference"] == [1, 2, 3, 4] and of["command"] == [5, 6, 7, 8]
    assert of["effectiveness_estimate"] == [0.1, 0.2, 0.3, 0.4] and of["failed"] == [0, 1, 0, 0]
    rates = len(TELEMETRY) * 4
    assert row[rates : rates + len(RATES)].tolist() == [10, 20, 30, 40]
    assert row[rates + len(RATES) : beliefs].tolist() == [0, 0, 1, 0]
    assert row[-len(GUARDED) :].tolist() == [0, 1, 0, 0, 1, 0]


def test_a_jammed_actuator_has_no_effectiveness() -> None:
    """What is estimated of it is its position, which is no effectiveness to be logged."""
    _, c, _, s, _ = records_of(vtail_setup(WEATHER))
    s.lambda_hat[1], s.jammed[1] = 2.5, 1
    (row,) = telemetry_rows(1, 4)
    write_diagnosis(row, c, s)
    assert row[8:12].tolist() == [1.0, 0.0, 1.0, 1.0]


KNOWN = [
    ({}, Belief.works),
    ({"failed": 1, "early": 1, "lambda_hat": 0.0}, Belief.lost),
    ({"early": 1, "lambda_hat": 0.1}, Belief.doubted),
    ({"early": 1, "lambda_hat": 0.9}, Belief.works),  # it came back
    ({"moved": -0.3}, Belief.doubted),
    ({"failed": 1, "jammed": 1, "lambda_hat": 2.5}, Belief.held),
    ({"failed": 1, "reversed": 1, "lambda_hat": -1.0}, Belief.reversed),
    ({"moved": 0.4, "offset_timer": 1.01 * MEAN_S}, Belief.offset),
    ({"late": 2.0, "late_variance": 0.01}, Belief.late),
    ({"late": 0.2, "late_variance": 0.01}, Belief.works),  # 2 standard deviations
]


@pytest.mark.parametrize(("memory", "belief"), KNOWN)
def test_what_the_memory_says_of_an_actuator_is_logged(memory: dict[str, float], belief: Belief) -> None:
    _, c, _, s, _ = records_of(vtail_setup(WEATHER))
    for name, value in memory.items():
        s[name][1] = value
    (row,) = telemetry_rows(1, 4)
    write_diagnosis(row, c, s)
    kind, position = np.split(row[: -len(GUARDED)][-8:], 2)
    assert kind.tolist() == [Belief.works, belief, Belief.works, Belief.works]
    held = memory["lambda_hat"] if belief is Belief.held else np.nan
    assert np.array_equal(position, [np.nan, held, np.nan, np.nan], equal_nan=True)


def test_a_law_that_diagnoses_nothing_says_nothing() -> None:
    _, c, _, s, _ = records_of(vtail_setup(WEATHER))
    c.estimates, c.monitors, c.tests_jams = False, False, False
    (row,) = telemetry_rows(1, 4)
    write_diagnosis(row, c, s)
    assert np.isnan(row).all()
