"""Figure 4."""

from __future__ import annotations

import numpy as np
from figure_flights import panels
from handmade import flight_of, level_log

from testbed.reporting.figures import TABLE as FIGURES


def test_heading_is_drawn_beside_its_reference_through_north() -> None:
    """A turn from 350 over 360 to 10 degrees, half a degree behind its reference: no jump, no full turn between them."""
    log = level_log()
    log["heading_command_deg"] = np.mod(350.0 + 2.0 * log["time_s"], 360.0)
    log["heading_deg"] = np.mod(log["heading_command_deg"] - 0.5, 360.0)
    heading = panels(FIGURES["states"][1](flight_of(log)))[2]
    reference, flown = (line.get_ydata() for line in heading.lines[-2:])
    np.testing.assert_allclose(flown, reference - 0.5, atol=1e-9)
    assert np.abs(np.diff(flown)).max() < 1.0
