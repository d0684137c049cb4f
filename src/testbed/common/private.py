"""Folders of this user's own, in which nobody else can have put anything: what is found there may be believed, and run."""

from __future__ import annotations

import contextlib
import grp
import os
import stat
import tempfile
from collections.abc import Iterator
from pathlib import Path


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


def private_folder(name: str) -> Path | None:
    """A folder of this name, made where it is missing, into which this user alone can write; None where there can be none."""
    for root in _roots():
        folder = root / name
        with contextlib.suppress(OSError):
            root.mkdir(mode=0o700, parents=True, exist_ok=True)
            if is_private(root):
                folder.mkdir(mode=0o700, exist_ok=True)
                if is_private(folder) and os.access(folder, os.W_OK):
                    return folder
    return None


def _roots() -> Iterator[Path]:
    """Where such folders may be, best first; not each is private. There may be no home folder, and no temporary folder either.

    In the temporary folder somebody else may have taken the usual name. Then it is one with a name that was free.
    """
    if home := cache_home():
        yield (home / "testbed").resolve()
    with contextlib.suppress(OSError):
        scratch = Path(tempfile.gettempdir()).resolve()
        usual = f"testbed-{os.getuid()}"
        yield scratch / usual
        yield from sorted(scratch.glob(f"{usual}-cache-*"))
        new = Path(tempfile.mkdtemp(prefix=f"{usual}-cache-", dir=scratch))
        if is_private(new):
            yield new
        else:
            new.rmdir()


def is_private(folder: Path) -> bool:
    """Whether this user and root alone can have changed what is in a folder, or which folder its path leads to.

    So each folder of its path belongs to one of them, and others cannot write into it. Where the sticky bit is set, as in /tmp,
    they can, but not move or remove what is not theirs: there it is enough for the folder below to belong to this user. A path with
    links in it is none: ask for the one that it leads to.
    """
    try:
        if folder != folder.resolve(strict=True):
            return False
        places = [(os.lstat(each), each == folder) for each in (folder, *folder.parents)]
    except (OSError, RuntimeError):
        return False
    return all(_is_safe(status, last) for status, last in places)


def _is_safe(status: os.stat_result, last: bool) -> bool:
    if not stat.S_ISDIR(status.st_mode) or status.st_uid not in (0, os.getuid()):
        return False
    others = bool(status.st_mode & stat.S_IWOTH)
    group = bool(status.st_mode & stat.S_IWGRP) and not _is_own_group(status.st_gid)
    sticky = bool(status.st_mode & stat.S_ISVTX) and not last
    return sticky or not (others or group)


def _is_own_group(number: int) -> bool:
    """Whether a group is this user's own: of the same number, and without other members."""
    try:
        return number == os.getuid() and not grp.getgrgid(number).gr_mem
    except KeyError:  # a group without a name has no other members
        return True
