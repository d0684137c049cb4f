"""No module imports itself in a circle, neither when it is loaded nor inside a function."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path

import testbed

_PACKAGE = Path(testbed.__file__).parent


def test_there_is_no_circle_of_modules() -> None:
    assert circles(imports(_PACKAGE)) == []


def test_a_circle_is_found(tmp_path: Path) -> None:
    """Negative control: two circles, one through a function; imports for the type checker alone make none."""
    package = tmp_path / "p"
    (package / "q").mkdir(parents=True)
    typed = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import p.f"
    for name, text in {
        "__init__": "", "a": "from p import b", "b": "def f():\n    import p.q.c", "q/__init__": "from p.q import c",
        "q/c": "from p.q import d\nfrom p.a import x", "q/d": "", "e": typed, "f": "import p.e", "g": "from p import h",
        "h": "from p import g",
    }.items():  # fmt: skip
        (package / f"{name}.py").write_text(text)
    assert circles(imports(package)) == [["p.a", "p.b", "p.q.c"], ["p.g", "p.h"]]


def imports(package: Path) -> dict[str, set[str]]:
    """The modules that each module of a package imports from it, but for those that only a type checker imports."""
    files = {_name(file, package): file for file in package.rglob("*.py")}
    return {name: set(_imported(file, name, files)) - {name} for name, file in files.items()}


def _name(file: Path, package: Path) -> str:
    parts = file.relative_to(package.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _imported(file: Path, name: str, files: Mapping[str, Path]) -> Iterator[str]:
    for node in _nodes(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in files)
        elif isinstance(node, ast.ImportFrom) and node.module:
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                if inner in files or node.module in files:
                    yield inner if inner in files else node.module


def _nodes(tree: ast.AST) -> Iterator[ast.AST]:
    """All parts of a module, but what stands under `if TYPE_CHECKING`."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            continue
        yield node
        yield from _nodes(node)


def circles(graph: Mapping[str, set[str]]) -> list[list[str]]:
    """The sets of modules that can all be reached from each other, by Tarjan's algorithm; those of one module are none."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    found: list[list[str]] = []

    def visit(name: str) -> None:
        index[name] = low[name] = len(index)
        stack.append(name)
        for other in sorted(graph[name]):
            if other not in index:
                visit(other)
                low[name] = min(low[name], low[other])
            elif other in stack:
                low[name] = min(low[name], index[other])
        if low[name] == index[name]:
            at = stack.index(name)
            found.append(sorted(stack[at:]))
            del stack[at:]

    for name in sorted(graph):
        if name not in index:
            visit(name)
    return sorted(each for each in found if len(each) > 1)
