"""Ctrl-C at many moments: one line and exit status 130, and nothing half-written."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import interruptible

_FLIGHT = ["run", "scenarios/left_tail_fail.yaml", "--out", "out", "--set", "requirements=[]"]
_FLIGHT += ["--set", "duration_s=3600"]  # longer than any of the waits below


def interrupted(
    folder: Path, after_s: float, *arguments: str, by: signal.Signals = signal.SIGINT
) -> tuple[int, str]:
    """Exit status and last line of a command that gets a signal so long after Ctrl-C is first handled."""
    begun = folder / "begun"
    begun.unlink(missing_ok=True)
    code = (
        "import sys; from testbed.cli import ending; ending.end_at_once()\n"  # as the first lines of `main`
        f"open({str(begun)!r}, 'w').close()\n"
        "from testbed.__main__ import main; sys.exit(main())"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code, *arguments], cwd=folder,
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=interruptible,
    )  # fmt: skip
    while not begun.exists():
        time.sleep(0.001)
    time.sleep(after_s)
    process.send_signal(by)
    _, err = process.communicate()
    return process.returncode, "".join(err.splitlines()[-1:]) if "Traceback" not in err else err


@pytest.mark.parametrize(
    "after_s",
    [
        0.0,
        0.3,
        pytest.param(0.6, marks=pytest.mark.nightly),
        1.2,
        pytest.param(2.4, marks=pytest.mark.nightly),
    ],
)
def test_ctrl_c_in_a_run_is_one_line(tmp_path: Path, after_s: float) -> None:
    assert interrupted(tmp_path, after_s, *_FLIGHT) == (130, "interrupted")
    assert [path.name for path in tmp_path.iterdir()] == ["begun"]


@pytest.mark.parametrize("by", [signal.SIGTERM, signal.SIGHUP])
def test_a_schedulers_signal_and_a_closed_terminal_are_as_ctrl_c(tmp_path: Path, by: signal.Signals) -> None:
    assert interrupted(tmp_path, 0.3, *_FLIGHT, by=by) == (130, "interrupted")


def test_ctrl_c_while_it_imports(tmp_path: Path) -> None:
    assert interrupted(tmp_path, 0.1, "validate", "scenarios/left_tail_fail.yaml") == (130, "interrupted")


@pytest.mark.parametrize("by", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_after_the_end_changes_nothing(tmp_path: Path, by: signal.Signals) -> None:
    """When Python takes itself apart, it has given its handlers back already."""
    code = (
        "import os, sys\n"
        "class Late:\n"
        f"    def __del__(self, kill=os.kill, pid=os.getpid()): kill(pid, {int(by)})\n"
        "late = Late()\n"
        "from testbed.__main__ import main; sys.exit(main(['list', 'metrics']))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, preexec_fn=interruptible
    )
    assert (done.returncode, done.stderr) == (0, "")


def said(code: str) -> str:
    """What a program that ends well and complains of nothing prints."""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, preexec_fn=interruptible
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_an_interrupt_that_a_callback_swallows_is_sent_again() -> None:
    """The interpreter cannot raise what a weak reference's callback raises."""
    code = (
        "import signal, time, weakref; from testbed.cli import ending; ending.end_at_once()\n"
        "class Thing: pass\n"
        "thing = Thing(); seen = weakref.ref(thing, lambda _: signal.raise_signal(signal.SIGINT))\n"
        "try:\n"
        "    with ending.tidily():\n"
        "        del thing; print('swallowed', flush=True)\n"
        "        time.sleep(60)\n"
        "except KeyboardInterrupt: print('tidied up')"
    )
    assert said(code) == "swallowed\ntidied up\n"


def test_an_interrupt_that_native_code_gives_another_name_is_an_interrupt() -> None:
    """Pydantic wraps whatever a serialiser of a class raises."""
    code = (
        "import signal; from testbed.cli import ending; ending.end_at_once()\n"
        "from pydantic import RootModel, model_serializer\n"
        "class Value(RootModel[int]):\n"
        "    @model_serializer\n"
        "    def write(self): signal.raise_signal(signal.SIGINT)\n"
        "try:\n"
        "    with ending.tidily(): Value(1).model_dump()\n"
        "except KeyboardInterrupt as error: print(type(error.__cause__).__name__)"
    )
    assert said(code) == "PydanticSerializationError\n"


def test_an_ignored_interrupt_stays_ignored(tmp_path: Path) -> None:
    """As in the background of a shell, or under nohup."""
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        process = subprocess.Popen(
            [sys.executable, "-m", "testbed", "list", "aircraft"], cwd=tmp_path, stdout=subprocess.DEVNULL
        )
        os.kill(process.pid, signal.SIGINT)
        assert process.wait() == 0
    finally:
        signal.signal(signal.SIGINT, before)
