"""Marks of events: no two labels touch, and many events do not bury the figure."""

from __future__ import annotations

from handmade import flight_of, injection, level_log

from testbed.reporting.figures.lines import LOOKS, label_rows, marks
from testbed.reporting.words import describe

FLIGHT = flight_of(level_log())


def test_labels_do_not_overlap() -> None:
    crowd = marks([injection(t) for t in (1.0, 1.1, 1.2, 9.0, 9.9)], FLIGHT)
    placed = label_rows(crowd, (0.0, 10.0), 8.0)
    assert len({row for _, row, _ in placed[:3]}) == 3
    assert placed[-1][2] == "right"  # has no room to the right


def test_chatter_does_not_bury_the_figure() -> None:
    chatter = [{"time_s": 0.02 * k, "kind": "release", "axis": "p_dot"} for k in range(400)]
    labels = [mark.label for mark in marks(chatter, FLIGHT) if mark.label]
    assert len(labels) < 15 and labels[-1] == "and 388 more events"


def test_failures_are_told_in_words_with_their_values() -> None:
    assert describe(injection(2.0), FLIGHT) == "elevon was lost completely"
    seen = injection(2.0, verified=False, effect={"quantity": "effective_deg"})
    assert describe(seen, FLIGHT) == "elevon was lost completely (HAD NO EFFECT)"
    not_kept = describe(seen | {"effect": None}, FLIGHT)
    assert not_kept == "elevon was lost completely (DID NOT STAY AS WRITTEN)"
    assert describe(injection(4.0, active=False), FLIGHT) == "elevon: effectiveness ends"


def test_kinds_have_looks_of_their_own() -> None:
    assert len({marker for _, marker in LOOKS.values()}) == len(LOOKS)


def test_a_recovery_is_marked_unless_nothing_was_ever_left() -> None:
    recovered = {"time_s": 5.0, "kind": "recovered", "after_s": 3.0}
    assert [mark.label for mark in marks([recovered, {**recovered, "after_s": 0.0}], FLIGHT)] == [
        "recovered 3.0 s after the failure"
    ]
    assert describe({**recovered, "after_s": 0.0}, FLIGHT) == "held within 5 m and 15 deg"
