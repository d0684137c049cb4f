"""The suite of aircraft that the law was not made on: it loads, and shares no aircraft with `open`."""

from __future__ import annotations

from pathlib import Path

import strangers
import yaml

from testbed.studies.benchmark.load import load_suite


def test_it_is_a_suite_of_other_aircraft(tmp_path: Path) -> None:
    file = tmp_path / "strangers.yaml"
    file.write_text(yaml.safe_dump(strangers.suite(), sort_keys=False))
    suite, _ = load_suite(file)
    known, _ = load_suite(strangers.ROOT / "scenarios" / "suites" / "open.yaml")
    assert suite.aircraft and not set(suite.aircraft) & set(known.aircraft)
    assert tuple(suite.controllers) == strangers.CONTROLLERS
