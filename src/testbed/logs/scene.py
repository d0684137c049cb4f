"""The replay of a diagnosis: timeline and picture of a flight, with what the diagnosis believes in place of a controller."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from testbed.aircraft.conventional_shape import conventional, shape_of
from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.shape import Shape
from testbed.common.signals import STATE, Belief
from testbed.flight.columns import stretches
from testbed.flight.flight import Flight
from testbed.logs.hypotheses import STATES
from testbed.logs.words import Diagnosis, sentence
from testbed.reporting.html import Html
from testbed.reporting.page import can_be_replayed, packed
from testbed.reporting.panels import response_of, shown_log
from testbed.reporting.run_report import to_fill

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
