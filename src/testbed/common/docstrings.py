"""Docstrings that users are shown: of metrics, controllers and failures. `python -OO` leaves them out of the compiled code."""

from __future__ import annotations

import ast
import inspect
import textwrap
from functools import cache
from itertools import pairwise
from typing import Any


def first_line(thing: Any) -> str:
    """First line of the docstring of a function or class; "" if it has none. With `python -OO` it is read from the source."""
    return (thing.__doc__ or _in_source(thing)).strip().partition("\n")[0]


def _in_source(thing: Any) -> str:
    try:
        (definition,) = ast.parse(textwrap.dedent(inspect.getsource(thing))).body
    except (OSError, TypeError, SyntaxError, ValueError):  # its source is not there, or is no definition
        return ""
    if not isinstance(definition, ast.FunctionDef | ast.ClassDef):
        return ""
    return ast.get_docstring(definition) or ""


def field_docstrings(kind: type) -> dict[str, str]:
    """The docstring below each field of a class, those of its bases in the same package included; empty without their source."""
    package = kind.__module__.partition(".")[0]
    own = [each for each in reversed(kind.__mro__) if each.__module__.partition(".")[0] == package]
    return {name: text for each in own for name, text in _fields_of(each).items()}


@cache
def _fields_of(kind: type) -> dict[str, str]:
    """The docstring below each field that a class defines itself; cached, because Python reads a whole module for it."""
    try:
        (definition,) = ast.parse(textwrap.dedent(inspect.getsource(kind))).body
    except (OSError, TypeError, SyntaxError, ValueError):
        return {}
    return _below(definition) if isinstance(definition, ast.ClassDef) else {}


def _below(definition: ast.ClassDef) -> dict[str, str]:
    found = {}
    for field, after in pairwise(definition.body):
        is_field = isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name)
        is_text = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
        if is_field and is_text:
            found[field.target.id] = " ".join(str(after.value.value).split())  # type: ignore[attr-defined]
    return found
