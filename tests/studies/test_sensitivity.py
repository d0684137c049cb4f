"""The inputs that matter are found, and those that do not are not."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from testbed.studies.summary import sensitivity


def test_the_inputs_that_matter_are_found() -> None:
    rng = np.random.default_rng(3)
    frame = pd.DataFrame({"a": rng.random(600), "b": rng.choice(["x", "y"], 600), "c": rng.random(600)})
    frame["passed"] = (frame["a"] > 0.6) | ((frame["b"] == "y") & (frame["a"] > 0.3))
    frame["error"] = 3 * frame["a"] + (frame["b"] == "y") + 0.1 * rng.standard_normal(600)
    found = sensitivity(frame, ["a", "b", "c"], ["passed", "error"])
    for output in ("passed", "error"):
        inputs = found[output]["inputs"]
        assert [inputs[n]["matters"] for n in "abc"] == [True, True, False]
        assert inputs["a"]["pawn"] > inputs["b"]["pawn"] > inputs["c"]["pawn"]
    # variance 9/12 of 9/12 + 1/4 + 0.01: closed form of the first-order index
    assert found["error"]["inputs"]["a"]["s1"] == pytest.approx(0.75 / 1.01, abs=0.06)
    assert found["error"]["inputs"]["b"]["s1"] == pytest.approx(0.25 / 1.01, abs=0.06)


def test_sensitivity_of_too_little_is_refused() -> None:
    frame = pd.DataFrame({"a": np.linspace(0, 1, 300), "passed": [True] * 295 + [False] * 5})
    assert "fewer than 10 flights differ" in sensitivity(frame, ["a"], ["passed"])["passed"]["reason"]
    assert "at least 20" in sensitivity(frame[:19], ["a"], ["passed"])["passed"]["reason"]
    assert "fewer than 5 flights differ" in sensitivity(frame[:59], ["a"], ["passed"])["passed"]["reason"]
    assert sensitivity(frame.assign(a=1.0), ["a"], ["passed"])["passed"]["reason"] == "nothing varies"


@pytest.mark.parametrize("runs", [20, 45, 60, 75, 99])
def test_few_runs_give_an_indicative_answer(runs: int) -> None:
    """The input that decides is found, without an index that needs more runs."""
    rng = np.random.default_rng(runs)
    frame = pd.DataFrame({"a": rng.random(runs), "b": rng.random(runs)})
    frame["passed"] = frame["a"] > 0.5
    found = sensitivity(frame, ["a", "b"], ["passed"])["passed"]
    assert found["indicative"] and found["inputs"]["a"]["matters"]
    assert found["inputs"]["a"]["pawn"] > 2.0 * found["inputs"]["b"]["pawn"]
    assert np.isnan(found["inputs"]["a"]["s1"])
