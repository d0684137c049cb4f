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
    definition = None if thing.__doc__ else _definition(thing)
    text = ast.get_docstring(definition) if definition else thing.__doc__
    return (text or "").strip().partition("\n")[0]


def _definition(thing: Any) -> ast.FunctionDef | ast.ClassDef | None:
    """Where a function or class is defined; None if its source is not there, or is no definition."""
    try:
        (definition,) = ast.parse(textwrap.dedent(inspect.getsource(thing))).body
    except (OSError, TypeError, SyntaxError, ValueError):
        return None
    return definition if isinstance(definition, ast.FunctionDef | ast.ClassDef) else None


def field_docstrings(kind: type) -> dict[str, str]:
    """The docstring below each field of a class, those of its bases in the same package included; empty without their source."""
    package = kind.__module__.partition(".")[0]
    own = [each for each in reversed(kind.__mro__) if each.__module__.partition(".")[0] == package]
    return {name: text for each in own for name, text in _fields_of(each).items()}


@cache
def _fields_of(kind: type) -> dict[str, str]:
    """The docstring below each field that a class defines itself; cached, because Python reads a whole module for it."""
    found, definition = dict[str, str](), _definition(kind)
    for field, after in pairwise(definition.body if definition else ()):
        is_text = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
        if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name) and is_text:
            found[field.target.id] = " ".join(str(after.value.value).split())  # type: ignore[attr-defined]
    return found
