"""The paper's figure 6: effectiveness estimates and true effectiveness."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from testbed.flight.flight import Flight
from testbed.reporting.figures.page import LIMIT, REFERENCE, TRUTH, frame, page


def effectiveness(flight: Flight) -> Figure:
    """True and estimated effectiveness of each actuator over time, the monitor's threshold, and its flag."""
    sheet = page(flight, "effectiveness of the actuators, 1 is healthy", [1.5] * len(flight.actuators))
    threshold = None if flight.flown_by else flight.scenario.controller.model_dump().get("threshold")
    for panel, name in zip(sheet.panels, flight.actuators, strict=True):
        truth = sheet.column(f"{name}_effectiveness")
        estimate = sheet.column(f"{name}_effectiveness_estimate")
        sheet.line(panel, truth, "truth", TRUTH)
        sheet.line(panel, estimate, "estimate", {**REFERENCE, "linewidth": 1.8})
        if threshold is not None:
            panel.axhline(threshold, label=f"threshold {threshold:g}", **LIMIT)
        sheet.shade(panel, sheet.column(f"{name}_failed"), "flagged failed")
        frame(panel, 1.2, truth, estimate, np.array([0.0, 1.0]))
        panel.set_ylabel(f"{name.replace('_', chr(10))}\n[-]", fontsize=9.5)
    return sheet.finish()
