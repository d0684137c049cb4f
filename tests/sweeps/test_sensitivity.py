"""The inputs that matter are found, and those that do not are not."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

from testbed.sweeps.sensitivity import sensitivity


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
    assert "at least 100" in sensitivity(frame[:60], ["a"], ["passed"])["passed"]["reason"]
    assert sensitivity(frame.assign(a=1.0), ["a"], ["passed"])["passed"]["reason"] == "nothing varies"
