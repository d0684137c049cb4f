"""A flight as a Gymnasium environment."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box

from testbed.aircraft.description import load_aircraft
from testbed.env.agent import Agent
from testbed.env.cockpit import MOST, OBSERVED
from testbed.env.episodes import Episodes, refused
from testbed.env.tasks import REWARDS, with_commands
from testbed.flight.flight import Outcome
from testbed.inputs.problems import guess
from testbed.reporting.flight import ReportedFlight
from testbed.simulation import Session


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
        self._task, self._reward, self._action_hz = task, REWARDS[task], action_hz
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
        reward = 0.0 if lost else self._reward(rows.truth[k].tolist(), rows.references[k].tolist())
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
