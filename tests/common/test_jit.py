"""Compiled code: the same results, kept on disk for these sources only, and called without a look at types."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import numba
import numpy as np
import pytest

from testbed.common import jit


def plus(a, b):  # type: ignore[no-untyped-def]
    return a + b


def add_into(a, b, out):  # type: ignore[no-untyped-def]
    for i in range(len(out)):
        out[i] = a[i] + b[i]


def test_compiled_and_bound_give_what_the_function_gives() -> None:
    """`bound` is for arguments of the types of its examples."""
    fast = jit.compiled(plus)
    assert fast(1.5, 2.0) == plus(1.5, 2.0)
    one, other, out = np.arange(3.0), np.ones(3), np.empty(3)
    add = jit.bound(jit.compiled(add_into), other, other, out)
    add(one, other, out)
    assert np.array_equal(out, one + other)


def test_kept_types_are_numbas_own() -> None:
    """Of arrays of any layout, of records, and of tuples of them."""
    record = np.zeros(2, np.dtype((np.record, [("x", np.float64, (3,)), ("flag", np.int8)])))
    frozen = np.zeros(3)
    frozen.flags.writeable = False
    values = [1, 1.5, np.zeros(3), np.zeros((2, 3)), np.zeros((2, 3)).T, np.zeros(6)[::2], record, frozen]
    values += [(np.zeros(3), np.zeros(3)), (record, (1, np.zeros((2, 3))))]
    for value in [*values, *values]:  # made, then kept
        assert jit._type_of(value) == numba.typeof(value)


def test_uncompiled_the_function_is_left_as_it_is() -> None:
    code = "from testbed.common import jit; f = lambda a: a; assert jit.bound(jit.compiled(f), 1.0) is f"
    subprocess.run([sys.executable, "-c", code], env={**os.environ, "NUMBA_DISABLE_JIT": "1"}, check=True)


def test_old_compiled_code_is_removed(tmp_path: Path) -> None:
    old, new, other = (tmp_path / name for name in ("numba-1-old", "numba-1-new", "something"))
    for folder in (old, new, other):
        folder.mkdir()
        (folder / "code.nbc").write_text("")
    long_ago = time.time() - 31 * 86400
    os.utime(old, (long_ago, long_ago))
    os.utime(other, (long_ago, long_ago))
    jit.prune(tmp_path)
    assert [folder.exists() for folder in (old, new, other)] == [False, True, True]


def test_another_folder_is_taken_where_home_cannot_be_written(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.write_text("a file, so that no folder can be made in it")
    code = "from testbed.common import jit; print(jit._FOLDER)"
    env = {**os.environ, "XDG_CACHE_HOME": str(home), "TMPDIR": str(tmp_path)}
    env.pop("NUMBA_CACHE_DIR", None)
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, text=True, check=True)
    assert Path(done.stdout.strip()).is_relative_to(tmp_path / f"testbed-{os.getuid()}")


def test_a_process_that_was_stopped_while_it_compiles_keeps_nobody_waiting(tmp_path: Path) -> None:
    fcntl = pytest.importorskip("fcntl")
    with open(tmp_path / "lock", "a") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        code = (
            "from testbed.common import jit; jit.LONGEST_WAIT_S = 0.2\n"
            "from testbed.controllers.outer_loops import clip\n"
            "print(jit.bound(clip, 1.0, 1.0)(3.0, 2.0))"
        )
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
        done = subprocess.run(
            [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
        )
    assert done.stdout == "2.0\n", done.stderr
