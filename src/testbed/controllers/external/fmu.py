"""A functional mock-up unit (FMU) as a controller: co-simulation by FMI 2.0 or 3.0, https://fmi-standard.org.

An input takes the signal, and an output commands the actuator, that has its name or that a mapping file names for it. It
flies in a process of its own (`fmu_process`), because it runs native code, which may fail or never return.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from pydantic import Field

from testbed.common.child import command, environment
from testbed.common.signals import SENSED, SETPOINT
from testbed.controllers.external.process import Process
from testbed.inputs import yaml_source
from testbed.inputs.base import Settings
from testbed.inputs.problems import BadInput, Problem, did_you_mean, one_of
from testbed.inputs.validation import validated

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup

SIGNALS = (*SENSED, *(f"reference.{name}" for name in SETPOINT), "dt_s", "trim_pitch")
"""What an input can take; after these, `trim.` and the name of each actuator."""
_NUMBERS = ("Real", "Float64")
_MOST_BYTES, _MOST_FILES = 1_000_000_000, 10_000
_LARGEST_DESCRIPTION = 50_000_000
_DESCRIPTION = "modelDescription.xml"
_Name = Annotated[str, Field(strict=True)]


class Mapped(Settings):
    """A mapping file, for names that do not fit.

    Attributes:
        inputs: the signal that each input takes.
        outputs: the output that commands each actuator.
    """

    inputs: dict[str, _Name] = Field(default={})
    outputs: dict[str, _Name] = Field(default={})


class Variable(NamedTuple):
    """An input or output: its value is (SI - offset) / factor."""

    name: str
    reference: int
    usable: bool
    unit: str
    start: str
    factor: float
    offset: float


class Fit(NamedTuple):
    """What fits an aircraft: each input with the index of its signal, and the output of each actuator; None where none does."""

    inputs: tuple[tuple[Variable, int | None], ...]
    outputs: tuple[Variable | None, ...]
    unused: tuple[Variable, ...]


def started(setup: Setup, words: Sequence[str]) -> Process:
    """The controller of one flight; raises BadInput when FMPy is missing, or when the unit does not fit the aircraft."""
    name = Path(words[0]).name
    _refuse_without_fmpy(name)
    module = "testbed.controllers.external.fmu_process"
    return Process(setup, command(module, *words), name, environment())


def described(file: str) -> Any:
    """The model description, by FMPy; raises BadInput when the file is no unit that can be flown."""
    _refuse_without_fmpy(file)
    from fmpy import read_model_description

    _refuse_archive(file)
    try:
        description = read_model_description(file)
    except Exception as error:  # of many kinds, for what is no unit
        raise BadInput([Problem(f"cannot be read as an FMU: {error}", file)]) from None
    if description.fmiVersion == "1.0" or description.coSimulation is None:
        what = f"is for FMI {description.fmiVersion}" + (
            ", without co-simulation" * (not description.coSimulation)
        )
        raise BadInput([Problem(what, file, expected="co-simulation by FMI 2.0 or 3.0")])
    return description


def fitted(description: Any, actuators: Sequence[str], mapping: str | None = None) -> Fit:
    """What fits by name or by a mapping file; raises BadInput for names in it that there are not."""
    variables = _variables(description)
    signals = (*SIGNALS, *(f"trim.{name}" for name in actuators))
    mapped = validated(Mapped, yaml_source.read(mapping)) if mapping else Mapped()
    _refuse_unknown(mapped, variables, signals, actuators, mapping or "")
    wanted = {_plain(name): i for i, name in enumerate(signals)}
    wanted |= {_plain(f"sensed.{name}"): i for i, name in enumerate(SENSED)}
    inputs = tuple(
        (each, wanted.get(_plain(mapped.inputs.get(each.name, each.name))) if each.usable else None)
        for each in variables["input"].values()
    )
    named = {_plain(name): each for name, each in variables["output"].items() if each.usable}
    outputs = tuple(named.get(_plain(mapped.outputs.get(name, name))) for name in actuators)
    unused = tuple(each for each in variables["output"].values() if each not in outputs)
    return Fit(inputs, outputs, unused)


def shown(file: str, mapping: str | None, actuators: Sequence[str]) -> list[tuple[str, str]]:
    """(name, meaning) of each input, of each output, and of each actuator that none commands."""
    fit = fitted(described(file), actuators, mapping)
    signals = (*SIGNALS, *(f"trim.{name}" for name in actuators))
    rows = [
        (
            each.name,
            f"takes {signals[i]}{_in(each)}" if i is not None else f"keeps its start value {each.start}",
        )
        for each, i in fit.inputs
    ]
    found = list(zip(actuators, fit.outputs, strict=True))
    rows += [(each.name, f"commands {actuator}{_in(each)}") for actuator, each in found if each]
    rows += [(each.name, "is an output that nothing takes") for each in fit.unused]
    return rows + [
        (actuator, "has no output: a mapping can name one") for actuator, each in found if not each
    ]


def complete(fit: Fit, actuators: Sequence[str], file: str) -> list[Variable]:
    """The output of each actuator; raises BadInput with those that have none."""
    names = [each.name for each in fit.unused if each.usable]
    problems = [
        Problem(
            f"has no output {actuator}",
            file,
            expected=one_of(names),
            suggestion=did_you_mean(actuator, names),
        )
        for actuator, each in zip(actuators, fit.outputs, strict=True)
        if each is None
    ]
    if problems:
        raise BadInput(problems)
    return [each for each in fit.outputs if each]


def _variables(description: Any) -> dict[str, dict[str, Variable]]:
    """Inputs and outputs by name."""
    units = {each.name: each.baseUnit for each in description.unitDefinitions if each.baseUnit}
    found: dict[str, dict[str, Variable]] = {"input": {}, "output": {}}
    for each in description.modelVariables:
        if each.causality in found:
            unit = each.unit or (each.declaredType and each.declaredType.unit) or ""
            base = units.get(unit)
            factor, offset = (base.factor, base.offset) if base else (1.0, 0.0)
            usable = each.type in _NUMBERS and not each.dimensions
            said = (each.name, each.valueReference, usable, unit, str(each.start or 0.0), factor, offset)
            found[each.causality][each.name] = Variable(*said)
    return found


def _refuse_unknown(
    mapped: Mapped,
    variables: Mapping[str, Mapping[str, Variable]],
    signals: Iterable[str],
    actuators: Iterable[str],
    file: str,
) -> None:
    numbers = {kind: [v.name for v in found.values() if v.usable] for kind, found in variables.items()}
    checks: list[tuple[str, Iterable[str], Iterable[str]]] = [
        ("inputs", mapped.inputs, numbers["input"]),
        ("inputs", mapped.inputs.values(), (*signals, *(f"sensed.{name}" for name in SENSED))),
        ("outputs", mapped.outputs, actuators),
        ("outputs", mapped.outputs.values(), numbers["output"]),
    ]
    problems = [
        Problem(
            f"{name} is no real scalar"
            if name in variables[place.removesuffix("s")]
            else f"there is no {name}",
            file,
            path=place,
            expected=one_of(known),
            suggestion=did_you_mean(name, known),
        )
        for place, names, known in checks
        for name in dict.fromkeys(names)
        if name not in known
    ]
    if problems:
        raise BadInput(problems)


def _refuse_archive(file: str) -> None:
    """Refuse what is no archive, and one whose files would be written elsewhere or without end."""
    try:
        with zipfile.ZipFile(file) as archive:
            members = archive.infolist()
    except (OSError, zipfile.BadZipFile) as error:
        raise BadInput([Problem(f"cannot be read as an FMU: {error}", file)]) from None
    checks: list[tuple[str, Callable[[zipfile.ZipInfo], bool]]] = [
        ("would be written elsewhere", lambda m: bool(re.search(r"^/|\\|:|(^|/)\.\.(/|$)", m.filename))),
        ("is too large", lambda m: m.filename == _DESCRIPTION and m.file_size > _LARGEST_DESCRIPTION),
    ]
    problems = [
        Problem(f"{m.filename!r:.80} {why}", file) for m in members for why, wrong in checks if wrong(m)
    ]
    if len(members) > _MOST_FILES or sum(m.file_size for m in members) > _MOST_BYTES:
        problems.append(Problem(f"has more than {_MOST_FILES} files or {_MOST_BYTES:g} bytes", file))
    if problems:
        raise BadInput(problems[:10])


def _refuse_without_fmpy(file: str) -> None:
    if find_spec("fmpy") is None:
        what = "an FMU needs the package fmpy"
        raise BadInput([Problem(what, file, expected="pip install 'testbed[fmu]'")])


def _plain(name: str) -> str:
    """A name without what tools write differently: `reference.altitude_rate` is referenceAltitudeRate."""
    return re.sub(r"[^a-z0-9]", "", name.casefold())


def _in(variable: Variable) -> str:
    return f" in {variable.unit}" if variable.unit else ""
