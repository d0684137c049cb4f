"""Run i is a pure function of (sweep, seed, i): however, wherever and in how many pieces a sweep is flown."""

from __future__ import annotations

import csv
import json
import random
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from sweep_files import SWEEP, command, journal_lines, run, same_rows, sorted_files, table, written
from sweep_flights import bad, quick

import testbed
from testbed.flight.folder import load as load_flight
from testbed.inputs.problems import BadInput
from testbed.sweeps.plan import load_sweep
from testbed.sweeps.statistics import proportion


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The small sweep, flown by one process without interruption."""
    folder = tmp_path_factory.mktemp("reference")
    testbed.sweep(written(folder), folder / "out", jobs=1)
    return folder / "out"


@pytest.mark.parametrize("jobs", [2, 4])
def test_any_number_of_workers_gives_the_same_bytes(reference: Path, tmp_path: Path, jobs: int) -> None:
    testbed.sweep(written(tmp_path), tmp_path / "out", jobs=jobs)
    same_rows(reference, tmp_path / "out")
    assert sorted_files(reference) == sorted_files(tmp_path / "out")
    assert (reference / "summary.json").read_bytes() == (tmp_path / "out/summary.json").read_bytes()


def test_variants_meet_the_same_failures(reference: Path) -> None:
    frame = table(reference)
    assert list(frame["run"]) == [i for i in range(12) for _ in range(2)]
    drawn = ["seed", "failures.0.at_s", "failures.0.value", "failures.0.actuator"]
    pairs = frame.groupby("run")[drawn].nunique()
    assert (pairs == 1).all().all()
    assert frame["seed"].nunique() == 12 and frame["seed"].min() > 1


def test_only_equals_the_row_and_keeps_the_flight(reference: Path, tmp_path: Path) -> None:
    result = run(tmp_path, "sweep", reference / "sweep.yaml", "--only", 5, "--out", "one")
    assert result.returncode in (0, 1), result.stderr
    lines = (reference / "results.csv").read_text().splitlines()
    rows = [line for line in lines if line.startswith("5,")]
    assert (tmp_path / "one/results.csv").read_text().splitlines()[1:] == rows
    assert result.stdout.splitlines()[1:3] == rows
    row = dict(zip(lines[0].split(","), rows[1].split(","), strict=True))
    flight = load_flight(tmp_path / "one/run-000005-fixed_inversion")
    assert flight.metrics["altitude_error_max_m"] == float(row["altitude_error_max_m"])
    again = testbed.fly(tmp_path / "one/run-000005-fixed_inversion/scenario.yaml")  # alone, without any sweep
    assert again.summary == flight.summary


def test_killed_at_random_instants_and_resumed(reference: Path, tmp_path: Path) -> None:
    sweep = written(tmp_path)
    arguments = command("sweep", sweep, "--out", "out", "--jobs", 2, "--resume", "--no-plots")
    instants = random.Random(5)
    kept: list[int] = []
    for _ in range(4):
        process = subprocess.Popen(arguments, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        began = len(kept)
        while process.poll() is None and journal_lines(tmp_path / "out") == (kept[-1] if kept else 0):
            time.sleep(0.01)  # let each attempt get somewhere, then pick an instant
        time.sleep(instants.uniform(0.0, 0.25))
        process.kill()
        process.communicate()
        kept.append(journal_lines(tmp_path / "out"))
        assert len(table(tmp_path / "out")) <= 24 and len(kept) == began + 1  # readable as it is
    assert kept == sorted(kept)
    done = subprocess.run(arguments, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 1, done.stderr
    same_rows(reference, tmp_path / "out")
    assert not list((tmp_path / "out").rglob(".*partial"))


def test_torn_and_damaged_lines_are_flown_again(reference: Path, tmp_path: Path) -> None:
    sweep = written(tmp_path)
    testbed.sweep(sweep, tmp_path / "out", jobs=2, figures=False)
    journal = tmp_path / "out/journal.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    lines[4] = lines[4].replace(b'"seed":', b'"sead":')
    journal.write_bytes(b"".join(lines[:-1]) + lines[-1][:37])
    testbed.sweep(sweep, tmp_path / "out", jobs=2, resume=True, figures=False)
    same_rows(reference, tmp_path / "out")
    assert journal.read_bytes().count(b"\n") == len(lines) + 1  # only the two were flown again


def test_resuming_flies_only_the_rest(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    testbed.sweep(sweep, tmp_path / "out", runs=5, fly=quick, figures=False)
    before = (tmp_path / "out/journal.jsonl").read_bytes()
    testbed.sweep(sweep, tmp_path / "out", runs=9, resume=True, fly=quick, figures=False)
    after = (tmp_path / "out/journal.jsonl").read_bytes()
    assert after.startswith(before) and after.count(b"\n") == 1 + 9 * 2
    testbed.sweep(sweep, tmp_path / "whole", runs=9, fly=quick, figures=False)
    same_rows(tmp_path / "whole", tmp_path / "out")


@pytest.mark.parametrize("sampling", ["sobol", "halton", "random"])
def test_a_longer_sweep_begins_with_the_shorter(tmp_path: Path, sampling: str) -> None:
    sweep = written(tmp_path)
    short, long = (load_sweep(sweep, [f"sampling={sampling}", f"runs={n}"]) for n in (1100, 2200))
    assert [short.task(k) for k in range(short.size)] == [long.task(k) for k in range(short.size)]
    assert long.task(4321) == load_sweep(sweep, [f"sampling={sampling}", "runs=3000"]).task(4321)


def test_seed_and_run_change_everything_drawn(tmp_path: Path) -> None:
    one, other = (load_sweep(written(tmp_path), [f"seed={seed}"]) for seed in (3, 4))
    tasks = [plan.task(2 * run) for plan in (one, other) for run in range(12)]
    for path in ("failures.0.at_s", "failures.0.value"):
        assert len({task.values[path] for task in tasks}) == 24
    assert len({task.seed for task in tasks}) == 24


CHANGES: list[tuple[list[str], str]] = [
    (["seed=4"], "sweep.yaml: seed: was 3, is now 4, expected an unchanged sweep"),
    (["sampling=halton"], "sweep.yaml: sampling: was 'sobol', is now 'halton', expected an unchanged sweep"),
    (["duration_s=2"], "sweep.yaml: scenario.duration_s: was 1, is now 2, expected an unchanged sweep"),
]


@pytest.mark.parametrize(("change", "words"), CHANGES)
def test_a_changed_sweep_is_not_resumed(tmp_path: Path, change: list[str], words: str) -> None:
    sweep = written(tmp_path)
    testbed.sweep(sweep, tmp_path / "out", settings=["runs=4"], fly=quick, figures=False)
    before = {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}
    with pytest.raises(BadInput) as refused:
        testbed.sweep(sweep, tmp_path / "out", settings=["runs=4", *change], resume=True, fly=quick)
    assert str(refused.value).endswith(words)
    with pytest.raises(BadInput, match=r"sweep\.yaml: runs: has 4 already, expected at least as many"):
        testbed.sweep(sweep, tmp_path / "out", runs=3, resume=True, fly=quick)
    assert before == {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}


def test_what_it_was_flown_with_must_be_the_same(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    testbed.sweep(sweep, tmp_path / "out", fly=quick, figures=False)
    with pytest.raises(BadInput, match="was begun with the function sweep_flights:quick"):
        testbed.sweep(sweep, tmp_path / "out", resume=True)
    with pytest.raises(BadInput, match="exists already, expected a new folder, or --resume"):
        testbed.sweep(sweep, tmp_path / "out", fly=quick)


def test_a_latin_hypercube_cannot_be_made_longer(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    settings = ["sampling=latin_hypercube"]
    testbed.sweep(sweep, tmp_path / "out", runs=6, settings=settings, fly=quick, figures=False)
    values = table(tmp_path / "out")["failures.0.value"].to_numpy()[::2]
    assert sorted((values * 6).astype(int)) == list(range(6))  # one in each stratum
    with pytest.raises(BadInput, match="a latin hypercube of 6 runs cannot be made longer"):
        testbed.sweep(sweep, tmp_path / "out", runs=8, settings=settings, fly=quick, resume=True)


def test_a_grid_has_every_combination(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    settings = ["sampling=grid", "levels=3", "vary={failures.0.value: {uniform: [0, 1]}, "
                "failures.0.actuator: {choice: [left_ruddervator, right_ruddervator]}}"]  # fmt: skip
    plan = load_sweep(sweep, [*settings, "runs=6"])
    drawn = [tuple(plan.draw(i).values()) for i in range(plan.runs)]
    actuators = ["left_ruddervator", "right_ruddervator"]
    assert drawn == [(value, actuator) for value in (0.0, 0.5, 1.0) for actuator in actuators]


def test_stopping_does_not_depend_on_workers(tmp_path: Path) -> None:
    text = SWEEP + "stop_when: {half_width: 0.15, confidence: 0.9}\n"
    tables = []
    for jobs in (1, 4):
        testbed.sweep(
            written(tmp_path, text), tmp_path / f"{jobs}", runs=200, jobs=jobs, fly=quick, figures=False
        )
        tables.append((tmp_path / f"{jobs}/results.csv").read_bytes())
    assert tables[0] == tables[1]
    summary = json.loads((tmp_path / "1/summary.json").read_text())
    assert 10 < summary["runs"] < 100
    runs, passed = summary["runs"], summary["variants"][0]["all_requirements"]["successes"]
    known = proportion(passed, runs, 0.9, method="exact")
    assert (known.high - known.low) / 2 <= 0.15
    rows = (tmp_path / "1/results.csv").read_text().splitlines()[1 : 1 + 2 * (runs - 1)]
    earlier = proportion(sum(",completed,True," in row for row in rows[::2]), runs - 1, 0.9, method="exact")
    assert (earlier.high - earlier.low) / 2 > 0.15  # and not a run later than it could


def test_cases_are_flown_as_written(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text(
        "failures.0.value,failures.0.at_s,seed\n0.25,0.5,77\n0.75,,78\n1,0.1,\n"
    )
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    frame = testbed.sweep(written(tmp_path, text), tmp_path / "out", fly=quick)
    assert list(frame["failures.0.value"]) == [0.25, 0.75, 1.0]
    assert list(frame["seed"][:2]) == [77, 78] and frame["seed"][2] > 1
    assert np.isnan(frame["failures.0.at_s"][1])  # as the scenario has it
    result = run(tmp_path, "sweep", "out/sweep.yaml", "--only", 1, "--out", "one")
    assert result.stdout.splitlines()[1].startswith("1,78,"), result.stderr


MISBEHAVIOURS: list[tuple[float, str, str]] = [
    (0.1, "error", "ValueError: the flight went wrong"),
    (0.2, "timeout", "no result within 2 s"),
    (0.3, "crashed", "the process was ended by signal 9 (SIGKILL)"),
    (0.4, "crashed", "the process was ended by exit status 7"),
    (2.0, "invalid", "failures.0.value: is 2.0, expected less than or equal to 1.5"),
]


def test_what_goes_wrong_is_a_row_with_its_reason(tmp_path: Path) -> None:
    values = [0.6, 0.1, 0.7, 0.2, 0.8, 0.3, 0.9, 0.4, 1.0]
    (tmp_path / "table.csv").write_text("failures.0.value\n" + "".join(f"{v}\n" for v in values))
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\ntime_limit_s: 2\n"
    for jobs in (1, 3):
        frame = testbed.sweep(
            written(tmp_path, text), tmp_path / f"{jobs}", jobs=jobs, fly=bad, figures=jobs == 1
        )
        assert list(frame["failures.0.value"]) == values
        for value, outcome, reason in MISBEHAVIOURS[:-1]:
            row = frame[frame["failures.0.value"] == value].iloc[0]
            assert (row["outcome"], row["reason"], row["passed"]) == (outcome, reason, False)
        assert list(frame[frame["outcome"] == "completed"]["failures.0.value"]) == [0.6, 0.7, 0.8, 0.9, 1.0]
    same_rows(tmp_path / "1", tmp_path / "3")


def test_a_rare_invalid_draw_is_a_row_with_its_reason(tmp_path: Path) -> None:
    """The normal's tail leaves the range in a few runs; the others fly."""
    text = SWEEP.replace("{uniform: [0, 1]}", "{normal: [1.2, 0.13]}")
    frame = testbed.sweep(written(tmp_path, text), tmp_path / "out", runs=120, fly=quick, figures=False)
    invalid = frame[frame["outcome"] == "invalid"]
    assert set(invalid["run"]) == set(frame[frame["failures.0.value"] > 1.5]["run"]) and len(invalid) > 0
    assert invalid["reason"].str.contains("failures.0.value: is .* expected less than or equal to 1.5").all()


