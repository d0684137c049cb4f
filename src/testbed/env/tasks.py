"""What an agent is to do: which references it is given, and how a state is rewarded."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from testbed.aircraft.changes import load_with_changes
from testbed.common.signals import SETPOINT, STATE
from testbed.scenario.checks import glides
from testbed.scenario.flown import altered
from testbed.scenario.model import Command, Scenario

ALTITUDE_M, AIRSPEED, HEADING_RAD = 5.0, 0.1, math.radians(10.0)
"""Errors that halve the reward, each alone; that of the airspeed as a part of its reference."""
_EVERY_S, _CLIMB_M, _TURN_DEG = 8.0, 10.0, 60.0
"""Drawn commands: how often, and at most how far from the last one."""
_ALTITUDE, _AIRSPEED, _HEADING = map(STATE.index, SETPOINT[:3])


def tracking(state: Sequence[float], reference: Sequence[float]) -> float:
    """Reward from 0 to 1: 1 / (1 + e^2), with the errors of altitude, airspeed and heading in units of those that halve it."""
    turn = math.remainder(reference[2] - state[_HEADING], 2.0 * math.pi) / HEADING_RAD
    climb = (reference[0] - state[_ALTITUDE]) / ALTITUDE_M
    faster = (1.0 - state[_AIRSPEED] / reference[1]) / AIRSPEED
    return 1.0 / (1.0 + turn * turn + climb * climb + faster * faster)


def flying(state: Sequence[float], reference: Sequence[float]) -> float:
    """Reward 1, whatever the state: there is more of it, the longer the aircraft flies."""
    return 1.0


REWARDS: dict[str, Callable[[Sequence[float], Sequence[float]], float]] = {
    "hold": tracking,
    "follow": tracking,
    "survive": flying,
}
"""The tasks, and what each rewards in every step until the aircraft is lost, which is rewarded with 0."""


def with_commands(scenario: Scenario, random: np.random.Generator) -> Scenario:
    """The scenario with drawn commands of altitude and heading, for an agent that follows; its own commands if it has some."""
    if len(scenario.commands) > 1:
        return scenario
    aircraft, first = load_with_changes(scenario.aircraft), scenario.commands[0]
    commands, altitude_m, heading_deg = [first], first.altitude_m or 0.0, first.heading_deg or 0.0
    for at_s in np.arange(_EVERY_S / 2, scenario.duration_s, _EVERY_S):
        altitude_m += random.uniform(-_CLIMB_M, _CLIMB_M)
        heading_deg = (heading_deg + random.uniform(-_TURN_DEG, _TURN_DEG)) % 360.0
        climb = {} if glides(aircraft) else {"altitude_m": altitude_m}
        commands.append(Command(at_s=float(at_s), heading_deg=heading_deg, **climb))
    return altered(scenario, commands=tuple(commands))
