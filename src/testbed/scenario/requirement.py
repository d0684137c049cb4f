"""A requirement of a scenario: limits of a metric, or of a logged signal in a time window; or a formula of signal temporal logic
over the columns of the log, read as data.

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

from pydantic import StrictBool, ValidationInfo, field_validator, model_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, after, refuse

_LONGEST_FORMULA = 1000
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
    if len(text) > _LONGEST_FORMULA:
        raise refuse(f"has {len(text)} characters", f"at most {_LONGEST_FORMULA}")
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


class Requirement(Settings):
    """`{metric, at_most|at_least}`, `{signal, from_s, until_s, at_most|at_least|within + of}` or `{formula}`.

    `within: 0.5, of: 300` limits the distance from a number, `of: altitude_command_m` the distance from another signal.
    Without `until_s` the time window lasts to the end of the flight. The limits hold in the whole window, unless one of
    `eventually`, `settles_by_s` and `never_for_longer_than_s` says otherwise.
    """

    name: Text | None = None
    """Title in the verdict; by default it is made from the other keys."""
    metric: Text | None = None
    """A metric of the flight; either this, `signal` or `formula`."""
    signal: Text | None = None
    """A column of the log."""
    formula: Text | None = None
    """What is to hold in time, such as `always(eventually[0:5](abs(roll_deg) < 10))`; its robustness is the value, at least 0."""
    from_s: NonNegative | None = None
    """Start of the time window of a `signal` [s]; default: start of the flight."""
    until_s: Positive | None = None
    """End of the time window [s]; default: end of the flight."""
    at_most: Number | None = None
    """Highest value allowed."""
    at_least: Number | None = None
    """Lowest value allowed."""
    within: NonNegative | None = None
    """Largest distance from `of` allowed; for a heading, the short way round."""
    of: Number | Text | None = None
    """What `within` is measured from: a number, or another column of the log."""
    eventually: StrictBool | None = None
    """True: the limits need to be kept at one instant of the window only."""
    settles_by_s: Positive | None = None
    """The limits are kept from this time on [s], to the end of the window; takes the place of `from_s`."""
    never_for_longer_than_s: Positive | None = None
    """The limits may be left, each time for no longer than this [s]."""
    scale: Positive | None = None
    """What robustness 1 is, in the unit of the signal or metric; default: the limit, or half the distance between two limits."""

    @field_validator("formula")
    @classmethod
    def _readable(cls, text: str | None) -> str | None:
        if text is not None:
            parse(text)
        return text

    _after_start = field_validator("until_s")(after("from_s"))

    @field_validator("at_least")
    @classmethod
    def _below_the_other(cls, at_least: float | None, info: ValidationInfo) -> float | None:
        at_most = info.data.get("at_most")
        if at_least is not None and at_most is not None and at_least > at_most:
            raise refuse(f"{at_least:g} is above at_most", f"at most {at_most:g}")
        return at_least

    @field_validator("of", mode="before")
    @classmethod
    def _number_or_signal(cls, of: object) -> object:
        if isinstance(of, bool) or not isinstance(of, int | float | str | None):
            raise refuse("is neither a number nor a signal", "a number or the name of a signal")
        return of

    @model_validator(mode="after")
    def _complete(self) -> Requirement:
        subjects = [key for key in ("metric", "signal", "formula") if getattr(self, key) is not None]
        if len(subjects) != 1:
            what = f"has both {' and '.join(subjects)}" if subjects else "has no subject"
            raise refuse(what, "a metric or a signal or a formula")
        if self.formula is not None:
            return self._alone()
        if self.at_most is None and self.at_least is None and self.within is None:
            raise refuse("has no limit", "at_most, at_least or within")
        if (self.within is None) != (self.of is None):
            raise refuse("has only one of within and of", "both, as in `within: 0.5, of: altitude_command_m`")
        windowed = (self.from_s, self.until_s, self.within, *self._timings.values())
        if self.metric and any(value is not None for value in windowed):
            raise refuse("asks for a window or a distance of a metric", "at_most or at_least")
        if len(self._timings) > 1:
            raise refuse(f"has {' and '.join(self._timings)}", "one of them")
        return self

    def _alone(self) -> Requirement:
        """A formula says limits and times itself."""
        given = set(self.model_dump(exclude_none=True)) - {"name", "formula", "scale"}
        if given:
            raise refuse(f"has {' and '.join(sorted(given))} beside a formula", "the formula, name and scale")
        return self

    @property
    def parsed(self) -> Node:
        """The formula."""
        return parse(str(self.formula))

    @model_validator(mode="after")
    def _in_order(self) -> Requirement:
        settled, longest = self.settles_by_s, self.never_for_longer_than_s
        if settled is not None and self.from_s is not None:
            raise refuse("has both from_s and settles_by_s", "settles_by_s alone, where the window begins")
        if settled is not None and self.until_s is not None and self.until_s <= settled:
            raise refuse(f"until_s {self.until_s:g} is not after settles_by_s", f"more than {settled:g}")
        length = math.inf if self.until_s is None else self.until_s - (self.from_s or 0.0)
        if longest is not None and longest >= length:
            raise refuse(
                f"never_for_longer_than_s {longest:g} is no shorter than its window", f"less than {length:g}"
            )
        return self

    @property
    def _timings(self) -> dict[str, float | bool]:
        """The one key, if any, that says when in the window the limits are to be kept."""
        keys = ("eventually", "settles_by_s", "never_for_longer_than_s")
        return {key: value for key in keys if (value := getattr(self, key))}

    @property
    def begins_s(self) -> float:
        """When the limits begin to apply [s]."""
        return self.settles_by_s or self.from_s or 0.0

    @property
    def longest_s(self) -> float | None:
        """Largest value allowed, where the value is a time [s]: that of settling, or the longest one outside the limits."""
        return self.settles_by_s or self.never_for_longer_than_s

    def scale_of(self, key: str) -> float:
        """What robustness 1 is for its limit `within`, `at_most` or `at_least`, in the limit's unit: `scale`, half the distance
        between two limits, or the limit itself; 1 where that is 0."""
        limit = abs(float(getattr(self, key)))
        if self.scale is not None:
            return self.scale
        if key != "within" and self.at_least is not None and self.at_most is not None:
            return (self.at_most - self.at_least) / 2.0 or limit or 1.0
        return limit or 1.0

    @property
    def limit(self) -> str:
        """The limits in words: `within 0.5 of altitude_command_m`."""
        if self.formula is not None:
            return "robustness at least 0"
        of = self.of if isinstance(self.of, str) or self.of is None else f"{self.of:g}"
        parts = [
            f"at least {self.at_least:g}" if self.at_least is not None else "",
            f"at most {self.at_most:g}" if self.at_most is not None else "",
            f"within {self.within:g} of {of}" if self.within is not None else "",
        ]
        return " and ".join(part for part in parts if part) + self._timing

    @property
    def _timing(self) -> str:
        """When in the window the limits are to be kept, in words."""
        if self.settles_by_s is not None:
            return f" from {self.settles_by_s:g} s on at the latest"
        if self.never_for_longer_than_s is not None:
            return f", never outside for longer than {self.never_for_longer_than_s:g} s"
        return " at least once" if self.eventually else ""

    @property
    def title(self) -> str:
        """Its `name`; else signal or metric, limit and window: `altitude_m within 0.5 of 300, 15 to 60 s`."""
        if self.name:
            return self.name
        if self.formula is not None:
            return self.formula
        text = f"{self.metric or self.signal} {self.limit}"
        if self.from_s is None and self.until_s is None:
            return text
        end = "the end" if self.until_s is None else f"{self.until_s:g} s"
        return f"{text}, {self.from_s or 0:g} to {end}"
