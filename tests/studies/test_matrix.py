"""A failure matrix: its cells, its flights, what came of them against a baseline, and its folder."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from html_page import Page
from sweep_files import here as flying_here
from sweep_flights import quick

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.api import matrix
from testbed.failures import TABLE
from testbed.inputs.problems import BadInput
from testbed.studies.matrix import MatrixPlan, load_matrix

WEAK = {"type": "effectiveness", "value": 0.2}
"""With half of its severity 0.6 is left, with which the made-up flights pass."""


def plan_of(**keys: object) -> MatrixPlan:
    return load_matrix("vtail", keys={"failures": [WEAK], **keys})


def flown(plan: MatrixPlan, folder: Path) -> dict[str, object]:
    return matrix.finish(plan, folder, matrix.fly(plan, folder, flying_here()), figures=True)


def rows(folder: Path) -> list[dict[str, str]]:
    return list(csv.DictReader((folder / "matrix.csv").read_text().splitlines()))


def test_every_actuator_meets_every_failure_that_fits_it() -> None:
    plan = load_matrix("vtail", keys={"severities": [1.0]})
    kinds = {name: kind for name, kind in TABLE.items() if name != "property"}
    actuators = load_aircraft("vtail").actuators
    assert {(cell.actuator, cell.failure) for cell in plan.cells} == {
        (a, f) for a in actuators for f in kinds
    }
    fitting = {
        (a, f) for a, what in actuators.items() for f, kind in kinds.items() if what.kind in kind.kinds
    }
    assert {(cell.actuator, cell.failure) for cell in plan.flown} == fitting
    assert plan.runs == len(fitting) and all(cell.reason for cell in plan.cells if cell not in plan.flown)


def test_severity_is_the_share_of_the_way_from_no_effect() -> None:
    plan = plan_of(failures=[WEAK, "rate_limit", "stuck"], severities=[0.25, 1.0])
    first = [cell for cell in plan.flown if cell.actuator == "left_ruddervator"]
    healthy = load_aircraft("vtail").actuators["left_ruddervator"].rate_limit
    assert healthy is not None
    broken = [
        (cell.severity, dict(cell.broken or {})["value"]) for cell in first if "value" in (cell.broken or {})
    ]
    assert broken == [(0.25, 0.8), (1.0, 0.2), (0.25, healthy + 0.25 * (2.0 - healthy)), (1.0, 2.0)]
    assert [cell.severity for cell in first if cell.failure == "stuck"] == [1.0]


def test_flights_of_one_seed_meet_the_same_air_in_every_cell() -> None:
    plan = plan_of(seeds=2, weather=["calm", 3.0, "light"])
    tasks = [plan.task(k) for k in range(plan.size)]
    assert len({task.seed for task in tasks}) == 2
    air = [plan.builder.scenario(task).atmosphere.turbulence_w20_m_s for task in tasks]
    assert sorted(set(air)) == [0.0, 3.0, pytest.approx(7.717, abs=1e-3)]
    failures = [plan.builder.scenario(task).failures for task in tasks]
    assert all(len(each) == 1 and each[0].at_s == 10.0 for each in failures)


def test_results_are_compared_with_the_baseline(tmp_path: Path) -> None:
    baseline = [
        {"failure": "effectiveness value=0.2", "severity": 1.0, "result": "survived"},
        {"actuator": "left_propeller", "severity": 1.0, "result": "held"},
        {"actuator": "right_propeller", "severity": 0.5, "result": "lost"},
    ]
    found = flown(plan_of(baseline=baseline), tmp_path / "out")
    assert found["counts"] == {"held": 4, "survived": 4} and not matrix.met(found)
    said = [line for line in matrix.answer(found) if "than expected" in line]
    assert said[0].startswith("worse than expected: left_propeller effectiveness value=0.2 1, ")
    assert said[1].startswith("better than expected: right_propeller effectiveness value=0.2 0.5, ")
    assert len(said) == 2 and "survived, expected held" in said[0]


def test_its_own_table_is_a_baseline_with_which_all_is_as_expected(tmp_path: Path) -> None:
    first = flown(plan_of(), tmp_path / "first")
    assert not matrix.met(first)
    again, folder = matrix.prepare(
        "vtail", tmp_path / "again", failures=[WEAK], baseline=tmp_path / "first/matrix.csv"
    )
    assert matrix.met(flown(again, folder))
    assert [row["result"] for row in rows(folder)] == [row["result"] for row in rows(tmp_path / "first")]
    assert (
        matrix.met(matrix.rebuild(folder)) and len(testbed.load(folder)) == 8
    )  # the folder knows its baseline


def test_a_baseline_may_be_of_more_than_is_flown(tmp_path: Path) -> None:
    baseline = [{"failure": "stuck", "result": "lost"}, {"controller": "mine", "result": "lost"},
                {"severity": 0.25, "weather": "severe", "result": "lost"}]  # fmt: skip
    assert not plan_of(baseline=baseline).study.baseline[0].actuator
    assert {plan_of(baseline=baseline).expected(cell, "pid") for cell in plan_of().cells} == {"held"}


def test_the_page_has_a_cell_for_each_that_names_its_command(tmp_path: Path) -> None:
    flown(plan_of(failures=[WEAK, "surface_lost"], severities=[1.0]), tmp_path / "out")
    text = (tmp_path / "out/report.html").read_text()
    assert Page(text).tags.count("details") == 6
    for row in rows(tmp_path / "out"):
        command = f"testbed matrix matrix.yaml --only {row['run']}<"
        assert (command in text) == (row["result"] != "not possible")


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"failures": ["stuk"]}, "is 'stuk' (one of your own needs --with FILE.py), did you mean stuck?"),
        ({"failures": [{"type": "effectiveness", "value": 3.0}]}, "effectiveness value=3.0: value: "),
        ({"failures": [{"type": "stuck", "at_s": 3.0}]}, "has at_s"),
        ({"weather": ["foggy"]}, "has 'foggy', expected calm, light, moderate, severe or a W20"),
        ({"vary": {"duration_s": {"uniform": [1, 2]}}}, "varies values"),
        ({"baseline": [{"failure": "stuk", "result": "lost"}]}, "no failure 'stuk', did you mean stuck?"),
        (
            {"baseline": [{"actuator": "tail", "result": "lost"}]},
            "no actuator 'tail', expected one of left_ruddervator",
        ),
        ({"baseline": [{"controller": "pidd", "result": "lost"}]}, "no controller 'pidd', did you mean pid?"),
        ({"baseline": [{"result": "crashed"}]}, "baseline.0.result"),
    ],
)
def test_what_cannot_be_meant_is_refused(keys: dict[str, object], words: str) -> None:
    with pytest.raises(BadInput) as refused:
        plan_of(**keys)
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("c310", "JSBSim has a model of this name, expected ./c310, after `testbed adopt c310`"),
        ("vtial", "mean vtail?"),
    ],
)
def test_what_is_no_aircraft_yet_says_how_to_have_it(name: str, words: str) -> None:
    with pytest.raises(BadInput) as refused:
        load_matrix(name)
    assert words in str(refused.value)


def test_from_python_it_is_a_table_of_cells(tmp_path: Path) -> None:
    frame = testbed.matrix("vtail", tmp_path / "out", failures=[WEAK], severities=[1.0], jobs=1, fly=quick)
    assert list(frame["result"]) == ["survived"] * 4 and set(frame["against"]) == {"worse"}
