"""Figure 5."""

from __future__ import annotations

from figure_flights import panels
from handmade import flight_of, level_log

from testbed.reporting.figures import plot


def test_a_reference_far_beyond_the_stops_does_not_flatten_the_rest() -> None:
    log = level_log()
    log["elevon_reference"][500] = 4000.0
    axes = panels(plot(flight_of(log), "actuators"))[0]
    assert axes.get_ylim()[1] < 40.0
