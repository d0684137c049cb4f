"""Runs written out in a table are drawn as they are written."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import SWEEP, fly_here, table, written

from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import parse
from testbed.studies.load import load_sweep, read_cases

TABLE = "failures.0.value,failures.0.at_s,seed\n0.25,0.5,77\n0.75,,78\n1,0.1,\n"


def test_cells_are_yaml_and_an_empty_one_is_left_out(tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text('a.b, c\n"[1, 2]",true\n\n,text\n')
    cases, text, places = read_cases(file, Problem("missing"))
    assert cases == [{"a.b": [1, 2], "c": True}, {"c": "text"}]
    assert text == file.read_text() and places == {"a.b": str(file), "c": str(file)}


@pytest.mark.parametrize("cell", ["0", "-0", "12", "-7.25", "0.1", "123456789012345.5", "100000000000000"])
def test_plain_numbers_are_those_of_yaml(tmp_path: Path, cell: str) -> None:
    file = tmp_path / "table.csv"
    file.write_text(f"a\n{cell}\n")
    ((case,), _, _) = read_cases(file, Problem("missing"))
    wanted = parse(cell).tree
    assert repr(case["a"]) == repr(wanted)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "has no runs, expected a header of dotted paths and a row for each run"),
        ("\n\n", "has no runs"),
        ("a,b\n\n,\n", "has no runs"),
        ("a,a\n1,2\n", "column a is there twice"),
        ("a,\n1,2\n", "column 2 has no name"),
        ("a\n1,2\n", "has 2 cells, expected 1, as the header"),
        (
            "sep=,\na,b\n1,2\n",
            "table.csv:1: is 'sep=,', which only a spreadsheet reads, expected the header: remove this line",
        ),
        (
            "a;b\n1;2\n",
            "table.csv:1: has semicolons between its cells, expected commas: save it as CSV with commas",
        ),
        ("a\tb\n1\t2\n", "has tabs between its cells, expected commas"),
        ("PK\x03\x04\x14", "is a spreadsheet or an archive, expected a CSV table, saved as text"),
        ("seed\n-1\n", "seed: is -1, expected a whole number, at least 0"),
    ],
)
def test_a_table_that_cannot_be_read_is_refused(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "table.csv").write_text(text)
    with pytest.raises(BadInput) as refused:
        read_cases(tmp_path / "table.csv", Problem("missing"))
    assert words in str(refused.value)
    with pytest.raises(BadInput, match="missing"):
        read_cases(tmp_path / "none.csv", Problem("missing"))


def test_an_empty_cell_without_a_value_in_the_scenario_is_refused(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("failures.0.value,failures.0.until_s\n0.25,0.5\n0.75,\n")
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    words = "table.csv:1: failures.0.until_s: has empty cells, and the scenario has no value for them, expected a value"
    with pytest.raises(BadInput, match=words):
        load_sweep(written(tmp_path, text))


def test_cases_are_flown_as_written(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text(TABLE)
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    folder = fly_here(load_sweep(written(tmp_path, text)), tmp_path / "out")
    frame = table(folder)
    assert list(frame["failures.0.value"]) == [0.25, 0.75, 1.0]
    assert list(frame["seed"][:2]) == [77, 78] and frame["seed"][2] > 1
    assert frame["failures.0.at_s"][1] == 0.3, (
        "of an empty cell, the value that the scenario has and that is flown"
    )
    again = load_sweep(folder / "sweep.yaml")  # the table is in the folder too
    assert [again.task(k) for k in range(3)] == [
        load_sweep(tmp_path / "small.yaml").task(k) for k in range(3)
    ]
