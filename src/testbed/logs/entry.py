"""Diagnose a log: read it, take the aircraft's design model, and say and write what each actuator did."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL
from testbed.common.writing import write
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.setup import Setup, setup_for
from testbed.flight.breakage import failure_times_s
from testbed.flight.columns import reading
from testbed.flight.flight import Flight
from testbed.flight.folder import load, refuse_existing, refuse_unwritable
from testbed.inputs.problems import BadInput, Problem, did_you_mean
from testbed.logs import identified_report, mapped
from testbed.logs.diagnosis import Diagnosis, diagnosed, summary, table
from testbed.logs.flight_log import FlightLog, bad, even
from testbed.logs.identification import Identified, identified, makers
from testbed.logs.output_error import residuals
from testbed.logs.page import of_flight, of_log, write_page
from testbed.plant.identification import stored
from testbed.reporting.panels import response_of, shown_log
from testbed.scenario.load import Scenario

_READ = ("airspeed", "p", "q", "r", "roll", "pitch", "alpha", "beta")


def diagnose(
    log: str | Path,
    model: str | Path | None = None,
    columns: str | Path | None = None,
    out: str | Path | None = None,
) -> Diagnosis:
    """What each actuator did in a flight, from its log: commands and what sensors read, and nothing else.

    Args:
        log: a run folder, a CSV or Parquet file, or a log of ArduPilot (DataFlash) or PX4 (ULog).
        model: the aircraft, by name or folder, whose design model is used; by default that of the run folder's scenario.
        columns: the mapping file of a log that is no run folder: which column is what.
        out: folder to write `diagnosis.csv`, `summary.json` and `report.html` into, which must not exist; None for none.

    Returns:
        `findings`, a tuple of {actuator, state, from_s, until_s, probability, effectiveness, std, position}; empty if nothing was
        found. `print` shows the story.

    Raises:
        BadInput: the log, the mapping or the model cannot be used.
    """
    path = Path(log)
    if out is not None:
        refuse_existing(Path(out))
    read, aircraft, flight = _read(path, model, columns)
    setup = _setup(aircraft)
    found = diagnosed(read, setup)
    if out is not None:
        folder = Path(out)
        refuse_unwritable(folder)
        write(folder / "diagnosis.csv", table(found), folder)
        scene = of_log(found, aircraft, setup.model) if flight is None else of_flight(found, flight)
        write_page(found, residuals(read, setup), scene, folder)
        write(folder / "summary.json", summary(found, aircraft.name), folder)
    return found


def identify(
    aircraft: str | Path,
    logs: Sequence[str | Path],
    columns: str | Path | None = None,
    out: str | Path | None = None,
) -> Identified:
    """An aircraft's design model from logs of healthy flight, with how far each of its coefficients can be believed.

    Args:
        aircraft: name or folder; its own design model is where the identification begins, and whose trim is kept.
        logs: run folders, or files as `diagnose` reads them.
        columns: the mapping file of the logs that are no run folders.
        out: folder to write `design_model.json`, `summary.json` and `report.html` into, which must not exist; with a name that ends
            in .json a file for the model alone.

    Raises:
        BadInput: a log, the mapping or the aircraft cannot be used.
    """
    if out is not None:
        refuse_existing(Path(out))
        refuse_unwritable(Path(out))
    read = [_read(Path(log), aircraft, None if Path(log).is_dir() else columns) for log in logs]
    own = load_aircraft(str(aircraft))
    found = identified([log for log, _, _ in read], _setup(own))
    wrong = [factor.name for factor in found.factors if factor.contradicted]
    remarks = [_half_logged(log.name, flight.scenario) for log, _, flight in read if flight is not None]
    found = replace(found, makers=makers(own, wrong), remarks=tuple(filter(None, remarks)))
    if out is not None and Path(out).suffix == ".json":
        found.model.save(Path(out))
    elif out is not None:
        folder, names = Path(out), [str(log) for log in logs]
        found.model.save(folder / DESIGN_MODEL)
        identified_report.write_page(found, own.name, names, folder)
        write(folder / "summary.json", identified_report.summary(found, own.name, names), folder)
    return found


def _half_logged(name: str, scenario: Scenario) -> str:
    """A sentence about a run whose log has not every command; empty otherwise."""
    if scenario.log_hz == scenario.rate_hz:
        return ""
    rates = f"has {scenario.log_hz:g} of {scenario.rate_hz:g} commands a second"
    return f"{name} {rates}: with noise, factors by equation error are too small; fly with log_hz: {scenario.rate_hz:g}"


def _read(
    path: Path, model: str | Path | None, columns: str | Path | None
) -> tuple[FlightLog, Aircraft, Flight | None]:
    if path.is_dir():
        if columns is not None:
            raise bad("is for a file, and the log is a run folder", "--columns")
        read, flight = read_run(path)
        aircraft = load_aircraft(str(model or flight.scenario.aircraft))
        if tuple(aircraft.actuators) != tuple(flight.actuators):
            raise bad(f"has other actuators than {aircraft.name}", path)
        return read, aircraft, flight
    if not path.exists():
        what, near = "there is no such file or folder", map(str, path.parent.glob("*"))
        raise BadInput([Problem(what, str(path), suggestion=did_you_mean(str(path), near))])
    needed = {"--model": model, "--columns": columns}
    if missing := [name for name, value in needed.items() if value is None]:
        raise BadInput(Problem("is needed with a log that is no run folder", name) for name in missing)
    aircraft = load_aircraft(str(model))
    return mapped.read_table(path, Path(str(columns)), aircraft), aircraft, None


def read_run(folder: Path) -> tuple[FlightLog, Flight]:
    """The log of a run folder, and its flight. Raises BadInput when it is none, or nothing was commanded."""
    flight = load(folder)
    log = flight.signals
    signals = {name: reading(log, name) for name in _READ}
    if np.any(np.isfinite(log["u_dot_m_s2"])):
        signals["u_dot"] = log["u_dot_m_s2"]
    commands = {}
    for name, facts in flight.actuators.items():
        commands[name] = log[f"{name}_command"] * (math.radians(1.0) if facts["kind"] == "servo" else 1.0)
        if not np.any(np.isfinite(commands[name])):
            raise bad("has no numbers: the controller logs no commands", folder, f"{name}_command")
    made = even(str(folder), log["time_s"], signals, commands, np.ones(len(commands), dtype=bool))
    true = shown_log(flight)
    there = [name for name in flight.actuators if response_of(name) in true]
    truth = {name: np.interp(made.time_s, log["time_s"], true[response_of(name)]) for name in there}
    return replace(made, truth=truth, failures_s=tuple(failure_times_s(flight.events))), flight


def _setup(aircraft: Aircraft) -> Setup:
    """What a controller of the aircraft would know; a log begins where it does, so the trim is the reference one."""
    model = stored(aircraft)
    trim = list(zip(model.trim, model.kinds, strict=True))
    commands = [p if kind == "servo" else 0.5 for p, kind in trim]
    positions = [math.degrees(p) if kind == "servo" else p for p, kind in trim]
    settings, no_step = AdaptiveInversionSettings(), math.nan
    return setup_for(aircraft, model, settings, no_step, commands, positions, model.alpha_rad)
