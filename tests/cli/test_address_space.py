"""`ulimit -v`: too little address space is said in words, before a library hangs or aborts for want of it."""

from __future__ import annotations

import subprocess
import sys

import pytest

from testbed.cli import address_space, status

resource = pytest.importorskip("resource")


def limited(megabytes: int, *arguments: str) -> subprocess.CompletedProcess[str]:
    """The command with this much address space."""
    size = megabytes * 1_000_000
    return subprocess.run(
        [sys.executable, "-m", "testbed", *arguments], capture_output=True, text=True, check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)),
    )  # fmt: skip


@pytest.mark.parametrize("megabytes", [50, 400, address_space.NEEDED_MB - 1])
def test_too_little_is_refused(megabytes: int) -> None:
    done = limited(megabytes, "list")
    assert done.returncode == status.ENDED_EARLY
    assert done.stderr == (
        f"the address space is limited to {megabytes} MB, of {address_space.NEEDED_MB} needed: raise it by `ulimit -v`\n"
    )


def test_what_is_called_enough_is_enough(tmp_path) -> None:  # type: ignore[no-untyped-def]
    done = limited(
        address_space.NEEDED_MB, "run", "scenarios/left_propeller_fail.yaml", "--out", str(tmp_path / "run")
    )
    assert done.returncode == status.MET, done.stderr
