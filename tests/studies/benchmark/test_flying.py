"""A benchmark flown: the same bytes however it is flown; who raises, gives no number or hangs loses that draw and no other."""

from __future__ import annotations

import json
import math
import shutil
import signal
import sqlite3
import subprocess
import time
from contextlib import closing
from pathlib import Path

import pandas as pd
import pytest
from command_line import in_this_process
from suite_files import BAD, flown, same_results, tree, written
from sweep_files import command, finished, run

import testbed
from testbed.api import benchmark
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput
from testbed.studies.record import key_of


@pytest.fixture
def folder(flown_suite: Path) -> Path:
    return flown_suite


def test_a_row_for_each_draw_and_controller(folder: Path) -> None:
    rows = testbed.load(folder)
    assert isinstance(rows, pd.DataFrame)
    assert list(rows["draw"]) == [0, 0, 1, 1, 2, 2, 3, 3]
    assert list(rows["controller"]) == ["default", "fixed"] * 4
    assert ((rows["outcome"] == "completed") == rows["survived"]).all()
    assert rows["held"].any() and not rows["held"].all(), "else this shows little"
    assert rows["inside"].between(0.0, 1.0).all()
    assert (rows["inside"][rows["held"]] == 1.0).all(), "who holds is inside all the time"


@pytest.mark.nightly
def test_two_workers_give_the_bytes_of_one(suite: Path, folder: Path, tmp_path: Path) -> None:
    same_results(folder, flown(suite, tmp_path / "two", jobs=2))


@pytest.mark.nightly
def test_going_on_with_fewer_draws_gives_the_bytes_of_all(suite: Path, folder: Path, tmp_path: Path) -> None:
    flown(suite, tmp_path / "more", draws=2)
    same_results(folder, flown(suite, tmp_path / "more", resume=True))


def test_other_seeds_are_not_mixed(suite: Path, folder: Path, tmp_path: Path) -> None:
    shutil.copytree(folder, tmp_path / "out")
    with pytest.raises(BadInput, match="seed"):
        flown(suite, tmp_path / "out", seed=6, resume=True)


def test_flights_of_other_code_are_not_mixed(suite: Path, folder: Path, tmp_path: Path) -> None:
    begun = shutil.copytree(folder, tmp_path / "out") / "benchmark.yaml"
    law = yamlfile.read(begun).tree["law_sha256"]
    begun.write_text(begun.read_text().replace(law, "a" * 64))
    with pytest.raises(BadInput, match="law_sha256: was 'aaaa"):
        flown(suite, tmp_path / "out", resume=True)


def test_a_stopped_benchmark_is_told_over_its_whole_draws(folder: Path, tmp_path: Path) -> None:
    """With the code that is said in its folder, not that of who tells it."""
    stopped = tmp_path / "stopped"
    shutil.copytree(folder, stopped)
    said = stopped / "benchmark.yaml"
    law = yamlfile.read(said).tree["law_sha256"]
    said.write_text(said.read_text().replace("draws: 4", "draws: 9").replace(law, "a" * 64))
    with closing(sqlite3.connect(stopped / "flights.sqlite")) as database, database:
        database.execute("DELETE FROM flights WHERE key = ?", (key_of(7),))
    assert run(tmp_path, "report", stopped).returncode == 0
    summary = json.loads((stopped / "summary.json").read_text())
    assert (summary["draws"], summary["law_sha256"]) == (3, "a" * 64)
    pd.testing.assert_frame_equal(testbed.load(stopped), testbed.load(folder)[:6])


def test_flights_that_were_drawn_otherwise_are_not_told(folder: Path, tmp_path: Path) -> None:
    other = tmp_path / "other"
    shutil.copytree(folder, other)
    with closing(sqlite3.connect(other / "flights.sqlite")) as database, database:
        database.execute(
            """UPDATE flights SET record = replace(record, '"duration_s":2', '"duration_s":3')"""
        )
    done = run(tmp_path, "report", other)
    assert (done.returncode, done.stderr) == (2, "draw 0 was drawn otherwise than this version does\n")


def test_each_flight_is_a_test(folder: Path, tmp_path: Path) -> None:
    rows, plan = testbed.load(folder), benchmark.plan_of(folder)
    tests = list(benchmark.tests(plan, folder, json.loads((folder / "summary.json").read_text())))
    assert [not test.failure for test in tests] == list(rows["held"])
    lost = next(test for test in tests if test.failure)
    assert (
        lost.name.startswith("draw ")
        and f"--only {lost.name.split()[1].rstrip(',')} --controller" in lost.text
    )


