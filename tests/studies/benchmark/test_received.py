"""The folder of a benchmark that somebody sent: what is wrong in it is said with its place."""

from __future__ import annotations

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

import testbed
from testbed.api.benchmark import rebuild
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store


@pytest.fixture
def copy(flown_suite: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(flown_suite, tmp_path / "received"))


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("seed: 5", "seed: -5", "seed: is -5"),
        ("seed: 5", "seed: true", "seed: is true"),
        ("seed: 5", "seed: [5]", "seed: "),
        ("draws: 4", "draws: 0", "draws: is 0"),
        ("draws: 4", "drawn: 2", "draws: is missing"),
        ("controllers:", "controllers: {}\nothers:", "controllers: "),
    ],
)
def test_a_plan_with_other_values_is_refused(copy: Path, old: str, new: str, place: str) -> None:
    file = copy / "benchmark.yaml"
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))
    with pytest.raises(BadInput, match=place):
        rebuild(copy)


@pytest.mark.parametrize(
    "text", [b"", b"draw,controller\n1,2,3\n4,5,6,7\n", b'draw\n"', b"\x85\xff", b"a,b\n1,2\n"]
)
def test_a_table_that_is_none_is_refused(copy: Path, text: bytes) -> None:
    (copy / "results.csv").write_bytes(text)
    with pytest.raises(BadInput, match="expected the table of a benchmark"):
        testbed.load(copy)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("UPDATE flights SET history = zeroblob(3000000)", "has an error history of 3000000 bytes in draw 0"),
        (
            "UPDATE flights SET record = replace(record, '\"run\":1,', '\"run\":0,')",
            "in place of another flight",
        ),
        (
            "UPDATE flights SET record = replace(record, '\"variant\":0', '\"variant\":7')",
            "in place of another flight",
        ),
    ],
)
def test_flights_that_are_none_of_it_are_refused(copy: Path, change: str, words: str) -> None:
    with closing(sqlite3.connect(copy / store.NAME)) as database, database:
        database.execute(change)
    with pytest.raises(BadInput, match=words):
        rebuild(copy)


def test_a_plan_of_many_draws_takes_no_longer(copy: Path) -> None:
    file = copy / "benchmark.yaml"
    file.write_text(file.read_text().replace("draws: 4", f"draws: {10**15}", 1))
    assert rebuild(copy)["draws"] == 4


def test_links_are_refused(copy: Path, tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("mine")
    (copy / "report.html").unlink(missing_ok=True)
    (copy / "report.html").symlink_to(tmp_path / "mine")
    for read in (rebuild, testbed.load):
        with pytest.raises(BadInput, match="is a link"):
            read(copy)
    assert (tmp_path / "mine").read_text() == "mine"
