"""A good scenario file to spoil, what is said of a spoiled one, and the round trip of a good one."""

from __future__ import annotations

from pathlib import Path

import pytest

from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.load import Scenario, dump, load_scenario

GOOD = """\
name: left tail failure
aircraft: vtail
duration_s: 60
rate_hz: 200
physics_hz: 400
seed: 1
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion, gamma: 4.0, epsilon: 0.05}
commands:
  - {at_s: 0, altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
  - {at_s: 40, heading_deg: 120}
command_rates: {heading_deg_s: 4, altitude_m_s: 1, airspeed_m_s2: 0.5}
failures:
  - {type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0.2}
  - {type: effectiveness, actuator: left_ruddervator, at_s: 15, value: 0.0}
  - {type: property, at_s: 20, until_s: 25, set: {fcs/right-ruddervator/command-scale: 0.5}}
sensors: ideal
atmosphere: {wind_m_s: [0, 0, 0], turbulence_w20_m_s: 0}
requirements:
  - {metric: altitude_error_max_m, at_most: 5}
  - {signal: heading_deg, from_s: 2, until_s: 50, within: 2, of: heading_command_deg}
"""


def problems_of(file: Path, *overrides: str) -> tuple[Problem, ...]:
    with pytest.raises(BadInput) as caught:
        load_scenario(file, overrides)
    return caught.value.problems


def again_as_it_is(scenario: Scenario, folder: Path) -> None:
    file = folder / "resolved.yaml"
    file.write_text(dump(scenario), encoding="utf-8")
    again = load_scenario(file)
    assert again == scenario
    assert dump(again) == dump(scenario)
