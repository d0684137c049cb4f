"""A certificate as text, as CSV and as JSON."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict

import pandas as pd

from testbed.common.files import plain
from testbed.common.signals import RATES
from testbed.common.text import cell
from testbed.margins.certificate import Certificate

_NOTHING = 1e-5
"""A certified error that is called none."""
Row = tuple[str, str, str, str, float]
"""Mode or actuator, airspeed [m/s] or axis, quantity, unit, value: a row of the CSV file."""


def as_json(certificate: Certificate) -> str:
    """All numbers, by the names of `Certificate`."""
    return json.dumps(plain(asdict(certificate)), indent=1) + "\n"


def as_csv(certificate: Certificate) -> str:
    """All numbers, one a row."""
    table = pd.DataFrame(_rows(certificate), columns=["of", "at", "quantity", "unit", "value"])
    table = table.assign(
        of=table["of"].map(cell), at=table["at"].map(cell), value=table["value"].astype(float)
    )
    return str(table.to_csv(index=False, lineterminator="\n", na_rep="nan"))


FORMATS: dict[str, Callable[[Certificate], str]] = {".csv": as_csv, ".json": as_json}
"""What a file contains, by the ending of its name."""


def _rows(c: Certificate) -> Iterator[Row]:
    for mode in c.modes:
        yield mode.title, "", "certified_error_of_estimates", "1", mode.estimates
        yield mode.title, "", "certified_error_of_inversion", "1", mode.inversion
    for axis, limits in zip(RATES, c.entries, strict=True):
        for actuator, limit in zip(c.actuators, limits, strict=True):
            yield actuator, axis, "certified_error_of_entry", "1", limit
    for each in c.conditions:
        for quantity in ("coupling", "radius", "remaining", "margin"):
            value = getattr(each, quantity)
            if value is not None:
                yield each.mode, f"{each.airspeed_m_s:.6g} m/s", quantity, "1", value
    for bias in c.biases:
        for quantity, value in asdict(bias).items():
            if quantity != "actuator":
                yield bias.actuator, "", quantity, "1", value
    yield "flight", "", "certified_error_of_its_sector", "1", c.sector_limit


def text(c: Certificate) -> str:
    """The tables that are printed."""
    parts = [
        f"input matrix of {c.aircraft}, as the controller of '{c.scenario}' has it",
        "An error is one of all entries at once, relative to each. The scale of a column is effectiveness, and no error.",
        "",
        _modes(c),
        "",
        _entries(c),
        "",
        *_conditions(c),
        "",
        *_biases(c),
        "",
        "These bound the estimates, not the motion: fly with controller.model_error to see what the outer loops bear.",
    ]
    if not c.exact_law:
        parts.append(
            "The scenario's estimation is not (13). Of the above, what is said of inversions holds, and the bias once e is 0."
        )
    return "\n".join(parts)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Columns of text, the first to the left and the others to the right."""
    lines = [tuple(head), *map(tuple, rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join(
        "  ".join(
            [line[0].ljust(widths[0]), *(x.rjust(w) for x, w in zip(line[1:], widths[1:], strict=True))]
        )
        for line in lines
    )


def _percent(value: float) -> str:
    return f"{max(round(100.0 * value, 3), 0.0):.3g} %" if value < 10.0 else "over 1000 %"


def _modes(c: Certificate) -> str:
    rows = [
        (f"  {m.title}" + (" (refused)" if m.refused else ""), _percent(m.estimates), _percent(m.inversion))
        for m in c.modes
    ]
    return _table(("certified at any airspeed up to an error of", "estimates", "inversion"), rows)


def _entries(c: Certificate) -> str:
    rows = [(f"  {axis}", *map(_percent, limits)) for axis, limits in zip(RATES, c.entries, strict=True)]
    return _table(("limit of one entry alone", *c.actuators), rows)


def _conditions(c: Certificate) -> Iterator[str]:
    head = ("level flight at", "effectiveness", "coupling", "H+ radius", "LMI margin", "certified besides")
    first = c.modes[0].title
    rows = [
        (
            f"  {each.airspeed_m_s:.3g} m/s",
            " ".join(f"{x:.2f}" for x in each.effectiveness),
            _percent(each.coupling),
            f"{each.radius:.4f}",
            _margin(each.margin),
            _percent(each.remaining),
        )
        for each in c.conditions
        if each.mode == first
    ]
    yield f"real input matrix against the model's, {first}"
    yield _table(head, rows)
    if c.no_flight:
        yield f"  no level flight at {', '.join(f'{v:.3g}' for v in c.no_flight)} m/s"
    others = [each for each in c.conditions if each.mode != first]
    if others:
        margins = [each.margin for each in others if each.margin is not None]
        yield (
            f"  after a loss: H+ radius at most {max(each.radius for each in others):.4f}, "
            f"LMI margin at least {_margin(min(margins, default=None))}"
        )


def _margin(margin: float | None) -> str:
    return "needs cvxpy" if margin is None else f"{margin:.4f}"


def _biases(c: Certificate) -> Iterator[str]:
    head = (
        f"flown, entries within {_percent(c.error)}", "|r|", "beta", "median", "95 %", "< 1 for", "< 1 up to",
        "estimate / truth", "healthy", "flagged if below",
    )  # fmt: skip
    rows = [
        (
            f"  {b.actuator}",
            f"{b.trim_reference:.3g}",
            f"{b.trim_beta:.2f}",
            f"{b.median_beta:.2f}",
            f"{b.high_beta:.2f}",
            _percent(b.share),
            _percent(b.error_limit),
            f"{b.range[0]:.2f} to {b.range[1]:.2f}",
            "not flagged" if b.no_false_alarm else "uncertain",
            f"{b.seen_below:.3f}" if b.seen_below else "uncertain",
        )
        for b in c.biases
    ]
    yield _table(head, rows)
    yield "  |r|, beta, estimate / truth and what follows are those at the start; beta bounds the bias of an estimate"
    if c.sector_limit < _NOTHING:
        yield "  Over the whole flight nothing is certified: a reference passes zero."
    else:
        limit = _percent(c.sector_limit)
        yield f"  However r moves in this flight, all estimates are bounded up to an error of {limit}."
