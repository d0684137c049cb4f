"""A file that a command is asked to write: refused before the work if it cannot be made, and written whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryFile
from typing import BinaryIO

from testbed.common.writing import replacing
from testbed.inputs.problems import BadInput, Problem


def refuse_unwritable(file: Path, is_ours: Callable[[Path], bool] = lambda _: False) -> None:
    """Raise BadInput when there is something at this path already, or no file can be made there.

    Folders above it that do not exist are made.

    Args:
        is_ours: whether a regular file that is there may be replaced, because it was made by the same command.
    """
    if "\0" in str(file):
        raise BadInput([Problem("has a NUL character in its name", repr(str(file)))])
    with writing(file):
        if os.path.lexists(file) and not (file.is_file() and is_ours(file)):
            raise BadInput([Problem("exists already", str(file), expected="a file that does not exist yet")])
        with suppress(FileNotFoundError):
            os.lstat(file)  # a name that is too long
        file.parent.mkdir(parents=True, exist_ok=True)
        TemporaryFile(dir=file.parent).close()


@contextmanager
def written(file: Path) -> Iterator[BinaryIO]:
    """A stream that takes the place of `file` when the block ends without an error; raises BadInput if it cannot."""
    with writing(file), replacing(file) as stream:
        yield stream


@contextmanager
def writing(place: Path) -> Iterator[None]:
    """For a block that writes a file or a folder: raises BadInput, with `place`, where that cannot be done."""
    try:
        yield
    except OSError as error:
        raise BadInput([cannot_write(place, error)]) from None


def cannot_write(place: Path, error: OSError) -> Problem:
    """Why no file or folder can be made there: what should be a folder above it is none, or else what the system says."""
    above = next(filter(os.path.lexists, place.parents), None)
    blocked = above is not None and not above.is_dir()
    why = f"{above} is a file, not a folder" if blocked else error.strerror or str(error)
    return Problem(f"cannot be written: {why}", str(place))
