"""How a number, or its absence, is written for a person: in the reports and on the terminal."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def number(value: Any, form: str = ".4g", absent: str = "-") -> str:
    """A number as text; `absent` for None, NaN and infinity, and a text as it is."""
    if isinstance(value, str):
        return value
    if value is None or not math.isfinite(value):
        return absent
    return str(value) if isinstance(value, int) else format(value, form)


def interval(known: Mapping[str, Any], of: str = "estimate", form: str = ".3f") -> str:
    """`0.970 (0.957 to 0.979)`: an estimate and its interval, each of which may be absent."""
    low, high = number(known["low"], form), number(known["high"], form)
    return f"{number(known[of], form)} ({low} to {high})"
