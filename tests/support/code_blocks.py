"""Pages of Markdown, as a reader takes them: their code blocks, and the names of the files to save them as."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple


class Block(NamedTuple):
    """A code block: its language, its text, and the file that the sentence before it says to save it as."""

    language: str
    text: str
    file: str


def all_blocks(page: str) -> Iterator[Block]:
    """Code blocks in order."""
    end = 0
    for found in re.finditer(r"^```(\w+)\n(.*?)^```$", page, flags=re.MULTILINE | re.DOTALL):
        saved = re.findall(r"[Ss]ave (?:this|it) as `([\w.]+)`", page[end : found.start()])
        end = found.end()
        yield Block(found[1], found[2], saved[-1] if saved else "")


def blocks(page: str, language: str) -> list[str]:
    """Texts of the code blocks in one language."""
    return [block.text for block in all_blocks(page) if block.language == language]
