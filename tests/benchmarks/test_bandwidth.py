"""The campaign on bandwidth: what it predicts on the ideal plant, what it counts as held, what it says."""

from __future__ import annotations

import math

import pytest
from bandwidth_ideal import bisected, ideal_extreme, ideal_reading, limits
from bandwidth_limits import held, last_held
from bandwidth_page import Row, page, relative
from section4_bandwidth import MOVING, flights

from paper import bandwidth
from testbed.inputs.yaml_source import parse
from testbed.studies.drawing.builder import Builder, Task, Variant


def record(
    altitude: float = 1.0, heading: float = 1.0, outcome: str = "completed", alarms: int = 0
) -> dict[str, object]:
    metrics = {"altitude_error_max_m": altitude, "heading_error_max_deg": heading, "false_alarms": alarms}
    return {"outcome": outcome, "metrics": metrics}


def test_every_flight_is_a_valid_scenario() -> None:
    from bandwidth_limits import BASE

    builder = Builder(parse(BASE, "campaign"), (Variant("", {}),))
    planned = list(flights())
    for number, values in enumerate(planned):
        assert builder.scenario(Task(number, 0, 1, values)).controller.type == "adaptive_inversion"
    assert len(planned) > 30


def test_the_ideal_plant_reads_what_is_predicted() -> None:
    lag, _ = MOVING[-1]
    predicted = bandwidth.offset_reading_within(bandwidth.lag(4.0, 1.0 / lag), 1.5)
    assert ideal_reading(lag, 0.0, 1.5) == pytest.approx(predicted, rel=0.01)
    assert ideal_extreme(8.0, 10.0) == pytest.approx(bandwidth.extreme(1.0, 0.2, 0.8), rel=0.01)
    known = dict((what.split(":")[0], (predicted, found)) for what, predicted, found in limits())
    assert len(known) == 10
    for predicted, found in known.values():
        assert found == pytest.approx(predicted, rel=0.01)


def test_the_last_value_before_the_first_loss_counts() -> None:
    """Negative controls: lost, too far off, and a false alarm each end the row, and what holds again later does not count."""
    good = record()
    assert last_held((1.0, 2.0, 3.0), [good, record(outcome="diverged"), good]) == 1.0
    assert math.isnan(last_held((1.0,), [record(altitude=5.1)]))
    assert [held(r) for r in (good, record(heading=15.1), record(alarms=1))] == [True, False, False]


def test_the_page_has_the_errors() -> None:
    row = Row("a condition", 0.1, 0.8, 0.808, 0.79, 0.84)
    text = page(
        {name: [row] for name in ("moving", "limited", "sampled", "lag", "late", "mixed", "stops")},
        [("b", -1.0, -1.1)],
        {"law": (math.nan, 4.0, 0.05)},
    )
    assert "| a condition | 0.800 | 0.808 | 0.840 | +5.0 % | 0.790 |" in text
    assert "| b | -1.000 | -1.100 | +10.0 % |" in text and "| law | none | 4 deg/s | 50 ms |" in text
    assert relative(0.9, 1.0) == "-10.0 %" and relative(math.nan, 1.0) == ""


def test_bisection_ends_where_it_changes() -> None:
    assert bisected(lambda x: x > 0.3, 0.0, 1.0) == pytest.approx(0.3, abs=2e-4)
