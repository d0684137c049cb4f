"""What a run, a sweep and a search leave when they are ended at any moment, and how a long sweep grows.

    nice -n 19 python benchmarks/faults.py signals [MOMENTS [SEED]]
    nice -n 19 python benchmarks/faults.py memory [FLIGHTS [FOLDER [SECONDS]]]

`signals` ends commands by Ctrl-C, SIGTERM, SIGHUP and SIGKILL at random moments, and goes on with `--resume` until each has
finished. It prints every moment at which a finished flight was lost, a traceback was shown, a process or a temporary file stayed,
or the table differs from that of an uninterrupted command. `memory` flies one sweep of short flights in two processes, and prints
the resident memory of the parent and of its workers in the course of it; with FOLDER and SECONDS a part of it, and the next call
goes on. Both need /proc.
"""

from __future__ import annotations

import math
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from testbed.studies.folder import store

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)
_STUDY = """\
name: short
scenario: scenarios/left_tail_fail.yaml
seed: 3
set:
  duration_s: {duration_s}
  failures: [{{type: effectiveness, actuator: left_ruddervator, at_s: 0.1, value: 0.2}}]
  initial: {{altitude_m: 300, airspeed_m_s: 18}}
  atmosphere: {{wind_m_s: [0, 0, 0]}}
  requirements: [{{name: held, metric: altitude_error_max_m, at_most: 1}}]
vary:
  atmosphere.wind_m_s.0: {{normal: [0, 2]}}
  atmosphere.wind_m_s.1: {{normal: [0, 2]}}
"""
_MAIN = """\
import sys; from testbed.cli import ending; ending.end_at_once()  # as the first lines of `main`
print(flush=True)
from testbed.__main__ import main; sys.exit(main())
"""
_PATIENCE_S = 60.0
"""Longest time after a command's end in which its processes may end [s]."""


@dataclass
class Command:
    """A command in a folder of its own, to be ended and begun again until it has finished."""

    folder: Path
    arguments: tuple[str, ...]
    study: bool = True

    @property
    def out(self) -> Path:
        """The folder that it makes."""
        return self.folder / "out"

    def ended(self, number: int = 0, after_s: float = 0.0) -> tuple[int, str, list[int]]:
        """Its exit status, its stderr and what is left of its processes, when it gets the signal so long after its start."""
        (self.folder / "tmp").mkdir(exist_ok=True)
        again = ["--resume"] if self.study and self.out.exists() else []
        process = subprocess.Popen(
            [sys.executable, "-c", _MAIN, *self.arguments, "--out", "out", "--no-plots", *again],
            cwd=self.folder, env={**os.environ, "TMPDIR": str(self.folder / "tmp")}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True, preexec_fn=_default,
        )  # fmt: skip
        assert process.stdout is not None
        process.stdout.readline()
        if number:
            time.sleep(after_s)
            process.send_signal(number)
        _, err = process.communicate()
        return process.returncode, err, _left(process.pid)

    def kept(self) -> int:
        """Number of its flights that are stored."""
        if not store.exists(self.out):
            return 0
        with store.reading(self.out) as flights:
            return len(flights)

    def table(self) -> bytes:
        """What it has found, in a file whose bytes depend on nothing but its inputs."""
        return (self.out / ("results.csv" if self.study else "log.csv")).read_bytes()


def commands(folder: Path) -> dict[str, Command]:
    """The three commands, each in a folder below this one."""
    found = {}
    for name, more in (("run", ()), ("sweep", ("--runs", "60")), ("search", ("--budget", "60"))):
        here = folder / name
        here.mkdir(parents=True)
        file = "scenarios/left_tail_fail.yaml" if name == "run" else "study.yaml"
        goal = "goal: smallest\n" if name == "search" else ""
        (here / "study.yaml").write_text(_STUDY.format(duration_s=0.5) + goal)
        jobs = () if name == "run" else ("--jobs", "2")
        found[name] = Command(here, (name, file, *more, *jobs), study=name != "run")
    return found


def problems(moments: int, seed: int, folder: Path) -> Iterator[str]:
    """What goes wrong at so many random moments, in words."""
    chance, whole = random.Random(seed), commands(folder / "whole")
    lasts = {}
    for name, command in whole.items():
        begun = time.monotonic()
        assert command.ended()[0] in (0, 1), name
        lasts[name] = time.monotonic() - begun
    struck = commands(folder / "struck")
    for k in range(moments):
        name = chance.choice(list(struck))
        number, after_s = chance.choice(SIGNALS), chance.uniform(0.0, lasts[name])
        for words in _struck(struck[name], whole[name], number, after_s):
            yield f"moment {k}, {name}, {signal.Signals(number).name} after {after_s:.3f} s: {words}"


