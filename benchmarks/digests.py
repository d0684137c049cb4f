"""Digests of what a page of results depends on, and which of them are proven to fly the same.

A part of the program is a set of Python files. Its digest is of their syntax: comments, docstrings, formatting, and the names
and folders of the files do not count. A part of the data is a folder or a file, whose bytes count. Two digests of a part are
worth the same if `same_bytes.py` has found that the programs they are of fly the same; it alone writes EQUAL.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
EQUAL = Path(__file__).with_name("proven_equal.json")
"""What `same_bytes.py` has proven: pairs of digests, with the commit compared and the number of files."""
CODE: Mapping[str, tuple[str, ...]] = {
    "law": ("controllers", "aircraft/control_design"),
    "plant": ("plant", "air", "failures", "injection", "sensors"),
    "simulation": ("simulation", "scenario", "aircraft", "flight", "metrics", "common"),
    "searches": ("reliability", "searches", "studies"),
    "sweeps": ("sweeps", "monte_carlo", "studies"),
    "theory": ("theory", "gains", "margins", "../../benchmarks/paper"),
    "adoption": ("adoption",),
    "logs": ("logs",),
}
"""Parts of the program: packages and modules, from src/testbed; those of earlier versions too, where it was flown with them."""
PROVABLE = ("law", "plant", "simulation", "sweeps", "searches", "adoption")
"""Parts whose work the flights, studies and adopted aircraft of `same_bytes.py` show."""
FLOWN = ("law", "plant", "simulation", "aircraft/vtail")
"""What every flight of the v-tail depends on."""
_DATA = ("xml", "yaml", "json", "csv")


def digest(part: str, root: Path = ROOT) -> str:
    """The digest of a part of CODE, or of a data folder or file by its path, in the checkout at `root`; empty if it has no file."""
    hashed = _code(part, root) if part in CODE else _data(root / part)
    each = sorted(hashed)
    return hashlib.sha256("".join(each).encode()).hexdigest()[:16] if each else ""


def proven(part: str, before: str, now: str, file: Path = EQUAL) -> bool:
    """Whether the two digests of a part are equal, or joined by proofs of `same_bytes.py`."""
    known, pairs = {before}, [(p["before"].get(part), p["after"].get(part)) for p in proofs(file)]
    for _ in pairs:
        for pair in pairs:
            known |= set(pair) if known & set(pair) else set()
    return now in known


def proofs(file: Path = EQUAL) -> list[dict[str, Any]]:
    """What `same_bytes.py` has written so far."""
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else []


def syntax(text: str) -> str:
    """A Python file's meaning as text, the same for all versions of Python.

    Left out are comments, docstrings and positions, and the module from which a part of the package imports: a file that is
    moved is the same file.
    """
    return "".join(_said(ast.parse(text)))


def _code(part: str, root: Path) -> Iterator[str]:
    for name in CODE[part]:
        place = root / "src" / "testbed" / name
        for file in [place.with_suffix(".py"), *place.rglob("*.py")]:
            if file.is_file():
                yield _syntax_digest(file.read_text(encoding="utf-8"))


@cache
def _syntax_digest(text: str) -> str:
    return hashlib.sha256(syntax(text).encode()).hexdigest()


def _data(place: Path) -> Iterator[str]:
    for file in [place, *place.rglob("*")]:
        if file.is_file() and file.suffix[1:] in _DATA:
            yield hashlib.sha256(file.read_bytes()).hexdigest()


def _said(node: ast.AST) -> Iterator[str]:
    yield f"({type(node).__name__}"
    for name, value in ast.iter_fields(node):
        if isinstance(node, ast.ImportFrom) and name in ("module", "level"):
            value = None if node.level or (node.module or "").startswith(("testbed", "paper")) else value
        if value not in (None, []) and name not in ("ctx", "kind", "type_comment"):
            yield f" {name}="
            yield from _value(value)
    yield ")"


def _value(value: object) -> Iterator[str]:
    if isinstance(value, ast.AST):
        yield from _said(value)
    elif isinstance(value, list):
        for each in _without_text(value):
            yield from _value(each)
    else:
        yield repr(value)


def _without_text(body: Iterable[object]) -> Iterator[object]:
    """Statements without those that are a text alone: docstrings, and what stands below a field."""
    for each in body:
        alone = isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
        if not (alone and isinstance(each.value.value, str)):  # type: ignore[union-attr,attr-defined]
            yield each
