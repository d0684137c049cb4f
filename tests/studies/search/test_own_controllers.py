"""Controllers of the user's in a search: searched beside the shipped ones, and the flight found flies again with the class."""

from __future__ import annotations

from pathlib import Path

import pytest
from own_controllers import own_controller
from search_files import SEARCH, backwards, search_here, written

import testbed
from testbed.api import search
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import dump
from testbed.scenario.load import load_scenario
from testbed.simulation import fly
from testbed.studies.run import Options

GUST = (
    SEARCH.replace("scenarios/left_tail_fail.yaml", "{name: plain, aircraft: vtail}")
    .replace("budget: 300", "budget: 20")
    .replace("altitude_error_max_m, at_most: 1", "altitude_error_max_m, at_most: 0.1")
    .replace("{wind_m_s: [0, 0, 0]}", "{gusts: [{at_s: 0.1, magnitude_m_s: [0, 0, 0], frame: ned, duration_s: 0.2}]}")
    .replace("wind_m_s.0", "gusts.0.magnitude_m_s.2")
    .replace("atmosphere.wind_m_s.1: {normal: [0, 2]}", "controller.parameters.gain: {uniform: [0.5, 1.5]}")
)  # fmt: skip


def test_the_flight_found_flies_again_with_the_class(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    plan, folder = search.prepare(written(tmp_path, GUST), tmp_path / "out", controllers=[own])
    result = search_here(plan, folder, Options(save_logs="none", workers=backwards))
    assert result.found and [variant["label"] for variant in result.summary["variants"]] == ["mine"]
    assert repr(result).endswith(
        "`testbed run found-mine/scenario.yaml --controller mine_flies.py:Mine` flies it again."
    )
    again = fly(load_scenario(folder / "found.yaml"), own_controllers([own])["mine"].load())
    assert again.data.tobytes() == testbed.load(folder / "found-mine").data.tobytes()  # type: ignore[union-attr]
    assert not again.passed


def test_a_search_that_was_written_asks_for_the_class(tmp_path: Path) -> None:
    own = own_controller(tmp_path)
    plan, _ = search.prepare(written(tmp_path, GUST), controllers=[own])
    again = written(tmp_path, dump(plan.tree), "search.yaml")
    with pytest.raises(BadInput, match="mine is a controller of one's own, and its class was not given"):
        search.prepare(again)
    assert search.prepare(again, controllers=[own])[0].tree == plan.tree
