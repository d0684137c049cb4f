"""The page of a search: the answer in sentences, the design point with bars, figures, and what it says when nothing is found."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from html_page import Page
from search_files import searched, written

from testbed.api.search import SearchResult
from testbed.flight.flight import Flight, Outcome
from testbed.scenario.load import load_scenario
from testbed.study_reports.search.report import write_search_page
from testbed.study_reports.search.words import answer, settings_of


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> SearchResult:
    """The smallest failure of made-up flights, with two controllers that do not matter."""
    folder = tmp_path_factory.mktemp("found")
    return searched(
        written(folder), folder / "out", "compare={controller.type: [adaptive_inversion, pid]}", figures=True
    )


@pytest.fixture(scope="module")
def likely(tmp_path_factory: pytest.TempPathFactory) -> SearchResult:
    folder = tmp_path_factory.mktemp("likely")
    return searched(
        written(folder), folder / "out", "goal=probability", "budget=1000", "cov=0.6", figures=True
    )


def test_it_is_one_file_that_fetches_nothing(found: SearchResult) -> None:
    page = Page((found.folder / "report.html").read_text(encoding="utf-8"))
    assert page.tags.count("img") == 2  # convergence and path; made-up flights are not compared
    assert page.fetches_and_runs_nothing()
    for words in (*answer(found.summary), "What it takes", "values at least as far", "found.yaml"):
        assert words in page.text


def test_the_answer_names_what_broke_and_compares(found: SearchResult) -> None:
    lines = answer(found.summary)
    assert lines[0].startswith("adaptive_inversion: the smallest failure found: a steady wind of ")
    assert "It breaks 'held'. Distance 2.5" in lines[0] and "about 1 flight in 160 is worse" in lines[0]
    assert lines[2].startswith("From the bigger failure needed to the smaller: ")
    assert f"{lines[0]}\n" in repr(found)


def test_bars_are_shares_of_the_squared_distance(found: SearchResult) -> None:
    point = found.summary["parts"][0]["point"]
    assert sum(each["share"] for each in point.values()) == pytest.approx(1.0)
    text = (found.folder / "report.html").read_text(encoding="utf-8")
    for each in point.values():
        assert f"width:{100 * each['share']:.1f}%" in text


def test_a_probability_comes_with_its_interval_and_levels(likely: SearchResult) -> None:
    known = likely.probability
    assert known is not None and known["low"] <= 0.00621 <= known["high"]  # P(normal > 2.5)
    page = Page((likely.folder / "report.html").read_text(encoding="utf-8"))
    assert "How likely a requirement is broken" in page.text and "robustness at most" in page.text
    assert answer(likely.summary)[0].startswith("A requirement is broken with probability 0.00")
    assert (likely.folder / "figures/levels.png").is_file()


def test_of_a_probability_only_what_is_known_is_said(likely: SearchResult) -> None:
    assert "coefficient of variation 0." in answer(likely.summary)[0]
    summary = json.loads(json.dumps(likely.summary))
    summary["variants"][0]["probability"] |= {"coefficient_of_variation": None, "plain_flights": None}
    assert re.search(r"\(\S+ to \S+, 95 %\), from \d+ flights\.", answer(summary)[0])


def test_none_of_the_flights_is_compared_with_plain_sampling(likely: SearchResult) -> None:
    """Why the bound is wider than that of independent flights, where it is; a bound that is theirs needs no word."""

    def told(high: float) -> str:
        known = {
            **likely.summary["variants"][0]["probability"],
            "estimate": 0.0,
            "flights": 120,
            "high": high,
        }
        variants = [{**likely.summary["variants"][0], "probability": known}]
        return answer({**likely.summary, "variants": variants})[0]

    assert (
        "at most 0.64 (95 %). As many flights drawn independently would say 0.03; these were drawn"
        in told(0.64)
    )
    assert told(0.03).endswith("at most 0.03 (95 %).")


def test_a_probability_that_is_not_known_is_said_to_be_so(likely: SearchResult, tmp_path: Path) -> None:
    summary = json.loads(json.dumps(likely.summary))
    for known in (summary["variants"][0]["probability"], summary["parts"][0]["probability"]):
        known |= {
            "estimate": None,
            "coefficient_of_variation": None,
            "plain_flights": None,
            "low": 0.0,
            "high": 0.5,
        }
    for level in summary["parts"][0]["levels"]:
        level |= {"threshold": None, "cov": None}
    assert "with a probability that is not known: 0 to 0.5 (95 %)" in answer(summary)[0]
    (tmp_path / "summary.json").write_text(json.dumps(summary))
    assert "not known" in write_search_page(tmp_path).read_text(encoding="utf-8")


def test_nothing_found_says_what_the_draws_allow(tmp_path: Path) -> None:
    result = searched(written(tmp_path), tmp_path / "out", "budget=40", fly="unbreakable", figures=True)
    page = Page((result.folder / "report.html").read_text(encoding="utf-8"))
    assert "Not found in 40 flights." in page.text and "What it takes" not in page.text


def test_settings_in_words() -> None:
    scenario = load_scenario(
        "scenarios/left_propeller_fail.yaml",
        {"failures": [{"type": "effectiveness", "actuator": "left_propeller", "at_s": 41.0, "value": 0.38}],
         "atmosphere": {"wind_m_s": [3.0, 4.0, 0.0],
                        "gusts": [{"at_s": 7.0, "magnitude_m_s": [0.0, 0.0, -4.6], "duration_s": 1.0}]},
         "requirements": []},
    )  # fmt: skip
    flight = Flight(scenario, Outcome.completed, 60.0, (), np.zeros((0, 0)))
    paths = ["failures.0.value", "failures.0.at_s", "atmosphere.wind_m_s.0", "atmosphere.wind_m_s.1",
             "atmosphere.gusts.0.magnitude_m_s.2", "initial.airspeed_m_s"]  # fmt: skip
    assert settings_of(flight, paths) == [
        "at 41.0 s the left propeller kept 38 % of its effect",
        "a steady wind of 5.0 m/s from 233 deg",
        "a gust of 4.6 m/s at 7.0 s",
        f"initial.airspeed_m_s = {scenario.initial.airspeed_m_s:.3g} m/s",
    ]


def test_turbulence_in_words_is_the_strongest_of_its_window() -> None:
    """Without the steady wind, and all coefficients in one sentence; a flight without a log of the air has its values."""
    scenario = load_scenario(
        "scenarios/left_propeller_fail.yaml",
        {"failures": [], "requirements": [], "atmosphere": {
            "model": "dryden_8785c", "turbulence": "light", "wind_m_s": [1, 0, 0],
            "noise": {"from_s": 1, "until_s": 2, "w": [0.5]}}},
    )  # fmt: skip
    columns = ("time_s", "wind_north_m_s", "wind_east_m_s", "wind_down_m_s")
    rows = np.array([[0.0, 90, 0, 0], [1, 1, 0, 0], [1.5, 4, 4, 0], [2, 1, 2, 0], [3, 90, 0, 0]])
    paths = ["atmosphere.noise.w.0", "atmosphere.noise.w.0"]
    flown = Flight(scenario, Outcome.completed, 60.0, columns, rows)
    assert settings_of(flown, paths) == ["turbulence of up to 5.0 m/s between 1 and 2 s"]
    made_up = Flight(scenario, Outcome.completed, 60.0, (), np.zeros((0, 0)))
    assert settings_of(made_up, paths) == ["atmosphere.noise.w.0 = 0.5"]
