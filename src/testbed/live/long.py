"""A flight of which only the last rows take memory: older ones are in files that have no name and go with the process.

A file takes the place of memory at the same address, so nothing that reads the rows notices. What is written there later is this
process's own, and no file is written twice: copies of the process that fly on differently never see each other's rows.
"""

from __future__ import annotations

import ctypes
import mmap
import os
from collections.abc import Iterator
from tempfile import TemporaryFile
from typing import Any

import numpy as np

from testbed.flight.flight import Flying, Outcome
from testbed.sensors.measurement import ERROR, FAULT, OFFSET, READING, SENSED
from testbed.simulation.conclude import so_far
from testbed.simulation.session import Session

_KEPT_S = 60.0
"""Rows of so much flight stay in memory at most [s]."""
_FOLDER = "/var/tmp"  # /tmp is memory on many systems
_FIXED = 0x10  # MAP_FIXED, which Python does not name
_LIBC = ctypes.CDLL(None, use_errno=True)
_LIBC.mmap.restype = ctypes.c_void_p
_LIBC.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *3 * [ctypes.c_int], ctypes.c_long]
_LIBC.madvise.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int]


class LongSession(Session):
    """A `Session` that puts its rows away while it flies."""

    def __init__(self, *args: Any) -> None:
        """As `Session`."""
        super().__init__(*args)
        self._away, self._next = 0, 0
        self._known: dict[int, tuple[np.ndarray, object]] = {}
        self._filled: object = None

    def step(self, n: int = 1) -> Outcome | None:
        """As `Session.step`. What `extend` and faults of sensors have filled of later rows is put away soon, too: it takes a few
        hundred megabytes."""
        ended = super().step(n)
        filled = (self.loop.steps, self.parts.scenario.sensors.faults)
        if self.loop.done >= self._next or filled != self._filled:
            self._filled = filled
            self.put_away()
        return ended

    def put_away(self) -> None:
        """Put the rows of all control steps flown into a file. They stay in memory where there can be none."""
        known, done = self._known, self.loop.done
        self._known, self._next = {}, done + int(_KEPT_S * self.parts.scenario.rate_hz)
        try:
            with TemporaryFile(dir=_FOLDER, buffering=0) as file:
                for rows, ahead in self._rows():
                    address = rows.ctypes.data
                    new = address not in known or known[address][1] != ahead
                    _map(rows, 0 if new else self._away, len(rows) if new and ahead else done, file.fileno())
                    self._known[address] = (rows, ahead)
        except OSError:  # a full disk
            self._known = {}
        self._away = done

    def so_far(self) -> Flying:
        """The flight so far, as it is told in words, in a process that is for this alone: what it reads takes no memory."""
        return so_far(
            self.parts, self.scenario, self.ended or Outcome.completed, self.loop.recorded, self._leave
        )

    def _leave(self) -> None:
        """Give back the memory of the rows that are in a file."""
        for rows in self.loop.rows:
            if rows.ctypes.data in self._known:
                low, high = _pages(rows, 0, self._away)
                _LIBC.madvise(low, max(high - low, 0), mmap.MADV_DONTNEED)

    def _rows(self) -> Iterator[tuple[np.ndarray, object]]:
        """Each array [steps, ...] of the flight; and, if its later rows have been filled too, what these depend on."""
        parts, loop = self.parts, self.loop
        yield from ((rows, None) for rows in (loop.rows.truth, loop.rows.measured, parts.weather.wind))
        yield loop.rows.telemetry, loop.steps
        yield loop.rows.references, (loop.steps, len(parts.scenario.commands))
        if parts.sensors is not None:
            drawn = (ERROR, OFFSET, FAULT) if parts.sensors.settings.faults else (ERROR,)
            for layer in (*drawn, SENSED, READING):
                ahead = (loop.steps, parts.sensors.settings.faults if layer != ERROR else ())
                yield parts.sensors.table[layer], ahead if layer in drawn else None


def _map(rows: np.ndarray, first: int, end: int, file: int) -> None:
    """Append the whole pages of these rows to a file, and have it in their place. Raises OSError."""
    low, high = _pages(rows, first, end)
    if high <= low:
        return
    offset = os.lseek(file, 0, os.SEEK_END)
    data = memoryview((ctypes.c_char * (high - low)).from_address(low))
    while data:
        data = data[os.write(file, data) :]
    how = (mmap.PROT_READ | mmap.PROT_WRITE, mmap.MAP_PRIVATE | _FIXED)
    if _LIBC.mmap(low, high - low, *how, file, offset) != low:
        raise OSError(ctypes.get_errno(), "a file cannot be mapped")
    # Pages of two megabytes would be shared with copies of this process, and kept by each.
    _LIBC.madvise(high, rows.ctypes.data + rows.nbytes - high, mmap.MADV_NOHUGEPAGE)


def _pages(rows: np.ndarray, first: int, end: int) -> tuple[int, int]:
    """Addresses of the first whole page of these rows, which may begin with others, and of what follows the last."""
    start, size, page = rows.ctypes.data, rows.strides[0], mmap.PAGESIZE
    return max(-(-start // page), (start + first * size) // page) * page, (start + end * size) // page * page
