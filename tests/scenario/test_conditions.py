"""Warnings about conditions that the scenario's controller is not made for."""

from __future__ import annotations

import pytest

from testbed.scenario.conditions import warnings
from testbed.scenario.load import load_scenario

PAPER = "scenarios/left_tail_fail.yaml"
NOISY, TURBULENT = "sensors=mems", "atmosphere.turbulence_w20_m_s=7.62"
GUST = "atmosphere.gusts=[{at_s: 5, magnitude_m_s: [0, 2, 0], length_m: 20}]"


@pytest.mark.parametrize(
    ("settings", "found"),
    [
        ((NOISY,), "has sensors with errors:"),
        ((TURBULENT,), "has turbulence:"),
        ((NOISY, TURBULENT), "has sensors with errors and turbulence:"),
        ((GUST,), "has gusts:"),
    ],
    ids=["sensors", "turbulence", "both", "gust"],
)
def test_the_papers_law_outside_its_conditions(settings: tuple[str, ...], found: str) -> None:
    (warning,) = warnings(load_scenario(PAPER, settings))
    assert found in warning and "preset: paper" in warning


@pytest.mark.parametrize(
    "settings",
    [
        (),
        ("atmosphere.wind_m_s=[3, 0, 0]",),
        (NOISY, TURBULENT, "controller.preset=default"),
        (NOISY, TURBULENT, "controller.type=pid"),
    ],
    ids=["calm", "steady wind", "default law", "another controller"],
)
def test_nothing_to_say(settings: tuple[str, ...]) -> None:
    assert warnings(load_scenario(PAPER, settings)) == []


def test_noise_without_turbulence_has_no_effect() -> None:
    settings = ["controller={type: adaptive_inversion}", "atmosphere={model: dryden_8785c, noise: {w: [1]}}"]
    (warning,) = warnings(load_scenario(PAPER, settings))
    assert "atmosphere.noise has no effect" in warning
    assert not warnings(load_scenario(PAPER, [*settings, TURBULENT]))
