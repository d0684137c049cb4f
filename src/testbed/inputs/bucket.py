"""Folders in a bucket, or wherever else fsspec reaches: a study's folder is copied there and fetched from there."""

from __future__ import annotations

import shutil
from pathlib import Path, PurePosixPath
from typing import Any

from testbed.common.writing import replacing
from testbed.inputs.problems import BadInput, Problem

_EXAMPLE = "an address such as s3://bucket/folder"


def is_address(text: str | Path) -> bool:
    """Whether a text is the address of a folder elsewhere, such as s3://bucket/folder."""
    return "://" in str(text)


def refuse(address: str, *, there: bool) -> None:
    """Raise BadInput when an address cannot be reached, or is there already where it must not be (`there` False)."""
    fs, root = _reached(address)
    if not there and _files(fs, root, address):
        raise BadInput([Problem("exists already", address, expected="a new folder, or --resume")])


def send(folder: Path, address: str) -> None:
    """Copy each file of a folder; what is there under another name stays. Raises BadInput when it cannot be copied."""
    fs, root = _reached(address)
    for file in sorted(each for each in folder.rglob("*") if each.is_file() and not each.is_symlink()):
        try:
            fs.put_file(str(file), f"{root}/{file.relative_to(folder).as_posix()}")
        except Exception as error:  # each service has exceptions of its own
            raise BadInput([_failed("cannot be written", address, error)]) from error


def fetch(address: str, folder: Path) -> Path:
    """Copy all files of an address into a new folder, and return it. Raises BadInput when there are none, or one cannot be had."""
    fs, root = _reached(address)
    files = _files(fs, root, address)
    if not files:
        raise BadInput([Problem("there is nothing", address, expected="the folder of a study")])
    for name in files:
        part = PurePosixPath(name.removeprefix(root).lstrip("/"))
        if ".." in part.parts:
            raise BadInput([Problem(f"holds {str(part)!r}, which leads out of it", address)])
        try:
            with fs.open(name, "rb") as source, replacing(folder / part, within=folder) as target:
                shutil.copyfileobj(source, target)
        except Exception as error:
            raise BadInput([_failed("cannot be read", address, error)]) from error
    return folder


def _reached(address: str) -> tuple[Any, str]:
    """fsspec's file system of an address, and the folder in it."""
    try:
        from fsspec.core import url_to_fs
    except ImportError:
        raise BadInput([Problem("needs fsspec", address, expected="pip install 'testbed[bucket]'")]) from None
    try:
        fs, root = url_to_fs(address)
    except (ImportError, ValueError, OSError) as error:
        # A package of the protocol's own is missing, or there is none.
        raise BadInput([Problem(str(error), address, expected=_EXAMPLE)]) from None
    return fs, str(root).rstrip("/")


def _files(fs: Any, root: str, address: str) -> list[str]:
    fs.invalidate_cache()
    try:
        return sorted(fs.find(root))
    except FileNotFoundError:
        return []
    except Exception as error:
        raise BadInput([_failed("cannot be reached", address, error)]) from error


def _failed(what: str, address: str, error: Exception) -> Problem:
    return Problem(f"{what}: {str(error) or type(error).__name__}", address)
