"""Formulas against their definition by brute force, against rtamt, and in a flight; and what is none is refused."""

from __future__ import annotations

import itertools
import math
import sys
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError
from scenario_files import GOOD, problems_of

import testbed
from testbed.flight.requirements import formula_robustness, judge
from testbed.scenario.requirement import Requirement, parse

RATE_HZ, ROWS = 2.0, 60


def log(seed: int) -> dict[str, np.ndarray]:
    x, y = np.random.default_rng(seed).standard_normal((2, ROWS)).cumsum(axis=1)
    return {"time_s": np.arange(ROWS) / RATE_HZ, "x": x, "y": y}


def first(text: str, seed: int = 0) -> float:
    return float(formula_robustness(parse(text), log(seed), RATE_HZ)[0])


@pytest.mark.parametrize("seed", range(3))
def test_by_brute_force(seed: int) -> None:
    x, y = (log(seed)[name] for name in "xy")
    assert first("x > 2", seed) == x[0] - 2
    assert first("always(-1 < x - 2*abs(y)/4 <= 5)", seed) == pytest.approx(
        min(min(a - abs(b) / 2 + 1, 5 - (a - abs(b) / 2)) for a, b in zip(x, y, strict=True))
    )
    assert first("eventually[1:3](x >= y)", seed) == max((x - y)[2:7])
    assert first("always[0:4](implies(x > 0, eventually[0.5:2](y > x)))", seed) == min(
        max(-x[k], max((y - x)[k + 1 : k + 5])) for k in range(9)
    )
    assert first("always(eventually[0:2](x > 0))", seed) == min(max(x[k : k + 5]) for k in range(ROWS - 4))
    assert first("not (x > 0 and y > 0) or always(x > y)", seed) == max(-min(x[0], y[0]), min(x - y))


@pytest.mark.parametrize("seed", range(3))
def test_until_by_brute_force(seed: int) -> None:
    """g at some time of the window, and f at all times before; the same without an end."""
    x, y = (log(seed)[name] for name in "xy")

    def until(k: int, ahead: range) -> float:
        return max(min([(y - 1)[k + j], *(x + 2)[k : k + j]]) for j in ahead)

    bounded = formula_robustness(parse("until[0.5,3](x > -2, y > 1)"), log(seed), RATE_HZ)
    assert bounded.tolist() == [until(k, range(1, 7)) for k in range(ROWS - 6)]
    endless = formula_robustness(parse("until(x > -2, y > 1)"), log(seed), RATE_HZ)
    assert endless.tolist() == [until(k, range(ROWS - k)) for k in range(ROWS)]
    assert first("always[0:4](until[0:2](x > y, y > 0))", seed) == min(
        max(min([y[k + j], *(x - y)[k : k + j]]) for j in range(5)) for k in range(9)
    )
    assert len(formula_robustness(parse("until[0:90](x > y, y > 0)"), log(seed), RATE_HZ)) == 0


@pytest.mark.skipif(sys.version_info >= (3, 13), reason="rtamt's parser does not run on Python 3.13")
@pytest.mark.filterwarnings("ignore:typing.io:DeprecationWarning")
@pytest.mark.parametrize("seed", range(3))
def test_agrees_with_rtamt(seed: int) -> None:
    """Its windows are in rows, and it writes -> for implies."""
    import rtamt

    ours = "always[0:10](implies(x > 0, eventually[0,4](y - x > 1)) and (not (y > 20) or until[2:3](x < 9, y < 5)))"
    theirs = "always[0:20]((x > 0 -> eventually[0,8](y - x > 1)) and (not (y > 20) or ((x < 9) until[4:6] (y < 5))))"
    specification = rtamt.StlDiscreteTimeSpecification()
    for name in "xy":
        specification.declare_var(name, "float")
    specification.spec = theirs
    specification.parse()
    given = {"time": list(range(ROWS)), **{name: log(seed)[name].tolist() for name in "xy"}}
    assert first(ours, seed) == specification.evaluate(given)[0][1]


def test_it_is_judged_as_other_requirements_are() -> None:
    same = {"signal": "x", "at_least": -100.0, "scale": 50.0}
    given = [Requirement.model_validate(one) for one in ({"formula": "always(x >= -100)", "scale": 50}, same)]
    formula, signal = judge(given, log(1), {}, 30.0)
    assert formula["value"] == signal["margin"] and formula["robustness"] == signal["robustness"]
    assert formula["passed"] and formula["name"] == "always(x >= -100)"
    late = Requirement(formula="always[0:30](x > -100)")
    (verdict,) = judge([late], log(1), {}, 60.0)  # the log has no row at 30 s
    assert not verdict["passed"] and "ended before" in verdict["reason"] and verdict["robustness"] < 0
    (verdict,) = judge([Requirement(formula="x / 0 > 1")], log(1), {}, 30.0)
    assert not verdict["passed"] and verdict["reason"] == "not a number in this flight"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("__import__('os').system('x') > 1", "which is no number"),
        ("x.y > 1", "which is no number"),
        ("x", "which is no formula"),
        ("always(x)", "which is no formula"),
        ("always[0:](x > 1)", "without two ends"),
        ("always[5:2](x > 1)", "from 5 to 2 s"),
        ("always[1, 2, 3](x > 1)", "without two ends"),
        ("always[5](x > 1)", "without two ends"),
        ("until(x > 1)", "which is no formula"),
        ("always(x > 1, x > 2)", "which is no formula"),
        ("always[0:x](x > 1)", "expected a number"),
        ("x == 1", "compares by Eq"),
        ("x > True", "expected a number"),
        ("x > 'a'", "expected a number"),
        ("x ** 9 > 1", "which is no number"),
        ("(lambda: x)() > 1", "which is no number"),
        ("x >", "is no formula"),
        ("not " * 40 + "x > 1", "nested too deep"),
        ("x > 1 " * 200, "characters"),
    ],
)
def test_what_is_no_formula_is_refused_and_nothing_is_run(text: str, words: str) -> None:
    with pytest.raises(ValidationError, match=words):
        Requirement(formula=text)


def test_in_a_scenario(tmp_path: Path) -> None:
    file = tmp_path / "good.yaml"
    file.write_text(GOOD)
    asked = (
        ("always(rol_deg < 9)", "unknown signal 'rol_deg', did you mean roll_deg?"),
        ("always[0:70](roll_deg < 9)", "70 s is not within the flight"),
    )
    for text, words in asked:
        (problem,) = (
            problems_of(file, f"requirements=[{{formula: '{text}'}}]") if "70" in text else named(file, text)
        )
        assert words in str(problem) and "requirements.0.formula" in str(problem)
    assert any(
        "beside a formula" in str(p)
        for p in problems_of(file, "requirements=[{formula: 'roll_deg < 9', at_most: 2}]")
    )


def named(file: Path, text: str) -> tuple[object, ...]:
    with pytest.raises(testbed.BadInput) as caught:
        testbed.fly(
            file, set={"requirements": [{"formula": text}], "duration_s": 0.5, "commands": [], "failures": []}
        )
    return caught.value.problems


def test_no_formula_takes_long() -> None:
    """The largest window in the longest log costs no more than the log."""
    x = np.zeros(200_000)
    nested = "always[0:100](" * 5 + "x > 1" + ")" * 5
    found = formula_robustness(parse(nested), {"time_s": x, "x": x}, 200.0)
    assert len(found) == 200_000 - 5 * 20_000 and math.isclose(found[0], -1.0)
    assert not list(itertools.filterfalse(lambda v: v == -1.0, found[:100]))
