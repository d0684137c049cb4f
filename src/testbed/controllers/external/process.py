"""A controller in a process of its own: one JSON object a line on its standard input, one back on its standard output.

The first line says what is flown; each further one is a control step, and is answered before the aircraft moves on. The whole
protocol is docs/reference/any_language.md.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import weakref
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, NoReturn

from testbed.common.child import signal_name
from testbed.common.writing import write, write_new
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.controllers.user.adapter import Reference, Sensed, State

PROTOCOL = 1
"""Version of the protocol, `testbed` in the first line."""
START_S, STEP_S, END_S = 60.0, 10.0, 2.0
"""How long the process may take to answer the first line and a step, and to end by itself [s]."""
CONSOLE = "console.txt"
"""In the folder of an autopilot: what it wrote to its two outputs."""
_LONGEST_LINE = 1_000_000
_OUTPUT, _MOST_KEPT = "stderr.txt", 10_000_000


class Process:
    """Flies one flight with a process that is started for it."""

    def __init__(
        self, setup: Setup, words: Sequence[str], name: str = "", environment: Mapping[str, str] | None = None
    ) -> None:
        self._name, self._time_s, self._step, self._rest = name or Path(words[0]).name, 0.0, -1, b""
        self._plan, self._errors = setup.plan, tempfile.TemporaryFile()  # noqa: SIM115, closed by `close`
        self._process = self._started(words, environment)
        self._end = weakref.finalize(self, ended, self._process)
        self._told: dict[str, Any] = {}
        try:
            self._answer({"testbed": PROTOCOL, **told(setup)}, START_S)
        except BaseException:
            self._end()
            raise

    def _started(
        self, words: Sequence[str], environment: Mapping[str, str] | None
    ) -> subprocess.Popen[bytes]:
        try:
            return subprocess.Popen(
                guarded(words),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._errors,
                env=environment,
                start_new_session=True,
            )
        except OSError as error:
            raise self._problem(f"cannot be started: {error.strerror}") from None

    def update(self, time_s: float, state: State, reference: Reference, sensed: Sensed) -> Sequence[float]:
        """The commands that the process answers with."""
        self._time_s, self._step = time_s, self._step + 1
        said = {"step": self._step, "sensed": sensed._asdict(), "reference": reference._asdict()}
        answer = self._answer(said, STEP_S)
        if "commands" not in answer:
            raise self._problem("answered without commands", expected='{"commands": [...]}')
        self._told |= answer
        commands: Sequence[float] = answer["commands"]
        return commands

    @property
    def effectiveness(self) -> Sequence[float] | None:
        """What the process took each actuator's effectiveness for when it said so last; None if it never did."""
        return self._told.get("effectiveness")

    @property
    def failed(self) -> Sequence[float] | None:
        """What the process took for failed when it said so last; None if it never did."""
        return self._told.get("failed")

    def close(self) -> None:
        """End the process: the end of its input tells it, then a signal. What it wrote to its standard error is kept."""
        self._end()
        if self._plan is not None:
            self._errors.seek(0)
            write(self._plan.folder / _OUTPUT, self._errors.read(_MOST_KEPT))
        self._errors.close()

    def _answer(self, said: Mapping[str, Any], within_s: float) -> dict[str, Any]:
        """Send one line, and read one."""
        stdin = self._process.stdin
        assert stdin is not None
        if b"\n" in self._rest:
            raise self._problem("answered more than once", expected="one answer to each line")
        try:
            stdin.write(json.dumps(said).encode() + b"\n")
            stdin.flush()
        except OSError:
            self._dead()
        line = self._line(time.monotonic() + within_s, within_s)
        try:
            answer = json.loads(line, parse_constant=_no_number)
        except (ValueError, RecursionError):
            raise self._problem(f"answered {_excerpt(line)}", expected="one JSON object in a line") from None
        if not isinstance(answer, dict):
            raise self._problem(f"answered {_excerpt(line)}", expected="a JSON object")
        if "problem" in answer:
            raise self._problem(f"said: {answer['problem']!s:.2000}")
        if answer.get("step", self._step) != self._step:
            what = f"answered for step {answer['step']!r} in step {self._step}"
            raise self._problem(what, expected="one answer to each line")
        return answer

    def _line(self, until_s: float, within_s: float) -> bytes:
        """The next line of the process; raises BadInput when it ends, is silent, or writes without end."""
        stdout = self._process.stdout
        assert stdout is not None
        while b"\n" not in self._rest:
            if len(self._rest) > _LONGEST_LINE:
                raise self._problem(f"wrote {_LONGEST_LINE:,} bytes without the end of a line")
            left_s = until_s - time.monotonic()
            if left_s <= 0 or not select.select([stdout], [], [], left_s)[0]:
                raise self._problem(f"has not answered within {within_s:g} s")
            read = os.read(stdout.fileno(), 1 << 16)
            if not read:
                self._dead()
            self._rest += read
        line, _, self._rest = self._rest.partition(b"\n")
        return line

    def _dead(self) -> NoReturn:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(END_S)
        raise self._problem(how_it_ended(self._process, self._errors) or "closed its output")

    def _problem(self, what: str, expected: str = "") -> BadInput:
        when = f"at {self._time_s:.3f} s " if self._step >= 0 else "before the flight "
        return BadInput([Problem(when + "it " + what, self._name, expected=expected)])


