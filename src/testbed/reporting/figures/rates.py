"""Controlled rates, desired against measured; an axis that is given up is hatched."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from testbed.flight.flight import Flight
from testbed.reporting.figures.page import REFERENCE, TRUTH, page

_UNITS = (("_deg_s2", "deg/s²", 4.0), ("_m_s2", "m/s²", 0.4))


def rates(flight: Flight) -> Figure:
    """Each controlled rate over time, desired and measured."""
    axes = [name.removesuffix("_released") for name in flight.columns if name.endswith("_released")]
    sheet = page(flight, "controlled rates", [1.7] * len(axes))
    for panel, axis in zip(sheet.panels, axes, strict=True):
        suffix, unit, least = next(u for u in _UNITS if f"{axis}{u[0]}" in flight.columns)
        measured, desired = sheet.column(f"{axis}{suffix}"), sheet.column(f"{axis}_desired{suffix}")
        sheet.line(panel, measured, "measured", TRUTH)
        sheet.line(panel, desired, "desired", REFERENCE)
        sheet.shade(panel, sheet.column(f"{axis}_released"), "axis released")
        # A few spikes of the desired rate may be cut off.
        sheet.frame(panel, least, measured, np.nanpercentile(desired, [0.5, 99.5]))
        panel.set_ylabel(f"{axis} [{unit}]", fontsize=9.5)
    return sheet.finish()
