"""Docstrings that users are shown: of metrics, controllers and failures. `python -OO` leaves them out of the compiled code."""

from __future__ import annotations

import ast
import inspect
import textwrap
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
