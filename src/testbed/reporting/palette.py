"""Colours, lines and markers of all figures, told apart in grey print and by colour-blind readers."""

from __future__ import annotations

from typing import Any

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""By Okabe and Ito."""
LINES = ("-", "--", ":", "-.", (0, (5, 1)), (0, (1, 1)))
MARKERS = "os^Dvp"
MISSED, MET = "#b3261e", "#23753a"


def nth(i: int, *parts: str) -> dict[str, Any]:
    """The look of the i-th of several: its colour, and its `marker` and `ls` (line) if these are asked for."""
    looks: dict[str, Any] = {"marker": MARKERS[i % 6], "ls": LINES[i % 6]}
    return {"color": COLOURS[i % 6], **{part: looks[part] for part in parts}}
