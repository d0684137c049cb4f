"""The card of an adopted aircraft: its trim, modes, input matrix, axes, and what each loss leaves."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from testbed.adoption.losses import Kept
from testbed.adoption.modes import modes_of
from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.common.signals import RATES
from testbed.controllers.released_axes import axes_to_release, released_from_start
from testbed.controllers.setup import stops
from testbed.plant.trim import Trim


def card(aircraft: Aircraft, model: DesignModel, trim: Trim, kept: Sequence[Kept]) -> str:
    """The whole card, in lines."""
    sections = [
        _head(aircraft, trim),
        _modes(model, trim),
        _inputs(aircraft, model),
        _axes(aircraft, model),
        _losses(kept),
    ]
    return "\n\n".join("\n".join(lines) for lines in sections)


def release(aircraft: Aircraft, model: DesignModel) -> dict[str, tuple[str, ...]]:
    """Axes to give up after the loss of each actuator alone, where there are any: those that the others cannot keep in gusts."""
    n, priorities = len(aircraft.actuators), aircraft.control.priorities
    present = tuple(axis for axis in priorities if axis in aircraft.axes)
    found = {}
    for i, name in enumerate(aircraft.actuators):
        left = [j for j in range(n) if j != i]
        axes = axes_to_release(model, stops(aircraft), left, present)
        found[name] = tuple(axis for axis in axes if axis in present)
    return {name: axes for name, axes in found.items() if axes}


def _head(aircraft: Aircraft, trim: Trim) -> list[str]:
    state, at = trim.state, aircraft.reference
    path = math.degrees(state["path_angle"])
    flight = "level" if abs(path) < 0.05 else f"path {path:.1f} deg"
    lines = [f"{aircraft.name}: {aircraft.description}"]
    lines += [
        f"trim at {at.airspeed_m_s:.4g} m/s, {at.altitude_m:g} m: {flight}, alpha {math.degrees(state['alpha']):.1f} deg"
    ]
    for (name, actuator), position, command in zip(
        aircraft.actuators.items(), trim.positions, trim.commands, strict=True
    ):
        share = "" if actuator.kind == "servo" else f" at throttle {command:.2f}"
        lines.append(
            f"  {name:<16} {position:9.4g} {actuator.unit:3} of {actuator.limits[0]:g} to {actuator.limits[1]:g}{share}"
        )
    return lines


def _modes(model: DesignModel, trim: Trim) -> list[str]:
    return [
        "modes, with surfaces and thrust held",
        *(f"  {mode}" for mode in modes_of(model, trim.state["path_angle"])),
    ]


def _inputs(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """B_m in units of the actuators' scales, and the condition number of its controlled rows."""
    scale = np.array(
        [a.scale * (math.radians(1.0) if a.kind == "servo" else 1.0) for a in aircraft.actuators.values()]
    )
    matrix = np.array(model.input_matrix)[:4] * scale
    rows = [RATES.index(axis) for axis in aircraft.axes]
    lines = ["rates by one `scale` of each actuator [rad/s2; u_dot m/s2]"]
    lines.append("  " + " " * 6 + "".join(f"{name[:12]:>14}" for name in aircraft.actuators))
    for row in rows:
        lines.append(f"  {RATES[row]:<6}" + "".join(f"{value:14.4f}" for value in matrix[row]))
    return [*lines, f"  condition number {np.linalg.cond(matrix[rows]):.3g}"]


def _axes(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """Which axes are given up from the start and after each loss."""
    absent = [axis for axis in RATES if axis not in aircraft.axes]
    present = tuple(axis for axis in aircraft.control.priorities if axis in aircraft.axes)
    now = released_from_start(model, stops(aircraft), present)
    lines = ["axes that the actuators cannot keep in gusts, and that are given up"]
    lines += [f"  always: {', '.join(absent)}, for want of an actuator"] if absent else []
    lines += [f"  from the start: {', '.join(now) or 'none'}"]
    for name, axes in release(aircraft, model).items():
        lines.append(f"  without {name}: {', '.join(axes)}")
    return lines


def _losses(kept: Sequence[Kept]) -> list[str]:
    return ["steady flight of the truth without one actuator", *(f"  without {each}" for each in kept)]
