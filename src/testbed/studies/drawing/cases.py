"""Read runs from a CSV table: a row for each run, columns named by dotted paths, cells with YAML values."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.problems import BadInput, Problem

LARGEST_TABLE = 20 * MEGABYTE
"""Largest table of cases that is read [bytes]."""

_NUMBER = re.compile(r"-?(0|[1-9][0-9]{0,14})(\.[0-9]{1,15})?")
"""Numbers that YAML reads as Python does, in a hundredth of the time."""

Cases = tuple[list[dict[str, Any]], str, dict[str, str]]
"""The values of each run by dotted paths, the text of the table, and the place of each column."""


def read_cases(file: Path, missing: Problem) -> Cases:
    """Read a table of runs; an empty cell is left out of its case (see `complete`).

    Raises BadInput: with `missing` when there is no such file, else with every column and cell that cannot be used.
    """
    if not os.path.lexists(file):
        raise BadInput([missing])
    text = read_text(file, LARGEST_TABLE, "a CSV table")
    _refuse_other(text, str(file))
    try:
        rows = list(csv.reader(text.splitlines(), strict=True))
    except csv.Error as error:
        raise BadInput([Problem(f"is no CSV table: {error}", str(file))]) from None
    header = [name.strip() for name in rows[0]] if rows else []
    problems = [
        Problem(f"column {j + 1} has no name" if not name else f"column {name} is there twice", str(file), 1)
        for j, name in enumerate(header)
        if not name or name in header[:j]
    ]
    cases = [
        _case(header, row, str(file), line, problems) for line, row in enumerate(rows[1:], 2) if any(row)
    ]
    if not cases:
        problems.append(
            Problem("has no runs", str(file), expected="a header of dotted paths and a row for each run")
        )
    if problems:
        raise BadInput(problems)
    return cases, text, {name: str(file) for name in header}


def complete(cases: list[dict[str, Any]], tree: Mapping[str, Any], places: Mapping[str, str]) -> None:
    """Put what is flown into the empty cells of a table: the value that the scenario's tree has.

    So a case says what its flight was flown with, whatever becomes of the scenario. Raises BadInput where the scenario has none.
    """
    problems = []
    for path, file in places.items():
        empty = [case for case in cases if path not in case and path != "seed"]
        try:
            value: Any = tree
            for part in path.split(".") if empty else ():
                value = value[int(part) if isinstance(value, list) else part]
            for case in empty:
                case[path] = value
        except (KeyError, IndexError, TypeError, ValueError):
            what, expected = "has empty cells, and the scenario has no value for them", "a value in each cell"
            problems.append(Problem(what, file, 1, path, expected))
    if problems:
        raise BadInput(problems)


def _refuse_other(text: str, file: str) -> None:
    """Raise BadInput for a table as a spreadsheet writes it, with other separators than commas."""
    first = text.partition("\n")[0]
    if first.lower().startswith("sep="):
        what, expected = f"is {first!r}, which only a spreadsheet reads", "the header: remove this line"
        raise BadInput([Problem(what, file, 1, expected=expected)])
    for character, name in ((";", "semicolons"), ("\t", "tabs")):
        if character in first and "," not in first:
            what, expected = f"has {name} between its cells", "commas: save it as CSV with commas"
            raise BadInput([Problem(what, file, 1, expected=expected)])


def _case(header: list[str], row: list[str], file: str, line: int, problems: list[Problem]) -> dict[str, Any]:
    if len(row) != len(header):
        expected = f"{len(header)}, as the header"
        problems.append(Problem(f"has {len(row)} cells", file, line, expected=expected))
        return {}
    case = {}
    for name, cell in zip(header, row, strict=True):
        if not cell.strip():
            continue
        if _NUMBER.fullmatch(cell):
            case[name] = float(cell) if "." in cell else int(cell)
            continue
        try:
            value = yamlfile.parse(cell)
        except BadInput as error:
            problems += [Problem(p.what, file, line, name) for p in error.problems]
            continue
        problems += [Problem(p.what, file, line, name, p.expected) for p in value.problems]
        case[name] = value.tree
    seed = case.get("seed", 2)
    if not isinstance(seed, int) or isinstance(seed, bool) or seed < 0:
        problems.append(Problem(f"is {seed!r}", file, line, "seed", "a whole number, at least 0"))
    return case
