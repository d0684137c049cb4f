"""What the results of this package share when they are shown: numbers as text, and a table for notebooks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape


def number(value: float) -> str:
    """Three digits, or that it is unknown."""
    return "unknown" if math.isnan(value) else f"{value:.3g}"


def block(lines: Iterable[str], head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """HTML of some lines of text, those that are not empty, and a table."""
    told = "".join(f"<p>{escape(line)}</p>" for line in lines if line)
    cells = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<div>{told}<table><tr>{cells}</tr>{body}</table></div>"
