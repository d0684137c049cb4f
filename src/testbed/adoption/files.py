"""The adopted aircraft's folder: JSBSim files, YAML, and a scenario to begin with, written so that a person can go on from them."""

from __future__ import annotations

import importlib.metadata
import math
import textwrap
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path

import yaml

from testbed.adoption.blocks import prefix_of
from testbed.adoption.controls import ADOPTED, Propulsor
from testbed.adoption.draft import Draft, Servo
from testbed.adoption.source import write_engines
from testbed.common.writing import write, write_new

Thrusts = Sequence[tuple[float, float]]
_SCALE = 0.4  # of half the travel: one unit of the scaled input matrix, near what the v-tail has
_BETA_MAX_DEG, _ROLL_MAX_DEG, _ALPHA_MAX_DEG = 40, 110, 25
_PAST_STALL_DEG = 10
_SLOWEST, _FASTEST = 0.65, 2.2  # of the stall speed, and of the reference airspeed
_DEFAULT = "   # a default, the model has none"
_BLOCKS = (
    "Between each actuator and what reads it stands a block of properties, through which commands and failures act. The "
    "model's own flight control still runs, but no longer moves these actuators. Edit what you know better."
)


def write_folder(draft: Draft, folder: Path) -> None:
    """Write the JSBSim files of an aircraft of the folder's name: the model in one file, engines and propellers in `Engines`."""
    write_engines(draft.tree, draft.source, folder)
    ET.indent(draft.tree, "  ")
    header = _origin(draft) + " Changes are listed in the YAML beside this file."
    text = ET.tostring(draft.tree, encoding="unicode")
    write_new(folder / f"{folder.name}.xml", f'<?xml version="1.0"?>\n<!-- {header} -->\n{text}\n')


def _origin(draft: Draft) -> str:
    """Where the aircraft comes from, and on what terms."""
    version = importlib.metadata.version("jsbsim")
    return (
        f"Adopted from the JSBSim model {draft.source.name} (jsbsim {version}). Its authors, its licence and its "
        "limits are in its <fileheader>; the jsbsim package itself is under the LGPL 2.1."
    )


def write_yaml(draft: Draft, folder: Path, airspeed_m_s: float, thrusts_n: Thrusts) -> None:
    """Write the aircraft's YAML, with a comment for what is not the model's own.

    Args:
        airspeed_m_s: of the reference.
        thrusts_n: of each engine at its lowest and highest throttle.
    """
    servos = [line for servo in draft.servos for line in _servo(servo)]
    engines = zip(draft.propulsors, thrusts_n, strict=True)
    lines = [
        *_comment(_origin(draft)),
        *_comment(_BLOCKS),
        f"name: {_quoted(folder.name)}",
        f"description: {_quoted(_description(draft))}",
        f"model: {_quoted(folder.name)}",
        *_reference(draft, airspeed_m_s),
        "",
        *_axes(draft),
        "",
        *_envelope(draft, airspeed_m_s),
        "",
        "# How the model is made ready to fly, once, with the airframe held: properties to write, then seconds to run.",
        "start:",
        *_start(draft),
        "",
        "actuators:",
        *servos,
        *(line for each, thrust in engines for line in _engine(each, thrust)),
    ]
    write(folder / f"{folder.name}.yaml", "\n".join(lines) + "\n")


def _reference(draft: Draft, speed: float) -> list[str]:
    size = draft.size
    stall = f"{size.stall_m_s:.4g} m/s at {size.stall_alpha_deg:g} deg"
    note = f"# {speed / size.stall_m_s:.3g} times the stall's {stall}; weight {size.weight_n:.4g} N"
    return [f"reference: {{altitude_m: {size.altitude_m:g}, airspeed_m_s: {speed:g}}}   {note}"]


def _axes(draft: Draft) -> list[str]:
    if draft.propulsors:
        return ["axes: [p_dot, q_dot, r_dot, u_dot]"]
    return ["axes: [p_dot, q_dot, r_dot]   # without an engine no u_dot: airspeed follows from pitch"]


def _envelope(draft: Draft, speed: float) -> list[str]:
    size = draft.size
    limits = {
        "alpha_max_deg": max(_ALPHA_MAX_DEG, size.stall_alpha_deg + _PAST_STALL_DEG),
        "beta_max_deg": _BETA_MAX_DEG,
        "airspeed_min_m_s": _round(_SLOWEST * size.stall_m_s),
        "airspeed_max_m_s": _round(_FASTEST * speed),
        "roll_max_deg": _ROLL_MAX_DEG,
    }
    inside = ", ".join(f"{name}: {value:g}" for name, value in limits.items())
    why = "Outside these limits the aircraft counts as lost. They are set from the stall and the reference, not read."
    return [f"# {why}", f"envelope: {{{inside}}}"]


