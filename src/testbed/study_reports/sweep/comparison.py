"""Two sweeps with the same draws, such as yesterday's and today's: which flights changed, by how much, and whether it is chance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.common import statistics
from testbed.common.statistics import Paired
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting import html
from testbed.reporting.words import count, interval, number
from testbed.studies.folder import table
from testbed.studies.folder.logs import in_file_names
from testbed.studies.plan import Plan
from testbed.studies.summary import metric_names
from testbed.study_reports.sweep.answer import SIGNIFICANT
from testbed.study_reports.sweep.flight_page import only

if TYPE_CHECKING:
    import pandas as pd

_SHOWN = 20
"""Changed flights that are printed of each variant; the page has all of them."""
_PASSED = {True: "passed", False: "not passed", None: "not judged"}
_MARKED = ("_before", "_after")


@dataclass(frozen=True)
class Change:
    """One variant in both sweeps.

    Attributes:
        pairs: a row for each run that both have flown, with `_before` and `_after` on each column.
        passes: the share that passed, the second minus the first.
        robustness: the mean change of the least robustness, over the runs that have one in both.
        metrics: the mean change of each metric, where it is not the same in all flights.
        missing: runs that only one of the two has.
    """

    label: str
    pairs: pd.DataFrame
    passes: Paired
    robustness: statistics.Mean
    metrics: dict[str, statistics.Mean]
    missing: int

    @property
    def is_worse(self) -> bool:
        """Whether fewer flights pass, and chance does not explain it."""
        return self.passes.difference < 0 and self.passes.p_value <= SIGNIFICANT

    @property
    def changed(self) -> pd.DataFrame:
        """The pairs of flights that ended in different ways: passed or not, or another outcome."""
        pairs = self.pairs
        before, after = (pairs[f"passed{mark}"].map(_PASSED.get) for mark in _MARKED)
        differ = (before != after) | (
            pairs["outcome_before"].astype(str) != pairs["outcome_after"].astype(str)
        )
        return pairs[differ]


def compared(first: Path, second: Path) -> tuple[Change, ...]:
    """Each variant that both sweeps have. Raises BadInput when they have none, or when their draws are not the same."""
    plans = [table.load_plan(folder) for folder in (first, second)]
    before, after = (
        dict(table.groups_of(plan, table.load(folder)))
        for plan, folder in zip(plans, (first, second), strict=True)
    )
    if len(before) == len(after) == 1:
        after = dict(zip(before, after.values(), strict=True))  # one controller against another one
    shared = [label for label in before if label in after]
    if not shared:
        what = f"compares {', '.join(after)}, and {first} compares {', '.join(before)}"
        raise BadInput([Problem(what, str(second), expected="a sweep with a variant of that name")])
    return tuple(_change(label, before[label], after[label], plans, second) for label in shared)


def _change(label: str, one: pd.DataFrame, other: pd.DataFrame, plans: list[Plan], place: Path) -> Change:
    pairs = one.merge(other, on="run", suffixes=_MARKED)
    for name in ["seed", *plans[0].paths]:
        columns = [f"{name}{mark}" for mark in _MARKED]
        if name not in other or not pairs[columns[0]].astype(object).equals(pairs[columns[1]].astype(object)):
            what = f"has other draws of {name}"
            raise BadInput([Problem(what, str(place), expected="the same seed, and the same vary or cases")])
    if not len(pairs):
        raise BadInput([Problem("has no run that the other has flown", str(place))])
    both = pairs.dropna(subset=["passed_before", "passed_after"])
    passes = statistics.paired(both["passed_after"].tolist(), both["passed_before"].tolist())
    moved = {name: _difference(pairs, name) for name in metric_names(plans[0], one) if name in other}
    metrics = {name: statistics.mean(by.tolist()) for name, by in moved.items() if (by != 0.0).any()}
    robustness = statistics.mean(_difference(pairs, "robustness").tolist())
    missing = len(one) + len(other) - 2 * len(pairs)
    return Change(label, pairs, passes, robustness, metrics, missing)


def _difference(pairs: pd.DataFrame, name: str) -> pd.Series:
    return (pairs[f"{name}_after"] - pairs[f"{name}_before"]).dropna()


def sentences(changes: tuple[Change, ...], second: Path) -> Iterator[str]:
    """What is printed: of each variant the shares, the changed flights, and the metrics that moved."""
    for change in changes:
        yield from _shares(change)
        rows = change.changed
        yield from (f"  {_said(row)}" for row in rows.head(_SHOWN).to_dict("records"))
        if len(rows) > _SHOWN:
            yield f"  and {len(rows) - _SHOWN} more"
        yield from _moved(change)
        if len(rows):
            run = int(rows["run"].iloc[0])
            yield f"  fly one again: {only(run, in_file_names(change.label), str(second / 'sweep.yaml'))}"


def _shares(change: Change) -> Iterator[str]:
    passes, who = change.passes, f"{change.label}: " if change.label else ""
    n = len(change.pairs)
    if not change.metrics and not len(change.changed):
        yield f"{who}no difference in {count(n, 'paired flight')}"
    else:
        before, after = passes.both + passes.only_second, passes.both + passes.only_first
        chance = number(passes.p_value, ".2g")
        verdict = "chance may explain it" if passes.p_value > SIGNIFICANT else "more than chance explains"
        yield (f"{who}passed {after} of {n}, before {before}: {passes.only_first} better, {passes.only_second} worse; "
               f"difference {interval(passes.plain, 'difference', '+.3f')}, p = {chance}, {verdict}")  # fmt: skip
    if change.missing:
        yield f"  {count(change.missing, 'flight')} of one sweep only, not compared"


def _said(row: dict[Any, Any]) -> str:
    """`run 17: completed, passed -> ground_contact, not passed; robustness 0.21 -> -1.3`."""
    ends = [f"{row[f'outcome{mark}']}, {_PASSED[row[f'passed{mark}']]}" for mark in _MARKED]
    least = [number(row[f"robustness{mark}"], ".3g") for mark in _MARKED]
    return f"run {row['run']}: {' -> '.join(ends)}; robustness {' -> '.join(least)}"


def _moved(change: Change) -> Iterator[str]:
    """Robustness, and the metrics whose mean change is not zero by its 95 % interval."""
    sure = {name: mean for name, mean in change.metrics.items() if mean.low > 0.0 or mean.high < 0.0}
    if change.metrics:
        yield f"  robustness: mean change {interval(change.robustness.plain, 'estimate', '+.3g')}"
        few = f"  {len(sure)} of {len(change.metrics)} metrics that differ moved by more than chance (95 % each)"
        yield f"{few}{': ' if sure else ''}{', '.join(sure)}"


def write_page(changes: tuple[Change, ...], first: Path, second: Path, file: Path) -> Path:
    """Write the page of two sweeps; returns its file. Raises OSError when it cannot be written."""
    title = f"{second.name} compared with {first.name}"
    facts = {"before": str(first), "after": str(second)}
    columns = ["run", *(f"{name}{mark}" for name in ("outcome", "passed", "robustness") for mark in _MARKED)]
    parts = [html.opening(title, [line.strip() for line in sentences(changes, second)], facts)]
    for change in changes:
        rows = (html.row([str(row[name]) for name in columns]) for row in change.changed.to_dict("records"))
        parts.append(html.tag("h2", change.label or "Changed flights"))
        parts.append(html.table([name.replace("_", " ") for name in columns], rows))
        moved = (
            html.row([name, mean.estimate, mean.low, mean.high]) for name, mean in change.metrics.items()
        )
        heads = ["metric", "mean change", "95 % from", "to"]
        parts.append(html.folded("Metrics that differ", html.table(heads, moved)))
    return html.write_page(file, title, parts)
