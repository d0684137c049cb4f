"""A flight with something of everything that figures show."""

from __future__ import annotations

import numpy as np
from handmade import flight_of, injection, level_log
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.flight.flight import Flight, Outcome

EVENTS = [
    injection(3.0),
    {"time_s": 3.4, "kind": "detection", "actuator": "elevon", "delay_s": 0.4},
    {"time_s": 3.4, "kind": "release", "axis": "p_dot"},
    {"time_s": 6.0, "kind": "false_alarm", "actuator": "fan"},
]


def broken(seconds: float = 10.0, outcome: Outcome = Outcome.completed) -> Flight:
    """A handmade flight in which an actuator is lost, flagged, and an axis released."""
    log = level_log(seconds)
    log["elevon_effectiveness"][300:] = 0.0
    log["elevon_failed"][340:] = 1.0
    log["p_dot_released"][340:] = 1.0
    log["altitude_m"] += np.sin(log["time_s"])
    return flight_of(log, [event for event in EVENTS if event["time_s"] < seconds], outcome)


def panels(figure: Figure) -> list[Axes]:
    """Axes of a figure but those that name events, or zoom."""
    return [axes for axes in figure.axes if axes.get_label() not in ("events", "zoom")]


def zooms(figure: Figure) -> list[Axes]:
    """Axes that zoom into the time around the failure."""
    return [axes for axes in figure.axes if axes.get_label() == "zoom"]
