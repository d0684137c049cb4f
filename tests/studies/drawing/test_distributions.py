"""Draws follow the distribution that the sweep file names."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError
from scipy import stats

from testbed.studies.drawing.distributions import Distribution, distribution_names
from testbed.studies.drawing.distributions import batch as block

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


@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        ("levy_stable", [0.001, 1]),
        ("studentized_range", [3, 10]),
        ("ksone", [1_000_000]),
        ("zipf", [1.0000001]),
    ],
)
def test_what_takes_hours_to_draw_is_refused(name: str, parameters: list[float]) -> None:
    with pytest.raises(ValidationError, match=f"{name} takes too long to draw from"):
        Distribution.model_validate({name: parameters})
    assert name not in distribution_names()


@pytest.mark.parametrize("name", ["halfnorm", "foldnorm", "expon", "rayleigh"])
def test_the_last_quantile_of_a_distribution_from_0_is_finite(name: str) -> None:
    """Those of halfnorm and foldnorm round to the quantile of 1, which is infinite."""
    given = {name: [1.0, 0.0, 2.0] if name == "foldnorm" else [0.0, 2.0]}
    law = getattr(stats, name)(*given[name])
    (last,) = Distribution.model_validate(given).quantiles(np.array([1.0]))
    assert last == pytest.approx(law.isf(2.0**-53))


@pytest.mark.parametrize("name", ["uniform", "integers", "normal", "log_uniform", "norm"])
@pytest.mark.parametrize("parameters", [[0, 10**400], [1, 1e400], [-1.7e308, 1.7e308], [-(10**308), 10**308]])
def test_numbers_beyond_a_floats_are_refused_or_drawn(name: str, parameters: list[float]) -> None:
    """YAML has whole numbers of any length; what a range of them draws must be finite."""
    try:
        drawn = Distribution.model_validate({name: parameters}).quantiles(
            np.array([0.0, 0.5, 1.0 - 2.0**-53])
        )
    except ValidationError as error:
        assert f"{name} " in str(error)
    else:
        assert np.all(np.isfinite(drawn))
