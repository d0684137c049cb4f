"""The zoom beside the flight: around the first failure and its flag, and only where it shows more than the flight does."""

from __future__ import annotations

import pytest
from figure_flights import EVENTS, broken, panels, zooms
from handmade import flight_of, injection, level_log

from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.figures import plot
from testbed.reporting.figures.lines import zoom_span


@pytest.mark.parametrize(
    ("events", "end_s", "span"),
    [
        ([], 60.0, None),
        ([injection(15.0)], 60.0, (14.5, 17.5)),
        ([injection(15.0), {"time_s": 16.0, "kind": "detection"}], 60.0, (14.5, 18.5)),
        ([injection(15.0), {"time_s": 40.0, "kind": "detection"}], 60.0, (14.5, 17.5)),
        ([injection(0.2)], 60.0, (0.0, 2.7)),
        ([injection(59.0)], 60.0, (58.5, 60.0)),
        ([injection(2.0)], 5.0, None),
    ],
)
def test_it_spans_the_failure_and_its_flag(
    events: list[dict[str, object]], end_s: float, span: tuple[float, float] | None
) -> None:
    assert zoom_span(events, end_s) == (None if span is None else pytest.approx(span))


@pytest.mark.parametrize("name", FIGURES)
def test_every_panel_has_one_with_the_failure_and_the_flag_apart(name: str) -> None:
    figure = plot(broken(), name)
    assert len(zooms(figure)) == len(panels(figure))
    for zoom in zooms(figure):
        upright = {line.get_xdata()[0] for line in zoom.lines if len(set(line.get_xdata())) == 1}
        assert {3.0, 3.4} <= upright and 6.0 not in upright
        inches = zoom.get_position().width * figure.get_figwidth()
        first, last = zoom.get_xlim()
        assert 0.4 / (last - first) * inches > 0.2, "apart by more than a marker"


def test_its_height_is_of_what_it_shows() -> None:
    log = level_log()
    log["altitude_m"][900:] = 150.0
    figure = plot(flight_of(log, EVENTS), "states")
    assert panels(figure)[0].get_ylim()[1] > 150.0
    assert zooms(figure)[0].get_ylim()[1] < 102.0


def test_a_flight_without_a_failure_has_none() -> None:
    assert not zooms(plot(flight_of(level_log()), "states"))
