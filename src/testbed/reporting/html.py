"""Parts that all pages are made of. A page is one HTML file with its figures and scripts, and loads nothing from the network.

`tag` is the one way from text to markup: what it is given is text and is escaped, but for what `tag` made itself and for what the
source says is `Html`. So no name in a file of somebody else becomes markup.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from html import escape
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import quote

from testbed.common.files import plain
from testbed.common.text import printable
from testbed.common.writing import write
from testbed.reporting.words import number

_ASSETS = Path(__file__).parent / "assets"
_STYLES = ("palette.css", "report.css", "sweep.css", "uplot.css")
_LIBRARIES = {name: "libraries.js" for name in ("flight.js", "compare.js", "live.js")}
"""What stands before these scripts in a page: other people's code that they use."""
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; "
"""Where the policy of every page begins: a browser loads nothing for it."""
_NOWHERE = "img-src data:; base-uri 'none'; form-action 'none'; script-src "
"""No address that relative links start from, no form that could be sent; then the scripts that may run, by their digests."""
_VOID = ("img", "meta", "br", "input")  # have no contents and no end


class Html(str):
    """Text that is already HTML: made by `tag`, or written in the source. Any other text is escaped."""


Item = TypeVar("Item")
Part = str | None | Iterable["Part"]
"""What can stand in an element: text, `Html`, nothing, or several of these."""
Cell = str | float | None
"""Content of a table's cell: text, HTML, a number, or None where there is no value."""
_SHAPES = (
    Html('<circle cx="7" cy="7" r="5"/>'),
    Html('<rect x="2.5" y="2.5" width="9" height="9"/>'),
    Html('<path d="M7 1.5 13 12H1Z"/>'),
    Html('<path d="M7 1 13 7 7 13 1 7Z"/>'),
)
"""Shapes of the marks of flights or variants that are compared, in their order."""


def joined(part: Part, between: str = "") -> Html:
    """A part as HTML, with `between` its pieces: text is escaped, and its control characters are shown as what they are."""
    if part is None or isinstance(part, Html):
        return Html(part or "")
    if isinstance(part, str):
        return Html(escape(printable(part)))
    return Html(between.join(made for each in part if (made := joined(each, between))))


def tag(name: str, /, *inside: Part, **attributes: str | float | None) -> Html:
    """An element with its contents and attributes; `class_` is `class`. An attribute that is "" or None is left out."""
    said = {
        key.rstrip("_").replace("_", "-"): value
        for key, value in attributes.items()
        if value not in ("", None)
    }
    about = "".join(f' {key}="{joined(str(value))}"' for key, value in said.items())
    return Html(f"<{name}{about}>" if name in _VOID else f"<{name}{about}>{joined(inside)}</{name}>")


def asset(name: str) -> str:
    """The text of a style sheet or script that reports contain."""
    return (_ASSETS / name).read_text(encoding="utf-8")


def write_page(
    file: Path,
    title: str,
    parts: Part,
    script: str = "",
    data: Mapping[str, Any] | None = None,
    within: Path | None = None,
) -> Path:
    """Write a page, completely or not at all; returns its file. Raises OSError if it cannot be written.

    Args:
        within: the folder that was asked for (see `writing.replacing`); by default the file's own. Others as of `page_text`.
    """
    write(file, page_text(title, parts, script, data).encode(errors="backslashreplace"), within)
    return file


