"""The tables of a benchmark as Markdown, from its summary.json. Any number in it may be None."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

_FEW = 20
"""Draws below which a group shows no share: it would say little."""
_TITLES = {
    "failures": "By kind of failure",
    "course": "By course of the failures",
    "aircraft": "By aircraft",
    "truth": "By what the controller is told",
    "weather": "By weather",
    "gust": "By gust",
    "sensors": "By sensors",
}
Summary = Mapping[str, Any]


def page(summary: Summary) -> list[str]:
    """All sections, in lines: first where the reference loses."""
    return [
        *_where(summary),
        *_totals(summary),
        *_noticed(summary),
        *_groups(summary),
        *_draws(summary),
        *_reasons(summary),
        *_flown(summary),
    ]


def again(summary: Summary, draw: int, name: str) -> str:
    """The command that flies a draw again by one controller."""
    said = summary["controllers"][name]
    chosen = f"{name}={said}" if isinstance(said, str) else name
    return f"testbed benchmark {summary['file']} --seed {summary['seed']} --only {draw} --controller {chosen}"


def _where(summary: Summary) -> Iterator[str]:
    """The groups in which another controller holds more, and the draws that only others hold."""
    first = summary["reference"]
    yield from (f"## Where `{first}` loses", "")
    rows = [*_behind(summary)]
    if rows:
        yield f"Groups of {_FEW} draws or more in which another that is not told the truth holds more:"
        yield ""
        yield from _table(("group", "draws", first, "the best other", "which"), sorted(rows, key=_gap))
    lost = summary["lost"][first]
    if lost:
        of = f"{lost[0]['of']} of {summary['draws']}"
        yield from ("", f"It does not hold {of} draws that another holds. The longest outside:", "")
        yield from _lost(summary, first)
    if not rows and not lost:
        yield "In no draw."


def _behind(summary: Summary) -> Iterator[list[str]]:
    first, told = summary["reference"], summary["told"]
    for groups in summary["by"].values():
        for group, counted in groups.items():
            others = {
                n: k for n, k in counted["held"].items() if n in summary["controllers"] and n not in told
            }
            best = max(others, key=lambda name: others[name])
            if counted["draws"] >= _FEW and others[best] > others[first]:
                n = counted["draws"]
                yield [group, str(n), f"{others[first] / n:.3f}", f"{others[best] / n:.3f}", f"`{best}`"]


def _gap(row: Sequence[str]) -> float:
    return float(row[2]) - float(row[3])


def _lost(summary: Summary, name: str) -> Iterator[str]:
    """The draws that a controller alone loses, with the commands that fly them again."""
    rows = [
        [str(each["draw"]), each["aircraft"], f"{each['failures']}, {each['course']}", each["weather"],
         f"{each['inside']:.2f}", ", ".join(each["held_by"]), f"`{again(summary, each['draw'], name)}`"]
        for each in summary["lost"][name]
    ]  # fmt: skip
    yield from _table(("draw", "aircraft", "failures", "weather", "inside", "held by", "again"), rows)


def _totals(summary: Summary) -> Iterator[str]:
    first = summary["reference"]
    yield from ("", "## All", "")
    head = ("controller", "survived", "held", "inside", f"held, minus `{first}`", f"inside, minus `{first}`",
            "outside where the best is inside", "held in each half")  # fmt: skip
    rows = []
    for name in summary["order"]:
        score = summary["scores"][name]
        against = score["against_reference"]
        rows.append([
            f"`{name}`{' (told)' if name in summary['told'] else ''}" if name in summary["controllers"] else name,
            _interval(score["survived"]), _interval(score["held"]), _interval(score["inside"]),
            _interval(against["held"], "difference", "+.3f"), _interval(against["inside"], "estimate", "+.3f"),
            _interval(score["short_of_bound"]),
            ", ".join(f"{half['estimate']:.3f}" for half in score["held_in_each_half"] if half["n"]),
        ])  # fmt: skip
    yield from _table(head, rows)


def _noticed(summary: Summary) -> Iterator[str]:
    yield from ("", "## What was noticed, and what control cost", "")
    head = ("controller", "rightly flagged", "a loss never flagged", "wrongly flagged", "delay, median [s]", "90 % [s]",
            "healthy hours", "false alarms in them", "effort [1/s]", "at a stop [s]")  # fmt: skip
    rows = [
        [f"`{name}`", *(_flags(score[key]) for key in ("noticed", "missed", "named_wrongly")),
         *(_number(score["delay_s"][key]) for key in ("p50", "p90")), _number(score["healthy_hours"]),
         _flags(score["healthy_false_alarms"]), _number(score["effort_per_s"]), _number(score["saturated_s"])]
        for name in summary["order"] if name in summary["controllers"] and (score := summary["scores"][name])
    ]  # fmt: skip
    yield from _table(head, rows)


def _flags(known: Summary | int | None) -> str:
    """A share or a count of flags; those of a controller that says nothing of failures are not judged."""
    if known is None or isinstance(known, int):
        return "not judged" if known is None else str(known)
    return _interval(known) if known["n"] else "not judged"


def _groups(summary: Summary) -> Iterator[str]:
    names = summary["order"]
    for factor in _TITLES:
        groups = summary["by"][factor]
        yield from ("", f"## {_TITLES[factor]}", "", "Share of the draws held.", "")
        rows = [
            [group, str(counted["draws"]), *(_held(counted, name) for name in names)]
            for group, counted in groups.items()
        ]
        yield from _table(("", "draws", *names), rows)


def _held(counted: Summary, name: str) -> str:
    held, draws = counted["held"][name], counted["draws"]
    return f"{held / draws:.2f}" if draws >= _FEW else f"{held}/{draws}"


def _draws(summary: Summary) -> Iterator[str]:
    for name in _others(summary):
        of = summary["lost"][name][0]["of"]
        yield from (
            "",
            f"## Where `{name}` loses",
            "",
            f"It does not hold {of} draws that another holds.",
            "",
        )
        yield from _lost(summary, name)


def _others(summary: Summary) -> Iterator[str]:
    """The controllers besides the reference that do not hold a draw which another holds."""
    for name in summary["order"]:
        if name in summary["controllers"] and name != summary["reference"] and summary["lost"][name]:
            yield name


def _reasons(summary: Summary) -> Iterator[str]:
    rows = [
        [f"`{name}`", str(count), reason]
        for name, score in summary["scores"].items()
        for reason, count in score.get("without_result", {}).items()
    ]
    if rows:
        yield from ("", "## Flights without a result", "", "They count as lost.", "")
        yield from _table(("controller", "flights", "why"), rows)


def _flown(summary: Summary) -> Iterator[str]:
    yield from ("", "## What was flown", "")
    said = f"Suite `{summary['suite']}`, version {summary['version']}, seed {summary['seed']}, {summary['draws']} draws."
    word = summary.get("word")
    if word:
        said += (
            f" The seed is made from the law's digest `{summary['law_sha256'][:16]}` and the word `{word}`."
        )
    yield said


def _interval(known: Summary, key: str = "estimate", form: str = ".3f") -> str:
    if known[key] is None:
        return ""
    return f"{known[key]:{form}} ({known['low']:{form}} to {known['high']:{form}})"


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield f"|{' --- |' * len(head)}"
    yield from (f"| {' | '.join(each.replace('|', '/') for each in row)} |" for row in rows)
