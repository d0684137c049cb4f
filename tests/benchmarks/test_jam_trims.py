"""The search for trims on the truth, against a trim that is known."""

from __future__ import annotations

import math

import pytest
from jam_trims import TruthSearch, jams

from testbed.aircraft.description import load_aircraft
from testbed.plant.trim import trimmed_start


def test_a_surface_jammed_at_its_trim_position_has_the_reference_trim() -> None:
    aircraft = load_aircraft("vtail")
    trim = trimmed_start(aircraft, 200.0, 18.0, 300.0, 0.0)
    (found,) = TruthSearch(aircraft, 0, trim.commands[0]).over_airspeeds([18.0], 0.0)
    assert found.alpha_deg == pytest.approx(math.degrees(trim.state["alpha"]), abs=1e-3)
    assert found.positions == pytest.approx(trim.positions, abs=2e-3)
    assert found.margin == pytest.approx((25.8 - trim.positions[1]) / 11.459, abs=1e-2)


def test_what_no_flight_balances_is_not_found() -> None:
    """Negative control: a tail at its lower stop at 18 m/s would need more thrust difference than there is."""
    assert TruthSearch(load_aircraft("vtail"), 0, math.radians(-25.8)).over_airspeeds([18.0], 0.0) == []


def test_jams_go_from_stop_to_stop() -> None:
    found = [words for _, name, _, words in jams(load_aircraft("vtail"), False) if name.startswith("left")]
    assert found[:3] == ["-25.8 deg", "-25.0 deg", "-20.0 deg"] and found[12] == "25.8 deg"
    assert found[13:15] == ["throttle 0.0", "throttle 0.1"] and found[-1] == "throttle 1.0"
