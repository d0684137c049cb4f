"""The page of a diagnosis: the story, each actuator's effectiveness beside the truth where the log has it, the findings, what the
model leaves of the turning rates, and the replay, with what the diagnosis believes in place of a controller."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from testbed.aircraft.conventional_shape import conventional, shape_of
from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.shape import Shape
from testbed.common.signals import STATE, Belief
from testbed.flight.columns import stretches
from testbed.flight.flight import Flight
from testbed.logs.diagnosis import UNKNOWN_STD, WINDOW_S, Diagnosis, Finding, sentence, story
from testbed.logs.hypotheses import MEANINGS, STATES
from testbed.logs.output_error import STRETCH_S, Residuals
from testbed.reporting import html
from testbed.reporting.html import Cell, Html, tag
from testbed.reporting.page import can_be_replayed, packed
from testbed.reporting.palette import PALETTE
from testbed.reporting.panels import response_of, shown_log
from testbed.reporting.run_report import to_fill
from testbed.reporting.words import title

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes


_TITLES = {"healthy": "nothing found", "unnoticed": "broken, not found", "flagged": "found"}
_PLACE = {"north": "north_m", "east": "east_m", "altitude": "altitude_m", "heading": "heading_deg"}
_ANGLES = ("roll", "pitch", "alpha", "beta", "heading")


class Scene(NamedTuple):
    """Columns [rows] by their names in a run's log; {kind, unit, limits, scale} of each actuator; and the aircraft's looks."""

    log: Mapping[str, np.ndarray]
    actuators: Mapping[str, Mapping[str, Any]]
    shape: Shape


def of_flight(found: Diagnosis, flight: Flight) -> Scene:
    """That of a run folder: what was true of it, without what its controller gave up."""
    log = {name: values for name, values in shown_log(flight).items() if not name.endswith("_released")}
    return Scene(log | believed(found, log["time_s"]), flight.actuators, flight.shape or conventional())


def of_log(found: Diagnosis, aircraft: Aircraft, model: DesignModel) -> Scene:
    """That of a log, in which actuators are where the diagnosis believes them: no columns if it does not say where it flew."""
    log = found.log
    facts = {
        name: actuator.model_dump(include={"kind", "unit", "limits", "scale"})
        for name, actuator in aircraft.actuators.items()
    }
    if not log.place:
        return Scene({"time_s": log.time_s}, facts, conventional())
    states = {name: log.states[:, STATE.index(name)] for name in ("airspeed", "roll", "pitch")}
    columns = {"time_s": log.time_s, "airspeed_m_s": states.pop("airspeed")}
    for name, values in {**log.place, **states}.items():
        turned = np.degrees(values) if name in _ANGLES else values
        columns[_PLACE.get(name, f"{name}_deg")] = turned
    columns |= believed(found, log.time_s)
    for i, (name, fact) in enumerate(facts.items()):
        command = log.commands[:, i] * (math.degrees(1.0) if fact["kind"] == "servo" else 1.0)
        command = command if log.as_positions[i] or fact["kind"] == "servo" else command * fact["limits"][1]
        held, works = columns[f"{name}_believed_position"], columns[f"{name}_effectiveness_estimate"]
        columns |= {
            f"{name}_command": command, f"{name}_position": np.where(np.isfinite(held), held, command),
            f"{name}_effectiveness": np.where(np.isfinite(works), works, 1.0), response_of(name): works,
        }  # fmt: skip
    return Scene(columns, facts, shape_of(aircraft, model))


def believed(found: Diagnosis, time_s: np.ndarray) -> dict[str, np.ndarray]:
    """Columns of a flight's log in which a controller says what it believes, with what the diagnosis does."""
    at = np.clip(np.searchsorted(found.time_s, time_s, "right") - 1, 0, None)
    kinds = np.array([Belief[s].value if s in Belief.__members__ else Belief.works.value for s in STATES])
    made: dict[str, np.ndarray] = {}
    for i, name in enumerate(found.actuators):
        states, place = found.states[at, i], np.full(len(time_s), np.nan)
        for one in found.findings:
            if (one.actuator, one.state) == (name, "held"):
                place[(time_s >= one.from_s) & (time_s < one.until_s)] = one.position
        made[f"{name}_effectiveness_estimate"] = found.effectiveness[at, i]
        made[f"{name}_belief"] = kinds[states].astype(float)
        made[f"{name}_failed"] = (states > 0).astype(float)
        made[f"{name}_believed_position"] = place
    return made


def replay(found: Diagnosis, scene: Scene) -> tuple[Html, dict[str, Any]] | None:
    """(timeline and replay in HTML, the data of the page) for `flight.js`; None where the log does not say where it was."""
    if not can_be_replayed(scene.log):
        return None
    told, columns = packed(scene.log)
    failures = [{"time_s": t, "kind": "injection", "text": "truly broken"} for t in found.log.failures_s]
    findings = [{"time_s": f.from_s, "kind": "detection", "text": sentence(f, found)} for f in found.findings]
    flight = {
        "data": told, "panels": [], "phases": phases(found), "failures_s": list(found.log.failures_s),
        "actuators": scene.actuators, "beliefs": {belief.value: belief.name for belief in Belief}, "estimates": True,
        "shape": scene.shape.model_dump(), "events": failures + findings, "titles": _TITLES, "believer": "the diagnosis",
    }  # fmt: skip
    return to_fill([], scene.log), {"flight": flight, "columns": columns}


def phases(found: Diagnosis) -> list[dict[str, Any]]:
    """{name, from_s, until_s}: `flagged` where something was found, `unnoticed` from a true failure to the next finding."""
    names = np.where(np.any(found.states > 0, axis=1), "flagged", "healthy").astype(object)
    for time_s in found.log.failures_s:
        for k in range(int(np.searchsorted(found.time_s, time_s)), len(names)):
            if names[k] == "flagged":
                break
            names[k] = "unnoticed"
    ends = np.append(found.time_s, found.log.time_s[-1])
    ends[0] = found.log.time_s[0]
    made = [
        {"name": name, "from_s": float(ends[a]), "until_s": float(ends[b])}
        for name in _TITLES for a, b in stretches(names == name)
    ]  # fmt: skip
    return sorted(made, key=lambda each: float(each["from_s"]))


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
