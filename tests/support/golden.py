"""Digests of shipped flights, for the versions of `locks/`: what "to the byte" is tested against.

    python tests/support/golden.py        store the digests of this Python, which must have the versions of its lock

`.ci/lock` calls it with each Python. The bytes of a flight depend on the versions, on the C library's functions, on whether the
processor has AVX2 and FMA, and on the kernel that OpenBLAS chooses for it. The last can be given, and is: that of Haswell.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
STORED = ROOT / "locks" / "digests.json"
PYTHON = "py{}{}".format(*sys.version_info)
LOCK = ROOT / "locks" / f"{PYTHON}.txt"
FLIGHTS = ("left_tail_fail", "mems_turbulence")
"""A flight with ideal sensors in calm air, and one with MEMS sensors in turbulence."""
KERNEL = {"OPENBLAS_CORETYPE": "Haswell"}


@cache
def digest(scenario: str, **environment: str) -> str:
    """SHA-256 of the log of a shipped scenario, flown in a process of its own with the kernel above or another."""
    command = [sys.executable, "-m", "testbed", "run", f"scenarios/{scenario}.yaml", "--no-plots", "--out"]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "flight"
        flown = {**os.environ, **KERNEL, **environment}
        subprocess.run([*command, str(out)], env=flown, cwd=folder, check=True, capture_output=True)
        return hashlib.sha256((out / "log.csv").read_bytes()).hexdigest()


def differences() -> list[str]:
    """What of this environment is not that of the stored digests, in words."""
    stored = _stored().get(PYTHON)
    if stored is None:
        return [f"nothing is stored for {PYTHON}"]
    here, there = this_machine(), stored["machine"]
    return [
        *unlocked(),
        *(f"{what} is {here[what]}, and was {there[what]}" for what in here if here[what] != there[what]),
    ]


def unlocked() -> Iterator[str]:
    """What is installed in another version than that of this Python's lock, in words."""
    if not LOCK.is_file():
        yield f"there is no {LOCK.name}"
        return
    for line in LOCK.read_text(encoding="utf-8").splitlines():
        name, _, locked = line.partition("==")
        if locked and (found := _installed(name)) not in (None, locked):
            yield f"{name} is {found}, and {locked} in {LOCK.name}"


def _stored() -> dict[str, Any]:
    return json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}


def stored_digest(scenario: str) -> str:
    """The digest of this flight with this Python's lock."""
    return str(_stored()[PYTHON]["logs"][scenario])


def _installed(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def this_machine() -> dict[str, str]:
    """What the bytes depend on besides versions."""
    flags = Path("/proc/cpuinfo").read_text(encoding="utf-8").split() if sys.platform == "linux" else []
    return {
        "machine": f"{sys.platform} {platform.machine()}",
        "C library": " ".join(platform.libc_ver()),
        "processor": " ".join(flag for flag in ("avx2", "fma") if flag in flags),
    }


def store() -> None:
    """Fly, and write the digests of this Python beside those of the others."""
    if wrong := list(unlocked()):
        sys.exit("\n".join(wrong))
    logs = {scenario: digest(scenario) for scenario in FLIGHTS}
    stored = {**_stored(), PYTHON: {"machine": this_machine(), "logs": logs}}
    STORED.write_text(json.dumps(stored, indent=1, sort_keys=True) + "\n", encoding="utf-8")


if __name__ == "__main__":
    store()
