"""Files written whole or not at all, and names made fit for files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def slug(name: str, otherwise: str) -> str:
    """A name as a file name: lower case letters, digits and hyphens; `otherwise` when nothing of it is left."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-") or otherwise


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """A path beside `file` to write to, which takes its place when the block ends without an error.

    A reader sees the old contents or the new, never a part of them. Raises OSError as writing does.
    """
    partial = file.with_name(f".{file.name}.partial")
    try:
        yield partial
        partial.replace(file)
    finally:
        partial.unlink(missing_ok=True)