def _comment(text: str) -> list[str]:
    return [f"# {line}" for line in textwrap.wrap(text, 118)]


def _description(draft: Draft) -> str:
    """The model's own description in one line, and what drives it."""
    own = " ".join((draft.tree.findtext("fileheader/description") or draft.source.name).split())
    kinds = sorted({ADOPTED[each.kind] for each in draft.propulsors})
    if kinds:
        many = f"{len(draft.propulsors)} {kinds[0]}s" if len(draft.propulsors) > 1 else kinds[0]
        return f"{own}; {many}; adopted from JSBSim"
    rocket = draft.tree.find("propulsion/engine")
    return f"{own}; {'glider' if rocket is None else 'its rocket is off'}; adopted from JSBSim"


def _quoted(text: str) -> str:
    return yaml.safe_dump(text, width=10_000, default_style='"').strip()


def _start(draft: Draft) -> list[str]:
    lines = []
    for step in draft.start.steps:
        lines += ["  - set:", *(f'      "{name}": {value:g}' for name, value in step.set.items())]
        lines += [f"    run_s: {step.run_s:g}"] if step.run_s else []
    return lines


def _servo(servo: Servo) -> list[str]:
    surface = servo.surface
    low, high = (math.degrees(end) for end in surface.travel)
    read = " and ".join(each.name for each in surface.readings)
    fraction = (
        "   # the model knows fractions of full deflection: 1 is called 20 deg" if surface.nominal else ""
    )
    limits, rate, lag = (
        _DEFAULT * missing
        for missing in (
            surface.unlimited,
            surface.dynamics.rate_rad_s is None,
            surface.dynamics.lag_rad_s is None,
        )
    )
    return [
        f"  {surface.name}:   # instead of {read}",
        "    kind: servo",
        f"    prefix: {prefix_of(surface.name)}",
        f"    unit: deg{fraction}",
        f"    limits: [{_round(low, 5):g}, {_round(high, 5):g}]{limits}",
        f"    rate_limit: {_round(math.degrees(servo.rate_rad_s)):g}{rate}",
        f"    lag_rad_s: {_round(servo.lag_rad_s):g}{lag}",
        f"    scale: {_round(_SCALE * 0.5 * (high - low)):g}",
    ]


def _engine(propulsor: Propulsor, thrust_n: tuple[float, float]) -> list[str]:
    low, high = sorted(thrust_n)
    dry = (
        "   # to 0.98: above 0.99 JSBSim lights the afterburner, and thrust jumps"
        if propulsor.throttle[1] < 1.0
        else ""
    )
    return [
        f"  {propulsor.name}:",
        "    kind: engine",
        f"    prefix: {prefix_of(propulsor.name)}",
        f"    engine: {propulsor.number}",
        "    unit: N",
        f"    throttle: [{propulsor.throttle[0]:g}, {propulsor.throttle[1]:g}]{dry}",
        f"    limits: [{_round(low):g}, {_round(high):g}]   # thrust at these throttles, measured at the reference",
        f"    scale: {_round(_SCALE * 0.5 * (high - low)):g}",
    ]


def _round(value: float, digits: int = 4) -> float:
    return float(f"{value:.{digits}g}")


FILE = "first_flight.yaml"
_DURATION_S, _TURN_S, _TURN_DEG, _FAILURE_S = 60, 5, 30, 20


def write_first_flight(draft: Draft, folder: Path) -> None:
    """Write the scenario, in which the first surface that rolls the aircraft is lost, else the last of all.

    It begins at the aircraft's reference, as every scenario does that says nothing else.
    """
    rolling = (servo for servo in draft.servos if servo.surface.stick == "roll")
    lost = next(rolling, draft.servos[-1]).surface.name
    lines = [
        f"# A turn by {_TURN_DEG} deg in which a surface is lost. Change it, or begin scenarios of your own with it.",
        f"name: {folder.name} without its {lost.replace('_', ' ')}",
        "aircraft: .   # this folder",
        f"duration_s: {_DURATION_S}",
        "controller: {type: adaptive_inversion}",
        "commands:",
        f"  - {{at_s: {_TURN_S}, heading_deg: {_TURN_DEG}}}",
        "failures:   # `testbed list failures` names the types",
        f"  - {{type: effectiveness, actuator: {lost}, at_s: {_FAILURE_S}, value: 0}}",
        "requirements:",
        "  - {signal: heading_deg, from_s: 30, within: 15, of: heading_command_deg}",
    ]
    write_new(folder / FILE, "\n".join(lines) + "\n")
