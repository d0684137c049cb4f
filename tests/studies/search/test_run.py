"""However and in how many pieces a search is flown, its bytes are the same; what it refuses, and what it says it did not find."""

from __future__ import annotations

import json
import random
import sqlite3
import subprocess
import time
from contextlib import closing
from pathlib import Path

import pytest
import search_flights
from search_files import SEARCH, searched, written
from search_flights import BETA, DESIGN, gusty
from sweep_files import finished, script, stored

import testbed
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store

FILES = ("results.csv", "results.parquet", "summary.json", "found.yaml", "search.yaml", "found/log.csv")


def same_bytes(one: Path, other: Path) -> None:
    for name in FILES:
        assert (one / name).read_bytes() == (other / name).read_bytes(), name


def test_the_nearest_failure_is_found_where_it_is_known(tmp_path: Path) -> None:
    result = searched(written(tmp_path), tmp_path / "out")
    point = result.summary["parts"][0]["point"]
    assert result.found and result.distance == pytest.approx(BETA, rel=0.02)
    for j, coordinate in enumerate(DESIGN):
        known = point[f"atmosphere.wind_m_s.{j}"]
        assert known["coordinate"] == pytest.approx(coordinate, abs=0.3)
        assert known["value"] == 2.0 * known["coordinate"]
    table = result.table
    assert len(table) == result.summary["flights"] <= 300
    assert list(table["run"]) == list(range(len(table)))
    nearest = table[~table["passed"]]["distance"].min()
    assert nearest == result.distance


def test_the_scenario_found_flies_again_to_the_same_log(tmp_path: Path) -> None:
    searched(written(tmp_path), tmp_path / "out")
    again = testbed.load(tmp_path / "out/found").scenario  # type: ignore[union-attr]
    assert gusty(again).data.tobytes() == testbed.load(tmp_path / "out/found").data.tobytes()  # type: ignore[union-attr]
    assert not gusty(again).passed


@pytest.mark.nightly
def test_two_workers_and_a_search_that_went_on_give_the_same_bytes(tmp_path: Path) -> None:
    file = written(tmp_path)
    searched(file, tmp_path / "one")
    testbed.search(file, tmp_path / "two", fly=gusty, jobs=2, figures=False)
    same_bytes(tmp_path / "one", tmp_path / "two")
    with closing(sqlite3.connect(tmp_path / "two" / store.NAME)) as database, database:
        database.execute("DELETE FROM flights WHERE rowid > 60")
    testbed.search(file, tmp_path / "two", fly=gusty, jobs=1, figures=False, resume=True)
    same_bytes(tmp_path / "one", tmp_path / "two")


