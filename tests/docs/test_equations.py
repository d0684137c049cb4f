"""The table of the paper's equations is whole, and what is missing from it is said."""

from __future__ import annotations

import inspect
from importlib import import_module

import equations
import pytest
from equation_table import TABLE, Equation
from equations import LAST, problems


def test_every_equation_has_a_test_that_names_it() -> None:
    assert list(problems(TABLE)) == []
    assert equations.table().count("\n") == len(TABLE) + 1


LAW = [equation for equation in TABLE if equation.code.startswith("inversion.")]


@pytest.mark.parametrize("equation", LAW, ids=lambda equation: equation.code)
def test_the_law_has_the_number_at_its_line(equation: Equation) -> None:
    """In a comment of the code that the table names, so that a reader of the paper can tick it off."""
    module, _, name = equation.code.rpartition(".")
    part = getattr(import_module(f"testbed.controllers.{module}"), name)
    lines = inspect.getsource(getattr(part, "py_func", part)).splitlines()
    comments = " ".join(line.partition("# ")[2] for line in lines)
    first, last = equation.numbers
    assert equations._named_in(f"\n{comments}") & set(range(first, last + 1)), comments


def test_what_is_missing_is_said() -> None:
    """Negative controls: a missing number, a missing test, one that does not exist, and one that is of another equation."""
    whole = Equation((1, LAST), "", "", ["paper/test_equations.py::test_eq_6_inverts_eq_5"])
    assert list(problems([whole])) == []
    assert list(problems([whole._replace(numbers=(2, LAST))])) == ["(1) is not listed"]
    assert list(problems([whole._replace(tests=[])])) == [f"(1) to ({LAST}) has no test"]
    nowhere = "paper/test_equations.py::test_eq_99"
    assert list(problems([whole._replace(tests=[nowhere])])) == [f"{nowhere} does not exist"]
    (other,) = problems(
        [
            whole,
            Equation((7, 7), "", "", ["paper/test_equations.py::test_eq_20_case_1_nothing_moves_at_zero"]),
        ]
    )
    assert other.endswith("test_eq_20_case_1_nothing_moves_at_zero does not name (7)")


def test_numbers_are_read_from_names_and_docstrings() -> None:
    assert equations._named_in("test_eq_9_10_11_error\n") == {9, 10, 11}
    assert equations._named_in("test_eq_25_to_28_eigenvalues\n") == {25, 26, 27, 28}
    assert equations._named_in("test_other\n(5), and (30) to (32) of 2019") == {5, 30, 31, 32}
