"""The paper's figure 4: the aircraft's states and their references."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from testbed.common.angles import wrap_deg
from testbed.flight.flight import Flight
from testbed.reporting.figures.page import REFERENCE, TRUTH, frame, page

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
        frame(panel, least, *signals)
        panel.set_ylabel(label, fontsize=9.5)
    return sheet.finish()
