"""Flights whose logs are diagnosed: flown once for all tests of this folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

import testbed
from testbed.inputs.yaml_source import dump

SCENARIO: dict[str, Any] = {
    "name": "logged", "aircraft": "vtail", "duration_s": 45, "log_hz": 100, "seed": 5,
    "commands": [{"at_s": 4, "heading_deg": 110}, {"at_s": 10, "altitude_m": 306}, {"at_s": 22, "heading_deg": 80},
                 {"at_s": 32, "altitude_m": 300}],
    "command_rates": {"heading_deg_s": 6, "altitude_m_s": 1},
}  # fmt: skip
WEATHER = {"sensors": {"model": "mems"}, "atmosphere": {"turbulence_w20_m_s": 5}}
AT_S = 18.0
Run = Callable[..., Path]


@pytest.fixture(scope="session")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """run(failure or None, weather): the run folder of a flight, each flown once."""
    made: dict[str, Path] = {}

    def fly(failure: Mapping[str, Any] | None = None, weather: bool = False) -> Path:
        broken = [] if failure is None else [{"at_s": AT_S, **failure}]
        text = dump({**SCENARIO, "failures": broken, **(WEATHER if weather else {})})
        if text not in made:
            folder = tmp_path_factory.mktemp("logged")
            (folder / "scenario.yaml").write_text(text)
            made[text] = testbed.fly(folder / "scenario.yaml").save(folder / "run", figures=False)
        return made[text]

    return fly
