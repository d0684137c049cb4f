"""A sweep in a narrow place: few open files, a small disk. It says so in one line, and keeps what has flown."""

from __future__ import annotations

import resource
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from sweep_files import command, finished, fly_here, same_rows, written

from testbed.studies.load import load_sweep

pytestmark = pytest.mark.nightly


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of half a megabyte."""
    folder = tmp_path / "disk"
    folder.mkdir()
    if _mounted(folder, "-t", "tmpfs", "tmpfs", "-o", "size=512k"):
        pytest.skip("needs root, to mount a tmpfs")
    yield folder
    subprocess.run(["umount", folder], check=True)


def _mounted(folder: Path, *options: str) -> int:
    try:
        return subprocess.run(["mount", *options, folder], capture_output=True, check=False).returncode
    except FileNotFoundError:
        return 1


def swept(sweep: Path, out: Path, runs: int, *more: str, files: int = 0) -> tuple[int, str]:
    """Exit status and stderr of a sweep in two processes that may have so many files open each; 0: as many as ever."""

    def limit() -> None:
        if files:
            resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))

    arguments = ("sweep", sweep, "--runs", runs, "--jobs", 2, "--out", out, "--no-plots", *more)
    done = subprocess.run(
        command(*arguments), cwd=sweep.parent, capture_output=True, text=True, preexec_fn=limit
    )
    return done.returncode, done.stderr


def test_a_full_disk_keeps_what_has_flown(small_disk: Path, tmp_path: Path) -> None:
    sweep, out = written(tmp_path), small_disk / "out"
    status, err = swept(sweep, out, 300, "--save-logs", "none")
    assert status == 3 and err.startswith(f"{out}: cannot write: ") and err.count("\n") == 1, err
    kept = finished(out)
    assert kept > 10 and f"{kept} of 600 flights are kept" in err
    assert _mounted(small_disk, "-o", "remount,size=64M") == 0
    assert swept(sweep, out, 300, "--save-logs", "none", "--resume")[0] in (0, 1)
    same_rows(out, fly_here(load_sweep(sweep, ["runs=300"]), tmp_path / "here", "testbed.simulation:fly"))


@pytest.mark.parametrize("files", [10, 14, 64])
def test_few_open_files_are_enough_or_said_in_one_line(tmp_path: Path, files: int) -> None:
    status, err = swept(written(tmp_path), tmp_path / "out", 3, files=files)
    assert (status in (0, 1) and not err) or (status == 3 and err.count("\n") == 1), err
    said = (
        "a worker process does not start",
        "cannot write",
    )  # which file is the one too many depends on timing
    assert status != 3 or err.partition(": ")[2].startswith(
        tuple(f"{what}: Too many open files" for what in said)
    )
    assert files < 64 or status != 3
