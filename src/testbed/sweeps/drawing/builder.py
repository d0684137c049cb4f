"""From drawn values to the scenario of one flight. A Builder is small: it is sent to every worker."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.inputs.overrides import set_value
from testbed.inputs.yaml_source import Source
from testbed.scenario.load import Scenario, scenario_from

_TYPE = "controller.type"


@dataclass(frozen=True)
class Variant:
    """One of the things compared, such as a controller: its name, and its values by dotted paths."""

    label: str
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Task:
    """One flight of a sweep: its run, its variant (an index), and the seed and values drawn for the run."""

    run: int
    variant: int
    seed: int
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Builder:
    """The base scenario's tree, the variants, and the place in the sweep file of each varied path."""

    base: Source
    variants: tuple[Variant, ...]
    places: Mapping[str, str] = field(default_factory=dict)

    def scenario(self, task: Task) -> Scenario:
        """The scenario of one flight; raises BadInput with everything wrong in it."""
        return scenario_from(self.source({**task.values, **self.variants[task.variant].values}, task.seed))

    def source(self, values: Mapping[str, Any], seed: int) -> Source:
        """The base scenario with these values set."""
        base = self.base
        source = Source(base.file, copy.deepcopy(base.tree), dict(base.places), list(base.problems))
        for path, value in values.items():
            if not self._of_another_controller(path, values):
                set_value(source, path.split("."), copy.deepcopy(value), self.places.get(path, "sweep"))
        source.tree["seed"] = seed
        return source

    def with_aircraft(self, folder: str) -> Builder:
        """The same, but with the aircraft of this folder, where a worker has unpacked it."""
        return replace(self, base=replace(self.base, tree={**self.base.tree, "aircraft": folder}))

    def _of_another_controller(self, path: str, values: Mapping[str, Any]) -> bool:
        """Whether a path is a setting that this variant's controller does not have, but another variant's has."""
        first, _, rest = path.partition(".")
        chosen = CONTROLLERS.get(str(values.get(_TYPE)))
        if first != "controller" or chosen is None or path == _TYPE:
            return False
        name = rest.partition(".")[0]
        return name in self._settings and name not in chosen.model_fields

    @cached_property
    def _settings(self) -> set[str]:
        """Names of settings that any of the compared controllers has."""
        types = [CONTROLLERS.get(str(variant.values.get(_TYPE))) for variant in self.variants]
        return {name for settings in types if settings for name in settings.model_fields}
