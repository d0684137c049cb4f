"""The database of flights: whole after a kill, read without a trace, and refused when it is none of ours."""

from __future__ import annotations

import json
import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
import tracemalloc
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pandas as pd
import pytest
from sweep_files import fly_here, here, table, written

from testbed.cli.commands import main
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store
from testbed.studies.folder.begin import begin
from testbed.studies.folder.table import records, write
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.studies.record import CHECKED, Record, key_of

RECORD = Record(
    3, 1, 2**70, {"a": 0.1 + 0.2, "b": [None, {"c": "ü \n"}], "d": -0.0}, "completed", True, "", 1e-300,
    -float("inf"), {"m": 5e-324, "n": float("nan")}, ((False, float("nan"), 1 / 3),),
)  # fmt: skip


def test_a_record_reads_back_as_it_was(tmp_path: Path) -> None:
    with closing(new(tmp_path)) as flights:
        flights.add(b"k", RECORD, b"\0history")
        assert repr(flights.record(b"k")) == repr(RECORD)
        assert flights.history(b"k") == b"\0history" and flights.history(b"none") == b""
        assert b"k" in flights and b"none" not in flights and len(flights) == 1
    assert repr(read(tmp_path)) == repr([(b"k", RECORD)])


def test_numbers_keep_every_digit() -> None:
    draw = random.Random(1)
    numbers = [draw.uniform(-1, 1) * 10 ** draw.randint(-300, 300) for _ in range(20_000)]
    record = replace(
        RECORD, values={"x": numbers}, metrics=dict(zip(map(str, numbers[:500]), numbers, strict=False))
    )
    again = CHECKED.validate_json(json.dumps(vars(record)), strict=True)
    assert again.values["x"] == numbers and list(again.metrics.values()) == numbers[:500]
    with pytest.raises(ValueError, match="at most 500"):
        CHECKED.validate_json(json.dumps({**vars(record), "metrics": dict.fromkeys(map(str, numbers), 1.0)}))


def new(folder: Path) -> store.Store:
    store.create(folder, {"fly": "f"})
    return store.opened(folder)


def read(folder: Path) -> list[tuple[bytes, Record]]:
    with store.reading(folder) as flights:
        return list(flights.records())


@pytest.mark.parametrize(
    ("which", "keeps"), [("none", lambda p: p & ~p), ("failed", lambda p: ~p), ("all", lambda p: p | ~p)]
)
def test_logs_are_kept_as_asked(tmp_path: Path, which: str, keeps: Callable[[pd.Series], pd.Series]) -> None:
    plan = load_sweep(written(tmp_path), ["runs=6"])
    frame = table(fly_here(plan, tmp_path / "out", save_logs=which))
    chosen = frame[keeps(frame["passed"])]
    names = {
        f"run-{run:06d}-{kind}.parquet"
        for run, kind in zip(chosen["run"], chosen["controller.type"], strict=True)
    }
    assert {f.name for f in (tmp_path / "out").glob("logs/*")} == names
    for name in names:
        assert len(pd.read_parquet(tmp_path / "out/logs" / name)) == 50


