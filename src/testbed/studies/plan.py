"""A resolved study: what it varies and compares, and what is drawn for run i. Nothing here flies."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any, ClassVar

import numpy as np

from testbed.aircraft.changes import name_in
from testbed.scenario.load import drop_commands_after_the_end, placed_name
from testbed.studies.drawing.builder import Builder, Task, Variant
from testbed.studies.drawing.distributions import BATCH, batch, hashed
from testbed.studies.model import StopWhen, Study
from testbed.studies.record import key_of


@dataclass(frozen=True, kw_only=True)
class Plan:
    """A resolved study: `runs` runs, each flown once for every variant, with the same drawn values and the same seed.

    This is a sweep's. A study that draws its flights in another way is a subclass with another `draw`, or `task`.
    """

    study: Study
    name: str
    builder: Builder
    runs: int
    sampling: str = "sobol"
    levels: int = 2
    stop_when: StopWhen | None = None
    cases: list[dict[str, Any]] | None = None
    cases_text: str | None = None
    histories: ClassVar[bool] = True
    """Whether the error histories of its flights are kept."""
    at_most: ClassVar[str] = ""
    """What is said before the number of flights, where there may be fewer."""

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The variants that are compared; a single one without a label if nothing is compared."""
        return self.builder.variants

    @property
    def paths(self) -> list[str]:
        """Dotted paths of the varied values, in the order of the file."""
        if self.cases is not None:
            return list(dict.fromkeys(path for case in self.cases for path in case if path != "seed"))
        return list(self.study.vary)

    @property
    def aircraft_names(self) -> list[str]:
        """Name or folder of every aircraft that may be flown, the base scenario's first."""
        found = [self.builder.base.tree["aircraft"]]
        for path in ("aircraft", "aircraft.name"):
            found += self.study.compare.get(path, [])
            found += self.study.vary[path].bounds if path in self.study.vary else []
            found += [case[path] for case in self.cases or () if path in case]
        return list(dict.fromkeys(placed_name(name_in(said), self.builder.base.file) for said in found))

    @property
    def size(self) -> int:
        """Number of flights: runs times variants."""
        return self.runs * len(self.variants)

    def task(self, k: int) -> Task:
        """Flight number k, from 0: run `k // len(variants)`, variant `k % len(variants)`."""
        run, variant = divmod(k, len(self.variants))
        values, seed = dict(self.draw(run)), hashed(self.study.seed, "run", run)
        if self.cases is not None:
            seed = values.pop("seed", seed)
        return Task(run, variant, seed, values)

    def key(self, task: Task) -> bytes:
        """The key by which a flight is stored, in whose order the table has the flights."""
        return key_of(task.run * len(self.variants) + task.variant)

    def draw(self, run: int) -> Mapping[str, Any]:
        """Values drawn for a run, by dotted paths: a pure function of (study, seed, run)."""
        if self.cases is not None:
            return self.cases[run]
        index, offset = divmod(run, BATCH)
        return self._batch(index)[offset]

    @cached_property
    def _batch(self) -> Callable[[int], list[dict[str, Any]]]:
        return lru_cache(4)(self._drawn)

    def _drawn(self, index: int) -> list[dict[str, Any]]:
        vary = self.study.vary
        if self.sampling == "grid":
            first, last = index * BATCH, min((index + 1) * BATCH, self.runs)
            levels = [distribution.grid(self.levels) for distribution in vary.values()]
            chosen = np.unravel_index(np.arange(first, last), [*map(len, levels)])  # the last changes fastest
            points = np.column_stack([each[k] for each, k in zip(levels, chosen, strict=True)])
        else:
            points = batch(self.sampling, self.study.seed, list(vary), self.runs, index)
        columns = [distribution.quantiles(points[:, j]) for j, distribution in enumerate(vary.values())]
        return [dict(zip(vary, row, strict=True)) for row in zip(*columns, strict=True)]

    @cached_property
    def tree(self) -> dict[str, Any]:
        """The contents of the study's file in its folder: resolved, with the scenario inside, so that it flies again as it is."""
        study, base = self.study, replace(self.builder.base, tree=copy.deepcopy(self.builder.base.tree))
        if not any(path.startswith("commands") for path in (*self.paths, *study.compare)):
            drop_commands_after_the_end(base)
        tree = {"name": self.name, **study.settings(), "scenario": base.tree}
        tree |= {"seed": study.seed, "time_limit_s": study.time_limit_s}
        vary = {} if self.cases is not None else {path: _spec(d) for path, d in study.vary.items()}
        more = {"vary": vary, "compare": study.compare, "controllers": study.controllers}
        return copy.deepcopy(tree | {key: value for key, value in more.items() if value})


def _spec(distribution: Any) -> dict[str, Any]:
    spec = {distribution.name: distribution.parameters}
    if distribution.weights is not None:
        spec["weights"] = list(distribution.weights)
    return spec
