"""A flight as a Gymnasium environment, and its tasks: which scenario each episode flies, one that stays or a draw of a sweep; which
references an agent is given; and how a state is rewarded."""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.error import ResetNeeded
from gymnasium.spaces import Box

from testbed.aircraft.changes import load_with_changes, name_in
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shipped import find_aircraft
from testbed.common.signals import SETPOINT, STATE
from testbed.env.cockpit import MOST, OBSERVED, Agent
from testbed.flight.flight import Outcome
from testbed.inputs import overrides
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.yaml_source import Source
from testbed.reporting.flight import ReportedFlight
from testbed.scenario.consistency import glides
from testbed.scenario.flown import altered
from testbed.scenario.load import changed, default_at, load_scenario, scenario_from
from testbed.scenario.model import Command, Scenario
from testbed.simulation import Session
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan

OPTIONS = ("scenario", "sweep", "run", "set", "failures")
_NEITHER: dict[str, Any] = {"scenario": {}, "sweep": None}
_KINDS: tuple[tuple[str, Any, str], ...] = (
    ("scenario", str | Path | Mapping, "a scenario's file, or a mapping as in one"),
    ("sweep", str | Path | None, "a sweep's file"),
    ("set", Mapping, "a mapping of dotted paths to values"),
)
_DEFAULTS = {"name": "episode", "duration_s": 30.0}
_SEEDS = 2**31


@dataclass(frozen=True)
class Episodes:
    """Where the scenarios of episodes come from.

    Attributes:
        aircraft: the one that all of them fly.
        scenario: a file, or a mapping as in a file; level flight if there is none.
        set: values by dotted paths, which replace those of the scenario and of the sweep.
        sweep: a sweep's file, of which each episode is a run; None for the same scenario with another seed each time.
    """

    aircraft: str
    scenario: str | Path | Mapping[str, Any] = field(default_factory=dict)
    set: Mapping[str, Any] = field(default_factory=dict)
    sweep: str | Path | None = None

    def __post_init__(self) -> None:
        for key, kinds, expected in _KINDS:
            if not isinstance(value := getattr(self, key), kinds):
                raise refused(key, f"is {value!r:.60}", expected)

    def drawn(
        self, random: np.random.Generator, options: Mapping[str, Any]
    ) -> tuple[Scenario, dict[str, int]]:
        """The scenario of an episode, and what was drawn for it: the scenario's seed, or the number of the sweep's run.

        Args:
            options: those of `reset`, which hold for this episode: `OPTIONS`.

        Raises:
            BadInput: with every problem found.
        """
        for word in options:
            if word not in OPTIONS:
                raise refused(f"options.{word}", "is no option of reset", *guess(word, OPTIONS))
        sources = {key: options[key] for key in _NEITHER if key in options}
        chosen = replace(self, **{**_NEITHER, **sources}) if sources else self
        scenario, drawn = chosen._same_or_run(random, options.get("run"))
        changes = dict(replace(self, set=options["set"]).set) if "set" in options else {}
        if "failures" in options:
            changes["failures"] = options["failures"]
        return chosen._checked(changed(scenario, changes) if changes else scenario), drawn

    def _same_or_run(self, random: np.random.Generator, run: object) -> tuple[Scenario, dict[str, int]]:
        """The scenario with a drawn seed, or the sweep's run of this number; a drawn one for None."""
        if self.sweep is None:
            if run is not None:
                raise refused("options.run", "has no meaning without a sweep", "a sweep")
            seed = int(random.integers(_SEEDS))
            return altered(self._same, seed=seed), {"seed": seed}
        plan = self._plan
        run = int(random.integers(plan.runs)) if run is None else run
        if isinstance(run, bool) or not isinstance(run, int) or not 0 <= run < plan.runs:
            raise refused("options.run", f"is {run!r}", f"a whole number from 0 to {plan.runs - 1}")
        return plan.builder.scenario(plan.task(run * len(plan.variants))), {"run": run}

    @cached_property
    def _same(self) -> Scenario:
        """The scenario that is not drawn."""
        if isinstance(self.scenario, str | Path):
            return load_scenario(self.scenario, self.set)
        tree = {**_DEFAULTS, "aircraft": self.aircraft, **copy.deepcopy(dict(self.scenario))}
        source = Source("scenario", tree)
        overrides.apply(source, self.set, default_at)
        return scenario_from(source)

    @cached_property
    def _plan(self) -> Plan:
        assert self.sweep is not None
        if self.scenario:
            raise refused("sweep", "has a scenario of its own", "a sweep or a scenario")
        return load_sweep(self.sweep, [f"{key}={json.dumps(value)}" for key, value in self.set.items()])

    def _checked(self, scenario: Scenario) -> Scenario:
        """The scenario, if it flies the environment's aircraft: with another one observations and actions would be others."""
        name = name_in(scenario.aircraft)
        if find_aircraft(name) != find_aircraft(self.aircraft):
            raise refused("aircraft", f"is {name}, and the environment's is {self.aircraft}", "the same")
        return scenario


def refused(path: str, what: str, expected: str = "", suggestion: str = "") -> BadInput:
    """What is raised for an argument or an option of an environment."""
    return BadInput([Problem(what, "environment", path=path, expected=expected, suggestion=suggestion)])


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
