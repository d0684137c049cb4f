"""`testbed live` as a process of its own, and what a browser would send to it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from time import monotonic
from typing import Any
from urllib.parse import urlsplit

import numpy as np
from command_line import ROOT
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin


@contextmanager
def serving(folder: Path, *arguments: str) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """The address of a server that writes into a folder, and its process; it is ended as a user does, by Ctrl-C."""
    command = [sys.executable, "-m", "testbed", "live", *arguments, "--no-browser"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    process = subprocess.Popen(
        command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        assert process.stdout is not None
        for line in process.stdout:
            if line.startswith("flying at "):
                yield line.split()[-1], process
                break
        else:
            raise AssertionError("the server has ended")
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
        try:
            process.wait(30)
        finally:
            process.kill()
            process.stdout.close()


class Page:
    """A page without a browser: it connects, asks, and keeps what it is told."""

    def __init__(self, address: str, origin: str | None = None) -> None:
        at = urlsplit(address)
        uri = f"ws://{at.netloc}/flight?{at.query}"
        self._open = ExitStack()
        page = connect(uri, origin=Origin(origin or f"http://{at.netloc}"), close_timeout=0.2)
        self.socket: ClientConnection = self._open.enter_context(page)
        self.notes: list[dict[str, Any]] = []
        self.asked = 0
        self._read = 0  # notes that `until` has gone past

    def hear(self, timeout_s: float = 20.0) -> dict[str, Any]:
        """The next note. Raises TimeoutError if none comes."""
        end = monotonic() + timeout_s
        while True:
            said = self.socket.recv(max(end - monotonic(), 0.0))
            if isinstance(said, str):
                self.notes.append(json.loads(said))
                return self.notes[-1]

    def see(self) -> float:
        """The time of the next frame [s]."""
        said: str | bytes = ""
        while isinstance(said, str):
            said = self.socket.recv(20.0)
        return float(np.frombuffer(said, "<f4")[0])

    def until(self, kind: str, **about: Any) -> dict[str, Any]:
        """The next note of this kind, in which these keys have these values; raises TimeoutError.

        Notes that came before the answer to the last message count, too: which comes first is not said.
        """
        end = monotonic() + 30.0
        while True:
            if self._read == len(self.notes):
                self.hear(end - monotonic())
            note = self.notes[self._read]
            self._read += 1
            if note["note"] == kind and all(note.get(key) == value for key, value in about.items()):
                return note

    def ask(self, do: str, **more: Any) -> dict[str, Any]:
        """Ask for something; returns the answer."""
        self.asked += 1
        self._read = len(self.notes)
        self.socket.send(json.dumps({"id": self.asked, "do": do, **more}))
        while True:
            note = self.hear()
            if note["note"] in ("done", "refused") and note["id"] == self.asked:
                return note

    def close(self) -> None:
        self._open.close()
