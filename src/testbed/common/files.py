"""What the writers of files share: a safe file name, a file written whole or not at all, and values that JSON can hold."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

_LONGEST_SLUG = 100
"""Most file systems take names of 255 bytes, of which temporary names need some."""


def slug(name: str, otherwise: str) -> str:
    """A name as a file name: at most 100 lower case letters, digits and hyphens; `otherwise` when nothing of it is left."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:_LONGEST_SLUG].strip("-") or otherwise


def cache_home() -> Path | None:
    """The folder in which programs of this user keep what they can make again; None without a home folder.

    A relative `XDG_CACHE_HOME` is ignored, as the XDG base directory specification asks. An empty `HOME` is none: Python would
    take it for the root folder.
    """
    if (chosen := Path(os.environ.get("XDG_CACHE_HOME", ""))).is_absolute():
        return chosen
    try:
        home = Path.home()
    except RuntimeError:
        return None
    return home / ".cache" if os.environ.get("HOME") != "" and home.is_absolute() else None


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """A path beside `file` to write to, which takes its place when the block ends without an error.

    A reader sees the old contents or the new, never a part of them. Raises OSError as writing does.
    """
    partial = partial_of(file)
    try:
        yield partial
        partial.replace(file)
    finally:
        partial.unlink(missing_ok=True)


def partial_of(file: Path) -> Path:
    """The path beside a file to which `replacing` writes."""
    return file.with_name(f".{file.name}.partial")


def write_whole(file: Path, content: bytes) -> None:
    """Write a file completely or not at all, in a folder that is made where it is missing, and flush it to disk."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with replacing(file) as partial, partial.open("wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def plain(value: Any) -> Any:
    """Python's own types, for JSON; None for a number that is not finite.

    Mappings become dicts with text keys; lists, tuples and numpy arrays become lists; numpy's numbers become
    Python's. Anything else is returned as it is.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):  # of numpy, which is not imported for this
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
