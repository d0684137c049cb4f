"""Which mode is in force, what is said of those that cannot be, and aircraft that cannot be flown at all."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from vtail_setup import WEATHER, vtail_setup

from testbed.controllers.initial_records import trimmed_memory
from testbed.controllers.inversion.evidence import MEAN_S
from testbed.controllers.inversion.mode_switch import ModeSwitch
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput

SETUP = vtail_setup()


def switch_of(setup: Setup = SETUP) -> tuple[ModeSwitch, Any]:
    memory = trimmed_memory(setup)
    return ModeSwitch(setup, memory), memory[0]


def with_control(**changes: Any) -> Setup:
    return replace(SETUP, control=SETUP.control.model_copy(update=changes))


def test_a_flight_begins_with_everything_available() -> None:
    modes, s = switch_of()
    k = modes.record[0]
    assert k.available.tolist() == [1] * 4 and not k.released.any() and not k.regulated
    assert np.array(k.B_hat_inv) @ (np.array(SETUP.model.input_matrix)[:4] * SETUP.scale) == pytest.approx(
        np.eye(4), abs=1e-9
    )
    assert s.pitch_integral == SETUP.trim_pitch
    assert modes.reasons == []


def test_a_flagged_tail_puts_its_mode_in_force_and_starts_the_integrals_again() -> None:
    modes, s = switch_of()
    s.failed[0], s.heading_integral, s.integral[:] = 1, 0.4, 5.0
    modes.switch(100)
    k = modes.record[0]
    assert modes.mode.failed == ("left_ruddervator",)
    assert k.available.tolist() == [0, 1, 1, 1] and k.released.tolist() == [0, 0, 1, 0] and k.regulated == 1
    assert k.K.any() and k.r_trim.any() and k.x_trim.any()
    assert s.heading_integral == 0.0 and not s.integral.any()
    assert k.slow_descent_from == SETUP.control.loops.protect_from_m_s
    s.failed[0] = 0
    modes.switch(200)
    assert modes.mode.failed == () and not k.regulated and not (k.r_trim.any() or k.x_trim.any())


def test_a_lost_propeller_protects_airspeed_earlier() -> None:
    modes, s = switch_of()
    s.failed[2] = 1
    modes.switch(1)
    k = modes.record[0]
    assert k.slow_descent_from == SETUP.control.loops.lost_thrust_protect_from_m_s
    assert k.airspeed_offset >= SETUP.control.loops.lost_thrust_faster_m_s - 1e-9


def test_what_cannot_be_flown_leaves_the_last_mode_and_is_said_once() -> None:
    modes, s = switch_of()
    s.failed[0] = 1
    modes.switch(1)
    for failed, said in (
        ((0, 1, 2), "one actuator cannot hold altitude and heading"),
        ((0, 1, 2, 3), "4 actuators"),
    ):
        s.failed[list(failed)] = 1
        modes.switch(2)
        modes.switch(3)
        assert modes.mode.failed == ("left_ruddervator",)
        assert [step for step, text in modes.reasons if said in text] == [2]


def test_a_descent_is_said_with_its_angle() -> None:
    modes, s = switch_of()
    s.failed[2:] = 1
    modes.switch(7)
    (step, text), (_, airspeed) = modes.reasons
    assert step == 7 and text.startswith("left_propeller, right_propeller failed: altitude cannot be held.")
    assert text.endswith("deg") and "path angle of about -" in text
    assert f"flies at {modes.record[0].x_trim[0]:.1f} m/s" in airspeed and "or sinks slowest" in airspeed


def test_level_flight_is_not_given_up_for_a_flag_that_came_early() -> None:
    modes, s = switch_of()
    s.failed[0] = s.early[0] = 1
    modes.switch(1)  # without one tail there is level flight
    assert modes.mode.failed == ("left_ruddervator",) and s.failed.tolist() == [1, 0, 0, 0]
    s.failed[3] = s.early[3] = 1
    modes.switch(2)
    assert modes.mode.failed == ("left_ruddervator",) and s.failed.tolist() == [1, 0, 0, 0]
    assert modes.record[0].available.tolist() == [0, 1, 1, 1]
    ((step, text),) = modes.reasons
    assert step == 2 and text.startswith(
        "right_propeller: seems lost, but without it altitude cannot be held"
    )
    s.failed[3], s.early[3] = 1, 0  # it has stayed low for so long
    modes.switch(3)
    assert modes.mode.failed == ("left_ruddervator", "right_propeller") and not s.early.any()


def test_what_leaves_no_steady_flight_at_all_is_not_given_up_early_either() -> None:
    """A T-38's weak elevator was reversed for 0.8 s. It was given up at once for a mode without a trim, and 1070 m were lost."""
    modes, s = switch_of()
    s.failed[0] = 1
    modes.switch(1)
    s.failed[1:3] = s.early[1:3] = 1
    modes.switch(2)
    assert modes.mode.failed == ("left_ruddervator",) and s.failed.tolist() == [1, 0, 0, 0]
    assert all("seems lost" in text for _, text in modes.reasons) and len(modes.reasons) == 2


