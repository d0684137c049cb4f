"""Long tables of pages of results: as CSV files beside the page, which links to them."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable
from pathlib import Path


def aside(lines: Iterable[str], file: Path) -> list[str]:
    """Lines of Markdown with their first table moved into a CSV file, and a link in its place."""
    given = "\n".join(lines).split("\n")
    first = next(i for i, line in enumerate(given) if line.startswith("|"))
    last = next((i for i in range(first, len(given)) if not given[i].startswith("|")), len(given))
    rows = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip("|"))] for line in given[first:last]]
    with file.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream, lineterminator="\n").writerows([rows[0], *rows[2:]])
    said = "; ".join(filter(None, rows[0]))
    return [*given[:first], f"[The table]({file.name}) has {len(rows) - 2} rows: {said}.", *given[last:]]


def aside_in(text: str, heading: str, file: Path) -> str:
    """A page with the first table of one of its sections moved into a CSV file."""
    before, found, rest = text.partition(f"\n{heading}\n")
    section, next_one, after = rest.partition("\n## ")
    assert found, heading
    return before + found + "\n".join(aside(section.split("\n"), file)) + next_one + after