def _struck(command: Command, whole: Command, number: int, after_s: float) -> Iterator[str]:
    """What is wrong after one moment; begins anew once the command has finished."""
    before = command.kept() if command.study else 0
    status, err, left = command.ended(number, after_s)
    if "Traceback" in err or status not in (0, 1, 130, -signal.SIGKILL):
        yield f"status {status}: {err}"
    if left:
        yield f"processes left: {left}"
    if number != signal.SIGKILL and (files := _litter(command.folder)):
        yield f"files left: {files}"
    kept = command.kept() if command.study else 0
    told = [int(word) for word in err.rpartition("; ")[2].split()[:1] if word.isdigit()]
    if kept < before or (told and kept < told[0]):
        yield f"{kept} flights are kept, of {before} before and {told} told"
    finished = (command.out / ("results.csv" if command.study else "log.csv")).exists()
    if finished and command.table() != whole.table():
        yield "another table"
    if finished or status in (0, 1):
        shutil.rmtree(command.out)
    shutil.rmtree(command.folder / "tmp")
    if number == signal.SIGKILL and not command.study:  # what no command can remove is not the next one's
        for path in command.folder.glob(".*"):
            shutil.rmtree(path)


def _litter(folder: Path) -> list[str]:
    """Temporary files that a command which could tidy up has left."""
    found = [*folder.glob("tmp/*"), *folder.rglob(".*")]
    return [str(path.relative_to(folder)) for path in found if ".nfs" not in path.name]


def _default() -> None:
    """Signals as a shell in the foreground gives them to its commands."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def _left(session: int) -> list[int]:
    """The processes of a session that do not end in _PATIENCE_S."""
    until = time.monotonic() + _PATIENCE_S
    while (left := [pid for pid, place, _ in _processes() if place == session]) and time.monotonic() < until:
        time.sleep(0.02)
    return left


def _processes() -> Iterator[tuple[int, int, int]]:
    """(process, session, parent) of all that run."""
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            state, parent, _, session = (folder / "stat").read_text().rpartition(")")[2].split()[:4]
        except OSError:
            continue
        if state != "Z":
            yield int(folder.name), int(session), int(parent)


def memory(
    flights: int, folder: Path, longest_s: float = math.inf, samples: int = 20
) -> list[tuple[int, int, int]]:
    """(flights finished, resident memory of the parent and the most of a worker [MB]) in the course of a sweep.

    It is ended by Ctrl-C after so long, and goes on where it was when it is called again with the same folder.
    """
    (folder / "study.yaml").write_text(_STUDY.format(duration_s=0.2))
    code = "import sys; from testbed.__main__ import main; sys.exit(main())"
    command = Command(folder, ())
    again = ["--resume"] if command.out.exists() else []
    process = subprocess.Popen(
        [sys.executable, "-c", code, "sweep", "study.yaml", "--runs", str(flights), "--jobs", "2", "--out", "out", "--no-plots",
         *again],
        cwd=folder, stdout=subprocess.DEVNULL, start_new_session=True, preexec_fn=_default,
    )  # fmt: skip
    begun, found, due = time.monotonic(), list[tuple[int, int, int]](), command.kept()
    while process.poll() is None:
        workers = [pid for pid, _, parent in _processes() if parent == process.pid]
        memory = _resident_mb(process.pid), max(map(_resident_mb, workers), default=0)
        # The number comes last: the table was not begun before flights that are still to come.
        if (done := command.kept()) >= due:
            found.append((done, *memory))
            due += flights // samples
        if time.monotonic() - begun > longest_s:
            process.send_signal(signal.SIGINT)
            process.wait()
        time.sleep(1.0)
    assert process.returncode in (0, 1, 130)
    return found


def _resident_mb(pid: int) -> int:
    try:
        return int(Path(f"/proc/{pid}/status").read_text().partition("VmRSS:")[2].split()[0]) // 1024
    except (OSError, IndexError):
        return 0


def main(what: str, number: str = "", folder: str = "", longest_s: str = "inf") -> None:
    """Print what is wrong at each moment, or the memory in the course of a sweep."""
    with tempfile.TemporaryDirectory() as scratch:
        if what == "signals":
            found, moments = 0, int(number or 200)
            for words in problems(moments, int(folder or 1), Path(scratch)):
                print(words, flush=True)
                found += 1
            print(f"{moments} moments, {found} problems")
        else:
            place = Path(folder or scratch)
            place.mkdir(parents=True, exist_ok=True)
            print("flights  parent [MB]  worker [MB]")
            for done, parent, worker in memory(int(number or 20_000), place, float(longest_s)):
                print(f"{done:7}  {parent:11}  {worker:11}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
