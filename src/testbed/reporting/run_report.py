"""The report of a flight: one page with its story, its replay, its panels, and every number; and its parts in HTML."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np

from testbed.common.angles import unwrapped_deg
from testbed.common.docstrings import first_line
from testbed.flight.breakage import UNITS, tracking_error
from testbed.flight.flight import Flight
from testbed.flight.requirements import worst_s
from testbed.metrics import TABLE as METRICS
from testbed.metrics import THEMES
from testbed.reporting import html
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.page import can_be_replayed, drawn, groups, packed
from testbed.reporting.panels import TRACKED, shown_log
from testbed.reporting.story import diagnoses, story
from testbed.reporting.words import DIGITS, VERDICTS, describe, kind_of, rounded
from testbed.scenario.load import dump

_NAMED = 3  # requirements that the verdict names; the others are in the table below
_CLASSES = {True: "met", False: "missed", None: ""}
AGAIN = Html("""<p>Run this in the folder of this report.
With the same versions of testbed and JSBSim the log is the same to the last digit.</p>
<pre>python -m testbed run scenario.yaml --out again</pre>""")


def write_page(
    flight: Flight,
    file: Path,
    figures: Path | None = None,
    again: Html = AGAIN,
    back: Part = None,
    within: Path | None = None,
) -> Path:
    """Write the page of a flight; returns its file. Raises OSError when it cannot be written.

    Args:
        figures: folder of the static figures, if there are any.
        again: HTML that says how to fly it again.
        back: what stands above the title, such as a link to where the flight comes from.
        within: the folder that was asked for; by default the file's own.
    """
    log = shown_log(flight)
    if not can_be_replayed(log):
        parts = _parts(flight, None, figures, again, back)
        return html.write_page(file, flight.scenario.name, parts, within=within)
    turned = TRACKED["heading"].error
    log |= {turned: unwrapped_deg(log[turned])} if turned in log else {}  # it goes on beyond a half turn
    shown = groups(flight, log)
    told, columns = packed(log)
    happened = [
        {"time_s": event["time_s"], "kind": event["kind"], "text": describe(event, flight)}
        for event in flight.events
    ]
    script = {"data": told, "panels": shown, **drawn(flight, log), "events": happened}
    parts = _parts(flight, to_fill(shown, log), figures, again, back)
    data = {"flight": script, "columns": columns}
    return html.write_page(file, flight.scenario.name, parts, "flight.js", data, within)


def _parts(flight: Flight, moving: Part, figures: Path | None, again: Html, back: Part) -> Iterator[Part]:
    yield back
    yield head(flight)
    yield moving
    if figures is not None:  # hidden where the script runs, and printed
        captions = {name: figure.caption for name, figure in FIGURES.items()}
        shown = html.figures(figures, captions)
        yield tag("div", tag("h2", "Figures"), shown, class_="still") if shown else None
    yield requirements(flight)
    yield events(flight)
    yield metrics(flight)
    yield how_again(flight, again)


def to_fill(shown: list[dict[str, Any]], columns: Iterable[str]) -> Html:
    """The places that the script fills: timeline, replay, panels, and a panel of any column."""
    said = "Drag in a panel to zoom, double-click for the whole flight, click to go there."
    chosen = tag("select", [tag("option", name) for name in columns if name != "time_s"])
    any_column = tag("div", tag("label", "column ", chosen), id="any-column")
    return tag(
        "div", tag("h2", "The flight"), [tag("div", id=place) for place in ("timeline", "replay")], html.note(said),
        map(html.panels, shown), html.folded("Any column of the log", any_column), class_="moving",
    )  # fmt: skip


def head(flight: Flight) -> Iterator[Html]:
    """Title, chips, verdict, story, what the controller said, and warnings."""
    said = diagnoses(flight)
    sentence = tag("p", verdict(flight), class_=f"verdict {_CLASSES[flight.judged]}".rstrip())
    yield html.opening(flight.scenario.name, story(flight), facts(flight), sentence)
    if said:
        yield html.folded(said[0], html.listed(said[1:])) if said[1:] else tag("p", said[0])
    for warning in flight.warnings:
        yield tag("p", f"Warning: {warning}", class_="missed")


def verdict(flight: Flight) -> Html:
    """Whether it passed, how it ended, how many requirements are met, and which are not."""
    counted = flight.counted if flight.requirements else "the scenario has no requirements"
    word = tag("strong", f"{flight.verdict.capitalize()}.")
    return html.joined(
        [word, f" It {flight.outcome.sentence} ({flight.end_time_s:g} s); {counted}.", unmet(flight)]
    )


def unmet(flight: Flight) -> Html:
    """The requirements that were not met, each a link to its worst moment; "" if all were met."""
    links = []
    for number, verdict in enumerate(flight.requirements):
        if verdict["passed"] is False:
            time_s = _moment_s(flight, number)
            go = None if time_s is None else f"{time_s:.3f}"
            links.append(tag("a", verdict["name"], _at(time_s), href="#requirements", data_go=go))
    more = [tag("a", f"{len(links) - _NAMED} more", href="#requirements")] if links[_NAMED:] else []
    named = html.joined([*links[:_NAMED], *more], "; ")
    return html.joined([" Not met: ", named, "."] if links else None)


def told(flight: Flight, verdict: Mapping[str, Any]) -> str:
    """When a requirement that was judged so was furthest from being met, in words for a terminal; "" if that is unknown."""
    return _at(_moment_s(flight, list(flight.requirements).index(verdict)))


def _at(time_s: float | None) -> str:
    return "" if time_s is None else f", worst at {time_s:.1f} s"


def _moment_s(flight: Flight, number: int) -> float | None:
    """When a requirement was furthest from being met [s]; of an error's metric, when that error was largest. None if unknown."""
    asked, log = flight.scenario.requirements, flight.signals
    if number >= len(asked):  # another version may have judged others
        return None
    metric = asked[number].metric
    if metric is None:
        return worst_s(asked[number], log)
    quantity = next((q for q in UNITS if metric.startswith(f"{q}_error")), None)
    error = np.array([]) if quantity is None else np.abs(tracking_error(log, quantity))
    return float(log["time_s"][np.nanargmax(error)]) if np.isfinite(error).any() else None


