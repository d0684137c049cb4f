"""The page of a diagnosis: the story, each actuator's effectiveness beside the truth where the log has it, the findings, what the
model leaves of the turning rates, and the replay."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from testbed.flight.columns import stretches
from testbed.logs.hypotheses import MEANINGS, STATES
from testbed.logs.output_error import STRETCH_S, Residuals
from testbed.logs.scene import Scene, replay
from testbed.logs.words import UNKNOWN_STD, WINDOW_S, Diagnosis, Finding, story
from testbed.reporting import html
from testbed.reporting.html import Cell, tag
from testbed.reporting.palette import PALETTE
from testbed.reporting.words import title

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes

_CAPTION = (
    "Effectiveness of each actuator with two standard deviations, and the truth where the log has it. Red: something was found. "
    f"Grey: nothing can be known, because {WINDOW_S:g} s say it no better than +-{UNKNOWN_STD:g}."
)


_LEFT = (
    f"Turning rates, measured and as the design model simulates them in stretches of {STRETCH_S:g} s if every actuator works, and "
    "what is left. It grows where an actuator does not do what it was told, and in gusts."
)
_STROKES = (
    "Strokes in the timeline: what was found, as listed below, and what truly broke, where the log has it."
)
_NO_TRUTH = " The log has no truth: surfaces, discs and thrusts are what the diagnosis believes."


def write_page(diagnosis: Diagnosis, left: Residuals, scene: Scene, out: Path) -> None:
    """Write `report.html` into a folder. Raises OSError.

    Args:
        left: as `output_error.residuals` gives them.
        scene: what is replayed, if the log says where the aircraft was.
    """
    columns: dict[str, Callable[[Finding], Cell]] = {
        "actuator": lambda f: title(f.actuator),
        "state": lambda f: f.state,
        "from [s]": lambda f: f.from_s,
        "until [s]": lambda f: f.until_s,
        "probability": lambda f: f.probability,
        "effectiveness": lambda f: f.effectiveness,
        "its std": lambda f: f.std,
        "position": lambda f: f.position,
    }
    meanings = [f"{state}: {MEANINGS[state]}" for state in STATES]
    name = f"Diagnosis of {diagnosis.log.name}"
    parts = [
        html.opening(name, story(diagnosis)),
        html.picture(_picture(diagnosis), _CAPTION),
        tag("h2", "Findings"),
        html.listing(diagnosis.findings, columns) if diagnosis.findings else html.note("None."),
        html.folded("What the states mean", html.listed(meanings)),
    ]
    if len(left[0]):
        parts += [
            tag("h2", "Residuals"),
            html.picture(residuals_picture(left, diagnosis.log.failures_s), _LEFT),
        ]
    script, data = "", None
    if shown := replay(diagnosis, scene):
        parts[1:1] = [shown[0], html.note(_STROKES + ("" if diagnosis.log.truth else _NO_TRUTH))]
        script, data = "flight.js", shown[1]
    html.write_page(out / "report.html", name, parts, script, data, out)


def _picture(diagnosis: Diagnosis) -> bytes:
    """PNG with a panel for each actuator."""
    from matplotlib.figure import Figure

    from testbed.reporting.figures.sheet import png

    figure = Figure(figsize=(10.0, 0.8 + 1.6 * len(diagnosis.actuators)), layout="constrained")
    made = figure.subplots(len(diagnosis.actuators), 1, sharex=True, squeeze=False)
    for i, axes in enumerate(made[:, 0]):
        _draw(axes, diagnosis, i)
    made[-1, 0].set_xlabel("time [s]")
    return png(figure)


def _draw(axes: Axes, diagnosis: Diagnosis, i: int) -> None:
    name, time_s = diagnosis.actuators[i], diagnosis.time_s
    level, spread = diagnosis.effectiveness[:, i], 2.0 * diagnosis.std[:, i]
    for rows, colour in (
        (diagnosis.alone_std[:, i] > UNKNOWN_STD, "0.5"),
        (diagnosis.states[:, i] > 0, PALETTE["missed"]),
    ):
        for first, end in stretches(np.asarray(rows)):
            axes.axvspan(time_s[first], time_s[end - 1], color=colour, alpha=0.15, lw=0)
    axes.fill_between(time_s, level - spread, level + spread, color=PALETTE["belief"], alpha=0.25, lw=0)
    axes.plot(time_s, level, color=PALETTE["belief"], ls="--", label="from the log")
    if name in diagnosis.log.truth:
        axes.plot(diagnosis.log.time_s, diagnosis.log.truth[name], color=PALETTE["truth"], label="truth")
    for time in diagnosis.log.failures_s:
        axes.axvline(time, color=PALETTE["failure"], lw=1.0)
    for finding in diagnosis.findings:
        if finding.actuator == name:
            axes.annotate(
                finding.state, (finding.from_s, 1.25), color=PALETTE["missed"], va="top", parse_math=False
            )
    axes.set_ylim(-1.3, 1.4)
    axes.set_ylabel(title(name).replace(" ", "\n"), parse_math=False)
    axes.legend(loc="lower right", fontsize="small")


def residuals_picture(left: Residuals, failures_s: Sequence[float] = ()) -> bytes:
    """PNG with a panel for each of p, q and r, and lines where something broke."""
    from matplotlib.figure import Figure

    from testbed.reporting.figures.sheet import png

    figure = Figure(figsize=(10.0, 6.0), layout="constrained")
    made = figure.subplots(3, 1, sharex=True)
    time_s, measured, error = (np.concatenate([x, 0.0 * x[:, :1] + np.nan], axis=1) for x in left)
    for i, axes in enumerate(made):
        lines = {
            "measured": (measured, PALETTE["truth"], "-"),
            "predicted": (measured + error, PALETTE["belief"], "--"),
            "left": (-error, PALETTE["missed"], "-"),
        }
        for label, (rates, colour, style) in lines.items():
            rate = np.degrees(rates[..., i]).ravel()
            axes.plot(time_s.ravel(), rate, color=colour, ls=style, lw=0.8, label=label)
        for time in failures_s:
            axes.axvline(time, color=PALETTE["failure"], lw=1.0)
        axes.set_ylabel(f"{'pqr'[i]} [deg/s]")
        axes.legend(loc="lower right", fontsize="small", ncols=3)
    made[-1].set_xlabel("time [s]")
    return png(figure)
