"""Allocation within the stops: what is given up, and that the rest is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from adopted_aircraft import adopted
from scipy.optimize import lsq_linear
from vtail_setup import WEATHER, Records, axial, records_of, vtail_setup

import testbed
from testbed.controllers.actuator_model import throttle_for
from testbed.controllers.inversion.allocation import allocate_and_command
from testbed.controllers.inversion.law import invert
from testbed.controllers.inversion.modes import allocation_of
from testbed.controllers.records import Q_DOT, R_DOT, U_DOT

SETUP = vtail_setup()
REDUNDANT = vtail_setup(WEATHER)  # roll released: four actuators for three axes
ALONG = axial(SETUP.model)
KEPT = [Q_DOT, R_DOT, U_DOT]


def allocate(records: Records, nu: np.ndarray, pressure_ratio: float = 1.0) -> Any:
    """Rates [4] that the references r give, beyond those of the trim."""
    m, c, k, s, w = records
    allocate_and_command(nu, pressure_ratio, ALONG, m, c, k, s, w)
    return np.array(m.B) @ (np.where(m.servo == 1, pressure_ratio, 1.0) * s.r - k.trim_effect)


def test_without_a_stop_in_the_way_it_is_the_inverse() -> None:
    records = records_of(REDUNDANT)
    nu = np.array([0.0, 0.5, -0.3, 0.1])
    given = allocate(records, nu)
    assert given[KEPT] == pytest.approx(nu[KEPT])
    found = records.s.r.copy()
    invert(nu, 1.0, records.m, records.k, records.s)
    assert np.array_equal(records.s.r, found)


@pytest.mark.parametrize("pressure_ratio", [0.7, 1.0, 1.4])
def test_one_at_its_stop_is_made_up_for_by_the_others(pressure_ratio: float) -> None:
    """The kept axes get what they ask for from the other three, and the one stands at its stop."""
    records = records_of(REDUNDANT)
    records.m.high[0] = 0.05
    nu = np.array([0.0, -2.0, 0.4, 0.2])
    given = allocate(records, nu, pressure_ratio)
    assert records.s.r[0] == pytest.approx(0.05)
    assert given[KEPT] == pytest.approx(nu[KEPT], abs=1e-3)


def test_airspeed_gives_way_and_attitude_does_not() -> None:
    """Both propellers would pass their stops: u_dot is missed by 8 m/s2, p, q and r together by a twentieth of that."""
    records = records_of(SETUP)
    nu = np.array([0.3, 0.2, -0.1, 12.0])
    given = allocate(records, nu)
    assert records.s.r[2:] == pytest.approx(records.m.high[2:], rel=0.05)
    assert np.abs(given - nu)[:3].max() < 0.05 * (nu - given)[U_DOT]


def test_only_what_the_strongest_surface_would_have_to_go_beyond_its_stop_for_is_missing() -> None:
    """Three demands: a pitch that no surface can give, the same the other way, and an airspeed that no propeller can give. The
    last costs attitude a little, which is no pitch that is missing."""
    for q_dot, u_dot in ((-60.0, 0.0), (60.0, 0.0), (-1.0, 12.0)):
        records = records_of(REDUNDANT)
        nu = np.array([0.0, q_dot, 0.0, u_dot])
        given = allocate(records, nu)
        assert records.s.saturated and abs(nu - given)[Q_DOT] > 1e-4
        missing = (nu - given)[Q_DOT] if u_dot == 0.0 else 0.0
        assert records.s.pitch_beyond_stop == pytest.approx(missing)
    allocate(records, np.array([0.0, -1.0, 0.0, 0.0]))
    assert records.s.pitch_beyond_stop == 0.0


def test_a_demand_on_airspeed_costs_attitude_almost_nothing() -> None:
    """The same attitude demands, with and without an airspeed demand that no actuator can meet."""
    rng = np.random.default_rng(1)
    for _ in range(200):
        attitude = rng.normal(size=3) * np.array([0.0, 4.0, 2.0])
        missed = []
        for u_dot in (0.0, 10.0, -10.0):
            given = allocate(records_of(REDUNDANT), np.array([*attitude, u_dot]))
            missed.append(np.abs(given[1:3] - attitude[1:]).max())
        assert max(missed[1:]) <= missed[0] + 0.15**2 * 10.0


def test_a_weak_actuator_has_less_travel() -> None:
    """The stops of the reference r are lambda_hat times those of the actuator."""
    records = records_of(SETUP)
    records.s.lambda_hat[2] = 0.5
    allocate(records, np.array([0.0, 0.0, 0.0, 12.0]))
    assert records.s.r[2] <= 0.5 * records.m.high[2] + 1e-9
    assert records.s.u[2] == pytest.approx(records.m.high[2], rel=0.05)


def test_the_travel_of_a_reversed_actuator_is_used_the_other_way() -> None:
    """A lower stop that is near limits how far up its force goes, and the others make up for it."""
    records = records_of(REDUNDANT)
    records.s.reversed[0], records.s.lambda_hat[0], records.m.low[0] = 1, -1.0, -0.05
    nu = np.array([0.0, -2.0, 0.4, 0.2])
    given = allocate(records, nu)
    assert records.s.r[0] == pytest.approx(0.05) and records.s.u[0] == pytest.approx(-0.05)
    assert given[KEPT] == pytest.approx(nu[KEPT], abs=1e-3)


def test_what_is_not_divided_by_the_estimates_has_its_whole_travel() -> None:
    records = records_of(SETUP)
    records.s.lambda_hat[2], records.c.uncompensated = 0.5, 1
    nu = np.array([0.0, 0.0, 0.0, 0.2])
    assert allocate(records, nu) == pytest.approx(nu)
    assert np.array_equal(records.s.u, records.s.r)


@pytest.mark.nightly
def test_random_demands_in_every_mode_are_met_as_well_as_the_stops_allow() -> None:
    """Against scipy: any demand, weak and failed actuators, any dynamic pressure, from one step to the next (warm start)."""
    rng = np.random.default_rng(2)
    modes = {(): (), (0,): ("r_dot",), (3,): ("p_dot",), (0, 2): ("p_dot", "r_dot")}
    for failed, released in modes.items():
        records = records_of(REDUNDANT)
        m, _, k, s, _ = records
        k.available[list(failed)] = 0
        k.trim_effect[:] = 0.0
        k.row_weight[:], k.hessian[:] = allocation_of(np.array(m.B), released, SETUP.control.allocation)
        used = [i for i in range(4) if i not in failed]
        kept = [i for i in range(4) if k.row_weight[i] > 0.0]
        k.B_hat_inv[:] = 0.0
        k.B_hat_inv[np.ix_(used, kept)] = np.linalg.pinv(np.array(m.B)[np.ix_(kept, used)])
        for _ in range(300):
            s.lambda_hat[:] = rng.uniform(0.05, 1.2, size=4)
            pressure = np.where(m.servo == 1, rng.uniform(0.5, 1.6), 1.0)
            nu = rng.normal(size=4) * np.array([3.0, 20.0, 8.0, 3.0])
            given = allocate(records, nu, float(pressure[0]))
            lam = np.maximum(s.lambda_hat, 0.1)
            assert np.all(s.u >= m.low) and np.all(s.u <= m.high)
            bounds = (lam * pressure * np.array([m.low, m.high]))[:, used]
            w = np.sqrt(k.row_weight)
            A = np.vstack([w[:, None] * np.array(m.B)[:, used], 1e-3 * np.eye(len(used))])
            best = lsq_linear(A, np.concatenate([w * nu, np.zeros(len(used))]), bounds, tol=1e-13)
            missed = np.sum((w * (given - nu)) ** 2)
            assert missed <= 2.0 * best.cost + 1e-9


def test_allocation_ends_in_commands_within_the_stops() -> None:
    records = records_of(SETUP)
    m, _, _, s, _ = records
    allocate(records, np.array([5.0, -30.0, 9.0, 20.0]))
    assert np.all(s.u >= m.low) and np.all(s.u <= m.high)
    assert s.command[:2] == pytest.approx(s.u[:2] * SETUP.scale[:2])
    assert s.command[2] == throttle_for(2, s.u[2] * SETUP.scale[2], ALONG, m, s)


@pytest.mark.nightly
def test_the_rudder_is_not_thrown_over_for_the_roll_of_a_weak_aileron(tmp_path: Path) -> None:
    """An F-15's aileron has 0.4 of its effect. With equal weights of all axes its rudder goes to the stop: lost in 7 s."""
    flown = {}
    for name, weights in {"derived": {}, "equal": {"p_dot": 1.0, "q_dot": 1.0, "r_dot": 1.0}}.items():
        folder = adopted("f15", tmp_path / name)
        description = yaml.safe_load((folder / "f15.yaml").read_text())
        description.setdefault("control", {})["allocation"] = weights
        (folder / "f15.yaml").write_text(yaml.safe_dump(description))
        at = description["reference"]
        start = {"altitude_m": at["altitude_m"], "airspeed_m_s": at["airspeed_m_s"], "heading_deg": 90}
        scenario = {
            "name": name, "aircraft": str(folder), "duration_s": 40, "seed": 94001, "initial": start,
            "controller": {"type": "adaptive_inversion"},
            "commands": [{"at_s": 0, **start}, {"at_s": 5, "heading_deg": 120}],
            "failures": [{"type": "effectiveness", "actuator": "aileron", "at_s": 20, "value": 0.4}],
            "atmosphere": {"turbulence_w20_m_s": 7.62},
        }  # fmt: skip
        file = tmp_path / f"{name}.yaml"
        file.write_text(yaml.safe_dump(scenario))
        flown[name] = testbed.fly(file).summary
    assert flown["derived"]["outcome"] == "completed"
    assert flown["equal"]["outcome"] == "envelope_exceeded"  # the control: the weights decide it
