"""The flights of a benchmark: draw i flown by every controller, a pure function of (suite, seed, i)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.description import load_aircraft
from testbed.controllers.user.own import OwnController
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.yaml_source import Source
from testbed.scenario.load import placed_name
from testbed.studies.benchmark.grammar import Dice, Drawn, drawn
from testbed.studies.benchmark.load import beside, provide
from testbed.studies.benchmark.model import Draws, Suite
from testbed.studies.drawing.builder import TYPE, Builder, Task, Variant
from testbed.studies.drawing.distributions import hashed
from testbed.studies.plan import Plan

_ATTEMPTS = 1000
"""Attempts at a draw that is a valid scenario."""


class Flights(Builder):
    """Makes the scenarios of a benchmark, wherever it is sent: what has to be adopted for one is adopted there."""

    def scenario(self, task: Task) -> Any:
        """As `Builder.scenario`."""
        said = task.values["aircraft"]
        name = said if isinstance(said, str) else said["name"]
        if name.startswith("./"):
            provide(name.removeprefix("./"))
        return super().scenario(task)

    def source(self, values: Mapping[str, Any], seed: int) -> Source:
        """As `Builder.source`, with the hangar of this machine."""
        source = super().source(values, seed)
        source.file = beside()
        return source


@dataclass(frozen=True, kw_only=True)
class Benchmark(Plan):
    """A suite with a seed, the number of draws, and the controllers that fly them all.

    Attributes:
        said: the tree of the suite's file.
        file: by which the suite was given.
        law: SHA-256 of the code of the shipped controllers; empty where a folder does not say with which it was flown.
        word: from which the seed was made; empty where it was given.
        entry: the file of the entry that is to be written.
    """

    suite: Suite
    said: Mapping[str, Any]
    file: str
    law: str
    word: str = ""
    entry: Path | None = None

    @cached_property
    def digest(self) -> str:
        """SHA-256 of what the suite says, from which its flights are drawn; comments, order and controllers do not count."""
        said = self.suite.model_dump(mode="json", exclude={"controllers", "told", "purpose", "time_limit_s"})
        return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()

    @property
    def labels(self) -> list[str]:
        """The names of the controllers."""
        return [variant.label for variant in self.variants]

    @property
    def aircraft_names(self) -> list[str]:
        """Name or folder of every aircraft of the suite; those that are missing are adopted."""
        return [self._placed(name) for name in self.suite.aircraft]

    def task(self, k: int) -> Task:
        """Flight number k, from 0: draw `k // controllers`, controller `k % controllers`."""
        number, variant = divmod(k, len(self.variants))
        one, seed = self._valid(number)
        name = f"{self.suite.suite} {self.suite.version}, draw {number}"
        return Task(number, variant, seed, {"name": name, **one.values})

    def groups(self, number: int) -> dict[str, str]:
        """What draw `number` is counted as: {factor: group}."""
        return dict(self._valid(number)[0].groups)

    @cached_property
    def _valid(self) -> Callable[[int], tuple[Drawn, int]]:
        return cache(self._first_valid)

    def _first_valid(self, number: int) -> tuple[Drawn, int]:
        """The first of the attempts at a draw that is a valid scenario, and the flight's own seed."""
        entropy = int(self.digest, 16), self.study.seed, number
        seed, problems = hashed(*entropy, "flight"), list[Problem]()
        crafts = self.suite.aircraft
        for attempt in range(_ATTEMPTS):
            dice = Dice(np.random.default_rng(np.random.SeedSequence([*entropy, attempt])))
            name = dice.among(list(crafts), (each.weight for each in crafts.values()))
            one = drawn(self.suite, dice, name, crafts[name], load_aircraft(self._placed(name)))
            try:
                self.builder.scenario(Task(number, 0, seed, {"name": "?", **one.values}))
                return one, seed
            except BadInput as error:
                problems = list(error.problems)
        what = f"{self.suite.suite}: of {_ATTEMPTS} attempts at draw {number} none is a scenario; the last:"
        raise BadInput([Problem(what), *problems])

    def _placed(self, name: str) -> str:
        one = self.suite.aircraft[name]
        if one.adopt is not None:
            provide(one.adopt)
        return placed_name(one.placed(name), self.builder.base.file)

    @cached_property
    def tree(self) -> dict[str, Any]:
        """What is flown, as benchmark.yaml says it: with the suite inside, it can be read again as it is."""
        return {
            "file": self.file,
            **({"word": self.word} if self.word else {}),
            "seed": self.study.seed,
            **({"law_sha256": self.law} if self.law else {}),
            "draws": self.runs,
            "controllers": {variant.label: self._said(variant) for variant in self.variants},
            "suite": dict(self.said),
        }

    def _said(self, variant: Variant) -> Any:
        """The settings of a shipped controller, or `FILE.py:CLASS` of one of the user's."""
        own = self.builder.own.get(variant.label)
        return variant.values["controller"] if own is None else own.reference


def benchmark_of(
    suite: Suite,
    said: Mapping[str, Any],
    compared: Mapping[str, Mapping[str, Any] | OwnController],
    *,
    draws: int,
    seed: int,
    file: str,
    law: str,
    word: str = "",
    entry: Path | None = None,
) -> Benchmark:
    """The benchmark of these controllers, each by its settings or the user's own.

    Args:
        said: the tree of the suite's file.
        file, law, word, entry: as of `Benchmark`.
    """
    own = {name: each for name, each in compared.items() if isinstance(each, OwnController)}
    variants = tuple(
        Variant(name, {TYPE: name} if isinstance(each, OwnController) else {"controller": dict(each)})
        for name, each in compared.items()
    )
    name, first = next(iter(suite.aircraft.items()))
    tree = {"aircraft": first.placed(name), "controller": next(iter(said["controllers"].values()))}
    return Benchmark(
        study=Draws(seed=seed, time_limit_s=suite.time_limit_s),
        name=f"benchmark {suite.suite} {seed}",
        builder=Flights(Source(beside(), tree), variants, {}, own),
        runs=draws,
        suite=suite,
        said=said,
        file=file,
        law=law,
        word=word,
        entry=entry,
    )
