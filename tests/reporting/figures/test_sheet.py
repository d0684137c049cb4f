"""The page that figures are drawn on."""

from __future__ import annotations

from figure_flights import broken

from testbed.flight.flight import Outcome
from testbed.reporting.figures import plot


def test_title_says_how_it_ended() -> None:
    figure = plot(broken(5.0, Outcome.ground_contact), "states")
    words = " ".join(text.get_text() for text in figure.texts)
    for part in ("handmade", "adaptive_inversion", "hit the ground", "5 s", "not passed"):
        assert part in words
