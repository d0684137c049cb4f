"""Trims with a motor that is stuck: its throttle stays, so its thrust falls with airspeed."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from adopted_aircraft import adopted
from vtail_setup import DT, vtail_setup

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import trimmed_memory
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.inversion.mode_trim import airspeed_range, margins, steady_flight
from testbed.controllers.inversion.modes import enumerate_modes
from testbed.controllers.inversion.regulator import design_regulator
from testbed.controllers.inversion.steady_flights import at_airspeeds, path_angles
from testbed.controllers.records import AIRSPEED, ALPHA, ALTITUDE, BETA, P_DOT, PITCH, R_DOT, ROLL, Q
from testbed.controllers.setup import Setup, setup_for

ENGINE = 3
"""Index of the only propeller or engine."""


def setup_of(name: str) -> Setup:
    aircraft = load_aircraft(name)
    model = load_design_model(aircraft.folder / DESIGN_MODEL)
    positions = [math.degrees(p) if k == "servo" else p for p, k in zip(model.trim, model.kinds, strict=True)]
    settings = AdaptiveInversionSettings()
    commands = [*model.trim[:ENGINE], 0.75]
    return setup_for(aircraft, model, settings, DT, commands, positions, model.alpha_rad)


SETUP = setup_of("aerosonde")
V, SCALE = SETUP.model.airspeed_m_s, float(SETUP.scale[ENGINE])
TRIM_N = SETUP.model.trim[ENGINE]


def stuck_at(thrust_n: float) -> DegradedAircraft:
    """What remains with the propeller stuck at the throttle of this thrust at the reference airspeed."""
    mode = enumerate_modes(SETUP.model, SETUP.scale, SETUP.control, SETUP.released)[(ENGINE,)]
    return DegradedAircraft.after(SETUP, mode, {ENGINE: thrust_n / SCALE})


def test_the_thrust_is_that_of_the_throttle_at_each_airspeed() -> None:
    degraded = stuck_at(TRIM_N)
    x = np.zeros((3, 10))
    x[:, AIRSPEED] = [0.8 * V, V, 1.2 * V]
    slow, same, fast = SCALE * degraded.with_thrust(x, np.tile(degraded.positions, (3, 1)))[:, ENGINE]
    assert same == pytest.approx(TRIM_N, abs=0.05)
    assert slow > same + 2.0 and fast < same - 2.0


@pytest.mark.parametrize("share", [0.5, 0.9, 1.0, 1.5, 3.0])
def test_level_flight_is_straight_at_the_airspeed_at_which_drag_is_the_thrust(share: float) -> None:
    degraded = stuck_at(share * TRIM_N)
    flight, held = steady_flight(degraded, SETUP.control.loops, "")
    assert held == ("altitude", "heading")
    assert degraded.motion(flight.state, flight.positions) == pytest.approx(np.zeros(10), abs=1e-6)
    assert flight.state[[BETA, ROLL]] == pytest.approx([0.0, 0.0], abs=5e-3)
    assert np.sign(flight.state[AIRSPEED] - V) == np.sign(round(share - 1.0, 6)) or share == 1.0


def test_more_thrust_is_flown_faster_and_no_airspeed_is_too_fast() -> None:
    flights = [steady_flight(stuck_at(share * TRIM_N), SETUP.control.loops, "") for share in (0.5, 1.0, 3.0)]
    assert np.all(np.diff([flight.state[AIRSPEED] for flight, _ in flights]) > 1.0)
    limits = airspeed_range(stuck_at(TRIM_N), *flights[1])
    assert limits.low == limits.high == pytest.approx(V, abs=1e-3) and limits.too_fast == math.inf


def test_a_propeller_that_brakes_leaves_a_shallow_glide() -> None:
    """No steeper than at any other airspeed within the same margins, and slower than the reference airspeed."""
    degraded = stuck_at(-20.0)
    flight, held = steady_flight(degraded, SETUP.control.loops, "")
    chosen = flight.only(np.newaxis)
    others = at_airspeeds(degraded, V * np.linspace(0.55, 1.3, 31))
    roomy = others.only(margins(degraded, others) >= margins(degraded, chosen)[0])
    assert held == ("airspeed", "heading") and flight.state[AIRSPEED] < V
    assert len(roomy.state) > 10 and path_angles(chosen)[0] >= path_angles(roomy).max() - 1e-6
    assert flight.state[ALPHA] < SETUP.model.stall_alpha_rad - 0.1


def test_the_estimated_thrust_belongs_to_the_measured_airspeed() -> None:
    """The same thrust, estimated 3 m/s above the reference airspeed, is that of a more open throttle: the trim is faster."""
    airspeeds = []
    for measured in (V, V + 3.0):
        memory = trimmed_memory(SETUP)
        modes, s = ModeSwitch(SETUP, memory), memory[0]
        s.failed[ENGINE], s.jammed[ENGINE], s.lambda_hat[ENGINE] = 1, 1, TRIM_N / SCALE
        modes.switch(1, measured)
        airspeeds.append(float(modes.record[0].x_trim[AIRSPEED]))
    assert airspeeds[0] == pytest.approx(V, abs=0.1) and airspeeds[1] > V + 0.5


def test_an_airspeed_that_cannot_be_is_not_believed() -> None:
    memory = trimmed_memory(SETUP)
    modes, s = ModeSwitch(SETUP, memory), memory[0]
    s.failed[ENGINE], s.jammed[ENGINE], s.lambda_hat[ENGINE] = 1, 1, TRIM_N / SCALE
    for measured in (0.0, -5.0, math.nan):
        modes.switch(1, measured)
        assert modes.mode.failed == ("propeller",) and np.all(np.isfinite(modes.record[0].K))


def test_with_thrust_short_of_least_drag_the_flight_is_not_slower_than_that(tmp_path: Path) -> None:
    """Slower, an elevator that holds altitude leaves the airspeed unstable; the trim of most margin asked for 1e4 rad/s2 a rad."""
    setup = setup_of(str(adopted("t6texan2", tmp_path)))
    mode = enumerate_modes(setup.model, setup.scale, setup.control, setup.released)[(ENGINE,)]
    for position in np.arange(1.3, 2.1, 0.1):
        regulator = design_regulator(setup, mode, {ENGINE: position})
        assert "altitude" in regulator.held and np.abs(regulator.K).max() < 500.0


def test_without_an_elevator_ailerons_and_rudder_are_not_thrown_for_pitch(tmp_path: Path) -> None:
    """The trim had 1.5 deg of bank, and a degree of pitch asked for 950 deg/s2 of roll: it rolled over within five seconds. With an
    engine lost as well a trim has bank, and its coupling is left out."""
    setup = setup_of(str(adopted("T37", tmp_path)))
    modes = enumerate_modes(setup.model, setup.scale, setup.control, setup.released)
    elevator, engine = (setup.model.actuators.index(name) for name in ("elevator", "left_engine"))
    for failed, bank in (((elevator,), 0.0), (tuple(sorted((elevator, engine))), 0.03)):
        regulator = design_regulator(setup, modes[failed], {})
        along = [AIRSPEED, ALPHA, Q, PITCH, ALTITUDE]
        assert np.abs(regulator.K[np.ix_([P_DOT, R_DOT], along)]).max() < 1.0
        assert regulator.eigenvalues.real.max() < 0.0
        assert abs(regulator.x_trim[ROLL]) == pytest.approx(bank, abs=0.01)
    setup = vtail_setup()
    both = enumerate_modes(setup.model, setup.scale, setup.control)[(0, 1)]
    assert design_regulator(setup, both, {}).K.any(), "its propellers control both"
