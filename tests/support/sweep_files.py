"""A small sweep, and helpers that fly it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pandas as pd

import testbed

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
TESTS = Path(__file__).parent


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
    return subprocess.run(command(*arguments), cwd=folder, capture_output=True, text=True, check=False)


def same_rows(one: Path, other: Path) -> None:
    for name in ("results.csv", "results.parquet", "histories.f32"):
        assert (one / name).read_bytes() == (other / name).read_bytes(), name


def sorted_files(folder: Path) -> dict[str, bytes]:
    return {f.name: f.read_bytes() for f in sorted(folder.glob("logs/*"))}


def journal_lines(folder: Path) -> int:
    file = folder / "journal.jsonl"
    return file.read_bytes().count(b"\n") if file.is_file() else 0
