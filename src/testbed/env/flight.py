"""A flight as a Gymnasium environment, and its tasks: which references an agent is given, and how a state is rewarded."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.description import load_aircraft
from testbed.common.signals import SETPOINT, STATE
from testbed.env.agent import Agent
from testbed.env.cockpit import MOST, OBSERVED
from testbed.env.episodes import Episodes, refused
from testbed.flight.flight import Outcome
from testbed.inputs.problems import guess
from testbed.reporting.flight import ReportedFlight
from testbed.scenario.checks import glides
from testbed.scenario.flown import altered
from testbed.scenario.model import Command, Scenario
from testbed.simulation import Session

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


REWARDS: dict[str, Callable[[Sequence[float], Sequence[float]], float]] = {
    "hold": tracking,
    "follow": tracking,
    "survive": lambda state, reference: 1.0,  # there is more of it, the longer the aircraft flies
}
"""The tasks, and what each rewards in every step until the aircraft is lost, which is rewarded with 0."""


class FlightEnv(gymnasium.Env[np.ndarray, np.ndarray]):
    """An agent flies an aircraft that breaks.

        env = gymnasium.make("testbed/vtail-v0", task="follow", sweep="scenarios/sweeps/left_tail_monte_carlo.yaml")
        observation, info = env.reset(seed=1)
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
        env.unwrapped.save("results/episode")

    Observations and actions are those of `Cockpit`: `names` are the names of an observation's numbers, the last n of which are the
    actuators' of an action. An episode ends with the scenario's duration (truncated) or the loss of the aircraft (terminated);
    then `info["outcome"]` is how. What an agent sees is one control step old when its action begins.

    Args:
        aircraft: name of a shipped aircraft, or an aircraft's folder; given by the id except in `testbed/flight-v0`.
        task: `hold` and `follow` reward small errors of altitude, airspeed and heading, `survive` only flying on. To follow,
            commands are drawn where the scenario has none.
        action_hz: actions per second; the scenario's `rate_hz` is a whole multiple.
        scenario, set, sweep: what is flown, and with which failures; see `Episodes`. `reset(options=...)` takes the same for one
            episode, and `failures`, a list as in a scenario, and `run`, the number of a sweep's run.

    Raises:
        BadInput: an argument or an option cannot be used, with every problem found.
    """

    metadata = {"render_modes": []}  # noqa: RUF012 # as Gymnasium declares it

    def __init__(
        self,
        aircraft: str,
        *,
        task: str = "hold",
        action_hz: int = 20,
        scenario: str | Path | Mapping[str, Any] | None = None,
        set: Mapping[str, Any] | None = None,
        sweep: str | Path | None = None,
    ) -> None:
        if task not in REWARDS:
            raise refused("task", f"is {task!r}", *guess(task, REWARDS))
        actuators = load_aircraft(aircraft).actuators
        self.names = (*(name for name, _ in OBSERVED), *actuators)
        self.observation_space = Box(-MOST, MOST, (len(self.names),), np.float32)
        self.action_space = Box(-1.0, 1.0, (len(actuators),), np.float32)
        self._task, self._action_hz = task, action_hz
        self._episodes = Episodes(aircraft, scenario or {}, set or {}, sweep)
        self._session: Session | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin an episode; what was drawn for it is in the info."""
        super().reset(seed=seed)
        scenario, drawn = self._episodes.drawn(self.np_random, options or {})
        if self._task == "follow":
            scenario = with_commands(scenario, self.np_random)
        self._every, rest = divmod(scenario.rate_hz, self._action_hz)
        if rest or not self._every:
            expected = f"{scenario.rate_hz}, the scenario's rate_hz, divided by a whole number"
            raise refused("action_hz", f"is {self._action_hz}", expected)
        self.close()
        self._agent = Agent()
        self._session = Session(scenario, self._agent)
        self._session.loop.advance(1)
        return self._observed(), dict(drawn)

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Fly with an action until the next one; raises BadInput for one that is not finite or has another shape."""
        if self._session is None or self._session.ended is not None:
            raise ResetNeeded("the flight is over, or none was begun: call reset")
        self._agent.act(action)
        loop = self._session.loop  # its steps prepare nothing for what could be done to the flight
        loop.advance(loop.done + self._every)
        ended, k, rows = loop.outcome, loop.done - 1, loop.rows
        truncated = ended is Outcome.completed
        lost = ended is not None and not truncated
        rewarded = REWARDS[self._task]
        reward = 0.0 if lost else rewarded(rows.truth[k].tolist(), rows.references[k].tolist())
        return self._observed(), reward, lost, truncated, {"outcome": ended.value} if ended else {}

    def _observed(self) -> np.ndarray:
        assert self._session is not None
        k, rows = self._session.loop.done - 1, self._session.loop.rows
        return self._agent.cockpit.observe(rows.measured[k].tolist(), rows.references[k].tolist())

    def flight(self) -> ReportedFlight:
        """The present episode so far as a flight; raises BadInput when none was begun."""
        if self._session is None:
            raise refused("flight", "no episode was begun", "reset before")
        return self._session.flight()

    def save(self, folder: str | Path, *, figures: bool = True) -> Path:
        """Write the present episode so far as a run folder, with its story and report, as `ReportedFlight.save` does."""
        return self.flight().save(folder, figures=figures)

    def close(self) -> None:
        """Free the simulator; an episode that is to be kept is saved before."""
        if self._session is not None:
            self._session.close()
            self._session = None


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
