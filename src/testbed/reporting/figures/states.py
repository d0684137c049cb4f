"""The paper's figure 4: the aircraft's states and their references."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.common.angles import wrap_deg
from testbed.flight.flight import Flight
from testbed.reporting.figures.page import LIMIT, REFERENCE, TRUTH, Page, page

_PANELS = (
    # label, column, reference, least height of the y axis
    ("altitude [m]", "altitude_m", "altitude_command_m", 1.0),
    ("airspeed [m/s]", "airspeed_m_s", "airspeed_command_m_s", 1.0),
    ("heading [deg]", "heading_deg", "heading_command_deg", 4.0),
    ("roll [deg]", "roll_deg", None, 4.0),
    ("pitch [deg]", "pitch_deg", None, 4.0),
    ("alpha [deg]", "alpha_deg", None, 4.0),
    ("beta [deg]", "beta_deg", None, 4.0),
)


def states(flight: Flight) -> Figure:
    """Altitude, airspeed, heading, roll, pitch, alpha and beta over time, with the references that exist."""
    sheet = page(flight, "aircraft states", [1.25] * len(_PANELS))
    for panel, (label, name, reference, least) in zip(sheet.panels, _PANELS, strict=True):
        values = sheet.column(name)
        signals = [values]
        if reference is not None:
            wanted = sheet.column(reference)
            if name == "heading_deg":
                wanted = np.unwrap(wanted, period=360.0)
                values = wanted + wrap_deg(values - wanted)  # on the same turn as the reference
            sheet.line(panel, wanted, "reference", REFERENCE)
            signals = [values, wanted]
        sheet.line(panel, values, "flown", TRUTH, wraps=name in ("roll_deg", "heading_deg"))
        sheet.frame(panel, least, *signals, *_limits(sheet, panel, name, reference))
        panel.set_ylabel(label, fontsize=9.5)
    return sheet.finish()


def _limits(sheet: Page, panel: Axes, name: str, reference: str | None) -> Iterator[np.ndarray]:
    """Draw what the requirements allow this signal, and give the values that the axis is to hold as well."""
    for requirement in sheet.flight.scenario.requirements:
        if requirement.signal != name:
            continue
        since, until = requirement.begins_s, requirement.until_s or math.inf
        for limit in (requirement.at_most, requirement.at_least):
            if limit is not None:
                sheet.level(panel, limit, "requirement", since, until)
                yield np.array([limit])
        if requirement.within is not None and requirement.of == reference and reference is not None:
            yield from _around(sheet, panel, reference, requirement.within, (since, until))


def _around(
    sheet: Page, panel: Axes, reference: str, within: float, window: tuple[float, float]
) -> Iterator[np.ndarray]:
    """Draw the band around a reference in a window of time [s]."""
    wanted = sheet.column(reference)
    wanted = np.unwrap(wanted, period=360.0) if reference.startswith("heading") else wanted
    inside = (sheet.time_s >= window[0]) & (sheet.time_s <= window[1])
    for sign in (-1.0, 1.0):
        limit = np.where(inside, wanted + sign * within, math.nan)
        sheet.line(panel, limit, "requirement", LIMIT)
        yield limit