class Autopilot:
    """An executable that is started for one flight, in the folder of `Setup.plan`. What it takes for failed is not said."""

    def __init__(self, setup: Setup, path: str, warm_up_s: float) -> None:
        self._name, self._dt, self._pitch = os.path.basename(path), setup.dt_s, setup.trim_pitch
        self._time_s, self._frames, self._sent = -warm_up_s, 0, 0
        if setup.plan is None:
            raise self._problem("is flown only with a plan of the flight")
        self._folder = setup.plan.folder

    def _start(
        self,
        command: Sequence[str],
        sockets: Sequence[socket.socket],
        environment: Mapping[str, str] | None = None,
    ) -> None:
        """Start it with no input; at its end the sockets are closed too."""
        try:
            write_new(self._folder / CONSOLE)
            with open(self._folder / CONSOLE, "r+b") as console:
                self._process = subprocess.Popen(
                    guarded(command),
                    cwd=self._folder,
                    env=environment,
                    stdin=subprocess.DEVNULL,
                    stdout=console,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                )
        except OSError as error:
            _close(sockets)
            raise self._problem(f"cannot be started: {error.strerror}") from None
        self._end = weakref.finalize(self, ended, self._process, sockets)

    def _tell_to_end(self) -> None:
        with contextlib.suppress(OSError):
            self._process.send_signal(signal.SIGTERM)

    def _living(self) -> None:
        """Raise BadInput if it has ended."""
        with open(self._folder / CONSOLE, "rb") as console:
            if how := how_it_ended(self._process, console):
                raise self._problem(how)

    def _problem(self, what: str, expected: str = "") -> BadInput:
        when = f"at {self._time_s:.3f} s " if self._frames and self._time_s >= 0.0 else self._before()
        return BadInput([Problem(when + "it " + what, self._name, expected=expected)])

    def _before(self) -> str:
        return "before the flight "


def started(setup: Setup, words: Sequence[str]) -> Process:
    """The controller of one flight; raises BadInput when the process cannot be started or does not answer."""
    return Process(setup, words)


def told(setup: Setup) -> dict[str, Any]:
    """What a controller outside of the program is told before a flight, as JSON holds it."""
    plan = setup.plan
    actuators = [
        {"name": name, "kind": kind, "low": each.low, "high": each.high, "rate": each.rate, "trim": trim}
        for name, kind, each, trim in zip(
            setup.model.actuators, setup.model.kinds, setup.actuators, setup.trim_commands, strict=True
        )
    ]
    said = {
        "aircraft": setup.aircraft,
        "dt_s": setup.dt_s,
        "trim_pitch": setup.trim_pitch,
        "actuators": actuators,
    }
    said["parameters"] = dict(setup.parameters)
    if plan is not None:
        said |= {"seed": plan.seed, "folder": str(plan.folder), "scenario": dict(plan.scenario)}
    return said


def guarded(words: Sequence[str]) -> list[str]:
    """The command, which the kernel ends with this process where it can be asked to; elsewhere the end of its input tells it."""
    guard = shutil.which("setpriv")
    return [guard, "--pdeathsig", "KILL", *words] if guard else list(words)


def how_it_ended(process: subprocess.Popen[bytes], errors: IO[bytes]) -> str:
    """How a process has ended, with the last line that it wrote to this file; empty while it goes on."""
    status = process.poll()
    if status is None:
        return ""
    how = f"ended with status {status}" if status >= 0 else f"was ended by {signal_name(-status)}"
    words = _last_words(errors)
    return how + (f'; its last words: "{words}"' if words else "")


def ended(process: subprocess.Popen[bytes], sockets: Sequence[socket.socket] = ()) -> None:
    """End a process and those that it has started: tell it by the end of its input, wait, then end the whole group."""
    with contextlib.suppress(OSError):
        if process.stdin:
            process.stdin.close()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(END_S)
    with contextlib.suppress(OSError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    if process.stdout:
        process.stdout.close()
    _close(sockets)


def _close(sockets: Sequence[socket.socket]) -> None:
    for each in sockets:
        each.close()


def _no_number(text: str) -> NoReturn:
    raise ValueError(f"{text} is no number of JSON")


def _excerpt(line: bytes) -> str:
    """The beginning of what a process wrote, for a message."""
    text = repr(line[:80].decode(errors="replace"))
    return text if len(line) <= 80 else f"{text} ..."


def _last_words(errors: IO[bytes]) -> str:
    """The last line that a process wrote to its standard error, without what a terminal would act on."""
    errors.seek(max(0, errors.seek(0, os.SEEK_END) - 400))
    lines = errors.read().decode(errors="replace").strip().splitlines()
    return "".join(c if c.isprintable() else " " for c in lines[-1]) if lines else ""
