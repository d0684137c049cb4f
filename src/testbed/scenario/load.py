"""Load scenario files, fill in defaults, check them, and write a scenario so that it can be flown again."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from testbed.aircraft.changes import ChangedAircraft, load_with_changes
from testbed.aircraft.description import Aircraft
from testbed.aircraft.shipped import find_scenario, is_folder_name
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.controllers.config import settings_of
from testbed.inputs import overrides
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.kinds import refuse_other
from testbed.inputs.problems import BadInput, Problem, TreePath
from testbed.inputs.validation import validated
from testbed.inputs.yaml_source import Source
from testbed.scenario import consistency
from testbed.scenario.model import Scenario as Scenario


def load_scenario(
    path: str | Path, settings: Iterable[str] | Mapping[str, Any] = (), *, with_aircraft: bool = True
) -> Scenario:
    """Load, complete and check a scenario file.

    Args:
        settings: changes as with `--set`, each KEY=VALUE; or values by KEY.
        with_aircraft: whether to check the scenario against its aircraft. To read results, the aircraft is not needed.

    Raises:
        BadInput: with every problem found.
    """
    source = yamlfile.read(find_scenario(path))
    refuse_other(source, "scenario")
    overrides.apply(source, settings, default_at)
    return scenario_from(source, with_aircraft=with_aircraft)


def changed(scenario: Scenario, settings: Mapping[str, Any]) -> Scenario:
    """The scenario with other values at these dotted paths; raises BadInput with every problem found."""
    source = yamlfile.parsed(dump(scenario), scenario.name)
    overrides.apply(source, settings, default_at)
    return scenario_from(source)


def scenario_from(source: Source, *, with_aircraft: bool = True) -> Scenario:
    """As `load_scenario`, from a tree to which overrides have been applied already. The tree is changed."""
    _drop_settings_of_other_controllers(source)
    drop_commands_after_the_end(source)
    aircraft, problems = _aircraft(source) if with_aircraft else (None, [])
    source.problems += problems
    tree = source.tree
    start = aircraft.reference.model_dump() if aircraft else {"altitude_m": 0.0, "airspeed_m_s": 1.0}
    if aircraft is not None and (tree.get("initial") is None or isinstance(tree["initial"], dict)):
        tree["initial"] = {**start, **(tree.get("initial") or {})}
    elif problems:  # of the aircraft: a missing initial condition is no problem of its own then
        tree.setdefault("initial", start)
    stand_ins = {"name": "?", "aircraft": "?", "duration_s": 1e9, "rate_hz": 1, "initial": start}
    scenario = validated(Scenario, source, lambda s: consistency.check(s, aircraft), stand_ins)
    scenario._source = source
    return scenario


def default_at(path: TreePath) -> dict[str, Any] | list[Any]:
    """The default where a file has no value, as far as the rest of a dotted path that leads on into it needs it.

    A list with its default entries, of which one is then replaced; settings of one of several types with their default type;
    else an empty mapping, which validation completes.
    """
    kind: type = Scenario
    default: Any = None
    for part in path:
        fields = kind.model_fields if issubclass(kind, BaseModel) else {}
        default = fields[part].get_default(call_default_factory=True) if part in fields else None
        kind = type(default)
    if isinstance(default, tuple):
        return list(default)
    if isinstance(default, BaseModel) and "type" in type(default).model_fields:
        return {"type": default.type}  # type: ignore[attr-defined] # which each of its types has
    return {}


def dump(scenario: Scenario) -> str:
    """The scenario as YAML with every default written out, so that it can be flown again as it is."""
    return yamlfile.dump(scenario.model_dump(mode="json", exclude_none=True))


def _aircraft(source: Source) -> tuple[Aircraft | None, list[Problem]]:
    """The aircraft that a tree names, or the problems with it. The path of an aircraft folder is made absolute in the tree."""
    said = source.tree.get("aircraft")
    holder: dict[str, Any] = said if isinstance(said, dict) else source.tree
    key = "name" if isinstance(said, dict) else "aircraft"
    name = holder.get(key)
    if not isinstance(name, str) or not name:
        return None, []
    holder[key] = placed_name(name, source.file)
    try:
        choice = ChangedAircraft.model_validate(said) if isinstance(said, dict) else holder[key]
    except ValidationError:  # of changes, which are found elsewhere
        choice = holder[key]
    try:
        return load_with_changes(choice), []
    except BadInput as error:
        return None, [_placed(source, problem) for problem in error.problems]


def placed_name(name: str, file: str | Path) -> str:
    """An aircraft's name as a file says it: of a folder the absolute path, beside that file or else in the present folder."""
    if not is_folder_name(name):
        return name
    beside = Path(file).parent / name
    return os.path.realpath(name if os.path.isdir(name) and not os.path.isdir(beside) else beside)


def _placed(source: Source, problem: Problem) -> Problem:
    """A problem with the aircraft, with its place in the scenario if it is not in a file of the aircraft."""
    if problem.file:
        return problem
    path = ("aircraft", *filter(None, problem.path.split(".")))
    return source.problem(path, problem.what, problem.expected, problem.suggestion)


def _drop_settings_of_other_controllers(source: Source) -> None:
    """After `--set controller.type=...`, drop those of the file's settings that only other types of controller have."""
    controller = source.tree.get("controller")
    if not isinstance(controller, dict) or not overrides.is_override(source, ("controller", "type")):
        return
    chosen = settings_of(controller.get("type"))
    if chosen is None:
        return
    others = {name for settings in CONTROLLERS.values() for name in settings.model_fields}
    for name in [n for n in controller if n in others - set(chosen.model_fields)]:
        if not overrides.is_override(source, ("controller", name)):
            del controller[name]


def drop_commands_after_the_end(source: Source) -> None:
    """After `--set duration_s=...`, drop the file's commands that come later. Failures and requirements that do are refused:
    without them it would be another test."""
    end, commands = source.tree.get("duration_s"), source.tree.get("commands")
    if not overrides.is_override(source, ("duration_s",)) or not isinstance(commands, list):
        return
    while commands and not overrides.is_override(source, ("commands",)):
        last = commands[-1].get("at_s") if isinstance(commands[-1], dict) else None
        changed_too = overrides.is_override(source, ("commands", len(commands) - 1, "at_s"))
        if changed_too or not all(isinstance(time, int | float) for time in (last, end)) or last < end:
            return
        commands.pop()
