"""The page of rare flights: counted from flights that are kept, also of plain sampling that is under way."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
import rare_flights
from rare_flights import CHECKED, RARE

from testbed.studies.checks import check
from testbed.studies.folder import store
from testbed.studies.record import Record
from testbed.studies.search.plan import Part, Space, key_of, load_search


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """One of 8 plain flights failed, one has no result; the flight at the origin failed; and one search has been made."""
    folder = tmp_path / "plain-4m-seed2"
    folder.mkdir()
    store.create(folder, {})
    flights, part = store.opened(folder), Part(0, 0, {}, 1.0, Space(()))
    for number in range(9):
        passed, robustness = number > 2, 0.5 if number > 2 else -0.5
        if number == 1:
            passed, robustness = True, math.nan
        record = Record(number, 0, 1, {}, "completed", passed, robustness=robustness)
        flights.add(key_of(part, (float(number), 0.0)), record)
    flights.close()
    made = tmp_path / "adaptive-4m-seed1"
    made.mkdir()
    known = {"estimate": 0.01, "low": 0.005, "high": 0.02, "coefficient_of_variation": 0.3, "flights": 700}
    (made / "summary.json").write_text(json.dumps({"probability": known}))
    return tmp_path


def test_plain_flights_are_counted_without_the_one_at_the_origin(out: Path) -> None:
    assert rare_flights.plain(out / "plain-4m-seed2") == (1, 8)


def test_the_page_has_a_row_for_each_search_that_was_made(out: Path) -> None:
    rows = [line for line in rare_flights.page(out).splitlines() if line.startswith("| 4 m")]
    assert [row.split(" | ")[1:3] for row in rows] == [["`plain`", "2"], ["`adaptive`", "1"]]
    assert "1.25e-01 | 3.2e-03 to 5.3e-01" in rows[0]  # Clopper and Pearson's interval of 1 in 8
    assert rows[1].endswith("| 1.00e-02 | 5.0e-03 to 2.0e-02 | 0.30 | 700 | 1.1e+03 |")


@pytest.mark.parametrize("limits", [CHECKED, RARE])
def test_the_limits_are_those_of_the_case(limits: rare_flights.Limits) -> None:
    plan = load_search(rare_flights.CASE, [limits.setting])
    check(plan)
    said = plan.builder.scenario(plan.task(0)).requirements
    assert [requirement.at_most for requirement in said] == [limits.altitude_m, limits.heading_deg]


def test_the_case_as_it_is_shipped_is_the_one_that_is_checked() -> None:
    shipped, checked = load_search(rare_flights.CASE), load_search(rare_flights.CASE, [CHECKED.setting])
    assert shipped.tree["scenario"] == checked.tree["scenario"]
