"""What a scenario may say of each controller: defaults, what is refused, and the way there and back."""

from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError
from short_flights import scenario
from vtail_setup import records_of, vtail_setup

from testbed.aircraft.control_design import ControlDesign
from testbed.controllers.config import (
    TABLE,
    AdaptiveInversionSettings,
    ControllerSettings,
    L1InversionSettings,
    PerKind,
    RlsInversionSettings,
)
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


def inversion(**given: object) -> AdaptiveInversionSettings:
    return AdaptiveInversionSettings.model_validate(given)


def test_the_type_alone_is_the_law_for_weather() -> None:
    default = inversion()
    assert (default.preset, default.estimation, default.released) == ("default", "weighted", None)
    assert (default.threshold, default.recovery, default.lambda_min) == (0.06, 0.8, -1.2)
    assert inversion(estimation="weighted", released="auto") == default
    assert inversion(recovery=0.9).recovery == 0.9


def test_a_threshold_that_is_given_is_for_propellers_too() -> None:
    assert inversion().propeller_threshold == 0.12
    assert inversion(threshold=0.2).propeller_threshold is None
    assert inversion(preset="paper").propeller_threshold is None
    assert inversion(threshold=0.05, propeller_threshold=0.1).propeller_threshold == 0.1
    kinds = records_of(vtail_setup(inversion())).c
    assert (kinds.threshold + kinds.threshold_rise).tolist() == pytest.approx([0.06, 0.06, 0.12, 0.12])


def test_the_papers_law_has_defaults_of_its_own_that_can_be_overridden() -> None:
    paper = inversion(preset="paper")
    assert (paper.estimation, paper.released, paper.filter_rad_s) == ("newton", (), 0.0)
    assert (paper.threshold, paper.recovery, paper.lambda_min) == (0.1, 0.6, 0.05)
    changed = inversion(preset="paper", recovery=0.7, released=["p_dot"])
    assert (changed.recovery, changed.released, changed.threshold) == (0.7, ("p_dot",), 0.1)


@pytest.mark.parametrize("given", [{"estimation": "newton"}, {"gamma": 4.0}, {"epsilon": 0.05}])
def test_settings_of_the_papers_law_alone_choose_it(given: dict[str, object]) -> None:
    """As they did before there were presets."""
    assert inversion(**given) == inversion(preset="paper", **given)


@pytest.mark.parametrize("name", ["estimate", "monitor", "model_error", "speed_rule", "jam_test"])
def test_parts_can_be_switched_off(name: str) -> None:
    assert inversion(ablate=[name]).ablate == (name,)
    with pytest.raises(ValidationError):
        inversion(ablate=[f"{name}s"])


def test_without_the_speed_rule_neither_airspeed_nor_altitude_is_given_up() -> None:
    control = ControlDesign()
    assert inversion().applied_to(control) is control
    loops = inversion(ablate=["speed_rule"]).applied_to(control).loops
    assert loops.lost_thrust_faster_m_s == loops.slow_descent_s == 0.0


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"threshold": 0.5, "recovery": 0.4}, "recovery.*0.4 is not above threshold"),
        ({"preset": "paper", "lambda_min": 0.0}, "newton integrates the logarithm"),
        ({"lambda_min": 0.5, "lambda_max": 0.4}, "lambda_max.*0.4 is not above lambda_min"),
        ({"gamma": 0.0}, "gamma"),
    ],
)
def test_contradictions_are_refused(given: dict[str, float], message: str) -> None:
    with pytest.raises(ValidationError) as caught:
        AdaptiveInversionSettings.model_validate(given)
    import re

    assert re.search(message, str(caught.value), flags=re.DOTALL)


@pytest.mark.parametrize("settings", [AdaptiveInversionSettings, L1InversionSettings, RlsInversionSettings])
@pytest.mark.parametrize("given", [{"lambda_min": 0.9, "lambda_max": 0.4}, {"lambda_min": 2.5}])
def test_the_limits_of_the_estimates_are_in_order(
    settings: type[ControllerSettings], given: dict[str, float]
) -> None:
    """Also where one of them is the default."""
    with pytest.raises(ValidationError, match="is not above lambda_min"):
        settings.model_validate(given)


def test_a_weighted_estimate_may_be_negative() -> None:
    given = {"estimation": "weighted", "lambda_min": -0.5}
    assert AdaptiveInversionSettings.model_validate(given).lambda_min == -0.5


def test_a_type_that_is_no_text_is_refused() -> None:
    with pytest.raises(BadInput, match=r"controller\.type"):
        load_scenario("scenarios/left_tail_fail.yaml", ["controller.type={a: 1}"])
