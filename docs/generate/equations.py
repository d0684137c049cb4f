"""Every numbered equation of the paper, with the code that has it and the tests that hold it.

    python docs/generate/equations.py

prints the table of docs/reference/equations.md, and fails when an equation is missing, a test does not exist, or a test does
not name its equation in its name or docstring. The site calls `table`, so a broken row stops its build too.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

from equation_table import TABLE, Equation

_ROOT = Path(__file__).parents[2]
LAST = 42
"""Number of the paper's last equation."""


def table() -> str:
    """The table in Markdown; raises LookupError with everything that is wrong with it."""
    wrong = list(problems(TABLE))
    if wrong:
        raise LookupError("; ".join(wrong))
    lines = ["| equation | what it says | in the code | tests |", "| --- | --- | --- | --- |"]
    for equation in TABLE:
        tests = "<br>".join(f"`{test}`" for test in equation.tests)
        code = f"`{equation.code}`" if equation.code else ""
        lines.append(f"| {_numbers(equation)} | {equation.says} | {code} | {tests} |")
    return "\n".join(lines)


def problems(equations: Sequence[Equation]) -> Iterator[str]:
    """What is missing: numbers, tests, and the numbers in the tests' own words."""
    listed = [n for equation in equations for n in range(equation.numbers[0], equation.numbers[1] + 1)]
    yield from (f"({n}) is not listed" for n in range(1, LAST + 1) if n not in listed)
    for equation in equations:
        if not equation.tests:
            yield f"{_numbers(equation)} has no test"
        for test in equation.tests:
            words = words_of(*test.split("::"))
            if words is None:
                yield f"{test} does not exist"
            elif not _named_in(words) & set(range(equation.numbers[0], equation.numbers[1] + 1)):
                yield f"{test} does not name {_numbers(equation)}"


def _numbers(equation: Equation) -> str:
    first, last = equation.numbers
    return f"({first})" if first == last else f"({first}) to ({last})"


def _named_in(words: str) -> set[int]:
    """Numbers of equations in a test's name and docstring: `eq_9_10_11`, (12), (5) to (8)."""
    name, _, said = words.partition("\n")
    found = {int(n) for run in re.findall(r"eq((?:_\d+|_to)+)", name) for n in re.findall(r"\d+", run)}
    for first, last in re.findall(r"_(\d+)_to_(\d+)", name) + re.findall(r"\((\d+)\) to \((\d+)\)", said):
        found |= set(range(int(first), int(last) + 1))
    return found | {int(n) for n in re.findall(r"\((\d+)\)", said)}


def words_of(file: str, name: str) -> str | None:
    """Name and docstring of a test; None if there is no such test."""
    said = _tests_in(_ROOT / "tests" / file).get(name)
    return None if said is None else f"{name}\n{said}"


@cache
def _tests_in(file: Path) -> dict[str, str]:
    if not file.is_file():
        return {}
    tree = ast.parse(file.read_text(encoding="utf-8"))
    return {
        node.name: ast.get_docstring(node) or "" for node in tree.body if isinstance(node, ast.FunctionDef)
    }


if __name__ == "__main__":
    try:
        print(table())
    except LookupError as error:
        sys.exit(str(error))
