"""Figures of a finished flight. To add one, write a function of a flight in a file here, and add a line to TABLE."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.flight.flight import Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def _states(flight: Flight) -> Figure:
    from testbed.reporting.figures.states import states

    return states(flight)


def _actuators(flight: Flight) -> Figure:
    from testbed.reporting.figures.actuators import actuators

    return actuators(flight)


def _effectiveness(flight: Flight) -> Figure:
    from testbed.reporting.figures.effectiveness import effectiveness

    return effectiveness(flight)


def _rates(flight: Flight) -> Figure:
    from testbed.reporting.figures.rates import rates

    return rates(flight)


TABLE: dict[str, tuple[str, Callable[[Flight], Figure]]] = {
    "states": ("States against their references (the paper's figure 4)", _states),
    "actuators": ("Reference, command and position of each actuator (figure 5)", _actuators),
    "effectiveness": ("Effectiveness: estimates against truth (figure 6)", _effectiveness),
    "rates": ("Controlled rates: desired against measured", _rates),
}
"""File name without its ending: (caption, function that draws). matplotlib is imported only when a figure is drawn."""


def draw(flight: Flight, folder: str | Path) -> list[Path]:
    """Write `folder/figures/<name>.png` for each of TABLE; returns the files in that order."""
    from testbed.reporting.figures.page import plain_text, save

    figures = Path(folder) / "figures"
    figures.mkdir(parents=True, exist_ok=True)
    with plain_text():
        return [save(make(flight), figures / f"{name}.png") for name, (_, make) in TABLE.items()]
