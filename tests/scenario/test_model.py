"""A scenario is complete, equal to what it was read from, and flies again as it is."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scenario_files import GOOD, again_as_it_is

from testbed.aircraft.description import load_aircraft
from testbed.failures import TABLE as FAILURES
from testbed.scenario.load import Scenario, load_scenario
from testbed.scenario.model import MAX_NAME


def test_defaults_complete_the_scenario(tmp_path: Path) -> None:
    file = tmp_path / "x.yaml"
    file.write_text("name: x\naircraft: vtail\nduration_s: 10\ncommands: [{at_s: 5, heading_deg: 30}]\n")
    scenario = load_scenario(file)
    first, second = scenario.commands
    assert (first.at_s, first.altitude_m, first.airspeed_m_s, first.heading_deg) == (0, 300, 18, 0)
    assert (second.at_s, second.altitude_m, second.heading_deg) == (5, None, 30)
    assert scenario.physics_hz == scenario.log_hz == scenario.rate_hz == 200


def test_a_window_ends_before_its_end(file: Path) -> None:
    """[at_s, until_s): one failure may start at the instant at which another ends."""
    file.write_text(GOOD.replace("at_s: 5, value", "at_s: 5, until_s: 15, value"))
    first, second, _ = load_scenario(file).failures
    assert first.window_s == (5, 15)
    assert second.window_s == (15, math.inf)


def test_a_different_scenario_is_different(file: Path) -> None:
    """The negative control of the round trip: equality would notice a lost value."""
    assert load_scenario(file) != load_scenario(file, ["failures.1.value=0.1"])
    assert load_scenario(file) == pickle.loads(pickle.dumps(load_scenario(file)))


@pytest.mark.parametrize(("name", "kind"), FAILURES.items())
def test_each_failure_type_knows_itself(name: str, kind: type) -> None:
    assert kind.model_fields["type"].default == name  # type: ignore[attr-defined]
    assert kind.__doc__


numbers = st.floats(-1e6, 1e6)


rates = st.integers(1, 20)
texts = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=MAX_NAME)
"""Text that a file can hold, and a name: without NUL, without halves of surrogate pairs."""
some_text = texts.filter(lambda text: text.splitlines() == [text])  # names are one line


@st.composite
def scenario_trees(draw: st.DrawFn) -> dict[str, object]:
    rate = draw(rates) * draw(rates)
    begin, end = draw(st.floats(0, 4)), draw(st.floats(5, 9))
    name = draw(st.sampled_from(sorted(load_aircraft("vtail").actuators)))
    timing = draw(st.sampled_from([{"at_s": begin}, {"at_s": begin, "until_s": end}]))
    return {
        "name": draw(some_text),
        "aircraft": "vtail",
        "duration_s": draw(st.integers(10, 100)),
        "rate_hz": rate,
        "physics_hz": rate * draw(rates),
        "seed": draw(st.integers(0, 2**70)),
        "initial": {"altitude_m": draw(st.floats(5, 1e6)), "airspeed_m_s": draw(st.floats(8, 40))},
        "controller": {
            "type": "adaptive_inversion",
            "gamma": draw(st.floats(1e-9, 1e9)),
            "model_error": draw(st.dictionaries(st.sampled_from(["Cm_alpha", "CX_left_propeller"]), numbers)),
        },
        "commands": [{"at_s": begin, "heading_deg": draw(st.floats(0, 360))}],
        "failures": [
            {"type": "effectiveness", "actuator": name, "value": draw(st.floats(0, 1.5)), **timing},
            {"type": "property", "at_s": begin, "set": {"p/" + draw(texts): draw(numbers)}},
        ],
        "atmosphere": {"wind_m_s": [draw(numbers), 0, draw(numbers)]},
        "requirements": [
            {"metric": draw(some_text), "at_most": draw(numbers)},
            {"signal": "x", "within": 1, "of": draw(numbers | some_text)},
        ],
    }


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(scenario_trees())
def test_any_scenario_flies_again_as_it_is(tmp_path: Path, tree: dict[str, object]) -> None:
    again_as_it_is(Scenario.model_validate(tree), tmp_path)
