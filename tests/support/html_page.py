"""A report as a browser's parser sees it."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

from testbed.flight.folder import load
from testbed.reporting.run_report import write_page

_VOID = ("meta", "img", "br")
"""Elements that have no closing tag."""


class Page(HTMLParser):
    """The tags, references and visible text of a page; fails when a tag is not closed where it should be."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.references: list[str] = []
        self.attributes: list[dict[str, str | None]] = []
        self.text = ""
        self._open: list[str] = []
        self.feed(text)
        self.close()
        assert not self._open, self._open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes.append(dict(attrs))
        found = [value or "" for name, value in attrs if name in ("src", "href", "srcset", "data")]
        self.references += [reference for reference in found if not reference.startswith("#")]  # to itself
        if tag not in _VOID:
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data

    def fetches_and_runs_nothing(self) -> bool:
        """Whether all that it shows is inside it: no script, and pictures as data only."""
        inside = all(reference.startswith("data:image/png;base64,") for reference in self.references)
        return inside and not {"script", "link", "iframe", "object"} & set(self.tags)


def write_report(folder: Path) -> Path:
    """Write the page of a run folder into it, with the figures that it has; returns the file."""
    return write_page(load(folder), folder / "report.html", folder / "figures")