def page_text(
    title: str,
    parts: Part,
    script: str = "",
    data: Mapping[str, Any] | None = None,
    style: str = "",
    connects: str = "",
) -> str:
    """A page.

    Args:
        script: the asset that draws what moves.
        data: what the script reads, by id: texts, or values that become JSON.
        style: an asset after the style sheets of every page.
        connects: the one address to which the script may connect; by default it has none.
    """
    body = joined([parts, *(_data(name, value) for name, value in (data or {}).items())], "\n")
    code = "".join(map(asset, filter(None, [_LIBRARIES.get(script), script])))
    digest = base64.b64encode(hashlib.sha256(code.encode()).digest()).decode("ascii")
    # A browser may run this code, connect to this address, and show what is in the page.
    policy = f"{_POLICY}{_NOWHERE}" + (f"'sha256-{digest}'" if code else "'none'")
    policy += f"; connect-src {connects}" if connects else ""
    head = [
        tag("meta", charset="utf-8"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("title", title),
        tag("style", Html("\n".join(map(asset, (*_STYLES, *filter(None, [style])))))),
    ]
    text = tag(
        "html",
        tag("head", head),
        "\n",
        tag(
            "body",
            tag("main", body),
            tag("script", Html(code)) if code else None,
            data_drawn=None if code else "yes",  # there is nothing to wait for
        ),
        lang="en",
    )
    return f"<!DOCTYPE html>\n{text}\n"


def is_page(file: Path) -> bool:
    """Whether a file is a page that `write_page` wrote."""
    with file.open(encoding="utf-8", errors="replace") as stream:
        begun = stream.read(1000)
    return joined(_POLICY) in begun or _POLICY in begun  # earlier versions did not escape


def _data(name: str, value: Any) -> Html:
    """Data for a script: a text, or JSON in which a number that is not finite is null. Nothing in it ends its element."""
    text, kind = value, "text/plain"
    if not isinstance(value, str):
        text, kind = json.dumps(plain(value), separators=(",", ":"), ensure_ascii=False), "application/json"
    for character in "<\u2028\u2029":
        text = text.replace(character, f"\\u{ord(character):04x}")
    return tag("script", Html(text), type=kind, id=name)


def row(cells: Iterable[Cell], kind: str = "") -> Html:
    """A row of a table: texts are escaped, numbers aligned to the right; `kind` is the row's CSS class."""
    return tag("tr", map(_cell, cells), class_=kind)


def _cell(value: Cell) -> Html:
    return tag("td", value) if isinstance(value, str) else tag("td", number(value), class_="number")


def table(heads: Iterable[str], rows: Iterable[Html], caption: str = "") -> Html:
    """A table with a head, from rows made by `row`. On a narrow screen the table scrolls, not the page."""
    above = tag("caption", caption) if caption else None
    head = tag("thead", tag("tr", [tag("th" if text else "td", text) for text in heads]))
    made = tag("table", above, head, "\n", tag("tbody", joined(rows, "\n")))
    return tag("div", made, class_="table", tabindex=0)  # so that keys can scroll it


def listing(
    items: Iterable[Item],
    columns: Mapping[str, Callable[[Item], Cell]],
    caption: str = "",
    kind: Callable[[Item], str] = lambda _: "",
) -> Html:
    """A table with a row for each item: {head: the cell of an item}; `kind` gives the row's CSS class."""
    cells = list(columns.values())
    return table(columns, (row([cell(item) for cell in cells], kind(item)) for item in items), caption)


def opening(
    title: str, lines: Iterable[str], facts: Mapping[str, str] | None = None, verdict: Part = None
) -> Html:
    """What a page begins with: its title, short facts {what: value} in a row, a verdict, and the answer in sentences."""
    chips = [tag("li", tag("b", what), value) for what, value in (facts or {}).items()]
    return joined(
        [
            tag("h1", title),
            tag("ul", chips, class_="chips") if chips else None,
            verdict,
            listed(lines, "story"),
        ],
        "\n",
    )


def bar(name: str, share: float, said: str, i: int = 0, chance: float | None = None, kind: str = "") -> Html:
    """A bar as long as a share of 1, in the i-th colour, with a name and what is `said` of it; `chance` is a line across it."""
    line = None if chance is None else tag("u", style=f"left:{100 * chance:.1f}%")
    filled = tag("i", class_=f"v{i % 6}", style=f"width:{100 * share:.1f}%")
    parts = {"name": name, "track": [filled, line], "number": said}
    return tag("div", [tag("div", part, class_=what) for what, part in parts.items()], class_=f"driver{kind}")


def figures(folder: Path, captions: Mapping[str, str]) -> list[Html]:
    """A figure for each `folder/<name>.png` of {name: caption} that exists, with the picture embedded."""
    found = ((folder / f"{name}.png", caption) for name, caption in captions.items())
    return [picture(file.read_bytes(), caption) for file, caption in found if file.is_file()]


def picture(data: bytes, caption: str) -> Html:
    """A figure whose picture is the contents of a PNG file."""
    source = f"data:image/png;base64,{base64.b64encode(data).decode('ascii')}"
    return tag("figure", tag("img", alt=caption, src=source), tag("figcaption", caption))


def panels(group: Mapping[str, Any]) -> Html:
    """The place of a group of panels (see `page.group_of`), which the page's script fills."""
    inside = tag("div", class_="panels", id=f"panels-{group['name']}")
    return folded(group["title"], inside) if group["folded"] else joined([tag("h2", group["title"]), inside])


def listed(lines: Iterable[str], kind: str = "") -> Html:
    """A list of sentences; `kind` is its CSS class."""
    return tag("ul", [tag("li", line) for line in lines], class_=kind)


def mark(i: int) -> Html:
    """The mark of the i-th flight or variant: a shape in its colour."""
    shape, kind = _SHAPES[i % len(_SHAPES)], f"mark v{i % 6}"
    return tag("svg", shape, class_=kind, width=14, height=14, viewBox="0 0 14 14", aria_hidden="true")


def legend(names: Iterable[str]) -> Html:
    """The mark of each flight or variant with its name."""
    return tag("p", [tag("span", mark(i), " ", name) for i, name in enumerate(names)], class_="legend")


def link(text: str, page: str) -> Html:
    """A link to a page in a folder near this one; no text makes it one to somewhere else."""
    return tag("a", text, href=quote(page))


def folded(title: str, *inside: Part) -> Html:
    """A part that is opened by a click."""
    return tag("details", tag("summary", title), "\n", inside)


def note(*inside: Part) -> Html:
    """A remark in grey, below what it is about."""
    return tag("p", inside, class_="note")
