"""Read a file that a user names: a regular file of a stated size at most, or problems in words.

A device such as /dev/zero has no end, and a pipe may never have a beginning: either would hold a command for ever.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path

from testbed.inputs.problems import BadInput, Problem

MEGABYTE = 1_000_000
LARGEST_YAML = MEGABYTE
"""Largest YAML file that is read [bytes]. Shipped ones have up to 7 kB; one of this size takes seconds to read."""

_ZIP = b"PK\x03\x04"
"""How xlsx, ods and zip files begin."""


def read_text(path: str | Path, most: int = LARGEST_YAML, expected: str = "a YAML file") -> str:
    """As `read_bytes`, decoded from UTF-8, without a byte order mark, with `\\n` at the end of lines."""
    content = read_bytes(path, most, expected)
    if content.startswith(_ZIP):
        raise BadInput(
            [Problem("is a spreadsheet or an archive", str(path), expected=f"{expected}, saved as text")]
        )
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise BadInput([Problem("is not UTF-8 text", str(path), expected=expected)]) from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def read_bytes(path: str | Path, most: int, expected: str) -> bytes:
    """The contents of a regular file of at most `most` bytes.

    Raises BadInput for anything else; `expected` says what kind of file is wanted, such as "a YAML file".
    """
    file = str(path)
    if "\0" in file:
        raise BadInput([Problem("has a NUL character in its name", repr(file), expected=expected)])
    try:
        # O_NONBLOCK, because opening a pipe otherwise waits until somebody writes to it.
        with open(path, "rb", opener=lambda name, _: os.open(name, os.O_RDONLY | os.O_NONBLOCK)) as stream:
            if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
                raise BadInput([Problem("is a device or a pipe", file, expected=expected)])
            content = stream.read(most + 1)
    except FileNotFoundError:
        raise BadInput([Problem("there is no such file", file)]) from None
    except IsADirectoryError:
        raise BadInput([Problem("is a folder", file, expected=expected)]) from None
    except OSError as error:
        raise BadInput([Problem(f"cannot be read: {error.strerror}", file)]) from None
    if len(content) > most:
        size = f"{most / MEGABYTE:g} MB"
        raise BadInput([Problem(f"has more than {size}", file, expected=f"{expected} of at most {size}")])
    return content
