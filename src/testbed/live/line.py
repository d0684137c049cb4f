"""A line between two processes of this machine: whole messages, which copies of a process can send on it, too."""

from __future__ import annotations

import contextlib
import pickle
import select
import socket
import zlib
from typing import Any, Self

_LONGEST = 8_000_000  # [bytes]
_LONG = 50_000  # longer ones are compressed: the system takes about 200 000 bytes at once
_COMPRESSED = 0x78  # the first byte of zlib's; pickle's is another


class Line:
    """One end. Both ends are this program's own: what comes is believed."""

    def __init__(self, end: socket.socket) -> None:
        self._end = end

    @classmethod
    def pair(cls) -> tuple[Self, Self]:
        """Both ends of a new line."""
        one, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        return cls(one), cls(other)

    def say(self, what: Any) -> None:
        """Send something; if the other end is gone, nobody hears it."""
        data = pickle.dumps(what)
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            self._end.send(data if len(data) < _LONG else zlib.compress(data, 1))

    def hear(self, wait_s: float | None = None) -> Any:
        """The next message; None if none comes within this time [s]. Raises EOFError if the other end is gone."""
        if wait_s is not None and not select.select([self._end], [], [], wait_s)[0]:
            return None
        try:
            data = self._end.recv(_LONGEST)
        except ConnectionResetError:
            data = b""
        if not data:
            raise EOFError
        return pickle.loads(zlib.decompress(data) if data[0] == _COMPRESSED else data)

    @property
    def gone(self) -> bool:
        """Whether the other end says nothing any more, even if messages of it are left."""
        poll = select.poll()
        poll.register(self._end, select.POLLRDHUP)
        return bool(poll.poll(0))

    def finish(self) -> None:
        """Say that nothing more will be said; the other end can go on to speak."""
        with contextlib.suppress(OSError):
            self._end.shutdown(socket.SHUT_WR)

    def close(self) -> None:
        """Give this end up; copies of this process keep theirs."""
        self._end.close()
