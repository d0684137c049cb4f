"""Draw i of a suite: a pure function of (suite, seed, i), valid, and of every kind of failure."""

from __future__ import annotations

import math
from collections import Counter
from pathlib import Path

import pytest
from suite_files import tree, written

from testbed.aircraft.shipped import files_in
from testbed.api.benchmark import prepare
from testbed.failures import TABLE
from testbed.simulation.check import check
from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.drawing.builder import Task


def plan_of(suite: Path | str, seed: int = 5, draws: int = 4, controllers: tuple[str, ...] = ()) -> Benchmark:
    return prepare(suite, seed=seed, draws=draws, controllers=controllers)[0]


def drawn(plan: Benchmark, numbers: range) -> dict[int, Task]:
    return {number: plan.task(number * len(plan.variants)) for number in numbers}


def test_a_draw_depends_on_nothing_but_suite_seed_and_number(tmp_path: Path) -> None:
    file = written(tmp_path)
    forth = drawn(plan_of(file), range(8))
    back = drawn(plan_of(file, draws=100, controllers=("fixed",)), range(7, -1, -1))
    assert forth == back
    other = drawn(plan_of(file, seed=6), range(8))
    assert all(forth[k].values != other[k].values and forth[k].seed != other[k].seed for k in forth)


def test_controllers_change_no_draw_and_another_suite_changes_each(tmp_path: Path) -> None:
    before = drawn(plan_of(written(tmp_path)), range(3))
    suite = tree()
    suite["controllers"]["pid"] = {"type": "pid"}
    assert drawn(plan_of(written(tmp_path, suite)), range(3)) == before
    suite["limits"]["heading_deg"] = 21
    assert all(drawn(plan_of(written(tmp_path, suite)), range(3))[k] != before[k] for k in before)


def test_every_controller_flies_the_same_draw(tmp_path: Path) -> None:
    plan = plan_of(written(tmp_path))
    one, two = plan.task(6), plan.task(7)
    assert (one.run, one.variant, two.run, two.variant) == (3, 0, 3, 1)
    assert (one.values, one.seed) == (two.values, two.seed)


def test_draws_are_flights_and_have_every_type_of_failure(tmp_path: Path) -> None:
    """Each draw makes a scenario, or `task` would raise; the first ones meet the whole check of `testbed run`."""
    plan = plan_of(written(tmp_path))
    tasks = drawn(plan, range(250))
    for number in range(6):
        check(plan.builder.scenario(tasks[number]), remembered=False)
    types = Counter(failure["type"] for task in tasks.values() for failure in task.values["failures"])
    assert set(types) == set(TABLE)
    counts = Counter(plan.groups(number)["failures"] for number in tasks)
    assert counts["none"] == pytest.approx(25, abs=15), "one in ten, within three standard deviations"
    assert counts["several"] == pytest.approx(100, abs=24), "four in ten"


def test_failures_end_come_back_and_follow_each_other(tmp_path: Path) -> None:
    plan = plan_of(written(tmp_path))
    courses = {plan.groups(number)["course"] for number in range(120)}
    assert {
        "healthy",
        "lasting",
        "ends",
        "comes back",
        "2 at once",
        "2 in turn",
        "2 in turn, some end",
    } <= courses


def test_held_is_measured_by_the_aircrafts_size_and_speed(tmp_path: Path) -> None:
    plan = plan_of(written(tmp_path))
    values = plan.task(0).values
    altitude, heading = values["requirements"]
    expected = 1.0 * 2.0 + 0.45 * values["initial"]["airspeed_m_s"]  # a span of 2 m
    assert altitude["at_most"] == pytest.approx(expected, rel=1e-5)
    assert heading["at_most"] == 20


@pytest.mark.nightly
@pytest.mark.parametrize("file", files_in("scenarios/suites"), ids=lambda file: file.stem)
def test_shipped_suites_begin_in_trimmed_flight(file: Path) -> None:
    plan = plan_of(file, draws=60)
    for number in range(60):
        check(plan.builder.scenario(plan.task(number * len(plan.variants))), remembered=False)


@pytest.mark.nightly
@pytest.mark.parametrize("file", files_in("scenarios/suites"), ids=lambda file: file.stem)
def test_spans_and_masses_of_shipped_suites_are_those_of_the_models(file: Path) -> None:
    from testbed.aircraft.description import load_aircraft
    from testbed.plant.jsbsim import Plant

    plan = plan_of(file)
    for (name, one), place in zip(plan.suite.aircraft.items(), plan.aircraft_names, strict=True):
        plant = Plant(load_aircraft(place), 200)
        assert one.span_m == pytest.approx(plant.span_m, rel=0.02), name
        plant.place(
            {"airspeed": one.airspeed_m_s[0], "altitude": one.altitude_m[0], "alpha": 0.0, "pitch": 0.0}
        )  # weighs the fuel
        mass_kg = plant["inertia/mass-slugs"] * 14.5939
        assert one.mass_kg is None or math.isclose(one.mass_kg, mass_kg, rel_tol=0.02), name
