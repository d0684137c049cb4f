"""The page that figures are drawn on."""

from __future__ import annotations

import numpy as np
import pytest
from figure_flights import EVENTS, broken, panels
from handmade import flight_of, level_log

from testbed.flight.flight import Outcome
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.figures import plot
from testbed.reporting.figures.signals import thin


def test_title_says_how_it_ended() -> None:
    figure = plot(broken(5.0, Outcome.ground_contact), "states")
    words = " ".join(text.get_text() for text in figure.texts)
    for part in ("handmade", "adaptive_inversion", "hit the ground", "5 s", "not passed"):
        assert part in words


def test_thinning_keeps_every_peak() -> None:
    time = np.arange(12000) / 200.0
    values = np.sin(time)
    values[7777], values[3333] = 9.0, -9.0
    thinned, shown = thin(time, values)
    assert len(shown) < 4000
    assert (shown.max(), shown.min()) == (9.0, -9.0)
    assert (thinned[0], thinned[-1]) == (time[0], time[-1])
    assert np.all(np.diff(thinned) > 0)


@pytest.mark.parametrize("name", FIGURES)
def test_a_long_flight_is_drawn_with_as_many_points_as_can_be_seen(name: str) -> None:
    """What drawing costs: 24 000 rows of noise become a few thousand points a line."""
    log = level_log(240.0)
    for column in list(log)[1:]:
        log[column] = log[column] + 0.01 * np.sin(np.arange(24000.0))
    for axes in panels(plot(flight_of(log, EVENTS), name)):
        assert all(len(line.get_xdata()) < 5000 for line in axes.lines)
