"""Suites in which a part of the law decides: they are the open one with fewer kinds of failure."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import parts_where_they_act as kinds
import pytest
import yaml

from testbed.controllers.config import Part
from testbed.studies.benchmark.load import load_suite


@pytest.mark.parametrize("kind", kinds.KINDS)
def test_each_is_a_suite_with_the_default_and_the_default_without_the_part(kind: str, tmp_path: Path) -> None:
    file = tmp_path / f"{kind}.yaml"
    file.write_text(yaml.safe_dump(kinds.suite_of(kind), sort_keys=False))
    suite, _ = load_suite(file)
    part, wanted = kinds.KINDS[kind]
    assert part in get_args(Part) and list(suite.controllers) == ["default", f"no_{part}"]
    entries = kinds.suite_of(kind)["failures"]["types"]
    assert entries and all(wanted(entry) for entry in entries)
    assert {entry.get("of") for entry in entries} == {"motor"} or kind != "thrust"


def test_of_stuck_sensors_each_flight_has_one() -> None:
    suite = kinds.suite_of("stuck_sensors")
    assert suite["sensor_faults"]["share"] == 1.0 and suite["sensors"] == {"mems": 1}
    assert {fault["type"] for fault in suite["sensor_faults"]["faults"]} == {"stuck"}
