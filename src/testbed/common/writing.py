"""The one place that opens files for writing.

A folder may have been made by somebody else, and may hold links, hard links, devices and pipes under any name. So nothing that is
there is opened. Each file is made anew, beside its place, under a name that nobody can foresee; then it takes the place, by a
rename, which replaces a link itself and not what it leads to. Folders inside the folder that was asked for are entered one by one,
each from the handle of the last, so that none of them is a link, nor becomes one meanwhile.
"""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

_FOLDER = os.O_RDONLY | os.O_DIRECTORY
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW


@contextmanager
def replacing(file: Path, within: Path | None = None, keep: bool = False) -> Iterator[BinaryIO]:
    """A stream whose contents take the place of `file` when the block ends without an error, flushed to disk.

    A reader sees the old contents or the new, never a part of them. Folders that are missing are made. Raises OSError.

    Args:
        within: the folder that was asked for, in which the file is at any depth; by default the file's own folder. No link is
            followed below it.
        keep: whether a file that is there stays, and this one is given up.
    """
    within = within or file.parent
    try:
        within.mkdir(parents=True, exist_ok=True)
        with _entered(within, file.parent.relative_to(within).parts) as folder:
            partial = f".{secrets.token_hex(8)}.partial"
            try:
                with os.fdopen(os.open(partial, _NEW, 0o666, dir_fd=folder), "wb") as stream:
                    yield stream
                    stream.flush()
                    os.fsync(stream.fileno())
                if not keep:
                    os.replace(partial, file.name, src_dir_fd=folder, dst_dir_fd=folder)
                else:
                    with suppress(FileExistsError):
                        os.link(partial, file.name, src_dir_fd=folder, dst_dir_fd=folder)
            finally:
                with suppress(FileNotFoundError):
                    os.unlink(partial, dir_fd=folder)
    except OSError as error:  # name the file that was asked for, not one with a name for the time being
        raise OSError(error.errno, error.strerror or str(error), str(file)) from error


def write(file: Path, content: str | bytes, within: Path | None = None, keep: bool = False) -> None:
    """Write a file as `replacing` does; a text in UTF-8."""
    with replacing(file, within, keep) as stream:
        stream.write(content.encode() if isinstance(content, str) else content)


def write_new(file: Path, content: str | bytes = b"") -> None:
    """Write a file where there is none, into a folder that this process has made; it is not flushed to disk.

    Raises FileExistsError where there is anything, a link too, and OSError.
    """
    with os.fdopen(os.open(file, _NEW, 0o666), "wb") as stream:
        stream.write(content.encode() if isinstance(content, str) else content)


def remove_partial(folder: Path) -> None:
    """Remove what a process that was killed had begun to write at any depth of a folder, which nobody else writes into now.

    Links are neither followed nor removed.
    """
    for found in list(folder.rglob(".*.partial")):
        if found.is_symlink():
            continue
        if found.is_dir():
            shutil.rmtree(found, ignore_errors=True)
        else:
            found.unlink(missing_ok=True)


def refuse_unsafe(file: Path) -> None:
    """Raise PermissionError for a file that must not be written in place: a link, a file with other names, no file, or another's.

    For a library that opens a path itself, as SQLite does. A file that is not there is none of these.
    """
    with suppress(FileNotFoundError):
        status = os.lstat(file)
        alone = stat.S_ISREG(status.st_mode) and status.st_nlink == 1
        if not alone or os.getuid() not in (0, status.st_uid):
            what = "is somebody else's" if alone else "is a link or a device, or has other names"
            raise PermissionError(errno.EPERM, what, str(file))


@contextmanager
def _entered(folder: Path, inside: Sequence[str]) -> Iterator[int]:
    """A handle of the folder at the end of a path; those of `inside` are made where they are missing, and none is a link."""
    handle = os.open(folder, _FOLDER)
    try:
        for name in inside:
            if name == os.pardir:
                raise NotADirectoryError(errno.ENOTDIR, "leads out of the folder", name)
            with suppress(FileExistsError):
                os.mkdir(name, dir_fd=handle)
            inner = os.open(name, _FOLDER | os.O_NOFOLLOW, dir_fd=handle)
            os.close(handle)
            handle = inner
        yield handle
    finally:
        os.close(handle)
