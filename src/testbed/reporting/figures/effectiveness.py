"""The paper's figure 6: effectiveness estimates and true effectiveness."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from testbed.flight.flight import Flight
from testbed.reporting.figures.page import REFERENCE, TRUTH, page
from testbed.reporting.story import has_estimates


def effectiveness(flight: Flight) -> Figure:
    """True and estimated effectiveness of each actuator over time, the monitor's threshold, and its flag.

    A controller that estimates nothing has no estimate here, although its log has a column of ones.
    """
    sheet = page(flight, "effectiveness of the actuators, 1 is healthy", [1.5] * len(flight.actuators))
    estimates = {n: sheet.column(n) for n in flight.columns if n.endswith("_effectiveness_estimate")}
    estimated = has_estimates(estimates, flight.actuators)
    own = flight.flown_by or not estimated
    threshold = None if own else flight.scenario.controller.model_dump().get("threshold")
    for panel, name in zip(sheet.panels, flight.actuators, strict=True):
        truth = sheet.column(f"{name}_effectiveness")
        estimate = estimates[f"{name}_effectiveness_estimate"] if estimated else truth
        sheet.line(panel, truth, "truth", TRUTH)
        if estimated:
            sheet.line(panel, estimate, "estimate", {**REFERENCE, "linewidth": 1.8})
        if threshold is not None:
            sheet.level(panel, threshold, f"threshold {threshold:g}")
        sheet.shade(panel, sheet.column(f"{name}_failed"), "flagged failed")
        sheet.frame(panel, 1.2, truth, estimate, np.array([0.0, 1.0]))
        panel.set_ylabel(f"{name.replace('_', chr(10))}\n[-]", fontsize=9.5)
    return sheet.finish()
