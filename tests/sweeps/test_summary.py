"""What a sweep says: right draws, the drivers that were put in, the worst runs, the report."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from scipy import stats
from sweep_files import SWEEP, table, written
from sweep_flights import bad, quick

import testbed
from testbed.sweeps.drawing.distributions import Distribution
from testbed.sweeps.drawing.sampling import batch as block
from testbed.sweeps.drawing.sampling import hashed
from testbed.sweeps.plan import load_sweep
from testbed.sweeps.sensitivity import sensitivity
from testbed.sweeps.summary import worst

DRAWS: list[tuple[dict[str, object], Any]] = [
    ({"uniform": [4, 10]}, stats.uniform(4, 6)),
    ({"normal": [1.0, 0.1]}, stats.norm(1.0, 0.1)),
    ({"log_uniform": [0.1, 10]}, stats.loguniform(0.1, 10)),
    ({"weibull_min": {"c": 1.5, "scale": 2}}, stats.weibull_min(1.5, scale=2)),
    ({"triang": [0.3, 1, 2]}, stats.triang(0.3, 1, 2)),
]


@pytest.mark.parametrize("sampling", ["sobol", "latin_hypercube", "halton", "random"])
@pytest.mark.parametrize(("spec", "law"), DRAWS, ids=[str(list(spec)) for spec, _ in DRAWS])
def test_draws_follow_their_distribution(sampling: str, spec: dict[str, object], law: Any) -> None:
    points = block(sampling, 11, ["a", "b"], 1024, 0)
    values = Distribution.model_validate(spec).quantiles(points[:, 1])
    assert all(type(value) is float for value in values)
    assert stats.kstest(values, law.cdf).pvalue > 0.01
    assert abs(np.corrcoef(points.T)[0, 1]) < 0.1


def test_discrete_draws_have_their_weights() -> None:
    u = block("sobol", 11, ["a"], 1024, 0)[:, 0]
    choice = Distribution.model_validate({"choice": ["a", "b", "c"], "weights": [1, 0, 3]}).quantiles(u)
    assert abs(choice.count("a") - 256) <= 1 and choice.count("b") == 0
    whole = Distribution.model_validate({"integers": [3, 6]}).quantiles(u)
    assert {whole.count(k) for k in (3, 4, 5, 6)} == {256} and all(type(value) is int for value in whole)
    poisson = Distribution.model_validate({"poisson": {"mu": 4}}).quantiles(u)
    assert all(type(value) is int for value in poisson) and abs(np.mean(poisson) - 4) < 0.05


def test_extreme_draws_are_finite() -> None:
    values = Distribution.model_validate({"normal": [0, 1]}).quantiles(np.array([0.0, 1.0]))
    assert values[0] < -8 and values[1] > 8 and np.isfinite(values).all()


def test_seeds_are_fit_for_the_engine() -> None:
    """31 bits, never 0 or 1, no two alike, and neighbours uncorrelated."""
    seeds = [hashed(7, "run", i) for i in range(5000)]
    assert min(seeds) >= 2 and max(seeds) < 2**31 and len(set(seeds)) == 5000
    assert abs(np.corrcoef(seeds[:-1], seeds[1:])[0, 1]) < 0.05
    assert hashed(7, "run", 1) != hashed(7, "draw", 1) != hashed(71, "run")


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


@pytest.fixture(scope="module")
def answered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("answered")
    testbed.sweep(written(folder), folder / "out", runs=150, jobs=2, fly=quick, save_logs="none")
    return folder / "out"


def test_the_summary_counts_the_table(answered: Path) -> None:
    summary = json.loads((answered / "summary.json").read_text())
    frame = table(answered)
    for variant in summary["variants"]:
        rows = frame[frame["controller.type"] == variant["label"]]
        share = variant["all_requirements"]
        assert (share["successes"], share["n"]) == (rows["passed"].sum(), len(rows))
        assert share["exact_low"] <= share["low"] <= share["estimate"] <= share["high"] <= share["exact_high"]
        assert variant["requirements"][0]["successes"] == rows["requirements.0.passed"].sum()
        largest = variant["metrics"]["altitude_error_max_m"]
        assert largest["largest"] == rows["altitude_error_max_m"].max()
        assert largest["tolerance_bounds"]["0.95"] == rows["altitude_error_max_m"].nlargest(3).iloc[-1]
        inputs = variant["sensitivity"]["passed"]["inputs"]
        assert max(inputs, key=lambda name: inputs[name]["pawn"]) == "failures.0.value"
    assert summary["pairs"][0]["difference"] == 0 and summary["pairs"][0]["p_value"] == 1
    assert summary["complete"] and summary["probabilistic"]


def test_the_worst_runs_come_first(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("failures.0.value\n0.05\n0.45\n0.4\n0.9\n0.01\n")
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    frame = testbed.sweep(written(tmp_path, text), tmp_path / "out", fly=bad)
    plan = load_sweep(tmp_path / "out/sweep.yaml")
    assert list(worst(plan, frame)["run"]) == [2, 4, 0, 1]  # no result; then by altitude error; 3 has passed
