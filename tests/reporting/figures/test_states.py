"""Figure 4."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from figure_flights import panels
from handmade import flight_of, level_log

from testbed.reporting.figures import plot
from testbed.scenario.requirement import Requirement


def test_heading_is_drawn_beside_its_reference_through_north() -> None:
    """A turn from 350 over 360 to 10 degrees, half a degree behind its reference: no jump, no full turn between them."""
    log = level_log()
    log["heading_command_deg"] = np.mod(350.0 + 2.0 * log["time_s"], 360.0)
    log["heading_deg"] = np.mod(log["heading_command_deg"] - 0.5, 360.0)
    heading = panels(plot(flight_of(log), "states"))[2]
    reference, flown = (line.get_ydata() for line in heading.lines[-2:])
    np.testing.assert_allclose(flown, reference - 0.5, atol=1e-9)
    assert np.abs(np.diff(flown)).max() < 1.0


def test_what_the_requirements_allow_is_drawn() -> None:
    """A band around a reference in its window, and a limit of a signal over the whole flight."""
    flight = flight_of(level_log())
    allowed = (
        Requirement(signal="altitude_m", within=2.0, of="altitude_command_m", from_s=3.0, until_s=8.0),
        Requirement(signal="beta_deg", at_most=5.0),
    )
    flight = replace(flight, scenario=flight.scenario.model_copy(update={"requirements": allowed}))
    shown = panels(plot(flight, "states"))
    low, high = (line for line in shown[0].lines if line.get_label() == "requirement")
    time, values = (np.asarray(data) for data in high.get_data())
    inside = np.isfinite(values)
    assert (time[inside].min(), time[inside].max()) == (3.0, 8.0)
    assert set(values[inside]) == {102.0} and set(np.asarray(low.get_ydata())[inside]) == {98.0}
    (limit,) = (line for line in shown[6].lines if line.get_label() == "requirement")
    assert list(limit.get_ydata()) == [5.0, 5.0]
    assert not [line for line in shown[1].lines if line.get_label() == "requirement"]
