"""A sweep file, read and resolved: how many runs it has, and what is drawn for run i. Nothing here flies."""

from __future__ import annotations

import copy
import itertools
from collections import OrderedDict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.shipped import find_scenario
from testbed.inputs import overrides
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source, TreePath, describe
from testbed.sweeps.drawing import sampling
from testbed.sweeps.drawing.builder import Builder, Task, Variant
from testbed.sweeps.drawing.cases import read_cases
from testbed.sweeps.model import Sweep

DEFAULT_RUNS = 1000
_MAPPINGS = ("set", "vary", "compare")


@dataclass(frozen=True)
class Plan:
    """A resolved sweep: `runs` runs, each flown once for every variant with the same draw and seed."""

    sweep: Sweep
    name: str
    builder: Builder
    runs: int
    cases: list[dict[str, Any]] | None = None
    cases_text: str | None = None
    _batches: OrderedDict[int, list[dict[str, Any]]] = field(default_factory=OrderedDict, compare=False)

    @property
    def variants(self) -> tuple[Variant, ...]:
        """What is compared; one nameless variant when nothing is."""
        return self.builder.variants

    @property
    def paths(self) -> list[str]:
        """Dotted paths of the varied values, in the order of the file."""
        if self.cases is not None:
            return list(dict.fromkeys(path for case in self.cases for path in case if path != "seed"))
        return list(self.sweep.vary)

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
        if sweep.stop_when:
            tree["stop_when"] = sweep.stop_when.model_dump()
        return copy.deepcopy(tree)


def load_sweep(path: str | Path, settings: Iterable[str] = ()) -> Plan:
    """Read and resolve a sweep file; raises BadInput with every problem of its own keys.

    `settings` are KEY=VALUE: a key of the sweep (`runs=10`), else a dotted path of the scenario
    (`duration_s=2`), changed for all runs. The scenarios that it draws are checked by `checks.check`.
    """
    source = yamlfile.read(find_scenario(path))
    _apply(source, settings)
    sweep = validated(Sweep, source, stand_ins={"scenario": "?"})
    _refuse_overwritten(sweep, source)
    base = _base(sweep, source)
    for key, value in sweep.set.items():
        overrides.set_value(base, key.split("."), value, _place(source, ("set", key)))
    paths = [("vary", path) for path in sweep.vary] + [("compare", path) for path in sweep.compare]
    places = {path: _place(source, (kind, path)) for kind, path in paths}
    cases, text = None, None
    if sweep.cases is not None:
        file = Path(source.file).parent / sweep.cases
        cases, text, case_places = read_cases(file, source.problem(("cases",), "there is no such file"))
        places |= case_places
    variants = tuple(_variants(sweep))
    name = sweep.name or Path(path).stem.replace("_", " ")
    runs = _runs(sweep, source, cases)
    return Plan(sweep, name, Builder(base, variants, places), runs, cases, text)


def _apply(source: Source, settings: Iterable[str]) -> None:
    """Set a key of the sweep (`runs`, or `vary.` and a whole dotted path); any other path is set in the scenario."""
    for setting in settings:
        key, equals, text = setting.partition("=")
        first, _, rest = key.strip().partition(".")
        if equals and first not in Sweep.model_fields:
            first, rest = "set", key.strip()
        if not equals or first not in _MAPPINGS or not rest:
            overrides.apply(source, [setting])
            continue
        place = f"--set {setting}"
        value = yamlfile.parse(text)
        if source.tree.get(first) is None:
            source.tree[first] = {}
        overrides.set_value(source, [first, rest], value.tree, place)


def _refuse_overwritten(sweep: Sweep, source: Source) -> None:
    """Raise BadInput for settings without effect, because `vary` or `compare` set the same in every flight."""
    later = {path: kind for kind in ("vary", "compare") for path in getattr(sweep, kind)}
    problems = [
        source.problem(("set", key), f"has no effect: {kind} sets {path} in every flight", f"no {key} in set")
        for key in sweep.set
        for path, kind in later.items()
        if f"{key}.".startswith(f"{path}.")
    ]
    if problems:
        raise BadInput(problems)


def _base(sweep: Sweep, source: Source) -> Source:
    """The base scenario: a file of its own, or written inside the sweep and then with its places there."""
    if isinstance(sweep.scenario, dict):
        places = {path[1:]: place for path, place in source.places.items() if path[:1] == ("scenario",)}
        return Source(source.file, copy.deepcopy(sweep.scenario), places)
    beside = Path(source.file).parent / sweep.scenario
    try:
        return yamlfile.read(beside if beside.exists() else find_scenario(sweep.scenario))
    except BadInput as error:
        missing = [p for p in error.problems if p.line is None and p.what == "there is no such file"]
        if not missing:
            raise
        raise BadInput([source.problem(("scenario",), f"there is no file {sweep.scenario!r}", "",
                                       missing[0].suggestion)]) from None  # fmt: skip


def _place(source: Source, path: TreePath) -> str:
    file, line = source.place(path)
    return file if line is None else f"{file}:{line}"


def _variants(sweep: Sweep) -> Iterator[Variant]:
    for values in itertools.product(*sweep.compare.values()):
        label = ", ".join(
            v if isinstance(v, str) else f"{path} {v}" for path, v in zip(sweep.compare, values, strict=True)
        )
        yield Variant(label, dict(zip(sweep.compare, values, strict=True)))


def _runs(sweep: Sweep, source: Source, cases: list[dict[str, Any]] | None) -> int:
    total: int | None = None if cases is None else len(cases)
    if cases is None and sweep.sampling == "grid":
        total = sampling.grid_size([d.grid(sweep.levels) for d in sweep.vary.values()])
    if total is not None and sweep.runs is not None and sweep.runs > total:
        what = f"is {describe(sweep.runs)}, there are {total}"
        raise BadInput([source.problem(("runs",), what, f"at most {total}, or no runs for all")])
    return sweep.runs or total or DEFAULT_RUNS


def _spec(distribution: Any) -> dict[str, Any]:
    spec = {distribution.name: distribution.parameters}
    if distribution.weights is not None:
        spec["weights"] = list(distribution.weights)
    return spec
