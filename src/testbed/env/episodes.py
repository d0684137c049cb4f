"""The scenario of each episode: one that stays, or a draw of a sweep."""

from __future__ import annotations

import copy
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.changes import name_in
from testbed.aircraft.shipped import find_aircraft
from testbed.inputs import overrides
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.yaml_source import Source
from testbed.scenario.flown import altered
from testbed.scenario.load import changed, default_at, load_scenario, scenario_from
from testbed.scenario.model import Scenario
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
