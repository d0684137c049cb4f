"""A run folder is written whole or not at all, never over another, and reads back to the last bit."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from command_line import ROOT
from handmade import make_flight

from testbed.flight.flight import Outcome
from testbed.flight.folder import FolderExists, load, write_run_folder
from testbed.inputs.problems import BadInput

CONTENTS = ["log.csv", "scenario.yaml", "summary.json"]


def test_reads_back_exactly(tmp_path: Path) -> None:
    flight = make_flight()
    folder = write_run_folder(flight, tmp_path / "deep" / "run")
    again = load(folder)
    assert sorted(p.name for p in folder.iterdir()) == CONTENTS
    assert again.columns == flight.columns
    assert again.data.tobytes() == flight.data.tobytes()
    assert again.scenario == flight.scenario
    assert again.summary == flight.summary
    assert again.outcome is Outcome.completed
    pd.testing.assert_frame_equal(again.log, flight.log)
    assert list(pd.read_csv(folder / "log.csv").columns) == list(flight.columns)


def test_a_changed_log_is_noticed(tmp_path: Path) -> None:
    """The negative control of the exact reading: one unit in the last place of one number."""
    flight = make_flight()
    folder = write_run_folder(flight, tmp_path / "run")
    text = (folder / "log.csv").read_text()
    value = repr(float(flight.data[7, 2]))
    assert value in text
    (folder / "log.csv").write_text(text.replace(value, repr(float(np.nextafter(flight.data[7, 2], np.inf)))))
    assert load(folder).data.tobytes() != flight.data.tobytes()


def test_two_folders_of_one_flight_are_identical(tmp_path: Path) -> None:
    one = write_run_folder(make_flight(), tmp_path / "one")
    time.sleep(0.01)
    two = write_run_folder(make_flight(), tmp_path / "two")
    for name in CONTENTS:
        assert (one / name).read_bytes() == (two / name).read_bytes()


@pytest.mark.parametrize("kind", ["folder", "empty folder", "file", "dangling link"])
def test_nothing_is_overwritten(tmp_path: Path, kind: str) -> None:
    out = tmp_path / "run"
    if kind == "file":
        out.write_text("mine")
    elif kind == "dangling link":
        out.symlink_to(tmp_path / "nowhere")
    else:
        out.mkdir()
    if kind == "folder":
        (out / "log.csv").write_text("mine")
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(FolderExists, match="exists already"):
        write_run_folder(make_flight(), out)
    assert sorted(tmp_path.rglob("*")) == before
    assert kind != "folder" or (out / "log.csv").read_text() == "mine"


def test_whole_or_not_at_all(tmp_path: Path) -> None:
    def broken(folder: Path) -> None:
        assert sorted(p.name for p in folder.iterdir()) == CONTENTS
        raise RuntimeError("no figure")

    with pytest.raises(RuntimeError):
        write_run_folder(make_flight(), tmp_path / "run", broken)
    assert list(tmp_path.iterdir()) == []


def test_killed_while_writing(tmp_path: Path) -> None:
    """A real process, killed when all but the name is written: nothing has the name."""
    program = (
        "import os, signal, sys; sys.path.insert(0, sys.argv[2]); from handmade import make_flight\n"
        "from testbed.flight.folder import write_run_folder\n"
        "write_run_folder(make_flight(), sys.argv[1], lambda _: os.kill(os.getpid(), signal.SIGKILL))"
    )
    command = [sys.executable, "-c", program, str(tmp_path / "run"), str(ROOT / "tests" / "support")]
    assert subprocess.run(command, check=False).returncode == -signal.SIGKILL
    assert not (tmp_path / "run").exists()
    write_run_folder(make_flight(), tmp_path / "run")


def test_the_folder_has_usual_permissions(tmp_path: Path) -> None:
    plain = tmp_path / "plain"
    plain.mkdir()
    folder = write_run_folder(make_flight(), tmp_path / "run")
    assert folder.stat().st_mode == plain.stat().st_mode


def test_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(BadInput, match="cannot be written"):
        write_run_folder(make_flight(), tmp_path / "file" / "run")


def test_a_folder_of_an_earlier_version_reads_back(tmp_path: Path) -> None:
    """Its summary has no warnings, and does not say who flew."""
    folder = write_run_folder(make_flight(), tmp_path / "run")
    summary = json.loads((folder / "summary.json").read_text())
    del summary["warnings"]
    (folder / "summary.json").write_text(json.dumps(summary))
    again = load(folder)
    assert again.passed and list(again.warnings) == [] and again.controller == "adaptive_inversion"


@pytest.mark.parametrize("name", CONTENTS)
@pytest.mark.parametrize("damage", ["missing", "empty", "garbage"])
def test_a_damaged_folder_is_bad_input(tmp_path: Path, name: str, damage: str) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    if damage == "missing":
        os.remove(folder / name)
    else:
        (folder / name).write_bytes(b"" if damage == "empty" else b"\x00{,\n1,2,3,x\n")
    with pytest.raises(BadInput):
        load(folder)


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (lambda data: data.decode().encode("utf-16"), "is no text in UTF-8, from byte 0 on"),
        (lambda data: data[: data.rfind(b",")], "has [0-9]+ values in .*line.*, and [0-9]+ columns"),
        (lambda _: b"", "cannot be read: Empty CSV file"),
        (lambda data: data.replace(b",", b";"), "cannot be read: [^\n]{1,200}, expected"),
    ],
    ids=["another encoding", "cut off", "empty", "another separator"],
)
def test_a_damaged_log_is_refused_in_one_short_sentence(
    tmp_path: Path, damage: Callable[[bytes], bytes], words: str
) -> None:
    file = write_run_folder(make_flight(), tmp_path / "run") / "log.csv"
    file.write_bytes(damage(file.read_bytes()))
    with pytest.raises(BadInput, match=f"log.csv: {words}") as caught:
        load(file.parent)
    assert len(str(caught.value)) < 500 and "\n" not in str(caught.value)


def test_a_mark_of_the_byte_order_is_no_damage(tmp_path: Path) -> None:
    """An editor may leave one."""
    file = write_run_folder(make_flight(), tmp_path / "run") / "log.csv"
    file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())
    assert load(file.parent).data.tobytes() == make_flight().data.tobytes()


@pytest.mark.parametrize(
    ("key", "wrong"),
    [("events", None), ("events", [3]), ("requirements", 7), ("requirements", {"x": {}}), ("metrics", []),
     ("metrics", {"x": {}}), ("warnings", 7), ("warnings", [None]), ("end_time_s", None), ("end_time_s", True)],
)  # fmt: skip
def test_a_summary_of_another_shape_is_bad_input(tmp_path: Path, key: str, wrong: object) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    summary = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps({**summary, key: wrong}))
    with pytest.raises(BadInput, match=rf"summary\.json: {key}(\.\w+)?: is "):
        load(folder)


def test_a_scenario_of_a_longer_flight_is_bad_input(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    file = folder / "scenario.yaml"
    longer = re.sub(r"(?m)^duration_s: .*$", "duration_s: 500.0", file.read_text())
    file.write_text(longer)
    with pytest.raises(BadInput, match=r"end_time_s: is .*, expected 500, as the scenario says"):
        load(folder)


def test_a_summary_without_end_is_bad_input(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    (folder / "summary.json").write_text("[" * 100_000)
    with pytest.raises(BadInput, match="is nested too deeply"):
        load(folder)
    os.truncate(folder / "summary.json", 10**9)
    with pytest.raises(BadInput, match=r"summary\.json: has more than 20 MB"):
        load(folder)


def test_reading_needs_no_simulator(tmp_path: Path) -> None:
    folder = write_run_folder(make_flight(), tmp_path / "run")
    program = (
        "import sys, testbed; flight = testbed.load(sys.argv[1]); assert flight.summary and len(flight.log)\n"
        "assert not {'jsbsim', 'numba', 'testbed.plant.jsbsim', 'testbed.simulation'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program, str(folder)], check=True)
