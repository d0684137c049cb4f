"""Allocation within the stops: what is given up, and that the rest is kept."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from vtail_setup import WEATHER, Records, axial, records_of, vtail_setup

from testbed.controllers.actuator_model import throttle_for
from testbed.controllers.inversion.allocation import allocate_and_command, give_up_airspeed, redistribute
from testbed.controllers.inversion.law import invert
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT

SETUP = vtail_setup()
REDUNDANT = vtail_setup(WEATHER)  # roll released: four actuators for three axes


def effect(records: Records, pressure_ratio: float = 1.0) -> Any:
    """Rates [4] that the references r give, beyond those of the trim."""
    m, _, k, s, _ = records
    return np.array(m.B) @ (np.where(m.servo == 1, pressure_ratio, 1.0) * s.r - k.r_trim)


def test_without_a_stop_in_the_way_nothing_is_given_up() -> None:
    records = records_of(REDUNDANT)
    m, c, k, s, _ = records
    nu = np.array([0.0, 0.5, -0.3, 0.1])
    invert(nu, 1.0, m, k, s)
    before = s.r.copy()
    redistribute(nu, 1.0, m, c, k, s)
    give_up_airspeed(m, c, k, s)
    assert np.array_equal(s.r, before)


@pytest.mark.parametrize("pressure_ratio", [0.7, 1.0, 1.4])
def test_one_at_its_stop_is_made_up_for_by_the_others(pressure_ratio: float) -> None:
    """The kept axes get what they ask for from the other three, and the one stands at its stop."""
    records = records_of(REDUNDANT)
    m, c, k, s, _ = records
    m.high[0] = 0.05
    nu = np.array([0.0, -2.0, 0.4, 0.2])
    invert(nu, pressure_ratio, m, k, s)
    assert s.r[0] > 0.05
    redistribute(nu, pressure_ratio, m, c, k, s)
    assert s.r[0] == pytest.approx(0.05)
    kept = [Q_DOT, R_DOT, U_DOT]
    assert effect(records, pressure_ratio)[kept] == pytest.approx(nu[kept])


def test_an_actuator_to_spare_is_needed_for_that() -> None:
    m, c, k, s, _ = records_of(SETUP)
    m.high[0] = 0.05
    nu = np.array([0.0, -2.0, 0.4, 0.2])
    invert(nu, 1.0, m, k, s)
    before = s.r.copy()
    redistribute(nu, 1.0, m, c, k, s)
    assert np.array_equal(s.r, before)


def test_airspeed_gives_way_and_the_other_axes_do_not() -> None:
    """A propeller would pass its stop: u_dot is cut until it does not, p, q and r get what they asked for."""
    records = records_of(SETUP)
    m, c, k, s, _ = records
    nu = np.array([0.3, 0.2, -0.1, 12.0])
    invert(nu, 1.0, m, k, s)
    assert s.r[2] > m.high[2]
    give_up_airspeed(m, c, k, s)
    assert np.all(s.r <= m.high + 1e-9) and np.all(s.r >= m.low - 1e-9)
    given = effect(records)
    assert given[:3] == pytest.approx(nu[:3])
    assert 0.0 < given[U_DOT] < 12.0
    assert max(s.r[2:] / m.high[2:]) == pytest.approx(1.0), "no more is given up than is needed"


def test_a_weak_actuator_has_less_travel() -> None:
    """The stops of the reference r are lambda_hat times those of the actuator."""
    m, c, k, s, _ = records_of(SETUP)
    s.lambda_hat[2] = 0.5
    nu = np.array([0.0, 0.0, 0.0, 12.0])
    invert(nu, 1.0, m, k, s)
    give_up_airspeed(m, c, k, s)
    assert s.r[2] == pytest.approx(0.5 * m.high[2])


def test_allocation_ends_in_commands_within_the_stops() -> None:
    m, c, k, s, _ = records_of(SETUP)
    along = axial(SETUP.model)
    allocate_and_command(np.array([5.0, -30.0, 9.0, 20.0]), 1.0, along, m, c, k, s)
    assert np.all(s.u >= m.low) and np.all(s.u <= m.high)
    assert s.command[:2] == pytest.approx(s.u[:2] * SETUP.scale[:2])
    assert s.command[2] == throttle_for(2, s.u[2] * SETUP.scale[2], along, m, s)
