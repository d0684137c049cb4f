"""A small sweep, and helpers that fly it."""

from __future__ import annotations

import pkgutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pandas as pd
from command_line import in_this_process

import testbed
from testbed.api.sweep import finish, prepare
from testbed.studies.flying.pool import serial
from testbed.studies.folder import store
from testbed.studies.plan import Plan
from testbed.studies.run import Options, fly_sweep

SWEEP = """\
name: small
scenario: scenarios/left_tail_fail.yaml
runs: 12
seed: 3
set:
  duration_s: 1
  failures: [{type: effectiveness, actuator: left_ruddervator, at_s: 0.3, value: 0.2}]
  requirements: [{metric: altitude_error_max_m, at_most: 0.02}]
vary:
  failures.0.at_s: {uniform: [0.1, 0.6]}
  failures.0.value: {uniform: [0, 1]}
  failures.0.actuator: {choice: [left_ruddervator, right_ruddervator], weights: [1, 3]}
  controller.model_error.Cm_alpha: {normal: [1.0, 0.1]}
compare: {controller.type: [adaptive_inversion, fixed_inversion]}
"""
SUPPORT = Path(__file__).parent


def written(folder: Path, text: str = SWEEP, name: str = "small.yaml") -> Path:
    file = folder / name
    file.write_text(text)
    return file


def table(folder: Path) -> pd.DataFrame:
    """A sweep folder's table, by the function that users call."""
    frame = testbed.load(folder)
    assert isinstance(frame, pd.DataFrame)
    return frame


def command(*arguments: object) -> list[str]:
    return [sys.executable, "-m", "testbed", *map(str, arguments)]


def run(folder: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    """A command, in the test's own process."""
    return in_this_process(folder, *map(str, arguments))


def same_rows(one: Path, other: Path) -> None:
    for name in ("results.csv", "results.parquet"):
        assert (one / name).read_bytes() == (other / name).read_bytes(), name
    assert stored(one) == stored(other)


def stored(folder: Path) -> list[tuple[bytes, str, bytes]]:
    """The key, the record and the error history of each finished flight of a folder, in order."""
    with store.reading(folder) as flights:
        return [(key, repr(record), flights.history(key)) for key, record in flights.records()]


def finished(folder: Path) -> int:
    """Number of flights that have finished in a folder, which may be flown into meanwhile."""
    if not store.exists(folder):
        return 0
    with store.reading(folder) as flights:
        return len(flights)


def sorted_files(folder: Path) -> dict[str, bytes]:
    return {f.name: f.read_bytes() for f in sorted(folder.glob("logs/*"))}


def fly_here(plan: Plan, folder: Path, fly: str = "sweep_flights:quick", save_logs: str = "none") -> Path:
    """Fly a whole sweep in this process, with made-up flights: the folder that workers would have left.

    For tests of what is done with the results; starting workers would take longer than all the rest.
    """
    fly_sweep(plan, folder, here(fly, save_logs))
    return folder


def here(fly: str | None = "sweep_flights:quick", save_logs: str = "none") -> Options:
    """Options that fly in this process; None flies really."""
    return Options(save_logs=save_logs, fly=pkgutil.resolve_name(fly) if fly else None, workers=serial)


def swept(
    sweep: Path,
    out: Path,
    fly: str | None = "sweep_flights:quick",
    *,
    resume: bool = False,
    mixed: bool = False,
    figures: bool = False,
    **asked: Any,
) -> pd.DataFrame:
    """As `testbed.sweep`, in this process."""
    plan, folder = prepare(sweep, out, resume=resume, **asked)
    options = replace(here(fly), mixed=mixed)
    finish(plan, folder, fly_sweep(plan, folder, options, resume=resume), figures=figures)
    return table(folder)


def script(text: str) -> list[str]:
    """The command of a Python program that flies, with the functions of sweep_flights."""
    paths = f"import sys; sys.path.insert(0, {str(SUPPORT)!r})"
    return [sys.executable, "-c", f"{paths}\nimport sweep_flights, testbed\n{text}"]


def flown(sweep: Path, out: Path, options: str) -> str:
    """The line of a program that flies a sweep of slow made-up flights."""
    return f"testbed.sweep({str(sweep)!r}, {str(out)!r}, {options}, fly=sweep_flights.slow, figures=False)"
