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


def flown(folder: Path, seconds: float, *failures: str) -> Readings:
    text = f"failures=[{', '.join(failures)}]"
    return readings(fly(scenario(folder, "informed_inversion", seconds, text)))


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
