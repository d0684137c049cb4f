"""Every number that stands in the code of the law, with what its own docstring or comment says of its unit and source."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

_CONTROLLERS = Path(__file__).parents[2] / "src" / "testbed" / "controllers"
FILES = (
    *sorted((_CONTROLLERS / "inversion").glob("*.py")),
    *(_CONTROLLERS / f"{name}.py" for name in ("initial_records", "outer_loops", "released_axes", "scaling")),
)


class Number(NamedTuple):
    """One number, or some that are set in one line, and what the code says of it."""

    where: str
    said: str
    meaning: str


def numbers() -> Iterator[Number]:
    """The numbers of all files of the law, in the order of the code."""
    for file in FILES:
        text = file.read_text(encoding="utf-8")
        body = ast.parse(text).body
        for node, after in zip(body, [*body[1:], None], strict=True):
            if isinstance(node, ast.Assign) and _is_number(node.value):
                said = " ".join(ast.unparse(node).split())
                yield Number(file.stem, re.sub(r"(^|, )_", r"\1", said), _meaning(node, after, text))


def _is_number(value: ast.expr) -> bool:
    """Whether it is made of numbers: no text, name of a channel or range of indices."""
    parts = list(ast.walk(value))
    called = [ast.unparse(part.func) for part in parts if isinstance(part, ast.Call)]
    numeric = any(isinstance(part, ast.Constant) and isinstance(part.value, int | float) for part in parts)
    texts = any(isinstance(part, ast.Constant) and isinstance(part.value, str) for part in parts)
    return (
        numeric
        and (not texts or isinstance(value, ast.Dict))
        and set(called) <= {"np.linspace", "math.radians"}
    )


def _meaning(node: ast.Assign, after: ast.stmt | None, text: str) -> str:
    """The docstring that follows, or the comment in its line."""
    if (
        isinstance(after, ast.Expr)
        and isinstance(after.value, ast.Constant)
        and isinstance(after.value.value, str)
    ):
        return " ".join(after.value.value.split())
    comment = re.search(r"#\s*(.*)$", text.splitlines()[(node.end_lineno or 1) - 1])
    return comment.group(1) if comment else ""
