"""The references that a controller follows: commands approached at a limited rate, or a reference of the user's own."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from testbed.common.signals import SETPOINT, first_step_at
from testbed.inputs.problems import BadInput
from testbed.scenario.model import Scenario

_FIELDS = (
    ("altitude", "altitude_m", 1.0),
    ("airspeed", "airspeed_m_s", 1.0),
    ("heading", "heading_deg", math.pi / 180),
)

Reference = Callable[[Scenario, np.ndarray, np.ndarray], np.ndarray]
"""(scenario, time [steps] [s], rows [steps, 6] as `references` has them without it): the rows to fly to, by `signals.SETPOINT`."""
TABLE: dict[str, Reference] = {}
"""References of the user's own by name: the key `reference` of a scenario names one."""


def references(
    scenario: Scenario, path_angle: float = 0.0, rows: np.ndarray | None = None, done: int = 0
) -> np.ndarray:
    """[steps, 6] rate-limited references and their rates, by `signals.SETPOINT` [m, m/s, rad; m/s, m/s2, rad/s].

    From each command on, the reference moves at a constant rate from its present value to the commanded one. Heading turns
    the short way and is not wrapped: it may pass 2 pi.

    Args:
        path_angle: of the steady flight in which the flight begins [rad]. Without propulsion that is a glide, and the reference of
            altitude is the glide at the reference airspeed; its rate, which a controller is given to climb or descend, is zero.
        rows: [steps, 6] where they are written, new ones by default.
        done: the first rows that are there already, and stay: an order in an hour takes .010 s of processor time by that, not .1 s.
    """
    if done and (path_angle or scenario.reference is not None):  # each row depends on all before it
        whole = references(scenario, path_angle)
        assert rows is not None and np.array_equal(whole[:done], rows[:done])
        rows[done:] = whole[done:]
        return rows
    rows = np.zeros((scenario.steps, len(SETPOINT))) if rows is None else rows
    for name, key, factor in _FIELDS:
        _approach(scenario, name, key, factor, rows, done)
    if done:
        return rows
    airspeed = rows[:, SETPOINT.index("airspeed")]
    sunk = np.concatenate([[0.0], np.cumsum(airspeed[:-1])]) * math.sin(path_angle) / scenario.rate_hz
    rows[:, SETPOINT.index("altitude")] += sunk
    return rows if scenario.reference is None else _own(scenario, rows)


def _approach(scenario: Scenario, name: str, key: str, factor: float, rows: np.ndarray, done: int) -> None:
    """Fill the rows from `done` on of one quantity and its rate."""
    limits = scenario.command_rates
    rates = {"altitude": limits.altitude_m_s, "airspeed": limits.airspeed_m_s2}
    rates["heading"] = math.radians(limits.heading_deg_s or 0.0)
    moves = rates[name]
    value, rate = (rows[:, SETPOINT.index(of)] for of in (name, f"{name}_rate"))
    value[done:], rate[done:] = getattr(scenario.initial, key) * factor, 0.0
    for first, end, target in _targets(scenario, key):
        # One row more than until the next command, which starts from there.
        after, start = slice(max(first, done), end + 1), float(value[first])
        change = target * factor - start
        if name == "heading":  # by at most half a turn
            change = math.remainder(change, 2.0 * math.pi)
        value[after], rate[after] = start + change, 0.0
        there = first + abs(change) / moves * scenario.rate_hz + 2 if moves else math.inf
        after = slice(after.start, int(min(after.stop, len(rows), max(there, after.start))))
        elapsed = np.arange(after.start, after.stop) / scenario.rate_hz - first / scenario.rate_hz
        value[after] = start + math.copysign(1.0, change) * np.minimum(moves * elapsed, abs(change))
        rate[after] = np.where(moves * elapsed < abs(change), math.copysign(moves, change), 0.0)


def _own(scenario: Scenario, rows: np.ndarray) -> np.ndarray:
    """The rows of a reference of the user's own; raises BadInput where they are none."""
    name = str(scenario.reference)
    time = np.arange(scenario.steps) / scenario.rate_hz
    own = np.array(TABLE[name](scenario, time, rows.copy()), dtype=float)
    if own.shape != rows.shape or not np.isfinite(own).all():
        what = f"gives {own.shape} values, {np.count_nonzero(~np.isfinite(own))} of them no numbers"
        raise BadInput([scenario.source.problem(("reference",), what, f"{rows.shape} finite numbers")])
    return own


def _targets(scenario: Scenario, key: str) -> Iterator[tuple[int, int, float]]:
    """First control step of each command of one quantity, that of the next, and what is commanded."""
    given = [
        (first, target)
        for command in scenario.commands
        if (target := getattr(command, key)) is not None
        and (first := first_step_at(command.at_s, scenario.rate_hz)) < scenario.steps
    ]
    ends = [*(first for first, _ in given[1:]), scenario.steps]
    for (first, target), end in zip(given, ends, strict=False):
        yield first, end, target
