"""Adaptive importance sampling: curved and several failure regions, which one density about a design point does not cover."""

from __future__ import annotations

import limit_states
import numpy as np
import pytest
from scipy import stats

from testbed.reliability import failure_probability
from testbed.reliability.adaptive import ROUND
from testbed.reliability.importance import Rounds
from testbed.reliability.limit_state import Asked
from testbed.reliability.mixture import Blend, Mixture, fitted

MIXTURE = Mixture(
    np.linalg.qr(np.random.default_rng(3).standard_normal((5, 2)))[0],
    np.array([0.3, 0.7]),
    np.array([[1.0, 2.0], [-1.0, 0.5]]),
    np.array([[[1.5, 0.2], [0.2, 0.8]], [[1.0, -0.1], [-0.1, 1.2]]]),
)


def adaptive(case: limit_states.Case, seed: int = 0, **given: object):
    return failure_probability(
        case.limit_state, case.dimensions, seed=seed, **{"method": "adaptive", "budget": 8000, **given}
    )


@pytest.mark.parametrize(
    "case",
    [
        limit_states.linear(20, 1e-5),
        limit_states.quadratic(20, 4.0, 0.3),
        limit_states.two_sided(10, 4.265, 4.5),
    ],
    ids=["half space", "curved", "two regions"],
)
def test_few_evaluations_give_a_rare_failure(case: limit_states.Case) -> None:
    found = [adaptive(case, seed) for seed in range(6)]
    assert sum(one.method == "adaptive" and one.converged for one in found) >= 5
    assert sum(one.interval[0] <= case.probability <= one.interval[1] for one in found) >= 5
    assert np.median([one.probability for one in found]) == pytest.approx(case.probability, rel=0.25)
    assert np.mean([one.evaluations for one in found]) < 5000


def test_regions_that_only_the_levels_above_have_seen_are_found() -> None:
    """Four branches at 1e-5: of 500 points a level, a run loses one or two of the branches on its way."""
    case = limit_states.four_branch(2, limit_states.FOUR_BRANCH_1E5)
    found = [adaptive(case, seed) for seed in range(8)]
    assert sum(0.6 < one.probability / case.probability < 1.6 for one in found) >= 7


def test_more_regions_than_it_can_see_are_left_to_subset_simulation() -> None:
    case = limit_states.series(20, 10, 4.5)
    found = [adaptive(case, seed, budget=4000) for seed in range(8)]
    assert sum(one.interval[0] <= case.probability <= one.interval[1] for one in found) >= 7
    assert sum(one.reason.startswith("Not by importance sampling") for one in found) >= 7


def test_weights_are_the_ratio_of_the_densities() -> None:
    points = np.random.default_rng(1).standard_normal((6, 5))
    whole = np.eye(5) - MIXTURE.basis @ MIXTURE.basis.T
    densities = [
        share
        * stats.multivariate_normal(
            MIXTURE.basis @ mean, MIXTURE.basis @ covariance @ MIXTURE.basis.T + whole
        ).pdf(points)
        for share, mean, covariance in zip(MIXTURE.shares, MIXTURE.means, MIXTURE.covariances, strict=True)
    ]
    expected = np.sum(densities, axis=0) / stats.multivariate_normal(np.zeros(5)).pdf(points)
    assert np.exp(MIXTURE.log_ratio(points)) == pytest.approx(expected)
    blend = Blend([MIXTURE, MIXTURE.broad(1.7)], np.array([0.6, 0.4]))
    assert np.exp(blend.log_ratio(points)) == pytest.approx(
        0.6 * expected + 0.4 * np.exp(MIXTURE.broad(1.7).log_ratio(points))
    )
    assert np.exp(-blend.log_ratio(blend.draw(20_000, np.random.default_rng(2)))).mean() == pytest.approx(
        1, abs=0.05
    )


def test_a_mixture_is_found_again_from_its_points() -> None:
    """Three of the five directions do not matter, and are not fitted."""
    apart = Mixture(MIXTURE.basis, MIXTURE.shares, np.array([[4.0, 2.0], [-4.0, 0.5]]), MIXTURE.covariances)
    points = apart.draw(3000, np.random.default_rng(1))
    found = fitted(points, np.full(3000, 1 / 3000), 3000.0, np.random.default_rng(2))
    assert found.basis.shape == (5, 2) and len(found.shares) == 2
    means = found.means @ found.basis.T
    order = np.argsort(found.shares)
    assert found.shares[order] == pytest.approx(apart.shares, abs=0.03)
    assert means[order] == pytest.approx(apart.means @ apart.basis.T, abs=0.2)


def test_a_round_does_not_change_its_own_weights() -> None:
    """So the mean over many runs is the probability: 0.0228 of u_1 > 2, from densities that are wrong by a lot."""
    estimates = []
    for seed in range(40):
        random, asked = np.random.default_rng(seed), Asked(lambda u: 2.0 - u[:, 0], 5, 10_000)
        rounds = Rounds()
        for _ in range(2):
            rounds.draw(asked, Blend([MIXTURE.broad(1.5)], np.ones(1)), ROUND, random)
        assert rounds.drawn == len(rounds.terms) == 2 * ROUND
        estimates.append(rounds.probability)
    assert np.mean(estimates) == pytest.approx(stats.norm.sf(2.0), rel=0.06)
