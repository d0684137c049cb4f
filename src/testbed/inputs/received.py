"""Folders that are read back, which anybody may have made: only files and folders are in them, and JSON is as we write it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from testbed.inputs.input_file import MEGABYTE, read_text
from testbed.inputs.problems import BadInput, Problem

_LARGEST_JSON = 20 * MEGABYTE
_DEEPEST = 10
"""Folders in folders: ours are three deep, and a path of thousands is longer than systems open."""
_SHOWN = 3
"""Members that are named."""


def refuse_links(folder: Path) -> None:
    """Raise BadInput when anything in a folder, at any depth, is neither a file nor a folder.

    A link may lead out of it: to a file that is to be overwritten, or to one that is not to be shown. A pipe has no end.
    """
    found = [problem for problem, _ in zip(_links(folder), range(_SHOWN), strict=False)]
    if found:
        raise BadInput(found)


def _links(folder: Path) -> Iterator[Problem]:
    waiting = [(folder, 0)]
    while waiting:
        place, depth = waiting.pop()
        if depth > _DEEPEST:
            yield Problem("is nested too deeply", str(place), expected=f"folders {_DEEPEST} deep at most")
            continue
        with os.scandir(place) as members:
            for member in sorted(members, key=lambda each: each.name):
                if member.is_dir(follow_symlinks=False):
                    waiting.append((Path(member.path), depth + 1))
                elif not member.is_file(follow_symlinks=False):
                    what = "is a link" if member.is_symlink() else "is a device or a pipe"
                    yield Problem(
                        what, member.path, expected="files and folders alone in a folder that is read back"
                    )


def read_json(file: Path, expected: str) -> Any:
    """The contents of a JSON file of a received folder.

    Raises BadInput for a file that is too large or no JSON, for a key that stands twice, for NaN and Infinity, which JSON has not,
    and for text that UTF-8 cannot hold.
    """
    return json_of(read_text(file, _LARGEST_JSON, expected), file, expected)


def json_of(text: str, file: Path, expected: str) -> Any:
    """As `read_json`, of text that was read from a file already."""
    try:
        value = json.loads(text, object_pairs_hook=_once, parse_constant=_no_number)
        json.dumps(value, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as error:
        words = "is nested too deeply" if isinstance(error, RecursionError) else f"cannot be read: {error}"
        raise BadInput([Problem(words, str(file), expected=expected)]) from None
    return value


@contextmanager
def believed(file: Path, expected: str) -> Iterator[None]:
    """While what was read from a file is used for the first time: what it lacks, or has of another type, is BadInput."""
    try:
        yield
    except (
        OSError,
        LookupError,
        TypeError,
        ValueError,
        AttributeError,
        ArithmeticError,
        RecursionError,
    ) as error:
        problem = Problem(
            f"does not hold what it should: {type(error).__name__}: {error}", str(file), expected=expected
        )
        raise BadInput([problem]) from None


def _no_number(word: str) -> None:
    raise ValueError(f"{word} is no finite number")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError("a key stands twice")
    return found