def test_a_jam_is_said_and_the_mode_is_designed_for_its_position() -> None:
    modes, s = switch_of(vtail_setup(WEATHER))
    s.failed[0], s.jammed[0], s.lambda_hat[0] = 1, 1, 0.6
    modes.switch(5)
    assert [text for _, text in modes.reasons] == [
        "left_ruddervator: not a loss of effectiveness: its force does not follow its command (jammed, offset or reversed)"
    ]
    assert s.designed_position[0] == 0.6
    assert modes.record[0].r_trim[0] == 0.6


def test_an_offset_is_said_and_changes_no_mode() -> None:
    modes, s = switch_of(vtail_setup(WEATHER))
    s.moved[1], s.offset_timer[1], s.heading_integral = -0.8, 1.01 * MEAN_S, 0.02
    modes.switch(5)
    assert modes.reasons == [
        (5, "right_ruddervator: its force follows its command with an offset: not jammed, used on")
    ]
    assert modes.mode.failed == () and s.heading_integral == 0.02


def test_what_is_reversed_is_used_and_said() -> None:
    modes, s = switch_of(vtail_setup(WEATHER))
    s.failed[:2], s.reversed[0] = 1, 1
    modes.switch(5)
    assert modes.mode.failed == ("right_ruddervator",) and modes.record[0].available.tolist() == [1, 0, 1, 1]
    said = "left_ruddervator: its force goes against its command: reversed, used again with the opposite sign"
    assert [text for _, text in modes.reasons] == [said]


def test_a_new_design_for_the_same_failure_keeps_what_the_integrals_have_learnt() -> None:
    """The part of nu that comes from the integrals is the same before and after; another failure starts with none."""
    modes, s = switch_of(vtail_setup(WEATHER))
    k = modes.record[0]
    s.failed[0], s.jammed[0], s.lambda_hat[0] = 1, 1, 0.6
    modes.switch(5)
    s.integral[:] = 1.0, -2.0, 0.3
    before, gains = k.K_integral @ s.integral, k.K_integral.copy()
    s.lambda_hat[0] = 1.1
    modes.switch(400)
    assert not np.allclose(k.K_integral, gains)
    assert k.K_integral @ s.integral == pytest.approx(before, rel=1e-9)
    s.jammed[0], s.failed[1] = 0, 1
    modes.switch(800)
    assert not s.integral.any()


def test_a_jam_that_no_trim_balances_is_flown_as_a_loss() -> None:
    modes, s = switch_of()
    s.failed[0], s.jammed[0], s.lambda_hat[0] = 1, 1, 300.0
    modes.switch(5)
    assert modes.mode.failed == ("left_ruddervator",)
    assert modes.record[0].r_trim[0] == pytest.approx(SETUP.model.trim[0] / SETUP.scale[0])


def test_a_level_trim_of_most_of_a_jam_comes_before_a_climb_that_balances_all() -> None:
    setup = vtail_setup(WEATHER)
    modes, s = switch_of(setup)
    position = setup.limits[0, 1]
    s.failed[0], s.jammed[0], s.lambda_hat[0] = 1, 1, position
    modes.switch(5)
    texts = [text for _, text in modes.reasons]
    assert (
        "left_ruddervator failed: no level trim balances the jam; flies by that of 70 % of its force" in texts
    )
    assert not any("altitude cannot be held" in text for text in texts)
    assert modes.record[0].r_trim[0] == pytest.approx(0.7 * position, abs=0.05)


def test_an_aircraft_that_cannot_be_inverted_is_bad_input_before_the_flight() -> None:
    with pytest.raises(BadInput) as caught:
        switch_of(with_control(condition_max=2.0))
    text = str(caught.value)
    for part in (
        "controller",
        "vtail cannot be flown by inversion",
        "condition number",
        "is above 2",
        "condition_max",
    ):
        assert part in text


def test_released_axes_that_leave_no_steady_flight_are_bad_input() -> None:
    limits = [replace(a, low=-1e-9, high=1e-9) for a in SETUP.actuators]
    with pytest.raises(BadInput, match="cannot be flown with these axes released"):
        switch_of(replace(vtail_setup(WEATHER), actuators=limits))


def test_another_airspeed_than_the_commanded_one_is_said_once_with_its_reason() -> None:
    modes, s = switch_of()
    s.failed[2] = 1
    modes.switch(7)
    modes.switch(8)
    ((step, text),) = modes.reasons
    height = SETUP.control.loops.lost_thrust_height_m
    assert step == 7 and f"3.9 m/s faster than commanded, to have {height:.0f} m of altitude" in text


def test_after_a_jam_airspeed_stays_where_level_flight_has_a_margin() -> None:
    modes, s = switch_of()
    s.failed[0] = s.jammed[0] = 1
    s.lambda_hat[0] = -math.radians(15.0) / SETUP.scale[0]
    modes.switch(1)
    k = modes.record[0]
    assert k.airspeed_offset == 0.0 and k.airspeed_high < k.airspeed_too_fast < SETUP.model.airspeed_m_s
    assert (
        k.airspeed_low <= k.x_trim[0] <= k.airspeed_high and k.fast_climb == SETUP.control.loops.fast_climb_s
    )
    assert any("farthest from the stops" in text for _, text in modes.reasons)
    s.lambda_hat[0] = SETUP.model.trim[0] / SETUP.scale[0]
    modes.switch(2)
    assert k.airspeed_low < SETUP.model.airspeed_m_s < k.airspeed_high and k.fast_climb == 0.0
