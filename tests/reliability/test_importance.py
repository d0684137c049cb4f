"""Importance sampling: what it gains on limit states that suit it, and that it knows those that do not."""

from __future__ import annotations

import limit_states
import numpy as np
import pytest
from scipy import stats

from testbed.reliability import failure_probability
from testbed.reliability.mixture import AboutPoints

LINEAR = limit_states.linear(20, 1e-5)


def importance(case: limit_states.Case, seed: int = 0, **given: object):
    return failure_probability(
        case.limit_state, case.dimensions, seed=seed, **{"method": "importance", **given}
    )


def test_about_a_design_point_it_needs_few_evaluations() -> None:
    found = [importance(LINEAR, seed) for seed in range(8)]
    assert all(one.method == "importance" and one.converged and one.cov < 0.2 for one in found)
    assert all(one.probability == pytest.approx(1e-5, rel=0.5) for one in found)
    assert max(one.evaluations for one in found) < 3600


def test_the_design_point_is_that_of_a_half_space() -> None:
    found = importance(LINEAR)
    assert found.distance == pytest.approx(LINEAR.distance, rel=0.01)
    assert found.design_point == pytest.approx(np.full(20, LINEAR.distance / np.sqrt(20)), abs=0.3)


@pytest.mark.parametrize(
    "case", [limit_states.sphere(20, 7.6), limit_states.parallel(20, 5, 1.3)], ids=["sphere", "corner"]
)
def test_failures_all_around_and_heavy_weights_are_left_to_subset_simulation(case: limit_states.Case) -> None:
    found = [importance(case, seed) for seed in range(5)]
    assert all(one.method == "subset" and one.reason.startswith("Not by importance") for one in found)
    assert sum(one.interval[0] <= case.probability <= one.interval[1] for one in found) >= 4


def test_more_regions_than_it_can_see_are_not_forgotten() -> None:
    """With ten alike regions the draws that lead to failures are alone in theirs: others must be missing."""
    case = limit_states.series(20, 10, 4.5)
    found = [importance(case, seed) for seed in range(10)]
    assert sum(one.interval[0] <= case.probability <= one.interval[1] for one in found) >= 8
    assert any("alone in their region" in one.reason for one in found)


def test_weights_are_the_ratio_of_the_densities() -> None:
    centres = np.array([[1.0, 2.0], [-1.0, 0.5]])
    mixture = AboutPoints(centres, np.array([0.3, 0.7]))
    points = np.random.default_rng(1).standard_normal((6, 2))
    densities = [stats.multivariate_normal(centre).pdf(points) for centre in centres]
    expected = stats.multivariate_normal(np.zeros(2)).pdf(points) / (0.3 * densities[0] + 0.7 * densities[1])
    assert np.exp(-mixture.log_ratio(points)) == pytest.approx(expected)
    drawn = mixture.draw(20_000, np.random.default_rng(2))
    assert np.exp(-mixture.log_ratio(drawn)).mean() == pytest.approx(1, abs=0.1)