def test_the_table_loads_with_dtypes_and_units(reference: Path) -> None:
    frame = table(reference)
    assert str(frame["outcome"].dtype) == str(frame["controller.type"].dtype) == "category"
    assert frame["passed"].dtype == bool and frame["run"].dtype == np.int64
    assert frame.attrs["units"]["altitude_error_max_m"] == "m"
    assert frame.attrs["units"]["airspeed_error_max_m_s"] == "m/s"
    assert frame.attrs["units"]["failures.0.at_s"] == "s" and frame.attrs["units"]["passed"] == ""
    text, binary = pd.read_csv(reference / "results.csv"), pd.read_parquet(reference / "results.parquet")
    assert list(text.columns) == list(binary.columns) == list(frame.columns)
    assert (text["altitude_error_max_m"] == binary["altitude_error_max_m"]).all()
    with (reference / "results.csv").open() as stream:
        assert all(row["reason"] == "" for row in csv.DictReader(stream))


@pytest.mark.parametrize(
    ("which", "keeps"), [("none", lambda p: p & ~p), ("failed", lambda p: ~p), ("all", lambda p: p | ~p)]
)
def test_logs_are_kept_as_asked(tmp_path: Path, which: str, keeps: Callable[[pd.Series], pd.Series]) -> None:
    frame = testbed.sweep(
        written(tmp_path), tmp_path / "out", runs=6, save_logs=which, fly=quick, figures=False
    )
    chosen = frame[keeps(frame["passed"])]
    names = {
        f"run-{run:06d}-{kind}.parquet"
        for run, kind in zip(chosen["run"], chosen["controller.type"], strict=True)
    }
    assert {f.name for f in (tmp_path / "out").glob("logs/*")} == names
    for name in names:
        assert len(pd.read_parquet(tmp_path / "out/logs" / name)) == 50


def test_a_function_that_workers_cannot_import_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="cannot be imported by a worker"):
        testbed.sweep(written(tmp_path), tmp_path / "out", fly=lambda scenario: quick(scenario))
