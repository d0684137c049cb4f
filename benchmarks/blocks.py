"""Blocks of a page that a script writes, between `<!-- NAME -->` and `<!-- end of NAME -->`; the rest is written by hand."""

from __future__ import annotations

import re
from pathlib import Path


def block(text: str, name: str) -> str:
    """What stands in a block; raises KeyError if the page has none of this name."""
    found = re.search(_pattern(name), text, flags=re.DOTALL)
    if found is None:
        raise KeyError(name)
    return found[2].strip("\n")


def with_block(text: str, name: str, body: str) -> str:
    """The page with this in place of what stands in a block; raises KeyError if there is none of this name."""
    block(text, name)
    return re.sub(_pattern(name), lambda found: f"{found[1]}{body}\n{found[3]}", text, flags=re.DOTALL)


def write(page: Path, name: str, body: str) -> None:
    """Replace a block of a page."""
    page.write_text(with_block(page.read_text(encoding="utf-8"), name, body), encoding="utf-8")
    print(f"wrote `{name}` of {page}")


def _pattern(name: str) -> str:
    return rf"(<!-- {name} -->\n)(.*?\n?)(<!-- end of {name} -->)"
