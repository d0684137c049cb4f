"""The journal: incomplete and damaged lines do not count."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import fly_here, same_rows, written
from sweep_flights import quick

import testbed
from testbed.inputs.problems import BadInput
from testbed.sweeps.folder.journal import Journal, decode, encode, records
from testbed.sweeps.load import load_sweep


def test_torn_and_damaged_lines_are_flown_again(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    reference = fly_here(load_sweep(sweep), tmp_path / "reference")
    fly_here(load_sweep(sweep), tmp_path / "out")
    journal = tmp_path / "out/journal.jsonl"
    lines = journal.read_bytes().splitlines(keepends=True)
    lines[4] = lines[4].replace(b'"seed":', b'"sead":')
    journal.write_bytes(b"".join(lines[:-1]) + lines[-1][:37])
    testbed.sweep(sweep, tmp_path / "out", jobs=1, resume=True, fly=quick, figures=False)
    same_rows(reference, tmp_path / "out")
    assert journal.read_bytes().count(b"\n") == len(lines) + 1  # only the two were flown again


RECORD = {
    "run": 3,
    "variant": 1,
    "reason": 'ü, "quoted"\nand broken',
    "metrics": {"a": 0.1 + 0.2, "b": float("inf")},
}


def test_a_line_reads_back_as_it_was_and_notices_any_change() -> None:
    line = encode(RECORD)
    assert decode(line) == RECORD and line.count(b"\n") == 1
    for i in range(len(line)):
        assert decode(line[:i]) is None
        assert decode(line[:i] + bytes([line[i] ^ 1]) + line[i + 1 :]) is None


def test_an_incomplete_last_line_is_cut_off_before_the_next(tmp_path: Path) -> None:
    file = tmp_path / "journal.jsonl"
    file.write_bytes(encode({"run": 0}) + encode({"run": 1})[:-4])
    journal = Journal(file)
    with pytest.raises(BadInput, match="is being flown by another process"):
        Journal(file)
    offset = journal.append(RECORD)
    assert journal.read(offset) == RECORD
    journal.close()
    assert [record["run"] for _, record in records(file)] == [0, 3]
    Journal(file).close()
