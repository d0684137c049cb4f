"""Figure 6: an estimate is drawn where the controller makes one."""

from __future__ import annotations

from figure_flights import broken, panels
from handmade import flight_of, level_log

from testbed.reporting.figures import plot


def _labels(flight: object) -> set[str]:
    return {line.get_label() for axes in panels(plot(flight, "effectiveness")) for line in axes.lines}


def test_a_controller_that_estimates_nothing_has_no_estimate() -> None:
    assert "believed" not in _labels(broken())


def test_an_estimate_is_drawn_with_its_threshold() -> None:
    log = level_log()
    log["elevon_effectiveness_estimate"][400:] = 0.5
    labels = _labels(flight_of(log))
    assert "believed" in labels and any(label.startswith("threshold") for label in labels)
