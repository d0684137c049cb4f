"""Signals as they are drawn: dense ones as a band of their extremes, all others as lines."""

from __future__ import annotations

import numpy as np
from figure_flights import EVENTS, panels
from handmade import flight_of, level_log

from testbed.reporting.figures import plot
from testbed.reporting.figures.lines import band

TIME = np.arange(12000) / 200.0
NOISE = np.random.default_rng(1).standard_normal(12000)


def test_noise_becomes_a_band_that_holds_every_value() -> None:
    values = NOISE.copy()
    values[5000], values[7000] = 30.0, -20.0
    found = band(TIME, values, 60.0, 180)
    assert found is not None
    middle, low, high, mean = found
    assert len(middle) < 200 and (high.max(), low.min()) == (30.0, -20.0)
    assert np.abs(mean).max() < 2.0


def test_what_can_be_read_as_a_line_stays_one() -> None:
    for values in (np.sin(TIME), TIME, np.zeros(12000), np.where(TIME > 30.0, 1.0, 0.0)):
        assert band(TIME, values, 60.0, 180) is None
    assert band(TIME[:500], NOISE[:500], 2.5, 180) is None, "each part has too few rows"
    broken = NOISE.copy()
    broken[3] = np.nan
    assert band(TIME, broken, 60.0, 180) is None


def test_a_dense_rate_is_drawn_as_a_band() -> None:
    log = level_log(60.0)
    log["p_dot_deg_s2"] = 50.0 * NOISE[:6000]
    shown = panels(plot(flight_of(log, EVENTS), "rates"))
    bands = [[c for c in axes.collections if c.get_label() == "extremes"] for axes in shown]
    assert len(bands[0]) == 1 and not bands[1]
