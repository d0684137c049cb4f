"""What a log that was edited or cut may lack: said with its line and column, before anything is drawn or compared."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from testbed.flight.columns import ALWAYS_KNOWN
from testbed.flight.flight import Flight, Outcome
from testbed.inputs.problems import BadInput, Problem

_NEEDED = (
    "time_s", "altitude_m", "altitude_command_m", "airspeed_m_s", "airspeed_command_m_s", "heading_deg", "heading_command_deg",
)  # fmt: skip
"""Columns that every comparison and verdict rests on."""
_SHOWN = 3
"""Problems that are named: a damaged file has one in each cell."""


def refuse_damaged(flight: Flight, file: str) -> None:
    """Raise BadInput if the log read from `file` has no rows, lacks a column of _NEEDED, or has no number in one of
    ALWAYS_KNOWN.

    The state of a flight that diverged may be no number. Times must increase.
    """
    problems = [problem for _, problem in zip(range(_SHOWN), _problems(flight, file), strict=False)]
    if problems:
        raise BadInput(problems)


def _problems(flight: Flight, file: str) -> Iterator[Problem]:
    if not len(flight.data):
        yield Problem("has no rows", file, expected="the log of a flight")
        return
    missing = [name for name in _NEEDED if name not in flight.columns]
    yield from (Problem(f"has no column {name}", file, 1) for name in missing)
    if flight.outcome is not Outcome.diverged:
        for name in ALWAYS_KNOWN:
            yield from _not_numbers(flight, file, name)
    if "time_s" not in missing:
        time_s = flight.column("time_s")
        for row in np.flatnonzero(~(np.diff(time_s) > 0.0)):
            yield Problem(f"is {time_s[row + 1]:g}", file, int(row) + 3, "time_s", "times that increase")


def _not_numbers(flight: Flight, file: str, name: str) -> Iterator[Problem]:
    values = flight.column(name) if name in flight.columns else np.zeros(0)
    for row in np.flatnonzero(~np.isfinite(values)):
        yield Problem(
            f"is {values[row]:g}", file, int(row) + 2, name, "a finite number"
        )  # line 1 has the names
