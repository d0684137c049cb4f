"""flights.sqlite: the finished flights of a study. This module alone reads and writes it.

A flight is stored by a key of bytes, in whose order the flights are read. Each is a transaction of its own, which outlasts the
process however that ends. A loss of power may lose the flights of the last second.

SQLite keeps transactions in flights.sqlite-wal until they are moved into the file, at the latest when it is closed; a process that
is killed leaves both files. The lock is exclusive, so that a second process is kept out, and no memory is shared between processes:
so a folder on a network file system will do.

A folder that is only read may have been made by anybody, and may be read-only. Nothing is written there: the file is opened as one
that does not change, or copied first where it may. A file whose tables are not exactly those below is refused, so nothing but
these tables is ever asked.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
import sqlite3
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager, nullcontext, suppress
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from testbed.common.writing import refuse_unsafe, write
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.record import BEGUN, CHECKED, Begun, Record

NAME = "flights.sqlite"
_APPLICATION, _VERSION = 0x666C7973, 1
"""`application_id` and `user_version` of the file."""
_TABLES = (
    "CREATE TABLE begun (inputs TEXT NOT NULL) STRICT",
    "CREATE TABLE flights (key BLOB NOT NULL PRIMARY KEY, record TEXT NOT NULL, history BLOB NOT NULL) STRICT",
)
_NEEDED = (3, 37)
"""The version of SQLite that has STRICT tables."""
_LARGEST = 16_000_000
"""Longest record that is read [bytes]."""
_SYNC_S = 1.0
"""Time between flushes to disk [s], and so the work that a loss of power may cost."""
_LARGEST_LOG, _LARGEST_COPY = 1_000_000_000, 20_000_000_000
"""Largest -wal [bytes], of which SQLite writes 4 MB at a time, and largest file that is copied beside it."""
_COPIES = 10
"""Attempts at copying a file that another process is writing."""


class Store:
    """The finished flights. Its methods raise BadInput when the file is damaged; `add` raises OSError when the disk is full."""

    def __init__(self, database: sqlite3.Connection, folder: Path) -> None:
        """Take over an open database of the folder; raises BadInput when it is no store of flights."""
        self.folder, self._database, self._synced = folder, database, time.monotonic()
        marks = self._all("PRAGMA application_id") + self._all("PRAGMA user_version")
        if marks != [(_APPLICATION,), (_VERSION,)]:
            raise self._refused("is not of this version of testbed")
        tables = self._all("SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY name")
        if tables != [(table,) for table in _TABLES]:
            raise self._refused("has other tables")

    @property
    def inputs(self) -> Begun:
        """What the study was begun with, as given to `create`."""
        try:
            ((text,),) = self._all("SELECT inputs FROM begun LIMIT 2")
            return BEGUN.validate_json(text, strict=True)
        except ValueError:
            raise self._refused("does not say what it was begun with") from None

    def __contains__(self, key: bytes) -> bool:
        return bool(self._all("SELECT 1 FROM flights WHERE key = ?", key))

    def __len__(self) -> int:
        return int(self._all("SELECT count(*) FROM flights")[0][0])

    def add(self, key: bytes, record: Record, history: bytes = b"") -> None:
        """Store a finished flight, whole or not at all."""
        text = json.dumps(vars(record), separators=(",", ":"), ensure_ascii=False)
        flush = time.monotonic() - self._synced > _SYNC_S
        with _disk_errors():
            # Each flight needs to outlast the process; a loss of power only those of some time ago.
            self._database.execute(f"PRAGMA synchronous = {'FULL' if flush else 'NORMAL'}")
            self._database.execute("INSERT INTO flights VALUES (?, ?, ?)", (key, text, history))
        self._synced = time.monotonic() if flush else self._synced

    def record(self, key: bytes) -> Record:
        """The record of a flight that is there."""
        ((text,),) = self._all("SELECT record FROM flights WHERE key = ?", key)
        return self._checked(text)

    def records(self) -> Iterator[tuple[bytes, Record]]:
        """(key, record) of every flight in the order of keys, one at a time."""
        for key, text in self._rows("SELECT key, record FROM flights ORDER BY key"):
            yield key, self._checked(text)

    def history(self, key: bytes) -> bytes:
        """The error history of a flight; b"" where there is none."""
        found = self._all("SELECT history FROM flights WHERE key = ?", key)
        return bytes(found[0][0]) if found else b""

    def close(self) -> None:
        """Move everything into the one file and flush it to disk; another process may then open it."""
        with _disk_errors():
            self._database.close()

    def _all(self, question: str, *values: object) -> list[tuple[Any, ...]]:
        return list(self._rows(question, *values))

    def _rows(self, question: str, *values: object) -> Iterator[tuple[Any, ...]]:
        try:
            # `yield from` would close the cursor, which it cannot when the database is closed already.
            for row in self._database.execute(question, values):  # noqa: UP028
                yield row
        except sqlite3.Error as error:
            if getattr(error, "sqlite_errorname", "") == "SQLITE_BUSY":  # an error of Python's own has none
                raise BadInput([Problem("is being flown by another process", str(self.folder))]) from None
            raise self._refused(f"cannot be read: {error}") from None

    def _checked(self, text: str) -> Record:
        try:
            return CHECKED.validate_json(text, strict=True)
        except ValidationError as error:
            first = error.errors(include_url=False, include_input=False)[0]
            place = ".".join(map(str, first["loc"]))
            raise self._refused(f"has a flight whose {place or 'record'} is wrong: {first['msg']}") from None

    def _refused(self, what: str) -> BadInput:
        return BadInput([Problem(what, str(self.folder / NAME), expected="a file as testbed writes it")])


@contextmanager
def _disk_errors() -> Iterator[None]:
    """What SQLite cannot write, as OSError."""
    try:
        yield
    except sqlite3.Error as error:
        raise OSError(str(error)) from None


def create(folder: Path, inputs: Mapping[str, Any]) -> None:
    """Make an empty store of a study that is begun with these inputs, whole or not at all; one that is there stays."""
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / NAME
        with _disk_errors(), closing(sqlite3.connect(file, isolation_level=None)) as database:
            for number, value in (("application_id", _APPLICATION), ("user_version", _VERSION)):
                database.execute(f"PRAGMA {number} = {value}")
            for table in _TABLES:
                database.execute(table)
            database.execute("INSERT INTO begun VALUES (?)", (json.dumps(inputs),))
            database.execute("PRAGMA locking_mode = EXCLUSIVE")
            database.execute("PRAGMA journal_mode = WAL")  # which the file keeps
        write(folder / NAME, file.read_bytes(), keep=True)  # of two processes that begin at once, the first's


def exists(folder: Path) -> bool:
    """Whether a folder has a store."""
    return (folder / NAME).is_file()


def opened(folder: Path) -> Store:
    """The store of a folder, for this process alone.

    Raises BadInput when another has it open, or when it is none of ours, and PermissionError when it cannot be written.
    """
    _refuse_links(folder)
    for file in (folder / NAME, _log(folder)):
        refuse_unsafe(file)
    for file in (folder, folder / NAME):
        if not os.access(file, os.W_OK):  # SQLite would open it, and then take it for damaged
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(file))
    return _store(folder, folder / NAME, "mode=rw", "PRAGMA locking_mode = EXCLUSIVE")


@contextmanager
def reading(folder: Path) -> Iterator[Store]:
    """The store of a folder in which nothing may be written, also while another process flies into it.

    Raises BadInput when there is none, or none of ours.
    """
    if not exists(folder):
        what, expected = "no flight has finished in this folder", ""
        if (folder / "journal.jsonl").is_file():
            what, expected = "was flown by an earlier version of testbed", "a folder of this version"
        raise BadInput([Problem(what, str(folder), expected=expected)])
    with tempfile.TemporaryDirectory() if _log(folder).exists() else nullcontext() as copy:
        file = _copied(folder, Path(copy)) if copy else folder / NAME
        with closing(_store(folder, file, "mode=rw" if copy else "mode=ro&immutable=1")) as store:
            yield store


def _store(folder: Path, file: Path, how: str, *settings: str) -> Store:
    """The store of a folder in a file, by a connection that trusts nothing in it."""
    _refuse_links(folder)
    if sqlite3.sqlite_version_info < _NEEDED:
        what = f"Python's SQLite is {sqlite3.sqlite_version}"
        raise BadInput([Problem(what, expected=f"{'.'.join(map(str, _NEEDED))} or newer")])
    address = f"{file.resolve().as_uri()}?{how}"
    try:
        database = sqlite3.connect(address, uri=True, isolation_level=None, timeout=0)
    except sqlite3.Error as error:
        raise BadInput([Problem(f"cannot be opened: {error}", str(file))]) from None
    try:
        database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LARGEST)
        for setting in ("PRAGMA trusted_schema = OFF", "PRAGMA cell_size_check = ON", *settings):
            database.execute(setting)
        return Store(database, folder)
    except BaseException:
        database.close()
        raise


def _log(folder: Path) -> Path:
    return folder / f"{NAME}-wal"


def _refuse_links(folder: Path) -> None:
    """Raise BadInput for links, which may lead out of a folder, and for a journal, which SQLite would undo: none is ours."""
    for file in (folder / NAME, _log(folder)):
        if file.is_symlink():
            raise BadInput([Problem("is a link", str(file), expected="a file")])
    journal = folder / f"{NAME}-journal"
    if os.path.lexists(journal):
        raise BadInput([Problem("is not written by testbed", str(journal), expected="no such file")])


def _copied(folder: Path, there: Path) -> Path:
    """Copy the file and its log; once more when the log was moved into the file meanwhile.

    Raises BadInput for a file that would fill the disk: one of nothing but a hole may say that it has terabytes.
    """
    for file, most in ((_log(folder), _LARGEST_LOG), (folder / NAME, _LARGEST_COPY)):
        with suppress(FileNotFoundError):
            if file.stat().st_size > most:
                what = f"has more than {most / 1e9:g} GB"
                raise BadInput([Problem(what, str(file), expected="a file as testbed writes it")])
    for _ in range(_COPIES):
        before = _stamp(folder / NAME)
        _log(there).unlink(missing_ok=True)
        with suppress(FileNotFoundError):  # a log that has just been moved into the file whole
            shutil.copyfile(_log(folder), there / _log(there).name)
        shutil.copyfile(folder / NAME, there / NAME)
        if _stamp(folder / NAME) == before:
            break
    return there / NAME


def _stamp(file: Path) -> tuple[int, int]:
    status = file.stat()
    return status.st_mtime_ns, status.st_size
