"""Parts that all reports are made of: page, style, tables, figures and notes.

A report is one HTML file. It contains its figures, has no script, and loads nothing from the network.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping
from html import escape
from pathlib import Path

from testbed.common.files import replacing
from testbed.reporting.numbers import number

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #1a1a1a; }
body { max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.verdict { padding: .7rem 1rem; border-left: .5rem solid; font-size: 1.1rem; }
.met { border-color: #2e7d32; } .missed { border-color: #b22222; background: #fdf1f0; }
.table { overflow-x: auto; } table { border-collapse: collapse; width: 100%; margin-bottom: .8rem; }
caption, figcaption, .note { color: #555; } caption { text-align: left; padding-bottom: .3rem; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.missed td:first-child { font-weight: bold; color: #b22222; }
img { max-width: 100%; } figure { margin: 1.5rem 0; }
code { background: #f4f4f4; padding: .1rem .3rem; }
pre { background: #f4f4f4; padding: .7rem 1rem; overflow-x: auto; }
@media print { body { max-width: none; } figure, tr { break-inside: avoid; } }
"""


class Html(str):
    """Text that is already HTML. Any other text is escaped when it is put into a table or a note."""


Cell = str | float | None
"""Content of a table's cell: text, HTML, a number, or None where there is no value."""


def write_page(file: Path, title: str, parts: Iterable[str]) -> Path:
    """Write a report, completely or not at all; returns its file. `parts` are HTML. Raises OSError when it cannot be written."""
    name, body = escape(title), "\n".join(part for part in parts if part)
    head = (
        f'<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{name}</title><style>{_STYLE}</style>"
    )
    text = f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'
    with replacing(file) as partial:
        partial.write_text(text, encoding="utf-8")
    return file


def row(cells: Iterable[Cell], kind: str = "") -> Html:
    """A row of a table: texts are escaped, numbers aligned to the right; `kind` is the row's CSS class."""
    inside = "".join(map(_cell, cells))
    return Html(f'<tr class="{kind}">{inside}</tr>' if kind else f"<tr>{inside}</tr>")


def table(heads: Iterable[str], rows: Iterable[Html], caption: str = "") -> Html:
    """A table with a head, from rows made by `row`. On a narrow screen the table scrolls, not the page."""
    head = "".join(f"<th>{_text(text)}</th>" for text in heads)
    above = f"<caption>{_text(caption)}</caption>" if caption else ""
    body = "\n".join(rows)
    inside = f"{above}<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>"
    return Html(f'<div class="table"><table>{inside}</table></div>')


def figures(folder: Path, captions: Mapping[str, str]) -> list[Html]:
    """A figure for each `folder/<name>.png` of {name: caption} that exists, with the picture embedded."""
    found = ((folder / f"{name}.png", escape(caption)) for name, caption in captions.items())
    return [_figure(file, caption) for file, caption in found if file.is_file()]


def _figure(file: Path, caption: str) -> Html:
    data = base64.b64encode(file.read_bytes()).decode("ascii")
    image = f'<img alt="{caption}" src="data:image/png;base64,{data}">'
    return Html(f"<figure>{image}<figcaption>{caption}</figcaption></figure>")


def note(text: str) -> Html:
    """A remark in grey, below what it is about."""
    return Html(f'<p class="note">{_text(text)}</p>')


def _cell(value: Cell) -> str:
    if isinstance(value, str):
        return f"<td>{_text(value)}</td>"
    return f'<td class="number">{number(value)}</td>'


def _text(text: str) -> str:
    return text if isinstance(text, Html) else escape(text)
