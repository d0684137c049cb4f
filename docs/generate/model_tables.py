"""The keys of a pydantic model as a Markdown table: type, default, range and meaning, read from the code."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
import textwrap
import types
from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

HEAD = "| key | type | default | meaning |\n| --- | --- | --- | --- |\n"
_WORDS = {float: "number", int: "whole number", str: "text", bool: "true or false", Any: "any value"}
_BOUNDS = {"gt": "above {}", "ge": "at least {}", "lt": "below {}", "le": "at most {}"}
Model = type[BaseModel]


def keys(path: str, closed: Sequence[str] = ()) -> str:
    """Table of the keys of `package.module:Model`, then of each mapping in it, except the mappings named in `closed`."""
    module, _, name = path.partition(":")
    model = getattr(importlib.import_module(module), name)
    return "\n\n".join([table(model), *_sections(model, "", closed)])


def _sections(model: Model, inside: str, closed: Sequence[str]) -> Iterator[str]:
    """Heading, docstring and table of each mapping in a model, at any depth."""
    for name, info in model.model_fields.items():
        if name in closed:
            continue
        inner = models(info.annotation)
        for each in inner:
            path = f"{inside}{name}" + (f", kind {_kind(each)}" if len(inner) > 1 else "")
            yield f"### `{path}`\n\n{described(each)}\n\n{table(each)}"
            yield from _sections(each, f"{inside}{name}.", ())


def _kind(model: Model) -> str:
    """The value of the key that tells one model of several: `servo`."""
    told = next(name for name in ("type", "kind") if name in model.model_fields)
    return str(model.model_fields[told].default)


def described(model: Model) -> str:
    """A model's docstring, without its list of attributes."""
    text = inspect.cleandoc(model.__doc__ or "").partition("Attributes:\n")[0]
    return text.strip()


def table(model: Model, leave_out: Sequence[str] = ()) -> str:
    """Table of a model's own keys, except those in `leave_out`."""
    said = meanings(model)
    rows = []
    for name, info in model.model_fields.items():
        if name in leave_out:
            continue
        cells = (f"`{name}`", _type(info), _default(info), cell(said.get(name, "")))
        rows.append(f"| {' | '.join(cells)} |")
    return HEAD + "\n".join(rows)


def meanings(model: Model) -> dict[str, str]:
    """Meaning of each field: the docstring below it; without one, its entry under `Attributes:` of the class; without
    that, the first paragraph of the docstring of the model that the field holds."""
    found = {}
    for name, info in model.model_fields.items():
        inner = models(info.annotation)
        if len(inner) == 1:
            found[name] = described(inner[0]).partition("\n\n")[0]
    for kind in reversed(model.__mro__):
        if issubclass(kind, BaseModel) and kind is not BaseModel:
            found |= _listed(kind)
            found |= dict(_below(kind))
    return found


def models(kind: Any) -> list[Model]:
    """The models in a type, in order: of a list, a mapping or alternatives too."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return [kind]
    return list(dict.fromkeys(model for part in get_args(kind) for model in models(part)))


def alternatives(model: Model, field: str) -> dict[str, Model]:
    """The models that a field chooses from, by the key that tells them apart: `pid`, `indi`."""
    return {_kind(each): each for each in models(model.model_fields[field].annotation)}


def _below(kind: Model) -> Iterator[tuple[str, str]]:
    """(field, docstring below it) of a class that is written in a file."""
    try:
        (tree,) = ast.parse(textwrap.dedent(inspect.getsource(kind))).body
    except (OSError, TypeError):  # made by create_model: its base classes speak for it
        return
    assert isinstance(tree, ast.ClassDef)
    field = ""
    for statement in tree.body:
        if isinstance(statement, ast.AnnAssign) and isinstance(statement.target, ast.Name):
            field = statement.target.id
        elif field and isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
            yield field, inspect.cleandoc(str(statement.value.value))
            field = ""
        else:
            field = ""


def _listed(kind: Model) -> dict[str, str]:
    """Entries of the section `Attributes:` of a class docstring."""
    _, _, section = inspect.cleandoc(kind.__dict__.get("__doc__") or "").partition("Attributes:\n")
    entries = re.findall(r"^    (\w+): (.+(?:\n {6,}.+)*)", section, flags=re.MULTILINE)
    return {name: text for name, text in entries}


def _type(info: FieldInfo) -> str:
    bounds = _bounds(info.metadata)
    return cell(_named(info.annotation) + (f", {bounds}" if bounds else ""))


def _named(kind: Any) -> str:
    """A type in words."""
    origin, arguments = get_origin(kind), get_args(kind)
    if origin is Annotated:
        bounds = _bounds(arguments[1:])
        return _named(arguments[0]) + (f", {bounds}" if bounds else "")
    if origin is Literal:
        return " or ".join(f"`{value}`" for value in arguments)
    if origin in (Union, types.UnionType):
        return " or ".join(dict.fromkeys(_named(a) for a in arguments if a is not type(None)))
    if origin is tuple and arguments[-1] is not Ellipsis:
        return f"list of {len(arguments)} {_named(arguments[0])}s"
    if origin in (tuple, list):
        return f"list of {_named(arguments[0])}"
    if origin is dict:
        return f"names, each with: {_named(arguments[1])}"
    return "mapping" if models(kind) else _WORDS.get(kind, str(kind))


def _bounds(metadata: Any) -> str:
    """Range of a number in words."""
    words = []
    for entry in metadata:
        for constraint in getattr(entry, "metadata", None) or [entry]:
            words += [
                text.format(f"{getattr(constraint, name):g}")
                for name, text in _BOUNDS.items()
                if getattr(constraint, name, None) is not None
            ]
    if any(word.startswith("above") for word in words):
        words = [word for word in words if word != "at least 0"]
    return " and ".join(dict.fromkeys(words))


def _default(info: FieldInfo) -> str:
    if info.is_required():
        return "required"
    value = info.get_default(call_default_factory=True, validated_data={})
    if value is None or (hasattr(value, "__len__") and not len(value)):
        return "none"
    if isinstance(value, BaseModel):
        if hasattr(value, "type"):
            return f"`{{type: {value.type}}}`"
        written = value.model_dump()
        few = isinstance(written, dict) and len(written) <= 2
        return cell(f"`{_yaml(written)}`") if few else "as below"
    return cell(f"`{_yaml(value)}`")


def _yaml(value: Any) -> str:
    """A default as it would be written in YAML."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name}: {_yaml(each)}" for name, each in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_yaml, value)) + "]"
    return str(value)


def cell(text: str) -> str:
    """Text for a cell: on one line, with bars escaped, except in code, where they do not end the cell."""
    parts = " ".join(text.split()).split("`")
    parts[::2] = [part.replace("|", "\\|") for part in parts[::2]]
    return "`".join(parts)
