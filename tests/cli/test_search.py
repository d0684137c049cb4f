"""`testbed search`: what it refuses, what it prints, its exit status, and what it keeps when it is interrupted."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import Called, in_this_process, interruptible, testbed
from search_files import REAL, SEARCH, searched, written
from sweep_files import command, finished
from sweep_files import written as sweep_written

from testbed.aircraft.shipped import data_root, files_in

Result = subprocess.CompletedProcess[str]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--jobs", "0"], "--jobs: is 0, expected at least 1"),
        (["--goal", "least"], "--goal: is 'least', expected smallest or probability"),
        (["--budget", "1"], "--budget 1: budget: is 1, expected greater than or equal to 20"),
        (["--set", "bogus.path=1"], "--set bogus.path=1: bogus: unknown key, expected one of "),
        pytest.param(
            ["--cluster", "tcp://127.0.0.1:1"],
            "--cluster: no cluster answers at tcp://127.0.0.1:1",
            marks=pytest.mark.nightly,  # it waits for 8 s
        ),
    ],
)
def test_bad_options_are_refused_and_leave_nothing(
    here: Path, called: Called, arguments: list[str], words: str
) -> None:
    status, out, err = called("search", written(here).name, *arguments)
    assert status == 2 and words in err and out == "", err
    assert [path.name for path in here.iterdir()] == ["gusty.yaml"]


def test_a_search_is_validated_by_its_goal(here: Path, called: Called) -> None:
    assert called("validate", written(here).name) == (0, "gusty.yaml: ok\n", "")
    status, _, err = called("validate", written(here, SEARCH.replace("wind_m_s.1", "wnd_m_s.1")).name)
    assert status == 2 and "gusty.yaml:13: atmosphere.wnd_m_s: unknown key" in err
    for file in files_in("scenarios/searches"):
        name = str(file.relative_to(data_root()))
        assert called("validate", name) == (0, f"{name}: ok\n", "")


def test_a_finished_search_is_reported_without_flying(here: Path, called: Called) -> None:
    searched(written(here), here / "out")
    status, out, err = called("report", "out")
    assert (status, err) == (1, "") and out.startswith("The smallest failure found: a steady wind of ")
    assert {"report.html", "figures"} <= {path.name for path in (here / "out").iterdir()}
    (here / "out/summary.json").write_text("{")
    status, out, err = called("report", "out")
    assert (status, out) == (2, "") and err.startswith("out/summary.json: cannot be read")
    assert "expected `testbed search --resume`" in err
    (here / "out/results.parquet").unlink()
    assert called("report", "out")[0] == 2


def test_a_search_and_a_sweep_do_not_go_on_in_each_others_folder(here: Path, called: Called) -> None:
    search, sweep = written(here).name, sweep_written(here).name
    for name, words, kind in (
        ("search.yaml", ["sweep", sweep], "sweep"),
        ("sweep.yaml", ["search", search], "search"),
    ):
        folder = here / kind
        folder.mkdir()
        (folder / name).write_text("a: 1")
        (folder / "journal.jsonl").write_text("")
        status, _, err = called(*words, "--out", kind, "--resume")
        assert status == 2 and f"{kind}: is not the folder of a {kind}" in err, err
        assert sorted(path.name for path in folder.iterdir()) == ["journal.jsonl", name]


@pytest.mark.nightly
def test_the_answer_and_the_exit_status(tmp_path: Path) -> None:
    def search(
        at_most: float, out: str, *options: str, call: Callable[..., Result] = in_this_process
    ) -> Result:
        file = written(tmp_path, REAL.replace("at_most: 1", f"at_most: {at_most}"))
        return call(tmp_path, "search", str(file), "--out", out, "--no-plots", "--jobs", "1", *options)

    found = search(0.38, "found", call=testbed)
    assert found.returncode == 1, found.stderr
    assert "The smallest failure found: a steady wind of " in found.stdout
    assert "It breaks 'held'." in found.stdout
    again = in_this_process(tmp_path, "run", "found/found.yaml", "--out", "again", "--no-plots")
    assert again.returncode == 1
    assert (tmp_path / "again/log.csv").read_bytes() == (tmp_path / "found/found/log.csv").read_bytes()
    none = search(500, "none")
    assert none.returncode == 0 and "Not found in 24 flights." in none.stdout
    refused = search(0.1, "refused")
    assert refused.returncode == 2 and "breaks 'held' already" in refused.stderr
    assert not (tmp_path / "refused").exists()
    likely = search(0.38, "likely", "--goal", "probability", "--set", "method=plain")
    assert likely.returncode == 0
    assert json.loads((tmp_path / "likely/summary.json").read_text())["goal"] == "probability"


@pytest.mark.nightly
def test_ctrl_c_keeps_the_flights(tmp_path: Path) -> None:
    file = written(tmp_path, REAL.replace("budget: 24", "budget: 2000"))
    process = subprocess.Popen(
        command("search", file, "--out", "out"), cwd=tmp_path, stderr=subprocess.PIPE, text=True, preexec_fn=interruptible,
    )  # fmt: skip
    while process.poll() is None and finished(tmp_path / "out") < 4:
        time.sleep(0.05)
    os.kill(process.pid, signal.SIGINT)
    _, err = process.communicate()
    assert process.returncode == 130 and "of at most 2000 flights are kept, --resume flies the rest" in err
    assert finished(tmp_path / "out") >= 4
