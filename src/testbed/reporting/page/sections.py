"""The parts of a flight's page in HTML: verdict, story, requirements, metrics by theme, and how to fly it again."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from html import escape
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from testbed.common.docstrings import first_line
from testbed.flight.flight import Flight
from testbed.metrics import TABLE as METRICS
from testbed.reporting import html
from testbed.reporting.numbers import rounded
from testbed.reporting.story import diagnoses, story
from testbed.reporting.words import describe, title
from testbed.scenario.load import dump

_THEMES = {
    "tracking": "Following the references",
    "monitoring": "Noticing failures",
    "estimation": "Estimating effectiveness",
    "effort": "Effort of the actuators",
}
"""Titles of the metrics' modules."""
AGAIN = """<p>Run this in the folder of this report.
With the same versions of testbed and JSBSim the log is the same to the last digit.</p>
<pre>python -m testbed run scenario.yaml --out again</pre>"""


def head(flight: Flight) -> str:
    """Title, chips, verdict, story and warnings."""
    missed = [requirement["name"] for requirement in flight.requirements if not requirement["passed"]]
    total = len(flight.requirements)
    verdict = "Passed" if flight.passed else "Not passed"
    text = f"<strong>{verdict}.</strong> It {flight.outcome.sentence} ({flight.end_time_s:g} s); "
    text += (
        f"{total - len(missed)} of {total} requirements met."
        if total
        else "the scenario has no requirements."
    )
    warnings = "".join(f'\n<p class="missed">Warning: {escape(warning)}</p>' for warning in flight.warnings)
    return (
        f"<h1>{escape(flight.scenario.name)}</h1>\n{html.chips(facts(flight))}\n"
        f'<p class="verdict {"met" if flight.passed else "missed"}">{text}</p>\n'
        f"{html.listed(story(flight), 'story')}{_said(flight)}{warnings}"
    )


def _said(flight: Flight) -> str:
    """What the controller said, folded: the first of it can be read."""
    said = diagnoses(flight)
    if not said:
        return ""
    return html.folded(said[0], html.listed(said[1:])) if said[1:] else f"<p>{escape(said[0])}</p>"


def facts(flight: Flight) -> dict[str, str]:
    """What the chips say: aircraft, controller, air, sensors, seed."""
    scenario = flight.scenario
    air = scenario.atmosphere
    w20 = air.turbulence_w20_m_s
    return {
        "aircraft": str(scenario.aircraft),
        "controller": flight.controller,
        "air": "calm" if air.is_calm else f"turbulence, W20 {w20:.3g} m/s" if w20 else "wind",
        "sensors": "ideal" if scenario.sensors.is_ideal else "with errors",
        "seed": str(scenario.seed),
        "duration": f"{flight.end_time_s:g} of {scenario.duration_s:g} s",
    }


def requirements(flight: Flight) -> str:
    """The requirements, missed ones first, with margins as bars."""
    if not flight.requirements:
        return ""
    order = sorted(flight.requirements, key=lambda r: bool(r["passed"]))
    caption = (
        "Value: the worst value. Bar: how much of the limit it takes; the line is the limit. "
        "Robustness: the distance from the limit in units of its scale, negative where it is not met."
    )
    columns: dict[str, Callable[[Mapping[str, Any]], html.Cell]] = {
        "verdict": lambda r: "met" if r["passed"] else "NOT MET",
        "requirement": lambda r: r["name"],
        "value": lambda r: rounded(r["value"]),
        "share of the limit": _bar,
        "robustness": lambda r: rounded(r.get("robustness")),
        "remark": lambda r: r.get("reason", ""),
    }
    table = html.listing(order, columns, caption, lambda r: "met" if r["passed"] else "missed")
    return f"<h2>Requirements</h2>\n{table}"


def _bar(requirement: Mapping[str, Any]) -> html.Html | str:
    """The worst value as a share of the limit, up to twice the limit; empty where there is no such share."""
    value, margin = requirement["value"], requirement.get("margin")
    if value is None or margin is None or not math.isfinite(value) or not math.isfinite(margin):
        return ""
    allowed = abs(value) + margin if value >= 0 else None
    if not allowed or allowed <= 0.0:
        return ""
    share = min(abs(value) / allowed, 2.0)
    kind = "margin" if requirement["passed"] else "margin missed"
    return html.Html(
        f'<span class="{kind}"><i style="width:{50 * share:.1f}%"></i><u style="left:50%"></u></span>'
    )


def events(flight: Flight) -> str:
    """What happened, in order of time."""
    if not flight.events:
        return "<h2>Events</h2>\n<p>Nothing broke, and nothing was flagged.</p>"
    columns: dict[str, Callable[[Mapping[str, Any]], html.Cell]] = {
        "time [s]": lambda event: f"{event['time_s']:.3f}",
        "kind": lambda event: title(str(event["kind"])),
        "what": lambda event: describe(event, flight),
    }
    return f"<h2>Events</h2>\n{html.listing(flight.events, columns)}"


def metrics(flight: Flight) -> str:
    """The metrics by theme, each with its definition; those of another version of testbed last."""
    themes: dict[str, list[str]] = {}
    for name in flight.metrics:
        module = METRICS[name].__module__.rpartition(".")[2] if name in METRICS else ""
        themes.setdefault(_THEMES.get(module, "Others"), []).append(name)
    parts = ["<h2>Metrics</h2>", html.note("A dash means that the metric has no value in this flight.")]
    columns: dict[str, Callable[[str], html.Cell]] = {
        "metric": str,
        "definition and [unit]": definition,
        "value": lambda name: rounded(flight.metrics[name]),
    }
    parts += (html.folded(theme, html.listing(names, columns)) for theme, names in themes.items())
    return "\n".join(parts)


def definition(metric: str) -> str:
    """First line of a metric's docstring; "" for a metric that this version does not have."""
    function = METRICS.get(metric)
    return first_line(function) if function else ""


def again(flight: Flight, how: str = AGAIN) -> str:
    """The resolved scenario, the versions, and the HTML `how` with the command that flies it again."""
    versions = ", ".join(f"{name} {_version(name)}" for name in ("testbed", "jsbsim", "numpy"))
    scenario = html.folded("The scenario with all its values", f"<pre>{escape(dump(flight.scenario))}</pre>")
    return f"<h2>Fly it again</h2>\n{how}\n{scenario}\n{html.note(f'Report made with {versions}.')}"


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:  # run from the repository, not installed
        return "not installed"
