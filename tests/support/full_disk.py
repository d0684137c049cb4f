"""A disk on which files cannot grow: beyond a size, writing fails as on a full disk (EFBIG, an OSError like ENOSPC)."""

from __future__ import annotations

import contextlib
import resource
import sys
from collections.abc import Iterator


@contextlib.contextmanager
def largest_file(size: int) -> Iterator[None]:
    """While in the block, no file of this process can be written beyond its first `size` bytes.

    Nor does Python write what it compiles: it would not notice that a file was cut short (CPython issue 126606), and every later
    test that imports the module would fail.
    """
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    writes_bytecode, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        sys.dont_write_bytecode = writes_bytecode
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
