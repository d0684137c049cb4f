"""What is drawn together: each panel is declared once here, and drawn by figures, by the page of a flight, and by a comparison.

To show another signal, add a line to TRACKED or STATES, or a panel to a function of GROUPS.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from testbed.common.units import unit as unit_of
from testbed.flight.breakage import failures_of, response, signs, tracking_error
from testbed.flight.columns import stuck_column
from testbed.flight.flight import Flight
from testbed.reporting.words import believed, title


class Tracked(NamedTuple):
    """A quantity that follows a reference: its column, its reference's and its error's, and how they are drawn.

    An axis shows at least `least` of it and `least_error` of its error. Where all flights of a sweep are in one panel, the axis of
    the error is linear up to `linear`, and logarithmic beyond.
    """

    flown: str
    reference: str
    error: str
    least: float
    least_error: float
    linear: float


TRACKED = {
    "altitude": Tracked("altitude_m", "altitude_command_m", "altitude_error_m", 1.0, 0.2, 1.0),
    "airspeed": Tracked("airspeed_m_s", "airspeed_command_m_s", "airspeed_error_m_s", 1.0, 0.2, 1.0),
    "heading": Tracked("heading_deg", "heading_command_deg", "heading_error_deg", 4.0, 0.5, 3.0),
}
STATES = {"roll_deg": "bank", "pitch_deg": "pitch", "alpha_deg": "angle of attack", "beta_deg": "sideslip"}
"""Other states that are drawn, and their titles."""
_LEAST_STATE = 2.0
_LEAST_RATE = {"deg_s2": 4.0, "m_s2": 0.4}
_WIND = {"wind_north_m_s": "truth", "wind_east_m_s": "second", "wind_down_m_s": "third"}
_STUCK = "sensor taken for stuck"


class Series(NamedTuple):
    """A column of the log in a panel. `style` is one of `figures.lines.STYLES`, and a colour of the page's style sheet.

    Of a series with `spikes` the axis need not hold all. One that is not `on_page` is only in the figures.
    """

    column: str
    label: str
    style: str
    spikes: bool = False
    on_page: bool = True


@dataclass(frozen=True)
class Panel:
    """Series over one axis, which shows at least `least`, and all of `span` if there is one.

    `levels` are {value: label} of lines, drawn where the series come near them. `flag` is a column: the times at which it is
    set are shaded, and named `flagged`.
    """

    title: str
    unit: str
    series: tuple[Series, ...]
    least: float
    levels: Mapping[float, str] | None = None
    span: tuple[float, float] | None = None
    flag: str = ""
    flagged: str = ""
    notes: tuple[tuple[float, float, str], ...] = ()
    """(from [s], until [s], words) of stretches, written where they begin."""
    most: float = math.inf
    """Values beyond it do not set the axis."""

    @property
    def heading(self) -> str:
        return f"{self.title} [{self.unit}]"


def has_estimates(log: Mapping[str, np.ndarray], actuators: Iterable[str]) -> bool:
    """Whether the controller estimated effectiveness: some estimate was not 1 all the time.

    A controller without estimates has NaN, or exactly 1 in older logs; in calm air those of an estimator differ from 1 by 1e-5 or
    less.
    """
    columns = (log.get(f"{name}_effectiveness_estimate") for name in actuators)
    return any(c is not None and bool(np.any(np.abs(c - 1.0) > 0.0)) for c in columns)


def shown_log(flight: Flight) -> dict[str, np.ndarray]:
    """The log by columns [rows], with those that reports add: errors, and what each actuator does for its command."""
    log, active = dict(flight.signals), failures_of(flight.events)
    for name in _answering(flight):
        log[response_of(name)] = response(log, name, active, flight.scenario.failures)
    return log | error_columns(log)


def error_columns(log: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The error of each quantity that follows a reference."""
    return {of.error: tracking_error(log, q) for q, of in TRACKED.items() if of.reference in log}


def _answering(flight: Flight) -> list[str]:
    """The actuators of which the log says how much effect they have."""
    return [name for name in flight.actuators if f"{name}_effectiveness" in flight.columns]


def response_of(actuator: str) -> str:
    """Name of the column of what an actuator truly does for its command."""
    return f"{actuator}_response"


def tracked(flight: Flight) -> Iterator[Panel]:
    """Each quantity with its reference."""
    for quantity, drawn in TRACKED.items():
        series = (Series(drawn.reference, "reference", "reference"), Series(drawn.flown, "flown", "truth"))
        flag = _stuck(flight, quantity)
        yield Panel(quantity, unit_of(drawn.flown), series, drawn.least, flag=flag, flagged=_STUCK)


def errors(flight: Flight) -> Iterator[Panel]:
    """Each quantity minus its reference."""
    return map(error_panel, TRACKED)


def error_panel(quantity: str) -> Panel:
    """A quantity minus its reference."""
    of = TRACKED[quantity]
    series = (Series(of.error, "error", "truth"),)
    return Panel(f"{quantity} minus reference", unit_of(of.error), series, of.least_error)


def states(flight: Flight) -> Iterator[Panel]:
    """Attitude and the angles of the air."""
    for column, name in STATES.items():
        series, flag = (Series(column, "flown", "truth"),), _stuck(flight, column.removesuffix("_deg"))
        yield Panel(name, unit_of(column), series, _LEAST_STATE, flag=flag, flagged=_STUCK)


