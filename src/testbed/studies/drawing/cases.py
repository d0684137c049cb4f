"""Read runs from a CSV table: a row for each run, columns named by dotted paths, cells with YAML values."""

from __future__ import annotations

import csv
import os
import re
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
    """Read a table of runs; an empty cell leaves the base scenario's value.

    Raises BadInput: with `missing` when there is no such file, else with every column and cell that cannot be used.
    """
    if not os.path.lexists(file):
        raise BadInput([missing])
    text = read_text(file, LARGEST_TABLE, "a CSV table")
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


def _case(header: list[str], row: list[str], file: str, line: int, problems: list[Problem]) -> dict[str, Any]:
    if len(row) != len(header):
        problems.append(
            Problem(f"has {len(row)} cells", file, line, expected=f"{len(header)}, as the header")
        )
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