@pytest.mark.nightly
def test_killed_and_resumed_gives_the_same_bytes(suite: Path, folder: Path, tmp_path: Path) -> None:
    options = ["benchmark", suite, "--draws", 4, "--seed", 5, "--jobs", 1, "--out", tmp_path / "out"]
    process = subprocess.Popen(command(*options), stdout=subprocess.DEVNULL)
    while finished(tmp_path / "out") < 2:
        assert process.poll() is None
        time.sleep(0.002)
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert run(tmp_path, *options, "--resume").returncode == 0
    same_results(folder, tmp_path / "out")


def test_a_draw_flown_alone_is_the_row_of_the_table(suite: Path, folder: Path, tmp_path: Path) -> None:
    said = ["--seed", 5, "--only", 2, "--controller", "default", "--no-plots", "--out", tmp_path / "alone"]
    done = run(tmp_path, "benchmark", suite, *said)
    flight = testbed.load(tmp_path / "alone" / "run-000002-default")
    row = testbed.load(folder).iloc[4]
    assert done.returncode == (0 if row["held"] else 1), done.stderr
    assert flight.metrics["altitude_error_max_m"] == pytest.approx(row["altitude_error_max_m"], rel=1e-12)


@pytest.mark.parametrize(
    "made_by", ["Raises", *(pytest.param(bad, marks=pytest.mark.nightly) for bad in ("NoNumber", "Hangs"))]
)
def test_who_does_not_fly_loses_alone(made_by: str, folder: Path, tmp_path: Path) -> None:
    (tmp_path / "bad.py").write_text(BAD)
    suite = written(tmp_path, tree() | {"time_limit_s": 20})
    own = f"bad={tmp_path / 'bad.py'}:{made_by}"
    rows = testbed.load(flown(suite, tmp_path / "out", draws=1, controllers=["default", own], jobs=1))
    default, bad = rows.iloc[0], rows.iloc[1]
    assert (bad["survived"], bad["held"], bad["inside"]) == (False, False, 0.0)
    reason = {"Raises": "ZeroDivisionError", "NoNumber": "finite", "Hangs": "no result within 20 s"}[made_by]
    assert reason in bad["reason"]
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert any(line.startswith("| `bad` | 1 | ") and reason in line for line in benchmark.answer(summary))
    assert default["altitude_error_max_m"] == testbed.load(folder).iloc[0]["altitude_error_max_m"]


def test_a_seed_of_a_word(suite: Path) -> None:
    from testbed.api.benchmark import prepare

    one, again, other = (prepare(suite, word=word)[0].study.seed for word in ("sun", "sun", "moon"))
    assert one == again != other
    with pytest.raises(BadInput, match="--word or --seed"):
        prepare(suite, word="sun", seed=1)


def test_what_the_summary_says(folder: Path) -> None:
    summary = json.loads((folder / "summary.json").read_text())
    rows = testbed.load(folder)
    for name in ("default", "fixed"):
        mine, score = rows[rows["controller"] == name], summary["scores"][name]
        assert score["held"]["estimate"] == mine["held"].mean()
        assert score["inside"]["estimate"] == pytest.approx(mine["inside"].mean())
        assert score["short_of_bound"]["estimate"] >= 0.0
    best = rows.groupby("draw")["held"].any().mean()
    assert summary["scores"]["best of all"]["held"]["estimate"] == best
    assert math.isclose(summary["scores"]["default"]["against_reference"]["inside"]["estimate"], 0.0)
    for groups in summary["by"].values():
        assert sum(group["draws"] for group in groups.values()) == 4


@pytest.mark.nightly
def test_merged_shards_have_the_bytes_of_all(suite: Path, folder: Path, tmp_path: Path) -> None:
    shard = ("benchmark", str(suite), "--draws", "4", "--seed", "5", "--jobs", "1", "--shard")
    for k in "12":
        assert in_this_process(tmp_path, *shard, f"{k}/2", "--out", k).returncode == 0
    part = in_this_process(tmp_path, "merge", "1", "--out", "part")
    assert part.returncode == 3 and "2 runs are missing: 1, 3" in part.stderr
    assert in_this_process(tmp_path, "merge", "1", "2", "--out", "both").returncode == 0
    for name in ("results.csv", "summary.json", "benchmark.yaml"):
        assert (tmp_path / "both" / name).read_bytes() == (folder / name).read_bytes(), name
    flown(suite, tmp_path / "more", draws=5)
    other = in_this_process(tmp_path, "merge", "1", "more", "--out", "other")
    assert other.returncode == 2 and "more: has another number of draws" in other.stderr
