"""What a flight says of itself: its summary, one line of text, and a piece of HTML for notebooks."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest
from handmade import flight_of, injection, level_log, make_flight

from testbed.flight.flight import Flight, Outcome
from testbed.flight.folder import write_run_folder


def test_summary_is_the_contract(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    assert json.loads((folder / "summary.json").read_text()) == {
        "scenario": "left tail failure",
        "seed": 1,
        "actuators": [],
        "outcome": "completed",
        "end_time_s": 60.0,
        "passed": True,
        "robustness": 0.25,
        "requirements": [
            {"name": "a", "passed": True, "value": 0.1, "limit": "at most 1", "robustness": 0.25}
        ],
        "events": [{"time_s": 5.0, "kind": "injection", "failure": 0, "verified": True}],
        "metrics": {"a": None, "b": 0.1},
        "warnings": [],
    }


def test_passed_needs_the_end_and_every_requirement() -> None:
    assert make_flight().passed
    assert not make_flight(
        requirements=[{"name": "a", "passed": False, "value": 2, "limit": "at most 1"}]
    ).passed
    for outcome in set(Outcome) - {Outcome.completed}:
        assert not make_flight(outcome=outcome).passed
        assert outcome.sentence


MET = {"name": "altitude", "passed": True, "value": 0.1234567, "limit": "at most 1", "reason": ""}
MISSED = {
    "name": "heading < 5 & > -5",
    "passed": False,
    "value": math.nan,
    "reason": "not a number in this flight",
}


def a_flight(**changes: object) -> Flight:
    return flight_of(level_log(), [injection(4.0)], metrics={"false_alarms": 2.0, "survived": 1.0}, **changes)  # type: ignore[arg-type]


def test_repr_is_one_short_line() -> None:
    said = repr(a_flight(requirements=[MET, MISSED], name="two rows"))
    assert said == (
        "<Flight 'two rows': completed at 10 s, not passed (1 of 2 requirements met), 1000 rows x 29 columns, 1 event>"
    )
    assert "not judged (no requirements)" in repr(a_flight(outcome=Outcome.completed))
    assert "ground_contact at 10 s, not passed" in repr(a_flight(outcome=Outcome.ground_contact))


def test_a_requirement_that_is_not_judged_is_neither_met_nor_missed() -> None:
    silent = {**MET, "passed": None, "value": math.nan, "margin": math.nan, "robustness": math.nan}
    judged = {**MET, "robustness": 0.5}
    flight = a_flight(requirements=[judged, silent])
    assert flight.passed is True and flight.verdict == "passed" and flight.robustness == 0.5
    assert flight.counted == "1 of 2 requirements met, 1 not judged"
    none = a_flight(requirements=[silent])
    assert none.passed is None and none.verdict == "not judged" and math.isnan(none.robustness)
    assert none.summary["passed"] is None and none.summary["requirements"][0]["value"] is None
    assert a_flight(requirements=[silent], outcome=Outcome.ground_contact).passed is False
    assert a_flight(requirements=[MISSED, silent]).passed is False


def test_html_shows_what_was_missed_first() -> None:
    html = a_flight(requirements=[MET, MISSED])._repr_html_()
    assert "Not passed" in html and "1 of 2 requirements met" in html
    assert html.index("NOT MET") < html.index("<td>met</td>")
    assert "heading &lt; 5 &amp; &gt; -5" in html and "heading < 5" not in html
    assert "not a number in this flight" in html and "0.1235" in html
    assert "<td>false alarms</td><td>2</td>" in html and "survived" not in html


@pytest.mark.parametrize("outcome", Outcome)
def test_html_of_any_outcome_is_well_formed(outcome: Outcome) -> None:
    from xml.etree import ElementTree

    many = [{**MET, "name": f"requirement {i}"} for i in range(20)]
    html = a_flight(requirements=many, outcome=outcome, name="<b>")._repr_html_()
    text = "".join(ElementTree.fromstring(html).itertext())
    assert outcome.sentence[1:] in text and "<b>" in text
    assert ("Not passed" in text) == (outcome is not Outcome.completed)
    assert "and 8 more" in text, "of 20 requirements 12 are shown"


def test_it_is_shown_without_pandas_and_matplotlib(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    program = (
        "import sys, testbed; flight = testbed.load(sys.argv[1]); assert repr(flight) and flight._repr_html_()\n"
        "assert not {'pandas', 'matplotlib', 'numba', 'jsbsim'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program, str(folder)], check=True)
