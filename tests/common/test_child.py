"""A child answers, or ends, or is ended; the one that asks is told how, and none is left behind."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from testbed.common import child
from testbed.common.child import Limits, ask

_MODULES = {
    "echo": "print('JSBSim says', end='')\n    yield {'first': 1}\n    print('{not JSON')\n    yield {'got': request}",
    "here": "import os\n    yield {'here': os.listdir(), 'threads': os.environ['OMP_NUM_THREADS']}",
    "killed": "import os, sys\n    yield {'first': 1}\n"
    "    print('last words', file=sys.stderr, flush=True)\n    os.kill(os.getpid(), 11)",
    "endless": "while True: pass\n    yield {}",
    "sleeping": "import os, pathlib, time\n"
    "    pathlib.Path(request).write_text(str(os.getpid()))\n    time.sleep(600)\n    yield {}",
    "greedy": "yield {'size': len(bytearray(request))}",
    "writing": "import pathlib\n    pathlib.Path(request).write_text('x')\n    yield {}",
    "raising": "yield {'first': 1}\n    raise ValueError('of no use')",
}


@pytest.fixture(autouse=True)
def modules(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Modules for children, on their path."""
    for name, body in _MODULES.items():
        head = "from testbed.common.child import answer\n\n\ndef of(request):\n    "
        (tmp_path / f"child_{name}.py").write_text(f"{head}{body}\n\n\nanswer(of)\n")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))


def test_it_answers_among_what_others_print() -> None:
    ended = ask("child_echo", {"a": [1, "ä"]}, Limits(10))
    assert (ended.answers, ended.status) == (({"first": 1}, {"got": {"a": [1, "ä"]}}), 0)
    assert (ended.overtime, ended.signal, ended.last) == ("", "", {"got": {"a": [1, "ä"]}})


def test_it_runs_in_an_empty_folder_with_one_thread() -> None:
    assert ask("child_here", None, Limits(10)).last == {"here": [], "threads": "1"}


def test_the_signal_that_ended_it_is_named_after_its_last_words() -> None:
    ended = ask("child_killed", None, Limits(10))
    assert (ended.signal, ended.errors.strip(), ended.last) == ("SIGSEGV", "last words", {"first": 1})


def test_an_exception_is_its_last_words() -> None:
    ended = ask("child_raising", None, Limits(10))
    assert (ended.status, ended.last) == (1, {"first": 1})
    assert ended.errors.endswith("ValueError: of no use\n")


def test_one_that_computes_for_ever_uses_up_its_processor_time() -> None:
    assert ask("child_endless", None, Limits(1)).overtime == "1 s of processor time"


def test_one_that_waits_is_ended_by_the_clock(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(child, "_PATIENCE", 0.2)
    assert ask("child_sleeping", str(tmp_path / "pid"), Limits(10)).overtime == "2 s"


def test_its_memory_is_limited() -> None:
    assert ask("child_greedy", 300_000_000, Limits(10)).last == {"size": 300_000_000}
    ended = ask("child_greedy", 300_000_000, Limits(10, memory_bytes=300_000_000))
    assert ended.errors.strip().endswith("MemoryError") and not ended.answers


def test_it_writes_no_file_unless_it_may(tmp_path: Path) -> None:
    file = tmp_path / "written"
    assert ask("child_writing", str(file), Limits(10)).last == {} and file.read_text() == "x"
    refused = ask("child_writing", str(file), Limits(10, writes_files=False))
    assert "File too large" in refused.errors and file.read_text() == ""


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="looks at /proc")
def test_it_ends_with_the_process_that_asked(tmp_path: Path) -> None:
    file = tmp_path / "pid"
    program = (
        f"from testbed.common.child import Limits, ask; ask('child_sleeping', {str(file)!r}, Limits(10))"
    )
    asking = subprocess.Popen([sys.executable, "-c", program], env=child.environment())
    while not (file.is_file() and file.read_text()):
        assert asking.poll() is None
        time.sleep(0.01)
    asking.send_signal(signal.SIGKILL)
    asking.wait()
    until = time.monotonic() + 60
    while _runs(int(file.read_text())):
        assert time.monotonic() < until, "it is still there"
        time.sleep(0.01)


def _runs(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_a_signal_without_a_name_has_its_number() -> None:
    assert (child.signal_name(9), child.signal_name(99)) == ("SIGKILL", "signal 99")
