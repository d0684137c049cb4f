"""The colours of figures: those of the pages on white, from their style sheet; lines and markers of several of a kind."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

STYLE = Path(__file__).parent / "assets" / "palette.css"
PALETTE = dict(re.findall(r"--([\w-]+): ([^;]+);", STYLE.read_text(encoding="utf-8").partition("@media")[0]))
"""{name: colour} of a page on white."""
COLOURS = tuple(PALETTE[f"v{i}"] for i in range(6))
LINES = ("-", "--", ":", "-.", (0, (5, 1)), (0, (1, 1)))
MARKERS = "os^Dvp"
MISSED, MET = PALETTE["missed"], PALETTE["met"]


def nth(i: int, *parts: str) -> dict[str, Any]:
    """The look of the i-th of several: its colour, and its `marker` and `ls` (line) if these are asked for."""
    looks: dict[str, Any] = {"marker": MARKERS[i % 6], "ls": LINES[i % 6]}
    return {"color": COLOURS[i % 6], **{part: looks[part] for part in parts}}
