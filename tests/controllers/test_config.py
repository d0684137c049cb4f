"""What a scenario may say of each controller: defaults, what is refused, and the way there and back."""

from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError
from short_flights import scenario

from testbed.controllers.config import TABLE, AdaptiveInversionSettings, PerKind
from testbed.inputs.problems import BadInput
from testbed.scenario.load import dump, load_scenario


@pytest.mark.parametrize("name", TABLE)
def test_the_table_names_each_by_its_type(name: str) -> None:
    assert TABLE[name]().type == name


@pytest.mark.parametrize("name", TABLE)
def test_settings_go_round(tmp_path: Path, name: str) -> None:
    first = scenario(
        tmp_path, name, 25, "controller.released=[p_dot]", "controller.model_error={Cm_alpha: 1.1}"
    )
    file = tmp_path / "again.yaml"
    file.write_text(dump(first))
    assert load_scenario(file).controller == first.controller
    assert isinstance(first.controller, TABLE[name])


@pytest.mark.parametrize("name", TABLE)
def test_an_unknown_setting_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(BadInput, match=r"controller\.nonsense: unknown key"):
        scenario(tmp_path, name, 25, "controller.nonsense=1")


def test_a_number_is_for_servos_and_motors() -> None:
    both, each = PerKind.model_validate(3), PerKind.model_validate({"servo": 1, "motor": 2.5})
    assert (both.of("servo"), both.of("motor")) == (3.0, 3.0)
    assert (each.of("servo"), each.of("motor")) == (1.0, 2.5)
    for wrong in (True, "3", [1, 2], {"servo": 1}, 0):
        with pytest.raises(ValidationError):
            PerKind.model_validate(wrong)


def test_weighted_has_defaults_of_its_own_that_can_be_overridden() -> None:
    newton = AdaptiveInversionSettings()
    weighted = AdaptiveInversionSettings.model_validate({"estimation": "weighted", "recovery": 0.9})
    assert (newton.threshold, newton.recovery, newton.lambda_min) == (0.1, 0.6, 0.05)
    assert (weighted.threshold, weighted.recovery, weighted.lambda_min) == (0.15, 0.9, -1.2)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"threshold": 0.5, "recovery": 0.4}, "recovery.*0.4 is not above threshold"),
        ({"lambda_min": 0.0}, "newton integrates the logarithm"),
        ({"lambda_min": 0.5, "lambda_max": 0.4}, "lambda_max.*0.4 is not above lambda_min"),
        ({"gamma": 0.0}, "gamma"),
    ],
)
def test_contradictions_are_refused(given: dict[str, float], message: str) -> None:
    with pytest.raises(ValidationError) as caught:
        AdaptiveInversionSettings.model_validate(given)
    import re

    assert re.search(message, str(caught.value), flags=re.DOTALL)


def test_a_weighted_estimate_may_be_negative() -> None:
    given = {"estimation": "weighted", "lambda_min": -0.5}
    assert AdaptiveInversionSettings.model_validate(given).lambda_min == -0.5
