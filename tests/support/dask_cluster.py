"""A Dask scheduler and two workers, real processes on 127.0.0.1 that have the package and nothing else."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from command_line import ROOT


class Cluster:
    """A scheduler and two workers, each a process in a session of its own."""

    def __init__(self, folder: Path) -> None:
        source = str(ROOT / "src")
        self._environment = {**os.environ, "PYTHONPATH": source, "TMPDIR": str(folder)}
        self._folder = folder
        file = folder / "scheduler.json"
        self.processes = [self._start("scheduler", "--port", "0", "--scheduler-file", str(file))]
        while not file.is_file() or not file.read_text().endswith("}"):
            assert self.processes[0].poll() is None
            time.sleep(0.02)
        self.address: str = json.loads(file.read_text())["address"]
        options = ["--nthreads", "1", "--no-nanny", "--local-directory", str(folder)]
        self.processes += [self._start("worker", self.address, *options) for _ in range(2)]

    def _start(self, what: str, *options: str) -> subprocess.Popen[bytes]:
        arguments = [sys.executable, "-m", "dask", what, "--host", "127.0.0.1", "--no-dashboard", *options]
        return subprocess.Popen(
            arguments, cwd=self._folder, env=self._environment, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip

    def kill_worker(self) -> None:
        os.killpg(self.processes[-1].pid, signal.SIGKILL)

    def close(self) -> None:
        for process in reversed(self.processes):
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
