"""The report of a run folder: verdict, requirements, events, figures and metrics of one flight."""

from __future__ import annotations

from html import escape
from pathlib import Path

from testbed.flight.flight import Flight
from testbed.flight.folder import load
from testbed.metrics import TABLE as METRICS
from testbed.reporting import html
from testbed.reporting.figures import TABLE as FIGURES
from testbed.reporting.figures.marks import describe
from testbed.reporting.story import story

_AGAIN = """<h2>Fly it again</h2>
<p>Run this in the folder of this report. With the same versions of testbed and JSBSim the log is the same to the last digit.</p>
<pre>python -m testbed run scenario.yaml --out again</pre>"""


def write_report(folder: str | Path) -> Path:
    """Write `report.html` into a run folder, from its log, summary and figures; returns the file.

    Raises BadInput when it is not a run folder.
    """
    folder = Path(folder)
    flight = load(folder)
    parts = (
        _verdict(flight),
        _requirements(flight),
        _events(flight),
        _figures(folder / "figures"),
        _metrics(flight),
        _AGAIN,
    )
    return html.write_page(folder / "report.html", flight.scenario.name, parts)


def _verdict(flight: Flight) -> str:
    missed = [requirement["name"] for requirement in flight.requirements if not requirement["passed"]]
    total = len(flight.requirements)
    verdict = "Passed" if flight.passed else "Not passed"
    text = f"<strong>{verdict}.</strong> The aircraft {flight.outcome.sentence} ({flight.end_time_s:g} s); "
    met = f"{total - len(missed)} of {total} requirements met."
    text += met if total else "the scenario has no requirements."
    scenario = flight.scenario
    about = f"{flight.controller}, aircraft {scenario.aircraft}, seed {scenario.seed}"
    about += f", {scenario.duration_s:g} s asked for"
    warnings = "".join(f'\n<p class="missed">Warning: {escape(warning)}</p>' for warning in flight.warnings)
    told = "".join(f"<p>{escape(line)}</p>\n" for line in story(flight))
    return (
        f"<h1>{escape(scenario.name)}</h1>\n<p>{escape(about)}</p>\n{told}"
        f'<p class="verdict {"met" if flight.passed else "missed"}">{text}</p>{warnings}'
    )


def _requirements(flight: Flight) -> str:
    if not flight.requirements:
        return ""
    rows = (
        html.row(
            [
                "met" if r["passed"] else "NOT MET",
                r["name"],
                r.get("reason", ""),
                r["value"],
                r.get("margin"),
            ],
            "met" if r["passed"] else "missed",
        )
        for r in flight.requirements
    )
    caption = "Value: the worst value. Margin: the distance to the limit, negative if the limit is exceeded."
    heads = ("verdict", "requirement", "remark", "value", "margin")
    return "<h2>Requirements</h2>\n" + html.table(heads, rows, caption)


def _events(flight: Flight) -> str:
    if not flight.events:
        return "<h2>Events</h2>\n<p>Nothing broke, and nothing was flagged.</p>"
    rows = (
        html.row([f"{event['time_s']:.3f}", str(event["kind"]).replace("_", " "), describe(event)])
        for event in flight.events
    )
    return "<h2>Events</h2>\n" + html.table(("time [s]", "kind", "what"), rows)


def _figures(folder: Path) -> str:
    shown = html.figures(folder, {name: caption for name, (caption, _) in FIGURES.items()})
    return "\n".join(["<h2>Figures</h2>", *shown]) if shown else ""


def _metrics(flight: Flight) -> str:
    rows = (html.row([name, definition(name), value]) for name, value in flight.metrics.items())
    caption = "A dash means that the metric has no value in this flight."
    heads = ("metric", "definition and [unit]", "value")
    return "<h2>Metrics</h2>\n" + html.table(heads, rows, caption)


def definition(metric: str) -> str:
    """First line of a metric's docstring; "" for a metric that this version does not have."""
    function = METRICS.get(metric)
    return (function.__doc__ or "").strip().partition("\n")[0] if function else ""