def test_two_processes_do_not_fly_one_folder(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    flights = begin(tmp_path / "out", plan, "f", resume=False)
    with pytest.raises(BadInput, match="is being flown by another process"):
        begin(tmp_path / "out", plan, "f", resume=True)
    flights.close()
    begin(tmp_path / "out", plan, "f", resume=True).close()


WRITER = """
import sys
from pathlib import Path
from testbed.studies.folder import store
from testbed.studies.record import Record, key_of
flights = store.opened(Path(sys.argv[1]))
print("ready", flush=True)
for k in range(len(flights), 100_000):
    flights.add(k.to_bytes(8, "big"), Record(k, 0, 1, {"text": "x" * (k % 5000)}, "completed", True), bytes(k % 3000))
    print(k, flush=True)
"""


@pytest.mark.nightly
def test_what_was_stored_outlasts_a_kill_at_any_moment(tmp_path: Path) -> None:
    """Whatever a flight's size, and whether its page had been moved into the file or not."""
    store.create(tmp_path, {})
    instants, told = random.Random(7), -1
    for _ in range(6):
        process = subprocess.Popen(
            [sys.executable, "-c", WRITER, tmp_path], stdout=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(instants.uniform(0.0, 0.15))
        process.send_signal(signal.SIGKILL)
        lines = process.stdout.read().splitlines(keepends=True)
        told = max([told, *(int(line) for line in lines if line.endswith("\n"))])
        found = read(tmp_path)
        assert [int.from_bytes(key, "big") for key, _ in found] == list(range(len(found)))
        assert len(found) in (told + 1, told + 2)  # the last one may not have been told any more
        told = len(found) - 1
        assert all(len(record.values["text"]) == k % 5000 for k, (_, record) in enumerate(found))
    store.opened(tmp_path).close()
    assert [file.name for file in tmp_path.iterdir()] == [store.NAME]  # one plain file


def test_reading_leaves_no_trace(tmp_path: Path) -> None:
    """Neither in a folder that is finished, nor in one that was killed, nor in one that is being flown."""
    flights = new(tmp_path)
    flights.add(b"k", RECORD)
    names = {store.NAME, f"{store.NAME}-wal"}
    content = {name: (tmp_path / name).read_bytes() for name in names}
    assert len(read(tmp_path)) == 1 and {file.name for file in tmp_path.iterdir()} == names
    flights.close()
    assert len(read(tmp_path)) == 1 and [file.name for file in tmp_path.iterdir()] == [store.NAME]
    killed = tmp_path / "killed"
    killed.mkdir()
    for name, data in content.items():
        (killed / name).write_bytes(data)
        (killed / name).chmod(0o444)
    killed.chmod(0o555)
    try:
        assert len(read(killed)) == 1
    finally:
        killed.chmod(0o755)
    assert {name: (killed / name).read_bytes() for name in names} == content
    assert len(list(killed.iterdir())) == 2


def change(folder: Path, *statements: str) -> None:
    with closing(sqlite3.connect(folder / store.NAME)) as database, database:
        for statement in statements:
            database.execute(statement)


DEFECTS = [
    ("PRAGMA user_version = 9", "is not of this version of testbed"),
    ("PRAGMA application_id = 9", "is not of this version of testbed"),
    ("CREATE TABLE more (a)", "has other tables"),
    ("CREATE VIEW more AS SELECT 1", "has other tables"),
    ("CREATE TRIGGER t AFTER INSERT ON flights BEGIN DELETE FROM flights; END", "has other tables"),
    ("CREATE INDEX i ON flights (length(history))", "has other tables"),
    ("ALTER TABLE flights ADD COLUMN more INT", "has other tables"),
]


@pytest.mark.parametrize(("statement", "words"), DEFECTS)
def test_a_file_with_other_tables_is_refused(tmp_path: Path, statement: str, words: str) -> None:
    new(tmp_path).close()
    change(tmp_path, statement)
    for opening in (read, store.opened):
        with pytest.raises(BadInput, match=words):
            opening(tmp_path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is not of this version"),
        (b"no database" * 500, "cannot be read: file is not a database"),
        (b"SQLite format 3\0" + b"\0" * 4080, "cannot be read|is not of this version"),
    ],
)
def test_a_file_that_is_no_database_is_refused(tmp_path: Path, content: bytes, words: str) -> None:
    (tmp_path / store.NAME).write_bytes(content)
    for opening in (read, store.opened):
        with pytest.raises(BadInput, match=words):
            opening(tmp_path)


@pytest.mark.parametrize(
    ("key", "value", "place"),
    [
        ("run", -1, "run"),
        ("run", True, "run"),
        ("run", 1.5, "run"),
        ("variant", -3, "variant"),
        ("seed", "x", "seed"),
        ("passed", 1, "passed"),
        ("outcome", None, "outcome"),
        ("outcome", "\x1b[2J<svg onload=1>", "outcome"),
        ("end_time_s", "soon", "end_time_s"),
        ("values", [], "values"),
        ("metrics", {"a": "b"}, "metrics.a"),
        ("requirements", [[True, 1.0]], "requirements.0"),
        ("requirements", "none", "requirements"),
    ],
)
def test_a_record_of_other_types_is_refused(tmp_path: Path, key: str, value: object, place: str) -> None:
    with closing(new(tmp_path)) as flights:
        flights.add(b"k", RECORD)
    text = json.dumps({**vars(RECORD), key: value})
    with closing(sqlite3.connect(tmp_path / store.NAME)) as database, database:
        database.execute("UPDATE flights SET record = ?", (text,))
    with pytest.raises(BadInput, match=f"has a flight whose {place}.* is wrong"):
        read(tmp_path)


@pytest.mark.parametrize("text", ["", "{", "[]", "[" * 10_000, '{"run": 1}', "{" + '"a":{' * 5000])
def test_a_record_that_is_none_is_refused(tmp_path: Path, text: str) -> None:
    with closing(new(tmp_path)) as flights:
        flights.add(b"k", RECORD)
    change(tmp_path, f"UPDATE flights SET record = '{text}'")
    with pytest.raises(BadInput, match="is wrong"):
        read(tmp_path)


def test_a_record_that_is_no_text_is_refused(tmp_path: Path) -> None:
    with closing(new(tmp_path)) as flights:
        flights.add(b"k", RECORD)
    change(tmp_path, "UPDATE flights SET record = CAST(x'7b22ff' AS TEXT)")
    with pytest.raises(BadInput, match="cannot be read: Could not decode to UTF-8"):
        read(tmp_path)


@pytest.mark.parametrize(
    "inputs", ["[]", "{", "7", "", '{"versions": []}', '{"fly": 1}', '{"arithmetic": {"a": {}}}', "[" * 9000]
)
def test_what_a_study_was_begun_with_is_checked(tmp_path: Path, inputs: str) -> None:
    new(tmp_path).close()
    change(tmp_path, f"UPDATE begun SET inputs = '{inputs}'")
    with store.reading(tmp_path) as flights, pytest.raises(BadInput, match="what it was begun with"):
        _ = flights.inputs


def test_a_damaged_page_is_refused(tmp_path: Path) -> None:
    with closing(new(tmp_path)) as flights:
        for k in range(200):
            flights.add(key_of(k), RECORD, bytes(2000))
    file = tmp_path / store.NAME
    content = bytearray(file.read_bytes())
    content[4096 * 5 : 4096 * 40] = b"\xff" * (4096 * 35)
    file.write_bytes(content)
    with pytest.raises(BadInput, match="cannot be read"):
        read(tmp_path)


@pytest.mark.parametrize(
    ("instead", "run"),
    [
        ("(SELECT record FROM flights LIMIT 1)", "0"),
        (f"replace(record, '\"run\":1,', '\"run\":{10**40},')", "10+"),
    ],
)
def test_a_flight_in_place_of_another_is_refused(tmp_path: Path, instead: str, run: str) -> None:
    plan = load_sweep(written(tmp_path))
    folder = fly_here(plan, tmp_path / "out")
    change(folder, f"UPDATE flights SET record = {instead}")
    with (
        pytest.raises(BadInput, match=f"has run {run}, variant 0 in place of another flight"),
        store.reading(folder) as all_,
    ):
        list(records(plan, all_))


def test_links_and_journals_that_lead_elsewhere_are_refused(tmp_path: Path) -> None:
    new(tmp_path).close()
    victim = tmp_path / "victim"
    for name, words in (("-wal", "is a link"), ("-journal", "is not written by testbed"), ("", "is a link")):
        file = tmp_path / f"{store.NAME}{name}"
        file.unlink(missing_ok=True)
        if not name:
            new(tmp_path).close()
            file.rename(victim)
        file.symlink_to(victim)
        for opening in (read, store.opened):
            with pytest.raises(BadInput, match=words):
                opening(tmp_path)
        file.unlink()


def test_a_study_that_begins_twice_at_once_has_one_store(tmp_path: Path) -> None:
    store.create(tmp_path, {"first": True})
    store.create(tmp_path, {"first": False})
    with store.reading(tmp_path) as flights:
        assert flights.inputs == {"first": True}
    assert [file.name for file in tmp_path.iterdir()] == [store.NAME]


@pytest.mark.nightly
def test_flights_are_neither_held_nor_rewritten(tmp_path: Path) -> None:
    """The parent's memory does not grow with the flights, nor the log of the database beyond some megabytes."""
    plan = load_sweep(written(tmp_path), ["runs=20000"])
    with closing(begin(tmp_path / "out", plan, "f", resume=False)) as flights:
        record = first_record(plan)
        tracemalloc.start()
        try:
            held = []
            for k in range(20_000):
                flights.add(key_of(k), replace(record, run=k // 2, variant=k % 2), bytes(2400))
                if k in (2_000, 19_999):
                    held.append(tracemalloc.get_traced_memory()[0])
            assert held[1] - held[0] < 18_000  # less than a byte a flight: nothing is kept
            assert os.stat(tmp_path / "out" / f"{store.NAME}-wal").st_size < 6_000_000
            tracemalloc.reset_peak()
            write(plan, lambda: records(plan, flights, 10_000), tmp_path)
            assert tracemalloc.get_traced_memory()[1] - held[1] < 20_000_000  # one group of rows
        finally:
            tracemalloc.stop()
    assert sum(1 for _ in (tmp_path / "results.csv").open()) == 20_001


def first_record(plan: Plan) -> Record:
    with here().workers(here().job(plan), None, None) as fly_all:
        (flown,) = fly_all([plan.task(0)])
    return flown.record


def test_a_store_that_is_read_only_is_not_called_damaged(tmp_path: Path) -> None:
    new(tmp_path).close()
    tmp_path.chmod(0o555)
    try:
        if os.access(tmp_path, os.W_OK):
            pytest.skip("this user may write everywhere")
        with pytest.raises(PermissionError, match="Permission denied"):
            store.opened(tmp_path)
        assert main(["report", str(tmp_path)]) == 2
    finally:
        tmp_path.chmod(0o755)


def test_a_database_that_has_another_name_too_is_not_flown_into(tmp_path: Path) -> None:
    """A hard link looks like a file; what is written into it is written into somebody's own."""
    plan = load_sweep(written(tmp_path))
    folder = fly_here(plan, tmp_path / "out")
    (tmp_path / "mine.sqlite").hardlink_to(folder / store.NAME)
    before = (tmp_path / "mine.sqlite").read_bytes()
    with pytest.raises(PermissionError, match="has other names"):
        store.opened(folder)
    assert (tmp_path / "mine.sqlite").read_bytes() == before


@pytest.mark.parametrize("name", [f"{store.NAME}-wal", store.NAME])
def test_a_file_of_a_terabyte_of_nothing_is_not_copied(tmp_path: Path, name: str) -> None:
    """A folder that is only read is copied where it has a log, into the temporary folder, which it would fill."""
    new(tmp_path).close()
    for file in (store.NAME, f"{store.NAME}-wal"):
        (tmp_path / file).touch()
    os.truncate(tmp_path / name, 10**12)
    with pytest.raises(BadInput, match=f"{name}: has more than (1|20) GB"):
        read(tmp_path)