@pytest.mark.nightly
def test_killed_at_random_instants_and_resumed(tmp_path: Path) -> None:
    file = written(tmp_path, SEARCH.replace("budget: 300", "budget: 60"))
    searched(file, tmp_path / "whole", fly="slow")
    call = f"{str(file)!r}, {str(tmp_path / 'out')!r}, jobs=2, resume=True, figures=False, fly=search_flights.slow"
    arguments = script(f"import search_flights\ntestbed.search({call})")
    instants, before = random.Random(4), 0
    for _ in range(2):
        process = subprocess.Popen(arguments, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while process.poll() is None and finished(tmp_path / "out") <= before:
            time.sleep(0.01)
        time.sleep(instants.uniform(0.0, 0.3))
        process.kill()
        process.communicate()
        before = finished(tmp_path / "out")
    assert 0 < before < 60
    done = subprocess.run(arguments, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    same_bytes(tmp_path / "whole", tmp_path / "out")


def test_going_on_flies_only_what_is_missing(tmp_path: Path) -> None:
    file = written(tmp_path)
    searched(file, tmp_path / "out", "budget=100")
    before = stored(tmp_path / "out")
    searched(file, tmp_path / "out", "budget=100", resume=True)
    assert stored(tmp_path / "out") == before


@pytest.mark.parametrize(("change", "words"), [
    ("seed=4", "seed: was 3, is now 4, expected an unchanged search"),
    ("vary.atmosphere.wind_m_s.0={normal: [0, 1]}", "vary.atmosphere.wind_m_s.0.normal: was [0, 2], is now [0, 1]"),
    ("goal=probability", "goal: was 'smallest', is now 'probability'"),
])  # fmt: skip
def test_another_search_does_not_go_on_in_its_folder(tmp_path: Path, change: str, words: str) -> None:
    file = written(tmp_path)
    searched(file, tmp_path / "out", "budget=20")
    with pytest.raises(BadInput) as refused:
        searched(file, tmp_path / "out", change, resume=True)
    assert words in str(refused.value)


def test_what_cannot_be_broken_is_not_found(tmp_path: Path) -> None:
    result = searched(written(tmp_path), tmp_path / "out", "budget=60", fly="unbreakable")
    (part,) = result.summary["parts"]
    assert not result.found and result.distance is None and not (tmp_path / "out/found.yaml").exists()
    # What n draws without a failure allow with 95 % confidence (Clopper and Pearson 1934).
    assert part["upper_bound"] == pytest.approx(1.0 - 0.05 ** (1.0 / part["independent"]))
    assert repr(result).startswith(
        f"Not found in {part['flights']} flights. {part['independent']} of them were independent"
    )


def test_what_is_broken_at_the_origin_is_refused_and_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="the flight at the origin of the search breaks 'held' already"):
        searched(written(tmp_path), tmp_path / "out", "vary.atmosphere.wind_m_s.0={normal: [9, 1]}")
    assert not (tmp_path / "out").exists()


def test_a_variant_that_is_broken_at_the_origin_has_distance_0(tmp_path: Path) -> None:
    compared = "compare={atmosphere.wind_m_s.2: [0, 1]}"
    one = searched(written(tmp_path), tmp_path / "one", compared, fly="broken_downwards")
    assert [variant["distance"] for variant in one.summary["variants"]] == [
        pytest.approx(BETA, rel=0.02),
        0.0,
    ]
    assert "the flight at the origin breaks 'held' already" in repr(one)


def test_flights_without_a_result_are_refused_with_the_reason(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="has no result: ValueError: it went wrong"):
        searched(written(tmp_path), tmp_path / "out", fly="lost")
    assert not (tmp_path / "out").exists()


def test_refused_by_a_worker_too(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="has no result: ValueError: it went wrong"):
        testbed.search(written(tmp_path), tmp_path / "out", fly=search_flights.lost, jobs=1)
    assert not (tmp_path / "out").exists()


@pytest.mark.nightly
def test_variants_meet_the_same_points_and_choices_are_searches_of_their_own(tmp_path: Path) -> None:
    settings = ["goal=probability", "method=plain", "cov=1", "budget=60", "vary.atmosphere.wind_m_s.0={normal: [0, 6]}",
                "compare={controller.type: [adaptive_inversion, pid]}",
                "vary.failures.0.value={choice: [0.1, 0.2], weights: [1, 3]}"]  # fmt: skip
    result = testbed.search(
        written(tmp_path), tmp_path / "out", fly=gusty, jobs=1, settings=settings, figures=False
    )
    labels = [part["label"] for part in result.summary["parts"]]
    assert labels == [f"{c}, failures.0.value {v}" for c in ("adaptive_inversion", "pid") for v in (0.1, 0.2)]
    first, second = (v["probability"]["estimate"] for v in result.summary["variants"])
    assert first == second > 0.0  # these flights do not depend on the controller
    parts = result.summary["parts"][:2]
    total = sum(part["weight"] * part["probability"]["estimate"] for part in parts)
    assert [part["weight"] for part in parts] == [0.25, 0.75] and first == pytest.approx(total)
    assert json.loads((tmp_path / "out/summary.json").read_text()) == result.summary
