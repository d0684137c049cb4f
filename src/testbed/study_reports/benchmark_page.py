"""The report of a benchmark, as Markdown and as a page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from testbed.reporting import html
from testbed.reporting.html import Html, Part, tag
from testbed.study_reports.benchmark import Section, sections


def markdown(summary: Mapping[str, Any], heading: str = "##") -> list[str]:
    """All sections, in lines."""
    lines: list[str] = []
    for section in sections(summary):
        parts = [[f"{heading} {section.title}"] if section.title else [], [section.words] if section.words else [],
                 [*_table(section.head, section.rows)]]  # fmt: skip
        for part in filter(None, parts):
            lines += [*([""] if lines else []), *part]
    return lines


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    if head:
        yield f"| {' | '.join(head)} |"
        yield f"|{' --- |' * len(head)}"
        yield from (f"| {' | '.join(each.replace('|', '/') for each in row)} |" for row in rows)


def write_benchmark_page(summary: Mapping[str, Any], folder: Path) -> Path:
    """Write report.html of a benchmark's folder; returns the file. Raises OSError when it cannot be written."""
    title = f"Benchmark {summary['suite']} {summary['version']}"
    facts = {"draws": str(summary["draws"]), "seed": str(summary["seed"])}
    parts: list[Part] = [html.opening(title, [], facts), *map(_part, sections(summary))]
    return html.write_page(folder / "report.html", title, parts)


def _part(section: Section) -> Html:
    title = tag("h2", _plain(section.title)) if section.title else None
    words = tag("p", _plain(section.words)) if section.words else None
    rows = (html.row(map(_plain, row)) for row in section.rows)
    table = html.table(map(_plain, section.head), rows) if section.head else None
    return html.joined([title, words, table], "\n")


def _plain(text: str) -> str:
    """Without the marks of Markdown."""
    return text.replace("`", "").replace("*", "")
