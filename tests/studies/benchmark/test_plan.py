"""Draw i of a suite: a pure function of (suite, seed, i), valid, and of every kind of failure."""

from __future__ import annotations

import math
from collections import Counter
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from suite_files import tree, written

from testbed.air.config import severity
from testbed.air.turbulence import EXCEEDED_FT, EXCEEDED_FT_S, intensities_and_lengths
from testbed.aircraft.changes import ChangedAircraft, load_with_changes
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shipped import files_in
from testbed.api.benchmark import prepare
from testbed.failures import TABLE
from testbed.inputs.problems import BadInput
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import trim
from testbed.simulation.check import check
from testbed.studies.benchmark.load import load_suite
from testbed.studies.benchmark.model import Craft, Weather
from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.drawing.builder import Task

STUCK = [entry["type"] for entry in tree()["failures"]["types"]].index("stuck_at")


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


@pytest.mark.parametrize(
    "path", [("references", "legs"), ("failures", "count"), ("failures", "types", STUCK, "values", "value")]
)
def test_a_choice_between_things_that_are_no_numbers_is_refused(
    tmp_path: Path, path: tuple[Any, ...]
) -> None:
    suite = part = tree()
    for key in path[:-1]:
        part = part[key]
    part[path[-1]] = {"choice": [1, {"a": 1}]}
    with pytest.raises(BadInput, match="can draw a mapping, expected numbers"):
        load_suite(written(tmp_path, suite))


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
    families = Counter(entry.family for entry in plan.suite.failures.types) if plan.suite.failures else {}
    counts = Counter(plan.groups(number)["failures"] for number in tasks)
    assert set(families) <= set(counts), "each alone in some draw"
    gusts = Counter(plan.groups(number)["gust"] for number in tasks)
    assert min(gusts[group] for group in ("with the first failure", "at any time", "none")) > 20
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


def test_commands_stay_within_the_aircrafts_altitudes(tmp_path: Path) -> None:
    plan = plan_of(written(tmp_path))
    low, high = plan.suite.aircraft["vtail"].altitude_m
    said = [one["altitude_m"] for task in drawn(plan, range(60)).values() for one in task.values["commands"]]
    assert min(said) >= low and max(said) <= high and max(said) - min(said) > 0.9 * (high - low)


def intensity_m_s(weather: Weather, craft: Craft) -> float:
    """Vertical turbulence at the middle altitude, the mean over what W20 may be."""
    assert weather.turbulence_w20_m_s is not None
    each = craft.w20_factor * np.array(weather.turbulence_w20_m_s.quantiles(np.linspace(0.05, 0.95, 19)))
    height = sum(craft.altitude_m) / 2.0
    return float(
        np.mean([intensities_and_lengths(height, w20, np.array([EXCEEDED_FT, EXCEEDED_FT_S[severity(w20)]]))[1]
                 for w20 in map(float, each)])
    )  # fmt: skip


@pytest.mark.parametrize("file", files_in("scenarios/suites"), ids=lambda file: file.stem)
def test_severer_weather_is_rougher_air_for_every_aircraft(file: Path) -> None:
    """Above 2000 ft the shipped light, moderate and severe once were the same turbulence, to the last digit."""
    suite, _ = load_suite(file)
    for name, craft in suite.aircraft.items():
        light, moderate, severe = (
            intensity_m_s(suite.weather[each], craft) for each in ("light", "moderate", "severe")
        )
        assert 1.1 * light < moderate and 1.1 * moderate < severe, name
    once = craft.model_copy(update={"w20_factor": 1.0})
    assert intensity_m_s(suite.weather["light"], once) == intensity_m_s(suite.weather["severe"], once)


def test_the_shipped_suites_have_the_same_aircraft() -> None:
    one, other = (load_suite(file)[0] for file in files_in("scenarios/suites"))
    assert one.aircraft == other.aircraft and one.truth == other.truth


@pytest.mark.nightly
def test_every_aircraft_of_the_shipped_suites_can_begin_wherever_it_is_drawn() -> None:
    """Slowest and fastest, lowest and highest; as it is, and heavy with its centre of gravity either way."""
    file = files_in("scenarios/suites")[0]
    suite, _ = load_suite(file)
    assert suite.truth is not None
    heavy = float(suite.truth.mass.quantiles(np.array([1.0]))[0])
    shifts = suite.truth.cg_shift.quantiles(np.array([0.0, 1.0]))
    for (name, craft), place in zip(suite.aircraft.items(), plan_of(file).aircraft_names, strict=True):
        assert craft.mass_kg is not None and craft.chord_m is not None
        changed = [
            {"mass_kg": craft.mass_kg * heavy, "cg_shift_x_m": craft.chord_m * float(x)} for x in shifts
        ]
        for change, airspeed, height in product([{}, *changed], craft.airspeed_m_s, craft.altitude_m):
            aircraft = load_with_changes(ChangedAircraft.model_validate({"name": place, **change}))
            begun = trim(Plant(aircraft, 200.0), airspeed, height)
            thrust = [
                c
                for c, a in zip(begun.commands, aircraft.actuators.values(), strict=True)
                if a.kind != "servo"
            ]
            assert max(thrust) < 0.96, f"{name} has no thrust left at {airspeed} m/s, {height} m"


@pytest.mark.nightly
def test_spans_and_masses_of_the_shipped_suites_are_those_of_the_models() -> None:
    plan = plan_of(files_in("scenarios/suites")[0])
    for (name, one), place in zip(plan.suite.aircraft.items(), plan.aircraft_names, strict=True):
        plant = Plant(load_aircraft(place), 200)
        assert one.span_m == pytest.approx(plant.span_m, rel=0.02), name
        plant.place(
            {"airspeed": one.airspeed_m_s[0], "altitude": one.altitude_m[0], "alpha": 0.0, "pitch": 0.0}
        )  # weighs the fuel
        mass_kg = plant["inertia/mass-slugs"] * 14.5939
        assert one.mass_kg is None or math.isclose(one.mass_kg, mass_kg, rel_tol=0.02), name
