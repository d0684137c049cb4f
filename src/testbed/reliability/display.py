"""Results as one line of text, and as a short piece of HTML for notebooks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from testbed.reliability.results import FailureProbability, SmallestFailure


def probability_line(result: FailureProbability) -> str:
    """`<FailureProbability 1.02e-05 (8.1e-06 to 1.9e-05), c.o.v. 0.11, 3024 evaluations, importance: 400 points ...>`."""
    low, high = result.interval
    doubt = "" if result.converged else "not known well: "
    return (
        f"<FailureProbability {_number(result.probability)} ({_number(low)} to {_number(high)}), {_cov(result)}, "
        f"{result.evaluations} evaluations, {result.method}: {doubt}{result.reason}>"
    )


def _cov(result: FailureProbability) -> str:
    return f"c.o.v. {result.cov:.2f}" if math.isfinite(result.cov) else "c.o.v. unknown"


def _number(value: float) -> str:
    return "unknown" if math.isnan(value) else f"{value:.3g}"


def probability_html(result: FailureProbability) -> str:
    """The line, what plain sampling would need, and the levels."""
    rows = [
        (f"{level.threshold:.4g}", f"{level.probability:.3g}", f"{level.cov:.2f}", level.evaluations)
        for level in result.levels
    ]
    head = ("at or below", "probability given the one before", "c.o.v.", "evaluations")
    return _block([probability_line(result).strip("<>"), _plainly(result)], head, rows)


def _plainly(result: FailureProbability) -> str:
    """How many independent draws would give the same coefficient of variation."""
    if not (0 < result.probability < 1 and math.isfinite(result.cov)):
        return ""
    needed = (1 - result.probability) / (result.probability * result.cov**2)
    return f"Plain sampling needs about {needed:.2g} evaluations for the same coefficient of variation."


def smallest_line(result: SmallestFailure) -> str:
    """`<SmallestFailure at 4.27 standard deviations, ...>`, or that none was found."""
    found = f"at {result.distance:.4g} standard deviations" if result.found else "not found"
    return f"<SmallestFailure {found}, {result.evaluations} evaluations: {result.reason}>"


def smallest_html(result: SmallestFailure) -> str:
    """The line, and the last improvements."""
    rows = [(step.evaluations, f"{step.distance:.4g}") for step in result.path[-10:]]
    return _block([smallest_line(result).strip("<>")], ("evaluations", "distance"), rows)


def _block(lines: Iterable[str], head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    told = "".join(f"<p>{escape(line)}</p>" for line in lines if line)
    cells = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<div>{told}<table><tr>{cells}</tr>{body}</table></div>"
