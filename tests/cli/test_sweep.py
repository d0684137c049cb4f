"""`testbed sweep` as a process: what it refuses, prints, keeps when it is interrupted."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path

import pytest
from sweep_files import SWEEP, command, journal_lines, run, table, written

import testbed
from testbed.flight.folder import load as load_flight


@pytest.mark.parametrize(
    "arguments",
    [["sweep"], ["sweep", "--only", "1"], ["validate"], ["sweep", "--cluster", "tcp://127.0.0.1:1"]],
)
def test_the_command_line_says_it_and_leaves_nothing(tmp_path: Path, arguments: list[str]) -> None:
    file = written(tmp_path, SWEEP.replace("unif", "unfi", 2))
    result = run(tmp_path, arguments[0], file.name, *arguments[1:])
    assert result.returncode == 2
    assert result.stderr.splitlines() == [
        "small.yaml:10: vary.failures.0.at_s: unknown distribution 'unfiorm', did you mean uniform?",
        "small.yaml:11: vary.failures.0.value: unknown distribution 'unfiorm', did you mean uniform?",
    ]
    assert result.stdout == "" and [p.name for p in tmp_path.iterdir()] == [file.name]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--jobs", "0"], "--jobs: is 0, expected at least 1"),
        (["--runs", "0"], "--runs: is 0, expected at least 1"),
        (["--save-logs", "some"], "--save-logs: is 'some', expected none, failed or all"),
        (["--only", "12"], "--only: there is no run 12, expected 0 to 11"),
        (["--set", "bogus.path=1"], "--set bogus.path=1: bogus: unknown key, expected one of "),
    ],
)
def test_bad_options_are_refused(tmp_path: Path, arguments: list[str], words: str) -> None:
    result = run(tmp_path, "sweep", written(tmp_path).name, *arguments)
    assert result.returncode == 2 and result.stderr.startswith(words), result.stderr


def test_the_shipped_sweeps_are_valid(tmp_path: Path) -> None:
    result = run(tmp_path, "validate", "scenarios/sweeps/left_tail_monte_carlo.yaml")
    assert (result.returncode, result.stderr) == (0, "")


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
    )
    while journal_lines(tmp_path / "out") < 10:
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to every process of the group
    out, err = process.communicate()
    assert process.returncode == 130
    assert "interrupted" in err and "of 800 flights are kept, --resume flies the rest" in err
    assert "Traceback" not in err and out == ""
    kept = journal_lines(tmp_path / "out") - 1
    assert 9 <= kept == len(table(tmp_path / "out"))
    report = run(tmp_path, "report", "out")  # of what there is
    assert report.returncode == 1 and "adaptive_inversion" in report.stdout
