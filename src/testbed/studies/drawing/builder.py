"""Make the scenario of one flight from drawn values. A Builder is sent to every worker, so it is kept small."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from testbed.controllers.config import settings_of
from testbed.controllers.user.own import OwnController
from testbed.inputs.overrides import set_value
from testbed.inputs.yaml_source import Source
from testbed.scenario.load import Scenario, default_at, scenario_from
from testbed.studies.record import Task as Task

TYPE = "controller.type"
_PARAMETERS = "parameters"


@dataclass(frozen=True)
class Variant:
    """One of the alternatives that are compared, such as a controller: its label, and its values by dotted paths."""

    label: str
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Builder:
    """The base scenario, the variants, the place (`file:line`) of each varied or compared path, and the user's controllers.

    A controller of the user's own flies in place of that of the base scenario, whose settings are then those of its set-up.
    """

    base: Source
    variants: tuple[Variant, ...]
    places: Mapping[str, str] = field(default_factory=dict)
    own: Mapping[str, OwnController] = field(default_factory=dict)

    def own_controller(self, task: Task) -> OwnController | None:
        """The user's controller that flies a task; None if a shipped one does."""
        return self.own.get(str(self.variants[task.variant].values.get(TYPE)))

    def scenario(self, task: Task) -> Scenario:
        """The scenario of one flight; raises BadInput with every problem found."""
        return scenario_from(self.source({**task.values, **self.variants[task.variant].values}, task.seed))

    def source(self, values: Mapping[str, Any], seed: int) -> Source:
        """The base scenario with these values set."""
        base = self.base
        source = Source(base.file, copy.deepcopy(base.tree), dict(base.places), list(base.problems))
        for path, value in values.items():
            if not self._of_another_controller(path, values):
                place = self.places.get(path, "sweep")
                set_value(source, path.split("."), copy.deepcopy(value), place, default_at)
        source.tree["seed"] = seed
        return source

    def with_aircraft(self, folder: str) -> Builder:
        """The same builder with the aircraft of this folder, into which a worker has unpacked it."""
        said = self.base.tree.get("aircraft")
        there = {**said, "name": folder} if isinstance(said, dict) else folder
        return replace(self, base=replace(self.base, tree={**self.base.tree, "aircraft": there}))

    def _of_another_controller(self, path: str, values: Mapping[str, Any]) -> bool:
        """Whether a path is a setting that another variant's controller has, but this variant's has not."""
        first, _, rest = path.partition(".")
        kind = str(values.get(TYPE))
        if first != "controller":
            return False
        if path == TYPE:
            return kind in self.own  # what it replaces stays
        name = rest.partition(".")[0]
        if name == _PARAMETERS:
            return bool(self.own) and kind not in self.own
        chosen = settings_of(self.base.tree["controller"]["type"] if kind in self.own else kind)
        return chosen is not None and name in self._settings and name not in chosen.model_fields

    @cached_property
    def _settings(self) -> set[str]:
        """Names of settings that any of the compared controllers has."""
        types = [settings_of(variant.values.get(TYPE)) for variant in self.variants]
        return {name for settings in types if settings for name in settings.model_fields}
