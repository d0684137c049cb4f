"""How far predictions are off, for the pages of section 4: the median and the extreme relative errors of each quantity."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

Pairs = Iterable[tuple[float, float]]
"""(predicted, measured)."""


def summary(groups: Mapping[str, Pairs]) -> Iterator[str]:
    """Lines of a table: for each quantity its pairs that both have a value, and their relative errors."""
    yield "| quantity | pairs | median error | from | to |"
    yield "|" + " --- |" * 5
    for name, pairs in groups.items():
        found = relative_errors(pairs)
        if len(found):
            sizes = np.abs(found)
            ends = (f"{100 * end:+.1f} %" for end in (found.min(), found.max()))
            words = (f"{100 * np.median(sizes):.1f} %", *ends)
            yield f"| {name} | {len(found)} | {' | '.join(words)} |"


def relative_errors(pairs: Pairs) -> np.ndarray:
    """[k] measured / predicted - 1 of the pairs whose numbers are both finite and not zero."""
    return np.array([m / p - 1.0 for p, m in pairs if math.isfinite(p) and math.isfinite(m) and p and m])
