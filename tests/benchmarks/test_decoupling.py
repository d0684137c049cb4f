"""The campaign on decoupling: what it flies, what counts, and that its page has both bounds and flights."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import decoupling
import pytest
from decoupling import CALM, MARGINS, TUNED, margin_flights, recovery_flights, until
from decoupling_page import DELAYS, SEEDS, draw, milliseconds, page
from mission_list import BASE
from mission_results import Row

from testbed.inputs.yaml_source import parse
from testbed.studies.drawing.builder import Builder, Task, Variant

HELD = Row("default", "hard_healthy", "vtail", 25.0, 0.0, 90001, "completed", 5.0, 15.0, 0.5, 0, 0)


def test_every_flight_is_a_valid_scenario() -> None:
    builder = Builder(parse(BASE, "campaign"), (Variant("", {}),))
    planned = [*margin_flights(TUNED, [1], CALM), *recovery_flights()]
    assert len(planned) == len(TUNED) * len(DELAYS) + len(MARGINS)
    for number, (seed, values) in enumerate(planned):
        assert builder.scenario(Task(number, 0, seed, values)).failures


def test_tuning_and_reporting_seeds_are_apart() -> None:
    assert max(decoupling.TUNING_SEEDS) < 50000 and min(SEEDS) >= 90001


def test_the_margin_ends_at_the_first_delay_that_is_not_good() -> None:
    """Negative control: what is good again at a longer delay does not count."""
    cells = [[{"good": n != 2}] for n in range(len(DELAYS))]
    assert until(cells, lambda record: record["good"]) == DELAYS[1]
    assert math.isnan(until([[{"good": False}]] * len(DELAYS), lambda record: record["good"]))
    assert [milliseconds(0.08), milliseconds(math.nan)] == ["80 ms", "no delay"]


def test_the_page_says_what_was_found() -> None:
    rows = [HELD, replace(HELD, controller="l1_inversion", altitude_m=6.0)]
    back = {"l1": {"metrics": {"error_peak_deg_s2": 170.0, "error_recovery_s": 0.5}}}
    text = page(rows, {"l1": [0.1, 0.08, 0.12, math.nan]}, back)
    assert "| l1 | 100 ms | 80 ms | 120 ms | no delay | 170 deg/s2 | 0.50 s |" in text
    assert "| hard_healthy | 1/1 | 0/1 |" in text


@pytest.mark.nightly
def test_the_figure_has_laws_and_bounds(tmp_path: Path) -> None:
    draw(tmp_path / "noise.png")
    assert (tmp_path / "noise.png").stat().st_size > 20000
