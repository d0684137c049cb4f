"""Told the truth in the step in which it becomes true, and nobody else is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_flights import scenario
from vtail_setup import vtail_setup

from testbed.controllers.config import InformedSettings
from testbed.controllers.informed import InformedController
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput
from testbed.metrics import Readings, readings
from testbed.simulation import assemble, fly

BROKEN_S = 3.0


def flown(folder: Path, seconds: float, *failures: str, choice: str = "") -> Readings:
    chosen = [f"controller.{choice}"] if choice else []
    text = f"failures=[{', '.join(failures)}]"
    return readings(fly(scenario(folder, "informed_inversion", seconds, text, *chosen)))


def test_a_loss_is_known_in_its_own_step(tmp_path: Path) -> None:
    lost = f"{{type: effectiveness, actuator: left_propeller, at_s: {BROKEN_S}, value: 0}}"
    weak = f"{{type: effectiveness, actuator: left_ruddervator, at_s: {BROKEN_S}, value: 0.3}}"
    log = flown(tmp_path, 20, lost, weak)
    row = log.row_at(BROKEN_S)
    assert log.survived
    for actuator in log.actuators:
        estimate, truth = (
            log.log[f"{actuator}_{name}"] for name in ("effectiveness_estimate", "effectiveness")
        )
        assert np.array_equal(estimate, truth)
    assert log.log["left_propeller_failed"][row - 1 : row + 1].tolist() == [0, 1]
    assert not log.log["left_ruddervator_failed"].any()  # weak, not lost


@pytest.mark.parametrize("kind", ["stuck_at, value: 5", "reversal", "float"])
def test_what_does_not_follow_its_command_is_flagged_until_it_does(tmp_path: Path, kind: str) -> None:
    jam = f"{{type: {kind}, actuator: right_ruddervator, at_s: {BROKEN_S}, until_s: {BROKEN_S + 2}}}"
    log = flown(tmp_path, 8, jam)
    flagged, first = log.log["right_ruddervator_failed"], log.row_at(BROKEN_S)
    end = log.row_at(BROKEN_S + 2)
    assert flagged[first:end].all()
    assert not flagged[:first].any() and not flagged[end:].any()
    assert log.survived


def test_nobody_else_is_told(tmp_path: Path) -> None:
    """Neither another controller, nor the user's own in its place."""
    seen: list[Setup] = []

    class Own:
        def __init__(self, setup: Setup) -> None:
            seen.append(setup)

        def update(self, *_: Any) -> list[float]:
            return [0.0] * 4

    for name in ("informed_inversion", "pid"):
        assemble(scenario(tmp_path, name), Own)
    assert [setup.truth for setup in seen] == [None, None]
    with pytest.raises(BadInput, match="told the truth by the simulation"):
        InformedController(vtail_setup(InformedSettings()))


def test_it_is_still_accepted_by_its_old_name(tmp_path: Path) -> None:
    with pytest.warns(FutureWarning, match="oracle is called informed_inversion now"):
        loaded = scenario(tmp_path, "pid", 10, "controller.type=oracle")
    assert loaded.controller.type == "informed_inversion"


def test_patience_waits_for_what_comes_back(tmp_path: Path) -> None:
    lost = "{type: effectiveness, actuator: left_propeller, at_s: 1, until_s: 3, value: 0}"
    waits = flown(tmp_path, 5, lost, choice="patience_s=2.5").log
    gives_up = flown(tmp_path, 5, lost, choice="patience_s=0.5").log
    assert not waits["left_propeller_failed"].any()
    assert gives_up["left_propeller_failed"].sum() == pytest.approx(300, abs=1)  # 1.5 s at 200 Hz


def test_it_can_keep_all_axes(tmp_path: Path) -> None:
    """A lost tail gives up roll; with `keeps_axes` the rest shares all axes, and the aircraft stays near its references."""
    lost = f"{{type: effectiveness, actuator: left_ruddervator, at_s: {BROKEN_S}, value: 0}}"
    released = [f"{axis}_released" for axis in ("p_dot", "q_dot", "r_dot", "u_dot")]
    gives_up, keeps = (flown(tmp_path, 20, lost, choice=choice) for choice in ("", "keeps_axes=true"))
    assert any(gives_up.log[name].any() for name in released)
    assert not any(keeps.log[name].any() for name in released)
    assert keeps.survived
    assert np.abs(keeps.error("altitude")).max() < 5.0


def test_increments_make_up_for_what_it_is_not_told(tmp_path: Path) -> None:
    """A bent linkage: the surface follows, and is as effective as ever. The heading error is what it leaves."""
    bent = f"{{type: bias, actuator: left_ruddervator, at_s: {BROKEN_S}, value: 8}}"
    with_increments, without = (
        float(np.abs(flown(tmp_path, 15, bent, choice=f"increments={flag}").error("heading")).max())
        for flag in ("true", "false")
    )
    assert with_increments < 0.8 * without