def facts(flight: Flight) -> dict[str, str]:
    """What the chips say: aircraft, controller, air, sensors, seed."""
    scenario = flight.scenario
    air = scenario.atmosphere
    w20 = air.most_w20_m_s
    code = {"its code": flight.flown_by_sha256[:DIGITS]} if flight.flown_by_sha256 else {}
    return {
        "aircraft": str(scenario.aircraft),
        "controller": flight.controller,
        **code,
        "air": "calm" if air.is_calm else f"turbulence, W20 {w20:.3g} m/s" if w20 else "wind",
        "sensors": "ideal" if scenario.sensors.is_ideal else "with errors",
        "seed": str(scenario.seed),
        "duration": f"{flight.end_time_s:g} of {scenario.duration_s:g} s",
    }


def in_order(flight: Flight) -> list[Mapping[str, Any]]:
    """The verdicts on its requirements: missed ones first, then those not judged."""
    return sorted(flight.requirements, key=lambda r: list(VERDICTS).index(r["passed"]))


def requirements(flight: Flight) -> Iterator[Html]:
    """The requirements, missed ones first, with margins as bars."""
    if not flight.requirements:
        return
    caption = (
        "Value: the worst value. Bar: how much of the limit it takes; the line is the limit. "
        "Robustness: the distance from the limit in units of its scale, negative where it is not met."
    )
    columns: dict[str, Callable[[Mapping[str, Any]], html.Cell]] = {
        "verdict": lambda r: VERDICTS[r["passed"]],
        "requirement": lambda r: r["name"],
        "value": lambda r: rounded(r["value"]),
        "share of the limit": _bar,
        "robustness": lambda r: rounded(r.get("robustness")),
        "remark": lambda r: r.get("reason", ""),
    }
    yield tag("h2", "Requirements", id="requirements")
    yield html.listing(in_order(flight), columns, caption, lambda r: _CLASSES[r["passed"]])


def _bar(requirement: Mapping[str, Any]) -> str:
    """The worst value as a share of the limit, up to twice the limit; empty where there is no such share."""
    value, margin = requirement["value"], requirement.get("margin")
    if value is None or margin is None or not 0.0 <= value < math.inf or not -value < margin < math.inf:
        return ""
    allowed = value + margin
    filled = tag("i", style=f"width:{50 * min(value / allowed, 2.0):.1f}%")
    kind = "margin" if requirement["passed"] else "margin missed"
    return tag("span", filled, tag("u", style="left:50%"), class_=kind)


def events(flight: Flight) -> Iterator[Html]:
    """What happened, in order of time."""
    columns: dict[str, Callable[[Mapping[str, Any]], html.Cell]] = {
        "time [s]": lambda event: f"{event['time_s']:.3f}",
        "kind": kind_of,
        "what": lambda event: describe(event, flight),
    }
    yield tag("h2", "Events")
    none = tag("p", "Nothing broke, and nothing was flagged.")
    yield html.listing(flight.events, columns) if flight.events else none


def metrics(flight: Flight) -> Iterator[Html]:
    """The metrics by theme, each with its definition; those of another version of testbed last."""
    themes: dict[str, list[str]] = {}
    for name in flight.metrics:
        about = (theme for theme, of in THEMES.items() if METRICS.get(name) in of)
        themes.setdefault(next(about, "Others"), []).append(name)
    columns: dict[str, Callable[[str], html.Cell]] = {
        "metric": str,
        "definition and [unit]": definition,
        "value": lambda name: rounded(flight.metrics[name]),
    }
    yield tag("h2", "Metrics")
    yield html.note("A dash means that the metric has no value in this flight.")
    yield from (html.folded(theme, html.listing(names, columns)) for theme, names in themes.items())


def definition(metric: str) -> str:
    """First line of a metric's docstring; "" for a metric that this version does not have."""
    function = METRICS.get(metric)
    return first_line(function) if function else ""


def how_again(flight: Flight, how: Html) -> Iterator[Html]:
    """The resolved scenario, the versions, and the HTML `how` with the command that flies it again."""
    yield tag("h2", "Fly it again")
    yield how
    yield html.folded("The scenario with all its values", tag("pre", dump(flight.scenario)))
    versions = ", ".join(f"{name} {_version(name)}" for name in ("testbed", "jsbsim", "numpy"))
    yield html.note(f"Report made with {versions}.")


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:  # run from the repository, not installed
        return "not installed"
