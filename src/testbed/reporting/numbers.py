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


def rounded(value: float | None) -> str:
    """A number with three digits, and 0 for what is only rounding."""
    return "0" if value is not None and abs(value) < 1e-6 else number(value, ".3g")


def interval(known: Mapping[str, Any], of: str = "estimate", form: str = ".3f") -> str:
    """`0.970 (0.957 to 0.979)`: the estimate `known[of]` with its interval, `low` to `high`; each may be None.

    `not judged` where none of the flights was.
    """
    if known.get("not_judged") and not known["n"]:
        return "not judged"
    low, high = number(known["low"], form), number(known["high"], form)
    return f"{number(known[of], form)} ({low} to {high})"
