"""The summary of a received flight is checked, each value by its place; so are its events against scenario, actuators and log."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from handmade import flight_of, injection, level_log

import testbed
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput

_LIMIT = {"limit": "roll_max_deg", "value": 90.0, "allowed": 60.0, "unit": "deg"}
WRONG: dict[str, tuple[str, Any]] = {
    "events.0.failure: is not in the scenario, which has 1": ("events", [injection(2.0, failure=1)]),
    "events.0.time_s: is ": ("events", [{"kind": "diagnosis", "text": "", "time_s": 10**400}]),
    "events.0.kind: is missing": ("events", [{"time_s": 1.0}]),
    "events.0.delay_s: is missing": ("events", [{"time_s": 1.0, "kind": "detection", "actuator": "fan"}]),
    "events.0.actuator: is no actuator of this flight: 'x', expected one of elevon, fan": (
        "events", [{"time_s": 1.0, "kind": "false_alarm", "actuator": "x"}]),
    "events.0.axis: is r_dot, of which the log says nothing": (
        "events", [{"time_s": 1.0, "kind": "release", "axis": "r_dot"}]),
    "events.0.axis: 'x' is not known": ("events", [{"time_s": 1.0, "kind": "release", "axis": "x"}]),
    "events.0.limits.0.value: is empty": (
        "events", [{"time_s": 1.0, "kind": "lost", "limits": [_LIMIT | {"value": None}], "at_stop": []}]),
    "metrics.x: is ": ("metrics", {"x": 10**400}),
    "requirements.0.value: is 'x'": ("requirements", [{"name": "a", "passed": True, "value": "x"}]),
    "actuators.0.limits.0: is 'low'": (
        "actuators", [{"name": "a", "kind": "servo", "unit": "deg", "limits": ["low", 1], "scale": 1}]),
}  # fmt: skip


@pytest.mark.parametrize("said", WRONG)
def test_what_a_flight_cannot_have_is_refused_with_its_place(tmp_path: Path, said: str) -> None:
    folder = write_run_folder(flight_of(level_log()), tmp_path / "run")
    assert testbed.load(folder)
    key, wrong = WRONG[said]
    file = folder / "summary.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), key: wrong}))
    with pytest.raises(BadInput) as refused:
        testbed.load(folder)
    assert str(refused.value.problems[0]).startswith(f"{file}: {said}")


@pytest.mark.parametrize("of", ["effectiveness", "effectiveness_estimate", "failed", "command"])
def test_a_log_without_a_column_of_an_actuator_is_refused(tmp_path: Path, of: str) -> None:
    log = level_log()
    del log[f"fan_{of}"]
    folder = write_run_folder(flight_of(log), tmp_path / "run")
    with pytest.raises(BadInput, match=rf"log\.csv:1: has no column fan_{of}$"):
        testbed.load(folder)
