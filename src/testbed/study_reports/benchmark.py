"""What a benchmark found, as sections of words and tables, from its summary.json: as Markdown and as a page.

Any number of the summary may be None.
"""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from testbed.reporting import html
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.junit import Test
from testbed.reporting.words import count, interval, number

if TYPE_CHECKING:
    import pandas as pd

_FEW = 20
"""Draws below which nothing is said of a group: it would say little."""
_WORST_GROUPS = 8
_TITLES = {
    "failures": "kind of failure",
    "course": "course of the failures",
    "aircraft": "aircraft",
    "truth": "what the controller is told",
    "weather": "weather",
    "gust": "gust",
    "sensors": "sensors",
}
Summary = Mapping[str, Any]
Row = Sequence[str]


class Section(NamedTuple):
    """A part of a report: words, and below them a table. One without a title goes on with the part before it."""

    title: str
    words: str
    head: Row = ()
    rows: Sequence[Row] = ()


def sections(summary: Summary) -> Iterator[Section]:
    """All that is reported: first where the reference loses."""
    yield Section("", _in_short(summary))
    yield from _where(summary)
    yield _totals(summary)
    yield from _ablations(summary)
    yield from _groups(summary)
    yield from _noticed(summary)
    yield from _others_lose(summary)
    yield from _halves(summary)
    yield from _reasons(summary)
    yield Section("What was flown", _flown(summary))


def markdown(summary: Mapping[str, Any], heading: str = "##") -> list[str]:
    """All sections, in lines."""
    lines: list[str] = []
    for section in sections(summary):
        parts = [[f"{heading} {section.title}"] if section.title else [], [section.words] if section.words else [],
                 [*_markdown_table(section.head, section.rows)]]  # fmt: skip
        for part in filter(None, parts):
            lines += [*([""] if lines else []), *part]
    return lines


def _markdown_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    if head:
        yield f"| {' | '.join(head)} |"
        yield f"|{' --- |' * len(head)}"
        yield from (f"| {' | '.join(each.replace('|', '/') for each in row)} |" for row in rows)


def write_benchmark_page(summary: Mapping[str, Any], folder: Path) -> Path:
    """Write report.html of a benchmark's folder; returns the file. Raises OSError when it cannot be written."""
    title = f"Benchmark {summary['suite']} {summary['version']}"
    facts = {"draws": str(summary["draws"]), "seed": str(summary["seed"])}
    parts: list[Part] = [html.opening(title, [], facts), *map(_section_html, sections(summary))]
    return html.write_page(folder / "report.html", title, parts)


def _section_html(section: Section) -> Html:
    title = tag("h2", _plain(section.title)) if section.title else None
    words = tag("p", _plain(section.words)) if section.words else None
    rows = (html.row(map(_plain, row)) for row in section.rows)
    table = html.table(map(_plain, section.head), rows) if section.head else None
    return html.joined([title, words, table], "\n")


def _plain(text: str) -> str:
    """Without the marks of Markdown."""
    return text.replace("`", "").replace("*", "")


def again(summary: Summary, draw: int | str, name: str) -> str:
    """The command that flies a draw again by one controller."""
    words = [str(summary["file"]), "--seed", str(summary["seed"]), "--only", str(draw)]
    return f"testbed benchmark {shlex.join([*words, '--controller', summary['given'][name]])}"


def compared(summary: Summary) -> list[str]:
    """The controllers that are told nothing, but for the reference without some of its parts."""
    return [name for name in summary["controllers"] if name not in {*summary["told"], *summary["ablated"]}]


def _best_rival(summary: Summary) -> str | None:
    """Who holds most, of the others that are told nothing; None if there is no other."""
    rivals = [name for name in compared(summary) if name != summary["reference"]]
    return max(rivals, key=lambda name: summary["scores"][name]["held"]["estimate"], default=None)


def _in_short(summary: Summary) -> str:
    """The result in three sentences."""
    first, scores, best = summary["reference"], summary["scores"], _best_rival(summary)
    said = f"Of {count(summary['draws'], 'draw')} `{first}` holds {_interval(scores[first]['held'])}."
    if best is not None:
        by = scores[best]["against_reference"]["held"]
        said += f" The best other, `{best}`, holds {scores[best]['held']['estimate']:.3f}: {_interval(by, 'difference', '+.3f')}."
    for bound in _bound(summary):
        said += f" The best controller in each draw holds {scores[bound]['held']['estimate']:.3f}."
    return said


def _bound(summary: Summary) -> list[str]:
    """The best of all that were flown; none where one alone was."""
    return summary["order"][-1:] if len(summary["controllers"]) > 1 else []


def _shown(summary: Summary) -> list[str]:
    """Who is in the tables: those told nothing, the best of the others, and the bound."""
    told = sorted(summary["told"], key=lambda name: -summary["scores"][name]["inside"]["estimate"])
    return [*compared(summary), *told[:1], *_bound(summary)]


def _named(summary: Summary, name: str) -> str:
    if name not in summary["controllers"]:
        return name
    return f"`{name}`{' (told)' if name in summary['told'] else ''}"


