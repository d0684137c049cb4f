"""Conditions that a controller is not made for: no mistake in the scenario, but a reason to doubt what the flight shows."""

from __future__ import annotations

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.scenario.model import Scenario


def warnings(scenario: Scenario) -> list[str]:
    """Sentences about conditions in which the scenario's controller is not expected to hold the aircraft."""
    return [*_without_effect(scenario), *_for_the_controller(scenario)]


def _without_effect(scenario: Scenario) -> list[str]:
    air = scenario.atmosphere
    if air.noise is None or air.turbulence_w20_m_s:
        return []
    return ["atmosphere.noise has no effect: there is no turbulence, and turbulence_w20_m_s is 0"]


def _for_the_controller(scenario: Scenario) -> list[str]:
    found = _unsuited(scenario)
    controller = scenario.controller
    if (
        not found
        or not isinstance(controller, AdaptiveInversionSettings)
        or controller.estimation != "newton"
    ):
        return []
    return [
        f"the paper's law (controller.preset: paper) is for calm air and ideal sensors, and this scenario has {found}: "
        "expect false alarms and a lost heading. {type: adaptive_inversion} without a preset is for these conditions"
    ]


def _unsuited(scenario: Scenario) -> str:
    """What of the scenario the paper's law is not for, in words; empty for calm air and ideal sensors."""
    air, found = scenario.atmosphere, []
    if not scenario.sensors.is_ideal:
        found.append("sensors with errors")
    if air.most_w20_m_s or air.gusts:
        found.append("turbulence" if air.most_w20_m_s else "gusts")
    return " and ".join(found)
