"""Conditions that a controller is not made for: no mistake in the scenario, but a reason to doubt what the flight shows."""

from __future__ import annotations

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.scenario.model import Scenario


def warnings(scenario: Scenario) -> list[str]:
    """Sentences about conditions in which the scenario's controller is not expected to hold the aircraft."""
    air, controller = scenario.atmosphere, scenario.controller
    found, unsuited = [], []
    if air.noise is not None and not air.turbulence_w20_m_s:
        found.append("atmosphere.noise has no effect: there is no turbulence, and turbulence_w20_m_s is 0")
    if not scenario.sensors.is_ideal:
        unsuited.append("sensors with errors")
    if air.most_w20_m_s or air.gusts:
        unsuited.append("turbulence" if air.most_w20_m_s else "gusts")
    is_papers = isinstance(controller, AdaptiveInversionSettings) and controller.estimation == "newton"
    if unsuited and is_papers:
        found.append(
            f"the paper's law (controller.preset: paper) is for calm air and ideal sensors, and this scenario has "
            f"{' and '.join(unsuited)}: expect false alarms and a lost heading. "
            "{type: adaptive_inversion} without a preset is for these conditions"
        )
    return found
