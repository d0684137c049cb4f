"""Too little address space, and settings of the environment with which a library would fail, are refused in words."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from testbed import __main__ as start
from testbed.cli import ending

resource = pytest.importorskip("resource")


def limited(megabytes: int, *arguments: str) -> subprocess.CompletedProcess[str]:
    """The command with this much address space."""
    size = megabytes * 1_000_000
    return subprocess.run(
        [sys.executable, "-m", "testbed", *arguments], capture_output=True, text=True, check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)),
    )  # fmt: skip


@pytest.mark.parametrize("megabytes", [50, 400, start.NEEDED_MB - 1])
def test_too_little_is_refused(megabytes: int) -> None:
    done = limited(megabytes, "list")
    assert done.returncode == ending.ENDED_EARLY
    assert done.stderr == (
        f"the address space is limited to {megabytes} MB, of {start.NEEDED_MB} needed: raise it by `ulimit -v`\n"
    )


@pytest.mark.nightly
def test_what_is_called_enough_is_enough(tmp_path) -> None:  # type: ignore[no-untyped-def]
    done = limited(
        start.NEEDED_MB, "run", "scenarios/left_propeller_fail.yaml", "--out", str(tmp_path / "run")
    )
    assert done.returncode == ending.MET, done.stderr


@pytest.mark.parametrize("text", ["0", "-3", "abc", "1.5", ""])
def test_a_wrong_number_of_threads_is_refused(text: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "testbed", "list"], env={**os.environ, "NUMBA_NUM_THREADS": text},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == ending.BAD_INPUT
    assert done.stderr == f"NUMBA_NUM_THREADS: is {text!r}, expected a whole number of 1 or more\n"


@pytest.mark.parametrize("text", ["1", " 2 ", None])
def test_numbers_that_numba_takes_are_taken(text: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NUMBA_NUM_THREADS", raising=False)
    if text is not None:
        monkeypatch.setenv("NUMBA_NUM_THREADS", text)
    assert start.wrong_setting() == ""


_NO_THREAD = """\
import os, resource, threading
from testbed.cli import commands
resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))
os.setuid(54321)
try:
    threading.Thread(target=print).start()
except RuntimeError as error:
    print(commands._in_words(error))
"""


@pytest.mark.skipif(
    os.name != "posix" or os.getuid() != 0, reason="needs root, who is not limited, to become another"
)
def test_a_thread_too_many_is_said() -> None:
    done = subprocess.run([sys.executable, "-c", _NO_THREAD], capture_output=True, text=True, check=True)
    assert "as many as are allowed, see `ulimit -u`" in done.stdout
