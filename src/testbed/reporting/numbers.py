"""Numbers, and missing numbers, as text for reports and for the terminal."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def number(value: Any, form: str = ".4g", absent: str = "-") -> str:
    """A number as text; `absent` for None, NaN and infinity. A text is returned as it is."""
    if isinstance(value, str):
        return value
    if value is None or not math.isfinite(value):
        return absent
    return str(value) if isinstance(value, int) else format(value, form)


def interval(known: Mapping[str, Any], of: str = "estimate", form: str = ".3f") -> str:
    """`0.970 (0.957 to 0.979)`: the estimate `known[of]` with its interval, `low` to `high`; each may be None."""
    low, high = number(known["low"], form), number(known["high"], form)
    return f"{number(known[of], form)} ({low} to {high})"
