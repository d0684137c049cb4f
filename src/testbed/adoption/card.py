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
from testbed.controllers.inversion.modes import enumerate_modes
from testbed.controllers.released_axes import released_from_start
from testbed.controllers.setup import own_axes, stops
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


def _scale(aircraft: Aircraft) -> np.ndarray:
    """[n] rad or N of one scaled unit of each actuator."""
    units = (math.radians(1.0) if a.kind == "servo" else 1.0 for a in aircraft.actuators.values())
    return np.array([a.scale * unit for a, unit in zip(aircraft.actuators.values(), units, strict=True)])


def _inputs(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """B_m in units of the actuators' scales, and the condition number of its controlled rows."""
    matrix = np.array(model.input_matrix)[:4] * _scale(aircraft)
    rows = [RATES.index(axis) for axis in aircraft.axes]
    lines = ["rates by one `scale` of each actuator [rad/s2; u_dot m/s2]"]
    lines.append("  " + " " * 6 + "".join(f"{name[:12]:>14}" for name in aircraft.actuators))
    for row in rows:
        lines.append(f"  {RATES[row]:<6}" + "".join(f"{value:14.4f}" for value in matrix[row]))
    return [*lines, f"  condition number {np.linalg.cond(matrix[rows]):.3g}"]


def _axes(aircraft: Aircraft, model: DesignModel) -> list[str]:
    """Which axes are given up from the start, for want of authority in gusts, and after each loss."""
    absent = [axis for axis in RATES if axis not in aircraft.axes]
    control = own_axes(aircraft)
    now = released_from_start(model, stops(aircraft), control.priorities)
    lines = ["axes that are given up, because the actuators cannot control them"]
    lines += [f"  always: {', '.join(absent)}, for want of an actuator"] if absent else []
    lines += [f"  from the start: {', '.join(now) or 'none'}"]
    modes = enumerate_modes(model, _scale(aircraft), control, (*absent, *now))
    for i, name in enumerate(aircraft.actuators):
        more = (
            [axis for axis in modes[(i,)].released if axis not in absent]
            if len(aircraft.actuators) > 1
            else []
        )
        lines += [f"  without {name}: {', '.join(more)}"] if more else []
    return lines


def _losses(kept: Sequence[Kept]) -> list[str]:
    return ["steady flight of the truth without one actuator", *(f"  without {each}" for each in kept)]
