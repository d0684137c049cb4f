"""`testbed schema`: what a file may say, as a JSON schema, with which editors complete and check YAML while it is typed."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from pathlib import Path
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any, get_args

from testbed.cli.command import add_out, write_out
from testbed.cli.ending import MET
from testbed.common.docstrings import field_docstrings
from testbed.inputs.output_file import refuse_unwritable

if TYPE_CHECKING:
    from pydantic import BaseModel

PURPOSE = "print the JSON schema of a kind of file, for editors that check YAML"
EXAMPLES = ("testbed schema scenario --out scenario.json",)

DRAFT = "https://json-schema.org/draft/2020-12/schema"


TABLE = {
    "aircraft": "testbed.aircraft.description:Aircraft",
    "matrix": "testbed.studies.model:Matrix",
    "scenario": "testbed.scenario.model:Scenario",
    "search": "testbed.studies.model:Search",
    "suite": "testbed.studies.benchmark.model:Suite",
    "sweep": "testbed.studies.model:Sweep",
}
"""The kinds of file that have a schema: `module:name` of the model of each."""

_NAMES = {
    ("Requirement", "metric"): "testbed.metrics:TABLE",
    ("Scenario", "reference"): "testbed.scenario.references:TABLE",
}
"""Texts that are names of parts: (model, key), and `module:name` of the table, which `--with` adds to."""


def text_of(kind: str) -> str:
    """The schema of one kind of file."""
    return json.dumps(schema_of(model_of(kind)), indent=1, ensure_ascii=False) + "\n"


def model_of(kind: str) -> type[BaseModel]:
    """The model of one kind of file, which is imported when it is asked for."""
    return resolve_name(TABLE[kind])


def arguments(command: ArgumentParser) -> None:
    command.add_argument("kind", choices=TABLE)
    add_out(command, "FILE", "write it into this file")


def run(options: Namespace) -> int:
    """Print a schema, or write it into a file, also over an earlier schema; raises BadInput if that cannot be done."""
    if options.out is None:
        print(text_of(options.kind), end="")
        return MET
    refuse_unwritable(options.out, _is_schema)
    write_out(options.out, text_of(options.kind))
    return MET


def _is_schema(file: Path) -> bool:
    """Whether a file is a schema that was written here, perhaps by another version."""
    with file.open(encoding="utf-8", errors="replace") as stream:
        return DRAFT in stream.read(100)


def schema_of(model: type[BaseModel]) -> dict[str, Any]:
    """The JSON schema of a model, with the meanings that the docstrings of its fields give."""
    from testbed.sensors.settings import PRESETS

    schema = {"$schema": DRAFT, **model.model_json_schema(by_alias=True)}
    named = {each.__name__: each for each in _models(model)}
    for name, part in [(model.__name__, schema), *schema.get("$defs", {}).items()]:
        if name in named:
            _explain(part, named[name])
    if model.__name__ == "Scenario":  # by default the aircraft's reference
        schema["required"] = [key for key in schema["required"] if key != "initial"]
        schema["$defs"]["Initial"].pop("required")
    # What a model also takes in place of a mapping, and turns into one before pydantic sees it.
    short: dict[str, Any] = {"PerKind": {"type": "number"}, "Sensors": {"enum": list(PRESETS)}}
    for name in short.keys() & schema.get("$defs", {}).keys():
        schema["$defs"][name] = {"anyOf": [short[name], schema["$defs"][name]]}
    return schema


def _explain(part: dict[str, Any], model: type[BaseModel]) -> None:
    meanings = field_docstrings(model)
    for name, entry in part.get("properties", {}).items():
        if name in meanings:
            entry["description"] = meanings[name]
        if name == "released" and "anyOf" in entry:
            entry["anyOf"].append({"const": "auto"})
        table = _NAMES.get((model.__name__, name))
        if table is not None and (names := sorted(resolve_name(table))):
            entry["anyOf"][0] = {"enum": names}


def _models(kind: Any, seen: set[type] | None = None) -> Iterator[type[BaseModel]]:
    """A model, and every model in the types of its fields."""
    from pydantic import BaseModel

    seen = set() if seen is None else seen
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        if kind in seen:
            return
        seen.add(kind)
        yield kind
        for field in kind.model_fields.values():
            yield from _models(field.annotation, seen)
        return
    for part in get_args(kind):
        yield from _models(part, seen)
