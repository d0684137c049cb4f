"""Processes of this package: their environment, their answers on stdout, and what ended them."""

from __future__ import annotations

import contextlib
import json
import os
import signal
from pathlib import Path
from typing import Any

_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


def environment() -> dict[str, str]:
    """The environment of such a process: this package first on its path, and one thread for each library, because several would
    compete for the cores."""
    package = str(Path(__file__).resolve().parents[2])
    path = os.pathsep.join(
        dict.fromkeys([package, *filter(None, os.environ.get("PYTHONPATH", "").split(os.pathsep))])
    )
    return {**os.environ, **dict.fromkeys(_THREADS, "1"), "PYTHONPATH": path}


def answers(text: str) -> list[dict[str, Any]]:
    """The JSON objects among the lines of a process's output; JSBSim may have written others."""
    found = []
    for line in text.splitlines():
        with contextlib.suppress(ValueError):
            found.append(json.loads(line))
    return [line for line in found if isinstance(line, dict)]


def signal_name(number: int) -> str:
    """Name of a signal, or its number where it has none."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"
