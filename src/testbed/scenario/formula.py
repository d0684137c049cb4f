"""Requirements in time: formulas of signal temporal logic over the columns of the log, read as data.

    always(heading_deg < 120 or eventually[0:5](abs(roll_deg) < 10))

`always[a:b](f)` holds where f does at all times from a to b seconds later, `eventually[a:b](f)` where it does at some of them;
without a window they mean all times until the end of the flight. `until[a:b](f, g)` holds where g does at some of them, and f at
all times before. `always[a,b]` is `always[a:b]`. Others are `and`, `or`, `not`, `implies(f, g)`, and comparisons of
arithmetic (+ - * / abs) on columns and numbers. Nothing is run: Python's parser reads the text, and all but these forms is refused.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from dataclasses import dataclass

from testbed.inputs.base import refuse

LONGEST = 1000
"""Longest formula [characters]."""
_DEEPEST = 30
_LARGEST = 1e12
_TIMED = {"always": 1, "eventually": 1, "until": 2}
"""How many formulas each takes."""
_FORMS = "always, eventually, until, implies, and, or, not, and comparisons"
_ARITHMETIC = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_COMPARED = {ast.Lt: "<", ast.LtE: "<", ast.Gt: ">", ast.GtE: ">"}


@dataclass(frozen=True)
class Node:
    """A part of a formula.

    Attributes:
        form: `always`, `eventually`, `until`, `and`, `or`, `not`, `above` (its first part is above its second); or of numbers
            `column`, `number`, `abs` and the signs of arithmetic.
        parts: what it is made of.
        window: of `always`, `eventually` and `until`, from and to how much later [s]; (0, inf) is to the end of the flight.
        name, value: of a column, and of a number.
    """

    form: str
    parts: tuple[Node, ...] = ()
    window: tuple[float, float] = (0.0, math.inf)
    name: str = ""
    value: float = 0.0

    @property
    def horizon_s(self) -> float:
        """How far ahead it looks [s], by its windows that have an end."""
        inner = max((part.horizon_s for part in self.parts), default=0.0)
        return inner + (self.window[1] if self.window[1] < math.inf else self.window[0])

    def columns(self) -> Iterator[str]:
        """The columns that it names."""
        if self.form == "column":
            yield self.name
        for part in self.parts:
            yield from part.columns()


def parse(text: str) -> Node:
    """The formula in a text; raises the error of a validator for anything else."""
    if len(text) > LONGEST:
        raise refuse(f"has {len(text)} characters", f"at most {LONGEST}")
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise refuse(f"is no formula: {getattr(error, 'msg', error)}", _FORMS) from None
    return _formula(tree.body, 0)


def _formula(tree: ast.expr, depth: int) -> Node:
    """A part that holds or does not."""
    if depth > _DEEPEST:
        raise refuse("is nested too deep", f"at most {_DEEPEST} levels")
    match tree:
        case ast.BoolOp(op=op, values=values):
            form = "and" if isinstance(op, ast.And) else "or"
            return Node(form, tuple(_formula(value, depth + 1) for value in values))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return Node("not", (_formula(operand, depth + 1),))
        case ast.Compare():
            return _comparison(tree, depth)
        case ast.Call(func=ast.Name(id="implies"), args=[first, second], keywords=[]):
            return Node("or", (Node("not", (_formula(first, depth + 1),)), _formula(second, depth + 1)))
        case ast.Call(func=ast.Name(id=form), args=args, keywords=[]) if _TIMED.get(form) == len(args):
            return Node(form, tuple(_formula(each, depth + 1) for each in args))
        case ast.Call(func=ast.Subscript(value=ast.Name(id=form), slice=window), args=args, keywords=[]) if (
            _TIMED.get(form) == len(args)
        ):
            return Node(form, tuple(_formula(each, depth + 1) for each in args), _window(window))
    raise refuse(f"has {ast.unparse(tree)[:60]!r}, which is no formula", _FORMS)


def _window(tree: ast.expr) -> tuple[float, float]:
    match tree:
        case ast.Slice(lower=ast.expr() as lower, upper=ast.expr() as upper, step=None):
            first, last = _number(lower), _number(upper)
        case ast.Tuple(elts=[lower, upper]):
            first, last = _number(lower), _number(upper)
        case _:
            raise refuse("has a window without two ends", "such as always[0:5](...)")
    if not 0.0 <= first <= last:
        raise refuse(f"has a window from {first:g} to {last:g} s", "0 <= from <= to")
    return first, last


def _number(tree: ast.expr) -> float:
    value = tree.value if isinstance(tree, ast.Constant) else None
    if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= _LARGEST:
        return float(value)
    raise refuse(f"has {ast.unparse(tree)[:60]!r}", "a number")


def _comparison(tree: ast.Compare, depth: int) -> Node:
    """Each pair of neighbours of `a < b < c`."""
    values = [_value(value, depth + 1) for value in (tree.left, *tree.comparators)]
    pairs = []
    for operator, left, right in zip(tree.ops, values, values[1:], strict=False):
        sign = _COMPARED.get(type(operator))
        if sign is None:
            raise refuse(f"compares by {type(operator).__name__}", "<, <=, > or >=")
        pairs.append(Node("above", (left, right) if sign == ">" else (right, left)))
    return pairs[0] if len(pairs) == 1 else Node("and", tuple(pairs))


def _value(tree: ast.expr, depth: int) -> Node:
    """A part that is a number at each time."""
    if depth > _DEEPEST:
        raise refuse("is nested too deep", f"at most {_DEEPEST} levels")
    match tree:
        case ast.Name(id=name):
            return Node("column", name=name)
        case ast.Constant():
            return Node("number", value=_number(tree))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return Node("-", (Node("number"), _value(operand, depth + 1)))
        case ast.BinOp(op=op, left=left, right=right) if type(op) in _ARITHMETIC:
            return Node(_ARITHMETIC[type(op)], (_value(left, depth + 1), _value(right, depth + 1)))
        case ast.Call(func=ast.Name(id="abs"), args=[inner], keywords=[]):
            return Node("abs", (_value(inner, depth + 1),))
    raise refuse(f"has {ast.unparse(tree)[:60]!r}, which is no number", "columns, numbers, + - * / and abs")
