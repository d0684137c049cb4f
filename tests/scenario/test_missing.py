"""A dotted path leads into what a scenario does not say: its default is there, and one entry of it is replaced."""

from __future__ import annotations

from typing import Any

import pytest

from testbed.inputs import overrides
from testbed.inputs.yaml_source import parse
from testbed.scenario.load import default_at, scenario_from
from testbed.scenario.model import Scenario

TEXT = "name: a\naircraft: vtail\nduration_s: 1\n"


@pytest.mark.parametrize(
    ("path", "there"),
    [
        (("atmosphere",), {}),
        (("atmosphere", "wind_m_s"), [0.0, 0.0, 0.0]),
        (("atmosphere", "gusts"), []),
        (("controller",), {"type": "adaptive_inversion"}),
        (("controller", "model_error"), {}),
        (("no", "such", "key"), {}),
    ],
)
def test_what_is_made(path: tuple[str, ...], there: Any) -> None:
    assert default_at(path) == there


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("atmosphere.wind_m_s.1=4", lambda s: s.atmosphere.wind_m_s == (0.0, 4.0, 0.0)),
        ("controller.model_error.Cm_alpha=1.2", lambda s: s.controller.model_error == {"Cm_alpha": 1.2}),
    ],
)
def test_a_setting_of_something_that_the_file_does_not_have(setting: str, said: Any) -> None:
    source = parse(TEXT)
    overrides.apply(source, [setting], default_at)
    scenario = scenario_from(source)
    assert said(scenario) and type(scenario.controller) is type(Scenario.model_fields["controller"].default)