def _where(summary: Summary) -> Iterator[Section]:
    """The groups in which another controller holds more, and the draws that only others hold."""
    first, lost = summary["reference"], summary["lost"][summary["reference"]]
    if not _bound(summary):
        return
    title = f"Where `{first}` loses"
    rows = sorted(_behind(summary), key=lambda row: float(row[2]) - float(row[3]))
    if rows:
        said = f"Groups of {_FEW} draws or more in which another that is told nothing holds more"
        said += ":" if len(rows) <= _WORST_GROUPS else f"; the {_WORST_GROUPS} widest gaps of {len(rows)}:"
        yield Section(title, said, ("group", "draws", first, "the best other", "which"), rows[:_WORST_GROUPS])
        title = ""
    if lost:
        of = f"It does not hold {lost[0]['of']} of {summary['draws']} draws that another, told nothing, holds. The longest outside"
        head = ("draw", "aircraft", "failures", "weather", "inside", "held by others")
        others = len(compared(summary)) - 1
        drawn = [
            [str(each["draw"]), each["aircraft"], f"{each['failures']}, {each['course']}", each["weather"],
             f"{each['inside']:.2f}", f"{len(each['held_by'])} of {others}"]
            for each in lost
        ]  # fmt: skip
        yield Section(title, f"{of} (`{again(summary, 'DRAW', first)}` flies one again):", head, drawn)
    if not rows and not lost:
        yield Section(title, "In none that another holds.")


def _behind(summary: Summary) -> Iterator[list[str]]:
    first = summary["reference"]
    for factor in _TITLES:
        for group, counted in _large(summary, factor).items():
            held, n = counted["held"], counted["draws"]
            best = max(compared(summary), key=lambda name: held[name], default=first)
            if held[best] > held[first]:
                shown = f"gust: {group}" if factor == "gust" else group  # `none` is a kind of failure, too
                yield [shown, str(n), f"{held[first] / n:.3f}", f"{held[best] / n:.3f}", f"`{best}`"]


def _large(summary: Summary, factor: str) -> dict[str, Summary]:
    """The groups of a factor with enough draws; those without a failure are of the kind `none` already."""
    groups = summary["by"][factor].items()
    return {group: each for group, each in groups if each["draws"] >= _FEW and group != "healthy"}


def _totals(summary: Summary) -> Section:
    first = summary["reference"]
    head = ("controller", "survived", "held", "inside", f"held, minus `{first}`", "outside where the best is inside",
            f"effort, of `{first}`'s", "at a stop [s]")  # fmt: skip
    rows = []
    for name in _shown(summary):
        score = summary["scores"][name]
        against, other = score["against_reference"], name != first
        rows.append([
            _named(summary, name), _interval(score["survived"]), _interval(score["held"]), _interval(score["inside"]),
            _interval(against["held"], "difference", "+.3f") if other else "",
            f"{score['short_of_bound']['estimate']:.3f}",
            _number(score.get("effort")), _number(score.get("saturated_s")),
        ])  # fmt: skip
    if not _bound(summary):  # what is beside others means nothing
        return Section("All", "", (*head[:4], *head[7:]), [[*row[:4], *row[7:]] for row in rows])
    return Section("All", "", head, rows)


def _ablations(summary: Summary) -> Iterator[Section]:
    """What the reference loses without some of its parts."""
    first, rows = summary["reference"], []
    for name in summary["ablated"]:
        score = summary["scores"][name]
        against = score["against_reference"]
        parts = ", ".join(summary["controllers"][name]["ablate"])
        rows.append([f"`{name}`", parts, _interval(score["held"]), _interval(against["held"], "difference", "+.3f"),
                     _interval(against["inside"], "estimate", "+.3f")])  # fmt: skip
    if rows:
        head = ("controller", "without", "held", f"held, minus `{first}`", f"inside, minus `{first}`")
        words = "The same law with a part switched off. An interval across zero shows neither good nor harm."
        yield Section(f"What the parts of `{first}` bring", words, head, rows)


def _halves(summary: Summary) -> Iterator[Section]:
    """Whether the scores and the ranks of two halves of the draws agree."""
    if summary["draws"] < 2 * _FEW:
        return
    names, (one, two) = compared(summary), summary["halves"]
    words = []
    for key in ("held", "inside", "rank"):
        apart = [f"`{name}`" for name in names if not _overlap(one[name][key], two[name][key])]
        words.append(f"*{key}* of all but {', '.join(apart)}" if apart else f"*{key}* of all {len(names)}")
    said = (
        "Of those that are told nothing, the intervals of the first and the second half of the draws overlap in "
        f"{'; '.join(words)}. Rank is by *inside*."
    )
    rows = [
        [f"`{name}`", *(_interval(half[name]["inside"]) for half in (one, two)),
         *(_interval(half[name]["rank"], form=".0f") for half in (one, two))]
        for name in names
    ]  # fmt: skip
    head = ("controller", "inside: first", "second", "rank: first", "second")
    yield Section("Two halves of the draws", said, head, rows)


def _overlap(one: Summary, two: Summary) -> bool:
    return bool(one["low"] <= two["high"] and two["low"] <= one["high"])