def _stuck(flight: Flight, sensor: str) -> str:
    """The column that says when the controller took a sensor for stuck; empty if the log has none."""
    column = stuck_column(sensor)
    return column if column in flight.columns else ""


def air(flight: Flight) -> Iterator[Panel]:
    """The wind, where the air moves."""
    series = [Series(c, c.split("_")[1], style) for c, style in _WIND.items() if c in flight.columns]
    if series:
        yield Panel("wind over the ground", unit_of(series[0].column), tuple(series), 1.0)


def effectiveness(flight: Flight) -> Iterator[Panel]:
    """Of each actuator, true and as the controller believes it, with the threshold of its monitor."""
    estimated = has_estimates(flight.signals, flight.actuators)
    own = flight.flown_by or not estimated
    chosen = {} if own else flight.scenario.controller.model_dump()
    usual, of_engine = chosen.get("threshold"), chosen.get("propeller_threshold")
    thresholds = {
        name: usual if actuator["kind"] == "servo" or of_engine is None else of_engine
        for name, actuator in flight.actuators.items()
    }
    known = dict.fromkeys(f"{value:g}" for value in thresholds.values() if value is not None)
    label = f"threshold {' / '.join(known)}"  # one for all panels, whose lines look alike
    for name, threshold in thresholds.items():
        series = [Series(response_of(name), "true", "truth")]
        if estimated:
            series.append(Series(f"{name}_effectiveness_estimate", "believed", "belief"))
        yield Panel(
            title(name), "-", tuple(series), 1.2, {} if threshold is None else {threshold: label},
            (0.0, 1.0), f"{name}_failed", "flagged failed", (*_held(flight, name), *_taken_for(flight, name)),
        )  # fmt: skip


def _held(flight: Flight, actuator: str) -> Iterator[tuple[float, float, str]]:
    """When an actuator does not follow its command, so that there is no line of what it does for it."""
    for failure in failures_of(flight.events):
        if failure.actuator == actuator and math.isnan(flight.scenario.failures[failure.number].response):
            yield failure.from_s, failure.until_s, "does not follow its command"


def _taken_for(flight: Flight, actuator: str) -> Iterator[tuple[float, float, str]]:
    """What the controller took an actuator for, where not for one that works, and when; to the end of the flight is without end."""
    end_s = float(flight.signals["time_s"][-1])
    for belief in signs(flight.signals, [actuator]):
        until_s = belief["until_s"] if belief["until_s"] < end_s else math.inf
        yield belief["time_s"], until_s, f"believed {believed(belief, flight.actuators)}"


def actuators(flight: Flight) -> Iterator[Panel]:
    """Position, command and reference of each actuator in its own unit, with its stops."""
    for name, facts in flight.actuators.items():
        series = (
            Series(f"{name}_position", "position", "position"),
            Series(f"{name}_command", "command u", "command"),
            Series(f"{name}_reference", "reference r", "reference", on_page=False),
        )
        yield Panel(
            title(name), str(facts.get("unit", "")), series, 0.5 * float(facts.get("scale", 1.0)),
            dict.fromkeys(facts.get("limits", ()), "stop"), None, f"{name}_failed", "flagged failed",
        )  # fmt: skip


def rates(flight: Flight) -> Iterator[Panel]:
    """The controlled rates, measured and desired; hatched where an axis is given up."""
    for flag in (name for name in flight.columns if name.endswith("_released")):
        axis = flag.removesuffix("_released")
        ending = next((ending for ending in _LEAST_RATE if f"{axis}_{ending}" in flight.columns), "deg_s2")
        measured = Series(f"{axis}_{ending}", "measured", "truth")
        desired = Series(f"{axis}_desired_{ending}", "desired", "reference", spikes=True)
        asked = desired.column in flight.columns and not np.isnan(flight.column(desired.column)).all()
        series = (measured, desired) if asked else (measured,)
        unit = unit_of(measured.column)
        yield Panel(axis, unit, series, _LEAST_RATE[ending], None, None, flag, "axis released")


class Group(NamedTuple):
    """Panels that stand together, made by `panels`; a `folded` group is opened by a click."""

    title: str
    panels: Collection[Callable[[Flight], Iterable[Panel]]]
    folded: bool = False

    def of(self, flight: Flight) -> list[Panel]:
        """The group's panels of a flight, those whose series its log has."""
        made = [panel for function in self.panels for panel in function(flight)]
        known = {
            *flight.columns,
            *(of.error for of in TRACKED.values()),
            *map(response_of, _answering(flight)),
        }
        return [panel for panel in made if all(series.column in known for series in panel.series)]


OWN: dict[str, Callable[[Flight], Iterable[Panel]]] = {}
"""Panels of the user's own, by name."""

GROUPS = {
    "errors": Group("Errors against the references", (errors,)),
    "effectiveness": Group("Effectiveness, true and believed", (effectiveness,)),
    "actuators": Group("Actuators", (actuators,)),
    "attitude": Group("Attitude and air", (states, air)),
    "rates": Group("Controlled rates", (rates,), folded=True),
    "own": Group("Panels of your own", OWN.values()),
    "states": Group("States against their references", (tracked, states)),
}
"""By the name of the group. Figures and pages say which of them they draw."""
