"""Coordinates keep the distribution of a value, and put the origin where distance is measured from."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import stats

from testbed.studies.drawing.distributions import Distribution
from testbed.studies.search.plan import Coordinate, Origin, Space, origin_at

DRAWS = np.random.default_rng(7).standard_normal(4000)
CASES: list[tuple[dict[str, Any], Any]] = [
    ({"uniform": [2, 5]}, stats.uniform(2, 3)),
    ({"normal": [1, 0.1]}, stats.norm(1, 0.1)),
    ({"log_uniform": [1, 10]}, stats.loguniform(1, 10)),
    ({"truncnorm": [0, 5, 0, 2]}, stats.truncnorm(0, 5, 0, 2)),
    ({"weibull_min": {"c": 1.5, "scale": 2}}, stats.weibull_min(1.5, scale=2)),
]


def coordinate(spec: dict[str, Any], origin: Origin = "median") -> Coordinate:
    return Coordinate("a", Distribution.model_validate(spec), origin)


@pytest.mark.parametrize(("spec", "law"), CASES)
@pytest.mark.parametrize("origin", ["median", "low", "high"])
def test_normal_coordinates_give_the_distribution(spec: dict[str, Any], law: Any, origin: Origin) -> None:
    if spec.keys() == {"normal"} and origin != "median":
        pytest.skip("a normal distribution has no end")
    if spec.keys() == {"weibull_min"} and origin == "high":
        pytest.skip("it has no upper end")
    assert stats.kstest(coordinate(spec, origin).values(DRAWS), law.cdf).pvalue > 0.001


def test_the_origin_is_the_median_or_the_end() -> None:
    spec = {"uniform": [0, 1]}
    assert [coordinate(spec, origin).nominal for origin in ("median", "low", "high")] == [0.5, 0.0, 1.0]


def test_farther_from_the_end_is_rarer() -> None:
    at = coordinate({"uniform": [0, 1]}, "high")
    for u in (0.5, -1.0, 2.0, -4.0, 8.0):
        (value,) = at.values(np.array([u]))  # P(at most this) = P(|normal| at least |u|)
        assert value == pytest.approx(2.0 * stats.norm.sf(abs(u)), rel=1e-12)


def test_the_upper_tail_is_exact_too() -> None:
    spec = {"weibull_min": {"c": 1.0, "scale": 1}}
    (value,) = coordinate(spec).values(np.array([12.0]))
    assert value == pytest.approx(-stats.norm.logsf(12.0), rel=1e-9)


def test_values_stay_within_their_ends() -> None:
    for spec in ({"uniform": [2, 5]}, {"log_uniform": [1, 10]}, {"integers": [0, 5]}):
        at = coordinate(spec)
        low, high = at.distribution.ends
        assert all(low <= value <= high for value in at.values(np.array([-40.0, -9.0, 0.0, 9.0, 40.0])))


def test_ends_of_a_range() -> None:
    uniform = Distribution.model_validate({"uniform": [0, 1]})
    assert [origin_at(uniform, value) for value in (0.0, 1.0, 0.5)] == ["low", "high", None]
    assert origin_at(Distribution.model_validate({"choice": [0, 1]}), 0.0) is None


def test_points_become_values_by_path() -> None:
    space = Space(
        (coordinate({"uniform": [0, 1]}), Coordinate("b", Distribution.model_validate({"integers": [0, 9]})))
    )
    assert len(space) == 2 and space.mirrored == ()
    assert space.values(np.zeros((2, 2))) == [{"a": 0.5, "b": 5}] * 2
    assert space.coordinates[0].beyond(-1.0) == pytest.approx(stats.norm.sf(1.0))


@pytest.mark.parametrize("origin", ["low", "high"])
@pytest.mark.parametrize("value", [0.1, 0.5, 0.88])
def test_what_is_worse_than_a_value_measured_from_its_end(origin: Origin, value: float) -> None:
    """88 % of the flights lose more than a surface that keeps 0.88 of its effect, where that is uniform from 0 to 1."""
    severity = Space((coordinate({"uniform": [0, 1]}, origin),))
    assert severity.mirrored == (0,)
    for sign in (1.0, -1.0):
        u = np.array([sign * stats.norm.isf(0.5 * value)])
        assert severity.beyond(u) == pytest.approx(value, rel=1e-6)
    assert (
        severity.coordinates[0].distance(-0.3) == 0.3
        and coordinate({"normal": [0, 1]}).distance(-0.3) == -0.3
    )


@pytest.mark.parametrize("u", [(1.2, -0.7, 0.4), (-0.5, 2.0, 0.0), (2.0, 0.1, -1.0), (0.2, 0.3, 1.8)])
def test_what_is_worse_beyond_a_flat_limit_is_as_often_drawn(u: tuple[float, ...]) -> None:
    at = np.array(u)
    draws = np.random.default_rng(11).standard_normal((400_000, 3))
    for origins in (("median",) * 3, ("high", "median", "median"), ("high", "low", "median")):
        space = Space(tuple(coordinate({"uniform": [0, 1]}, origin) for origin in origins))
        ends = [origin != "median" for origin in origins]
        worse = np.where(ends, np.abs(draws), draws) @ np.where(ends, np.abs(at), at) > at @ at
        assert space.beyond(at) == pytest.approx(worse.mean(), rel=0.06)
    assert Space((coordinate({"normal": [0, 1]}),)).beyond(np.array([-3.0])) == stats.norm.sf(3.0)
