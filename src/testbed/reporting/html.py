"""Parts that all reports are made of: page, style, tables, figures and notes.

A report is one HTML file. It contains its figures and scripts, and loads nothing from the network.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterable, Mapping
from html import escape
from pathlib import Path
from typing import Any, TypeVar

from testbed.common.files import plain
from testbed.common.writing import write
from testbed.reporting.numbers import number

_ASSETS = Path(__file__).parent / "assets"
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"
"""What a browser may load for a page: only what the page contains. It holds even against what a name might smuggle in."""


class Html(str):
    """Text that is already HTML. Any other text is escaped when it is put into a table or a note."""


Item = TypeVar("Item")
_SHAPES = (
    '<circle cx="7" cy="7" r="5"/>',
    '<rect x="2.5" y="2.5" width="9" height="9"/>',
    '<path d="M7 1.5 13 12H1Z"/>',
    '<path d="M7 1 13 7 7 13 1 7Z"/>',
)
"""Shapes of the marks of flights or variants that are compared, in their order; their colours are in sweep.css."""

Cell = str | float | None
"""Content of a table's cell: text, HTML, a number, or None where there is no value."""


def asset(name: str) -> str:
    """The text of a style sheet or script that reports contain."""
    return (_ASSETS / name).read_text(encoding="utf-8")


def write_page(
    file: Path, title: str, parts: Iterable[str], styles: Iterable[str] = (), within: Path | None = None
) -> Path:
    """Write a report, completely or not at all; returns its file. Raises OSError when it cannot be written.

    Args:
        parts: HTML.
        styles: names of style sheets beside the one of all reports.
        within: the folder that was asked for (see `writing.replacing`); by default the file's own.
    """
    name, body = escape(title), "\n".join(part for part in parts if part)
    style = "\n".join(map(asset, ("report.css", *styles)))
    head = (
        f'<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">'
        f"<title>{name}</title><style>{style}</style>"
    )
    text = f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'
    write(file, text, within)
    return file


def is_page(file: Path) -> bool:
    """Whether a file is a report that `write_page` wrote."""
    with file.open(encoding="utf-8", errors="replace") as stream:
        return _POLICY in stream.read(1000)


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


def listing(
    items: Iterable[Item],
    columns: Mapping[str, Callable[[Item], Cell]],
    caption: str = "",
    kind: Callable[[Item], str] = lambda _: "",
) -> Html:
    """A table with a row for each item: {head: the cell of an item}; `kind` gives the row's CSS class."""
    cells = list(columns.values())
    return table(columns, (row([cell(item) for cell in cells], kind(item)) for item in items), caption)


def bar(name: str, share: float, said: str, i: int = 0, chance: float | None = None, kind: str = "") -> Html:
    """A bar as long as a share of 1, in the i-th colour, with a name and what is `said` of it; `chance` is a line across it."""
    line = "" if chance is None else f'<u style="left:{100 * chance:.1f}%"></u>'
    return Html(
        f'<div class="driver{kind}"><div class="name">{escape(name)}</div><div class="track">'
        f'<i class="v{i % 6}" style="width:{100 * share:.1f}%"></i>{line}</div>'
        f'<div class="number">{escape(said)}</div></div>'
    )


def figures(folder: Path, captions: Mapping[str, str]) -> list[Html]:
    """A figure for each `folder/<name>.png` of {name: caption} that exists, with the picture embedded."""
    found = ((folder / f"{name}.png", caption) for name, caption in captions.items())
    return [picture(file.read_bytes(), caption) for file, caption in found if file.is_file()]


def picture(data: bytes, caption: str) -> Html:
    """A figure whose picture is the contents of a PNG file."""
    encoded, said = base64.b64encode(data).decode("ascii"), escape(caption)
    image = f'<img alt="{said}" src="data:image/png;base64,{encoded}">'
    return Html(f"<figure>{image}<figcaption>{said}</figcaption></figure>")


def panels(group: Mapping[str, Any]) -> Html:
    """The place of a group of panels (see `page.panels`), which the page's script fills."""
    inside = Html(f'<div class="panels" id="panels-{group["name"]}"></div>')
    title = group["title"]
    return folded(title, inside) if group["folded"] else Html(f"<h2>{escape(title)}</h2>{inside}")


def script(text: str, kind: str = "", name: str = "") -> Html:
    """A script, or data for one: `kind` is its type, and `name` its id. The text may hold anything."""
    about = "".join(f' {key}="{value}"' for key, value in (("type", kind), ("id", name)) if value)
    inside = text.replace("</script", "<\\/script").replace("<!--", "<\\!--")  # would end the script
    return Html(f"<script{about}>{inside}</script>")


def data(value: object, name: str) -> Html:
    """Data for a script, as JSON; a number that is not finite is null."""
    text = json.dumps(plain(value), separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return script(text, "application/json", name)


def listed(lines: Iterable[str], kind: str = "") -> Html:
    """A list of sentences; `kind` is its CSS class."""
    inside = "".join(f"<li>{escape(line)}</li>" for line in lines)
    return Html(f'<ul class="{kind}">{inside}</ul>' if kind else f"<ul>{inside}</ul>")


def mark(i: int) -> Html:
    """The mark of the i-th flight or variant: a shape in its colour."""
    shape = _SHAPES[i % len(_SHAPES)]
    about = 'width="14" height="14" viewBox="0 0 14 14" aria-hidden="true"'
    return Html(f'<svg class="mark v{i % 6}" {about}>{shape}</svg>')


def legend(names: Iterable[str]) -> Html:
    """The mark of each flight or variant with its name."""
    named = (f"<span>{mark(i)} {escape(name)}</span>" for i, name in enumerate(names))
    return Html(f'<p class="legend">{"".join(named)}</p>')


def chips(facts: Mapping[str, str]) -> Html:
    """Short facts in a row: {what: value}."""
    inside = "".join(f"<li><b>{escape(what)}</b>{escape(value)}</li>" for what, value in facts.items())
    return Html(f'<ul class="chips">{inside}</ul>')


def folded(title: str, inside: str) -> Html:
    """A part that is opened by a click."""
    return Html(f"<details><summary>{escape(title)}</summary>\n{inside}\n</details>")


def note(text: str) -> Html:
    """A remark in grey, below what it is about."""
    return Html(f'<p class="note">{_text(text)}</p>')


def _cell(value: Cell) -> str:
    if isinstance(value, str):
        return f"<td>{_text(value)}</td>"
    return f'<td class="number">{number(value)}</td>'


def _text(text: str) -> str:
    return text if isinstance(text, Html) else escape(text)
