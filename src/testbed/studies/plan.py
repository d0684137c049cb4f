"""A resolved sweep: how many runs it has, and what is drawn for run i. Nothing here flies."""

from __future__ import annotations

import copy
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from testbed.aircraft.changes import name_in
from testbed.scenario.load import placed_name
from testbed.studies.drawing import sampling
from testbed.studies.drawing.builder import Builder, Task, Variant
from testbed.studies.model import Sweep


@dataclass(frozen=True)
class Plan:
    """A resolved sweep: `runs` runs, each flown once for every variant, with the same drawn values and the same seed."""

    sweep: Sweep
    name: str
    builder: Builder
    runs: int
    cases: list[dict[str, Any]] | None = None
    cases_text: str | None = None
    _batches: OrderedDict[int, list[dict[str, Any]]] = field(default_factory=OrderedDict, compare=False)

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The variants that are compared; a single one without a label if nothing is compared."""
        return self.builder.variants

    @property
    def paths(self) -> list[str]:
        """Dotted paths of the varied values, in the order of the file."""
        if self.cases is not None:
            return list(dict.fromkeys(path for case in self.cases for path in case if path != "seed"))
        return list(self.sweep.vary)

    @property
    def aircraft_names(self) -> list[str]:
        """Name or folder of every aircraft that may be flown, the base scenario's first."""
        found = [self.builder.base.tree["aircraft"]]
        for path in ("aircraft", "aircraft.name"):
            found += self.sweep.compare.get(path, [])
            found += self.sweep.vary[path].bounds if path in self.sweep.vary else []
            found += [case[path] for case in self.cases or () if path in case]
        return list(dict.fromkeys(placed_name(name_in(said), self.builder.base.file) for said in found))

    @property
    def extendable(self) -> bool:
        """Whether runs can be added without changing the first ones."""
        return self.sweep.sampling != "latin_hypercube" or self.cases is not None

    @property
    def size(self) -> int:
        """Number of flights: runs times variants."""
        return self.runs * len(self.variants)

    def task(self, k: int) -> Task:
        """Flight number k, from 0: run `k // len(variants)`, variant `k % len(variants)`."""
        run, variant = divmod(k, len(self.variants))
        values = dict(self.draw(run))
        seed = values.pop("seed", None) if self.cases is not None else None
        return Task(
            run, variant, sampling.hashed(self.sweep.seed, "run", run) if seed is None else seed, values
        )

    def number(self, task: Task) -> int:
        """The number of a flight."""
        return task.run * len(self.variants) + task.variant

    def draw(self, run: int) -> Mapping[str, Any]:
        """Values drawn for a run, by dotted paths: a pure function of (sweep, seed, run)."""
        if self.cases is not None:
            return self.cases[run]
        index, offset = divmod(run, sampling.BATCH)
        if index not in self._batches:
            self._batches[index] = self._drawn(index)
            while len(self._batches) > 4:
                self._batches.popitem(last=False)
        return self._batches[index][offset]

    def _drawn(self, index: int) -> list[dict[str, Any]]:
        sweep, paths = self.sweep, list(self.sweep.vary)
        if sweep.sampling == "grid":
            first, last = index * sampling.BATCH, min((index + 1) * sampling.BATCH, self.runs)
            points = np.array([sampling.grid_point(self._levels, i) for i in range(first, last)])
        else:
            points = sampling.batch(sweep.sampling, sweep.seed, paths, self.runs, index)
        columns = [sweep.vary[path].quantiles(points[:, j]) for j, path in enumerate(paths)]
        return [dict(zip(paths, row, strict=True)) for row in zip(*columns, strict=True)]

    @cached_property
    def _levels(self) -> list[np.ndarray]:
        return [distribution.grid(self.sweep.levels) for distribution in self.sweep.vary.values()]

    @cached_property
    def tree(self) -> dict[str, Any]:
        """The contents of sweep.yaml: the resolved sweep with the scenario inside, which flies again as it is."""
        sweep = self.sweep
        tree: dict[str, Any] = {"name": self.name, "scenario": self.builder.base.tree, "runs": self.runs}
        tree |= {"seed": sweep.seed, "time_limit_s": sweep.time_limit_s}
        if self.cases is None:
            tree["sampling"] = sweep.sampling
            if sweep.sampling == "grid":
                tree["levels"] = sweep.levels
            tree["vary"] = {path: _spec(d) for path, d in sweep.vary.items()}
        else:
            tree["cases"] = "cases.csv"
        if sweep.compare:
            tree["compare"] = sweep.compare
        if sweep.controllers:
            tree["controllers"] = sweep.controllers
        if sweep.stop_when:
            tree["stop_when"] = sweep.stop_when.model_dump()
        return copy.deepcopy(tree)


def _spec(distribution: Any) -> dict[str, Any]:
    spec = {distribution.name: distribution.parameters}
    if distribution.weights is not None:
        spec["weights"] = list(distribution.weights)
    return spec
