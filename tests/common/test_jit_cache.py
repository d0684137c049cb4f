"""Damage to the files of compiled code: it is compiled again and kept again, whatever the damage."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from full_disk import largest_file

from testbed.common import jit

_PROGRAM = """
from testbed.common import jit
def plus(a, b):
    return a + b
fast = jit.compiled(plus)
assert fast(1.0, 2.0) == 3.0
print(len(fast.stats.cache_hits), len(fast.stats.cache_misses))
"""


def hits_and_misses(folder: Path) -> str:
    """Loads from the cache and compilations in a new process, for one function with its cache in this folder."""
    file = folder / "program.py"
    file.write_text(_PROGRAM)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(folder / "cache")}
    done = subprocess.run(
        [sys.executable, str(file)], env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with compiled code that is loaded; each test leaves it so."""
    folder = tmp_path_factory.mktemp("kept")
    assert hits_and_misses(folder) == "0 1"
    assert hits_and_misses(folder) == "1 0"
    return folder


def _cut(content: bytes) -> bytes:
    return content[: len(content) // 2]


def _zeros(content: bytes) -> bytes:
    return bytes(len(content))


def _flipped(content: bytes) -> bytes:
    middle = len(content) // 2
    return content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]


def _empty(_: bytes) -> bytes:
    return b""


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("ending", "damage"),
    [("nbi", _empty), ("nbi", _cut), ("nbi", _zeros), ("nbc", _cut), ("nbc", _flipped)],
)  # fmt: skip
def test_a_damaged_file_is_made_anew(kept: Path, ending: str, damage: Callable[[bytes], bytes]) -> None:
    (file,) = kept.rglob(f"*.{ending}")
    file.write_bytes(damage(file.read_bytes()))
    assert hits_and_misses(kept) == "0 1"
    assert hits_and_misses(kept) == "1 0"


def test_a_full_disk_costs_the_cache_alone(tmp_path: Path) -> None:
    with largest_file(2000):
        assert hits_and_misses(tmp_path) == "0 1"
    assert not list(tmp_path.rglob("*.nbc"))


@pytest.mark.nightly
def test_code_is_found_again_by_a_copy_of_the_sources(tmp_path: Path) -> None:
    """Two installations with the same sources, one after the other."""
    program = (
        "from testbed.common import jit; from testbed.controllers.outer_loops import clip\n"
        "jit.bound(clip, 1.0, 1.0); print(len(clip.stats.cache_hits), len(clip.stats.cache_misses))"
    )
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")}
    environment.pop("NUMBA_CACHE_DIR", None)
    found = []
    for name in ("one", "other"):
        folder = tmp_path / name
        shutil.copytree(Path(jit.__file__).parents[1], folder / "testbed", copy_function=shutil.copyfile)
        environment["PYTHONPATH"] = str(folder)
        done = subprocess.run(
            [sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True
        )
        found.append(done.stdout.strip())
    assert found == ["0 1", "1 0"]


_RECORDS = f"""
import math, sys
import numpy as np
from testbed.common import jit
@jit.compiled
def total(record):  # too long to become a piece of its caller
    found = 0.0
    for i in range(len(record.values)):
        a = record.values[i]
        found += {" + ".join(["math.sin(a) * math.exp(-a) + math.tan(a) * math.atan(a)"] * 20)}
    return found
@jit.compiled
def twice(records):
    return total(records[0]) + total(records[1])
for n in map(int, sys.argv[1:]):
    records = np.zeros(2, [("values", float, n), ("n", float)])
    records["values"] = np.arange(1.0, n + 1.0)
    right = 2.0 * total.py_func(records.view(np.recarray)[0])
    assert math.isclose(jit.bound(twice, records)(records), right)
"""


@pytest.mark.nightly
def test_code_for_records_of_two_sizes_that_two_processes_compiled_is_told_apart(tmp_path: Path) -> None:
    """The linker takes the first of two functions of one name, and numba's names do not tell records apart."""
    file = tmp_path / "program.py"
    file.write_text(_RECORDS)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    for sizes in (("4",), ("5",), ("4", "5"), ("5", "4")):
        subprocess.run([sys.executable, str(file), *sizes], env=environment, check=True)
