"""A file of parts: run once, its tables read, and what is no part refused before anything changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import wraps
from pathlib import Path
from typing import Any, NamedTuple, get_args

from pydantic import BaseModel

from testbed.common.docstrings import first_line
from testbed.controllers.user.loader import in_words, module_of, shown
from testbed.controllers.user.own import code_of, sha256_of
from testbed.failures import TABLE as FAILURES
from testbed.failures import Failure
from testbed.inputs.problems import BadInput, Problem
from testbed.metrics import TABLE as METRICS
from testbed.metrics import Readings
from testbed.reporting.panels import OWN as PANELS
from testbed.scenario.references import TABLE as REFERENCES
from testbed.sensors.faults import TABLE as SENSOR_FAULTS
from testbed.sensors.faults import SensorFault
from testbed.sensors.settings import PRESETS, SENSORS


class Kind(NamedTuple):
    """A kind of part: its word, the table of the shipped ones, and what is wrong with something that is to be one, or ""."""

    word: str
    table: dict[str, Any]
    wrong: Callable[[Any], str]


def _no_class_of(base: type[BaseModel]) -> Callable[[Any], str]:
    def wrong(part: Any) -> str:
        if not (isinstance(part, type) and issubclass(part, base)):
            return f"is no class of {base.__name__}"
        if len(get_args(part.model_fields["type"].annotation)) != 1:
            return 'has no name, as in type: Literal["sticky"] = "sticky"'
        return "" if first_line(part) else "has no docstring"

    return wrong


def _no_function(part: Any) -> str:
    if not callable(part) or not getattr(part, "__name__", "").isidentifier():
        return "is no function"
    return "" if first_line(part) else "has no docstring"


def _no_preset(part: Any) -> str:
    if not isinstance(part, Mapping):
        return "is no mapping of sensors to their errors"
    for sensor, errors in part.items():
        if sensor not in SENSORS:
            return f"has no sensor {sensor!r} to set"
        SENSORS[sensor].model_validate(errors)
    return ""


KINDS = {
    "FAILURES": Kind("failure", FAILURES, _no_class_of(Failure)),
    "SENSOR_FAULTS": Kind("sensor fault", SENSOR_FAULTS, _no_class_of(SensorFault)),
    "SENSORS": Kind("preset of sensors", PRESETS, _no_preset),
    "METRICS": Kind("metric", METRICS, _no_function),
    "PANELS": Kind("panel", PANELS, _no_function),
    "REFERENCES": Kind("reference", REFERENCES, _no_function),
}
"""The kinds of parts by the names of their tables in a file."""


@dataclass(frozen=True)
class Parts:
    """A file of parts of the user's own.

    Attributes:
        file: its path.
        code: path and contents of the file and of those beside it that it imports.
        tables: the parts by name, of each of KINDS that it has; empty until it is loaded.
    """

    file: str
    code: tuple[tuple[str, bytes], ...]
    tables: Mapping[str, Mapping[str, Any]] = field(default_factory=dict, compare=False)

    @property
    def name(self) -> str:
        """Its name without the folder: the same on every machine."""
        return Path(self.file).name

    @property
    def digest(self) -> str:
        """SHA-256 of its code."""
        return sha256_of(self.code)

    def sent(self, folder: Path | None = None) -> Parts:
        """What a worker is sent: without what the file made, and where its code is unpacked into a folder, from there."""
        return replace(self, tables={}, file=self.file if folder is None else str(folder / self.name))


def loaded(file: str | Path) -> Parts:
    """Run a file of parts. Raises BadInput with every part that is none, or when the file cannot be run."""
    module = module_of(Path(file))
    path = Path(file).resolve()
    problems: list[Problem] = []
    tables: dict[str, dict[str, Any]] = {}
    for kind in KINDS:
        with in_words(str(file), f"in {kind}"):
            tables[kind] = dict(_named(getattr(module, kind, ())))
            problems += _problems(kind, tables[kind], str(file))
    if not any(tables.values()) and not problems:
        problems.append(Problem("has no parts", str(file), expected=f"a list {', '.join(KINDS)}"))
    if problems:
        raise BadInput(problems)
    tables["METRICS"] = {name: _measured(metric, str(file)) for name, metric in tables["METRICS"].items()}
    return Parts(str(path), tuple(code_of(path)), tables)


def _named(table: Any) -> Iterator[tuple[str, Any]]:
    """(name, part) of a table: a mapping, or a list of parts that know their names."""
    if isinstance(table, Mapping):
        yield from table.items()
        return
    for part in table:
        fields = getattr(part, "model_fields", {})
        named = fields["type"].default if "type" in fields else getattr(part, "__name__", shown(part))
        yield str(named), part


def _problems(kind: str, parts: Mapping[str, Any], file: str) -> Iterator[Problem]:
    for name, part in parts.items():
        wrong = KINDS[kind].wrong(part)
        if name in KINDS[kind].table:
            wrong = f"is the name of another {KINDS[kind].word}"
        if wrong:
            yield Problem(f"{name} {wrong}", file, path=kind)


def _measured(metric: Callable[[Readings], float], file: str) -> Callable[[Readings], float]:
    """The metric, which gives a float; what it raises is reported with its file and line."""

    @wraps(metric)
    def measured(readings: Readings) -> float:
        with in_words(file, f"in the metric {metric.__name__}"):
            return float(metric(readings))

    return measured