def _noticed(summary: Summary) -> Iterator[Section]:
    """What those noticed that name a failure at all."""
    broken = any(group != "none" for group in summary["by"]["failures"])
    flagged = ["rightly flagged", "a loss never flagged", "wrongly flagged", "delay, median [s]", "90 % [s]"]
    head = ["controller", *(flagged if broken else ()), "healthy hours", "false alarms in them", "per hour"]
    rows = []
    for name in filter(summary["controllers"].__contains__, _shown(summary)):
        score = summary["scores"][name]
        alarms, per_h = score["healthy_false_alarms"], score["healthy_false_alarms_per_h"]
        if alarms is None:  # it says nothing of failures
            continue
        said = [*(_interval(score[key]) for key in ("noticed", "missed", "named_wrongly")),
                *(_number(score["delay_s"][key]) for key in ("p50", "p90"))]  # fmt: skip
        if score["noticed"]["successes"] or score["named_wrongly"]["successes"] or alarms or not broken:
            rows.append([_named(summary, name), *(said if broken else ()), _number(score["healthy_hours"]), str(alarms),
                         _interval(per_h, form=".2f")])  # fmt: skip
    if rows:
        words = "Those that never flag, or say nothing of failures, are left out." if broken else ""
        yield Section("What was noticed", words, head, rows)


def _groups(summary: Summary) -> Iterator[Section]:
    """The shares held in each group, by the reference, the best other and the bound."""
    rival = _best_rival(summary)
    shown = [summary["reference"], *([] if rival is None else [rival]), *_bound(summary)]
    title, words = "By group", f"Share of the draws held. Groups of fewer than {_FEW} draws are left out."
    for factor, said in _TITLES.items():
        groups = _large(summary, factor)
        if len(groups) > 1:
            rows = [
                [group, str(each["draws"]), *(f"{each['held'][name] / each['draws']:.2f}" for name in shown)]
                for group, each in groups.items()
            ]
            yield Section(title, words, (said, "draws", *shown), rows)
            title = words = ""


def _others_lose(summary: Summary) -> Iterator[Section]:
    """Of each other controller, how many draws it alone loses, and which of them first."""
    rows = [
        [_named(summary, name), str(lost[0]["of"]), ", ".join(str(each["draw"]) for each in lost)]
        for name in _shown(summary)
        if name in summary["controllers"] and name != summary["reference"] and (lost := summary["lost"][name])
    ]
    if rows:
        words = "Draws that it does not hold and another, told nothing, does, and those in which it is outside longest."
        yield Section("Where the others lose", words, ("controller", "draws", "which"), rows)


def _reasons(summary: Summary) -> Iterator[Section]:
    counts: dict[tuple[str, int], list[str]] = {}
    for name in summary["controllers"]:
        for reason, many in summary["scores"][name]["without_result"].items():
            counts.setdefault((reason, many), []).append(f"`{name}`")
    everyone = len(summary["controllers"])
    rows = [
        ["all" if len(names) == everyone > 1 else ", ".join(names), str(many), reason]
        for (reason, many), names in counts.items()
    ]
    if rows:
        head = ("controller", "flights of each", "why")
        yield Section("Flights without a result", "They count as lost.", head, rows)


def _flown(summary: Summary) -> str:
    said = f"Suite `{summary['suite']}`, version {summary['version']}, seed {summary['seed']}, {count(summary['draws'], 'draw')}."
    if summary.get("word"):
        digest = summary["law_sha256"]
        law = f"digest `{digest[:16]}`" if digest else "digest, which was not recorded,"
        said += f" The seed is made from the controllers' {law} and the word `{summary['word']}`."
    return said


def _interval(known: Summary, key: str = "estimate", form: str = ".3f") -> str:
    return "" if known[key] is None else interval(known, key, form)


def _number(value: float | None) -> str:
    return number(value, ".3g", absent="")


def tests_of_benchmark(summary: Mapping[str, Any], frame: pd.DataFrame) -> Iterator[Test]:
    """A test of each flight, in the order of draws and controllers, which fails where it was not held."""
    for row in frame.to_dict("records"):
        said = row["reason"] or ("left its limits" if row["survived"] else f"lost: {row['outcome']}")
        command = again(summary, row["draw"], row["controller"])
        name = f"draw {row['draw']}, {row['controller']}"
        yield Test(name) if row["held"] else Test(name, said, f"{_drawn(row)}\n{command}")


def _drawn(row: Mapping[Any, Any]) -> str:
    """What was drawn, and how far the flight strayed: a benchmark keeps no log of which a story could be told."""
    about = ", ".join(f"{key} {row[key]}" for key in ("weather", "gust", "sensors", "failures", "course"))
    inside = f"within its limits in {100 * row['inside']:.0f} % of the flight, which ended at {row['end_time_s']:g} s"
    worst = (
        f"{row['altitude_error_max_m']:.1f} m of altitude, {row['heading_error_max_deg']:.0f} deg of heading"
    )
    return f"{row['aircraft']}, {row['truth']}: {about}.\nWorst: {worst}; {inside}."
