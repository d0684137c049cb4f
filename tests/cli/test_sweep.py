"""`testbed sweep`: what it refuses, what it prints, and what it keeps when it is interrupted."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from command_line import Called, in_this_process, interruptible
from sweep_files import SWEEP, command, finished, fly_here, table, written

import testbed
from testbed.aircraft.shipped import data_root, files_in
from testbed.flight.folder import load as load_flight
from testbed.studies.folder import store
from testbed.studies.load import load_sweep


@pytest.mark.parametrize(
    "arguments",
    [["sweep"], ["sweep", "--only", "1"], ["validate"], ["sweep", "--cluster", "tcp://127.0.0.1:1"]],
)
def test_a_bad_sweep_is_refused_and_leaves_nothing(here: Path, called: Called, arguments: list[str]) -> None:
    file = written(here, SWEEP.replace("unif", "unfi", 2))
    status, out, err = called(arguments[0], file.name, *arguments[1:])
    assert status == 2
    assert err.splitlines() == [
        "small.yaml:10: vary.failures.0.at_s: unknown distribution 'unfiorm', did you mean uniform?",
        "small.yaml:11: vary.failures.0.value: unknown distribution 'unfiorm', did you mean uniform?",
    ]
    assert out == "" and [p.name for p in here.iterdir()] == [file.name]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--jobs", "0"], "--jobs: is 0, expected at least 1"),
        (["--jobs", "100000"], "--jobs: is 100000, expected at most 1000"),
        (["--runs", "0"], "--runs: is 0, expected at least 1"),
        (["--save-logs", "some"], "--save-logs: is 'some', expected none, failed or all"),
        (["--only", "12"], "--only: there is no run 12, expected 0 to 11"),
        (["--set", "bogus.path=1"], "--set bogus.path=1: bogus: unknown key, expected one of "),
    ],
)
def test_bad_options_are_refused(here: Path, called: Called, arguments: list[str], words: str) -> None:
    status, _, err = called("sweep", written(here).name, *arguments)
    assert status == 2 and err.startswith(words), err


def test_what_is_resumed_must_be_there(here: Path, called: Called) -> None:
    (here / "runs" / "mine").mkdir(parents=True)
    file = written(here).name
    said = (2, "", "runs/mnie: does not exist, expected a folder to resume, did you mean runs/mine?\n")
    assert called("sweep", file, "--out", "runs/mnie", "--resume") == said
    assert not (here / "runs" / "mnie").exists()


def test_the_shipped_sweeps_are_valid(here: Path, called: Called) -> None:
    for file in files_in("scenarios/sweeps"):
        name = str(file.relative_to(data_root()))
        assert called("validate", name) == (0, f"{name}: ok\n", "")


def test_a_sweep_folder_is_reported_without_flying(here: Path, called: Called) -> None:
    fly_here(load_sweep(written(here)), here / "out")
    status, out, err = called("report", "out")
    assert (status, err) == (1, "")  # not every flight has passed
    assert out.startswith("adaptive_inversion meets all requirements in ")
    assert "\nadaptive_inversion: 12 runs\n  " in out and "minus fixed_inversion: +0.000 (" in out
    assert {"summary.json", "report.html", "figures"} <= {path.name for path in (here / "out").iterdir()}


def test_a_sweep_folder_without_a_flight_is_refused(here: Path, called: Called) -> None:
    folder = fly_here(load_sweep(written(here)), here / "out")
    (folder / store.NAME).unlink()
    store.create(folder, {})
    assert called("report", "out") == (2, "", "out: no flight has finished in this sweep folder\n")


@pytest.mark.parametrize(
    ("name", "is_folder"), [("results.csv", True), (f"{store.NAME}-wal", True), ("logs", False)]
)
def test_what_is_in_the_way_is_bad_input(here: Path, called: Called, name: str, is_folder: bool) -> None:
    folder, file = here / "out", written(here)
    fly_here(load_sweep(file), folder)
    (folder / name).unlink(missing_ok=True)
    (folder / name).mkdir() if is_folder else (folder / name).touch()
    words = "is a folder, expected a file" if is_folder else "is a file, expected a folder"
    expected = (2, "", f"out/{name}: {words}\n")
    assert called("report", "out") == expected
    assert called("sweep", file.name, "--out", "out", "--resume", "--save-logs", "all")[0] == 2


@pytest.mark.nightly
def test_only_equals_the_row_and_keeps_the_flight(tmp_path: Path) -> None:
    testbed.sweep(written(tmp_path), tmp_path / "whole", runs=6, jobs=1, figures=False)
    reference = tmp_path / "whole"
    result = in_this_process(tmp_path, "sweep", str(reference / "sweep.yaml"), "--only", "5", "--out", "one")
    assert result.returncode in (0, 1), result.stderr
    lines = (reference / "results.csv").read_text().splitlines()
    rows = [line for line in lines if line.startswith("5,")]
    assert (tmp_path / "one/results.csv").read_text().splitlines()[1:] == rows
    assert result.stdout.count("Worst since ") == 2  # the story of each variant's flight
    assert (tmp_path / "one/run-000005-fixed_inversion/report.html").is_file()
    row = dict(zip(lines[0].split(","), rows[1].split(","), strict=True))
    flight = load_flight(tmp_path / "one/run-000005-fixed_inversion")
    assert flight.metrics["altitude_error_max_m"] == float(row["altitude_error_max_m"])
    again = testbed.fly(tmp_path / "one/run-000005-fixed_inversion/scenario.yaml")  # alone, without any sweep
    assert again.summary == flight.summary


def test_one_variant_alone_is_a_normal_run_folder(here: Path, called: Called) -> None:
    sweep = written(here)
    status, out, err = called("sweep", sweep.name, "--only", "5", "--variant", "pid")
    assert (status, out) == (2, "")
    assert (
        err == "--variant: there is no variant 'pid', expected one of adaptive_inversion, fixed_inversion\n"
    )
    status, out, _ = called("sweep", sweep.name, "--only", "5", "--variant", "fixed_inversion", "--no-plots")
    assert status in (0, 1) and out.endswith("wrote runs/small-run-5-fixed-inversion\n")
    folder = here / "runs/small-run-5-fixed-inversion"
    assert {p.name for p in folder.iterdir()} == {"scenario.yaml", "summary.json", "log.csv", "report.html"}
    assert load_flight(folder).controller == "fixed_inversion"


def test_a_run_alone_that_has_no_result_says_why(here: Path, called: Called) -> None:
    set_ = ["--set", "time_limit_s=0.01"]
    status, out, err = called(
        "sweep", written(here).name, "--only", "5", *set_, "--no-plots", "--out", "alone"
    )
    assert (status, out) == (1, "wrote alone\n")
    assert err == "WARNING: run 5 has no result: no result within 0.01 s\n"


def test_a_variant_is_of_one_run(here: Path, called: Called) -> None:
    expected = (2, "", "--variant: is for one run, expected --only I beside it\n")
    assert called("sweep", written(here).name, "--variant", "fixed_inversion") == expected


@pytest.mark.nightly
def test_ctrl_c_keeps_what_had_finished(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    arguments = command("sweep", sweep, "--out", "out", "--runs", 400, "--jobs", 2, "--no-plots")
    process = subprocess.Popen(
        arguments,
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=interruptible,
    )
    while finished(tmp_path / "out") < 9:
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to every process of the group
    out, err = process.communicate()
    assert process.returncode == 130
    assert "interrupted" in err and "of 800 flights are kept, --resume flies the rest" in err
    assert "Traceback" not in err and out == ""
    kept = finished(tmp_path / "out")
    assert 9 <= kept == len(table(tmp_path / "out"))
    report = in_this_process(tmp_path, "report", "out")  # of what there is
    assert report.returncode == 1 and "adaptive_inversion" in report.stdout
