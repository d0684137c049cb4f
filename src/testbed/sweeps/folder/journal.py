"""journal.jsonl: one line of JSON for each flight, written as soon as it has finished. Lines are only ever appended.

The first line has the versions, aircraft and function with which the sweep is flown (see `resuming`). Each further line is
a flight's record (see `workers.flying`). Every line ends in a checksum. An incomplete or damaged line does not count: its
flight is flown again. A lock keeps a second process out; the operating system releases it when the process that holds it
ends, in whatever way.
"""

from __future__ import annotations

import fcntl
import json
import os
import time
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from testbed.inputs.problems import BadInput, Problem

_MARK = b',"crc32":"'
_SYNC_S = 1.0
"""Time between flushes to disk [s], and so the work that a power cut may lose; a killed process loses none."""


def encode(record: Mapping[str, Any]) -> bytes:
    """The line of a record, with its checksum."""
    body = json.dumps(record, separators=(",", ":"), ensure_ascii=False).encode()[:-1]
    return body + _MARK + f"{zlib.crc32(body):08x}".encode() + b'"}\n'


def decode(line: bytes) -> dict[str, Any] | None:
    """The record of a line; None when the line is incomplete or damaged."""
    body, mark, tail = line.rpartition(_MARK)
    if not mark or tail != f'{zlib.crc32(body):08x}"}}\n'.encode():
        return None
    record: dict[str, Any] = json.loads(body + b"}")
    return record


def records(file: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    """(offset, record) of every line that counts, one at a time; `offset` is the line's first byte in the file."""
    offset = 0
    with file.open("rb") as stream:
        for line in stream:
            record = decode(line)
            if record is not None:
                yield offset, record
            offset += len(line)


class Journal:
    """The journal, open for appending by this process alone."""

    def __init__(self, file: Path) -> None:
        """Open or create it. Raises BadInput when another process has it open, OSError when it cannot be opened."""
        self.file = file
        self._handle = os.open(file, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
        try:
            fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(self._handle)
            raise BadInput([Problem("is being flown by another process", str(file.parent))]) from None
        self._end = self._cut_incomplete_line()
        self._synced = time.monotonic()

    def append(self, record: Mapping[str, Any]) -> int:
        """Append one record, whole or not at all, and return its offset. Raises OSError when the disk is full."""
        line, offset = encode(record), self._end
        try:
            written = os.write(self._handle, line)
            while written < len(line):  # on a nearly full disk only a part may be written
                written += os.write(self._handle, line[written:])
            if time.monotonic() - self._synced > _SYNC_S:
                os.fsync(self._handle)
                self._synced = time.monotonic()
        except BaseException:
            os.ftruncate(self._handle, offset)
            raise
        self._end = offset + len(line)
        return offset

    def read(self, offset: int) -> dict[str, Any]:
        """The record at an offset."""
        size = 4096
        while b"\n" not in (block := os.pread(self._handle, size, offset)) and offset + size < self._end:
            size *= 4
        record = decode(block[: block.index(b"\n") + 1])
        if record is None:
            raise BadInput([Problem("was changed while it was read", str(self.file))])
        return record

    def close(self) -> None:
        """Flush the journal to disk and close it; another process may then open it."""
        try:
            os.fsync(self._handle)
        finally:
            os.close(self._handle)

    def _cut_incomplete_line(self) -> int:
        """Cut off an incomplete last line, which a killed process may leave; returns the length of the file [bytes]."""
        size = os.fstat(self._handle).st_size
        end, chunk = size, 1 << 16
        while end:
            start = max(0, end - chunk)
            newline = os.pread(self._handle, end - start, start).rfind(b"\n")
            if newline >= 0:
                end = start + newline + 1
                break
            end = start
        if end < size:
            os.ftruncate(self._handle, end)
        return end
