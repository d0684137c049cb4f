"""Parts that all reports are made of: page, style, tables, figures and notes.

A report is one HTML file. It contains its figures and scripts, and loads nothing from the network.
"""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable, Mapping
from html import escape
from pathlib import Path

from testbed.common.files import replacing
from testbed.reporting.numbers import number

_ASSETS = Path(__file__).parent / "assets"
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"
"""What a browser may load for a page: only what the page contains. It holds even against what a name might smuggle in."""


class Html(str):
    """Text that is already HTML. Any other text is escaped when it is put into a table or a note."""


Cell = str | float | None
"""Content of a table's cell: text, HTML, a number, or None where there is no value."""


def asset(name: str) -> str:
    """The text of a style sheet or script that reports contain."""
    return (_ASSETS / name).read_text(encoding="utf-8")


def write_page(file: Path, title: str, parts: Iterable[str], styles: Iterable[str] = ()) -> Path:
    """Write a report, completely or not at all; returns its file. Raises OSError when it cannot be written.

    Args:
        parts: HTML.
        styles: names of style sheets beside the one of all reports.
    """
    name, body = escape(title), "\n".join(part for part in parts if part)
    style = "\n".join(map(asset, ("report.css", *styles)))
    head = (
        f'<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">'
        f"<title>{name}</title><style>{style}</style>"
    )
    text = f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'
    with replacing(file) as partial:
        partial.write_text(text, encoding="utf-8")
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


def figures(folder: Path, captions: Mapping[str, str], width: int = 1100) -> list[Html]:
    """A figure for each `folder/<name>.png` of {name: caption} that exists, with the picture embedded.

    Pictures are embedded no wider than `width` [pixels] and with 128 colours, which makes them a quarter of the size.
    """
    found = ((folder / f"{name}.png", escape(caption)) for name, caption in captions.items())
    return [_figure(file, caption, width) for file, caption in found if file.is_file()]


def picture(data: bytes, caption: str) -> Html:
    """A figure whose picture is the contents of a PNG file."""
    return _figure(io.BytesIO(data), caption, 1100)


def _figure(file: Path | io.BytesIO, caption: str, width: int) -> Html:
    from PIL import Image  # slow to import, and needed only here

    with Image.open(file) as opened:
        shown = opened.convert("RGB")
    if shown.width > width:
        shown = shown.resize((width, round(shown.height * width / shown.width)), Image.Resampling.LANCZOS)
    few = shown.quantize(128, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    stream = io.BytesIO()
    few.save(stream, "png", optimize=True)
    data = base64.b64encode(stream.getvalue()).decode("ascii")
    image = f'<img alt="{caption}" src="data:image/png;base64,{data}">'
    return Html(f"<figure>{image}<figcaption>{caption}</figcaption></figure>")


def script(text: str, kind: str = "", name: str = "") -> Html:
    """A script, or data for one: `kind` is its type, and `name` its id. The text may hold anything."""
    about = "".join(f' {key}="{value}"' for key, value in (("type", kind), ("id", name)) if value)
    inside = text.replace("</script", "<\\/script").replace("<!--", "<\\!--")  # would end the script
    return Html(f"<script{about}>{inside}</script>")


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
