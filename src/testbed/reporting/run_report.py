"""The report of a run folder: one HTML file with everything in it, no script, nothing from the network."""

from __future__ import annotations

import base64
import math
from collections.abc import Iterable
from html import escape
from pathlib import Path
from typing import Any

from testbed.flight.flight import Flight
from testbed.flight.folder import load
from testbed.metrics import TABLE
from testbed.reporting.figures import FIGURES
from testbed.reporting.figures.marks import describe

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #1a1a1a; }
body { max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.verdict { padding: .7rem 1rem; border-left: .5rem solid; font-size: 1.1rem; }
.met { border-color: #2e7d32; } .missed { border-color: #b22222; background: #fdf1f0; }
table { border-collapse: collapse; width: 100%; }
caption { text-align: left; color: #555; padding-bottom: .3rem; }
th, td { text-align: left; padding: .25rem .6rem; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.missed td:first-child { font-weight: bold; color: #b22222; }
img { max-width: 100%; } figure { margin: 1.5rem 0; } figcaption { color: #555; }
pre { background: #f4f4f4; padding: .7rem 1rem; overflow-x: auto; }
@media print { body { max-width: none; } figure, tr { break-inside: avoid; } }
"""


_AGAIN = """<h2>Fly it again</h2>
<p>In this folder; with the same versions of testbed and JSBSim the log is the same to the last digit.</p>
<pre>python -m testbed run scenario.yaml --out again</pre>"""


def write_report(folder: str | Path) -> Path:
    """Write `report.html` into a run folder, from what is in it: log, summary and whatever figures are there.

    Raises BadInput when it is not a run folder.
    """
    folder = Path(folder)
    file = folder / "report.html"
    partial = folder / ".report.html.partial"
    partial.write_text(page(load(folder), folder), encoding="utf-8")
    partial.replace(file)
    return file


def page(flight: Flight, folder: Path) -> str:
    """The report as HTML, with the figures found in `folder/figures`."""
    name = escape(flight.scenario.name)
    parts = (
        _verdict(flight),
        _requirements(flight),
        _events(flight),
        _figures(folder / "figures"),
        _metrics(flight),
        _AGAIN,
    )
    head = f'<meta charset="utf-8"><title>{name}</title><style>{_STYLE}</style>'
    body = "\n".join(parts)
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'


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
    return (
        f"<h1>{escape(scenario.name)}</h1>\n<p>{escape(about)}</p>\n"
        f'<p class="verdict {"met" if flight.passed else "missed"}">{text}</p>{warnings}'
    )


def _requirements(flight: Flight) -> str:
    if not flight.requirements:
        return ""
    rows = (
        _row(
            ["met" if r["passed"] else "NOT MET", r["name"], r.get("reason", "")],
            [r["value"], r.get("margin")],
            "met" if r["passed"] else "missed",
        )
        for r in flight.requirements
    )
    caption = "Value: the worst seen. Margin: how far it is inside the limit; negative is outside."
    return _table("Requirements", caption, ("verdict", "requirement", "remark", "value", "margin"), rows)


def _events(flight: Flight) -> str:
    rows = (
        _row([f"{event['time_s']:.3f}", str(event["kind"]).replace("_", " "), describe(event)])
        for event in flight.events
    )
    if not flight.events:
        return "<h2>Events</h2>\n<p>Nothing broke, and nothing was flagged.</p>"
    return _table("Events", "", ("time [s]", "kind", "what"), rows)


def _metrics(flight: Flight) -> str:
    rows = (_row([name, definition(name)], [value]) for name, value in flight.metrics.items())
    caption = "A dash is a metric that has no value in this flight."
    return _table("Metrics", caption, ("metric", "definition and [unit]", "value"), rows)


def definition(metric: str) -> str:
    """First line of a metric's docstring; nothing for one that this version does not know."""
    function = TABLE.get(metric)
    return (function.__doc__ or "").strip().partition("\n")[0] if function else ""


def _figures(folder: Path) -> str:
    parts = []
    for name, (caption, _) in FIGURES.items():
        file = folder / f"{name}.png"
        if file.is_file():
            data = base64.b64encode(file.read_bytes()).decode("ascii")
            image = f'<img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
            parts.append(f"<figure>{image}<figcaption>{escape(caption)}</figcaption></figure>")
    return "<h2>Figures</h2>\n" + "\n".join(parts) if parts else ""


def _table(title: str, caption: str, heads: Iterable[str], rows: Iterable[str]) -> str:
    head = "".join(f"<th>{escape(text)}</th>" for text in heads)
    above = f"<caption>{escape(caption)}</caption>" if caption else ""
    body = "\n".join(rows)
    return (
        f"<h2>{title}</h2>\n<table>{above}<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody></table>"
    )


def _row(texts: Iterable[str], numbers: Iterable[Any] = (), kind: str = "") -> str:
    cells = [f"<td>{escape(text)}</td>" for text in texts]
    cells += [f'<td class="number">{_number(value)}</td>' for value in numbers]
    return (f'<tr class="{kind}">' if kind else "<tr>") + "".join(cells) + "</tr>"


def _number(value: Any) -> str:
    if value is None or not math.isfinite(value):
        return "-"
    return f"{value:.4g}"
