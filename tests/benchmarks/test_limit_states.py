"""The known probabilities of the limit states, against plain sampling where that can see them."""

from __future__ import annotations

import limit_states
import numpy as np
import pytest

from testbed.reliability import failure_probability, smallest_failure

COMMON = {
    "linear": limit_states.linear(20, 0.01),
    "series": limit_states.series(5, 3, 2.0),
    "parallel": limit_states.parallel(5, 2, 1.0),
    "two_sided": limit_states.two_sided(4, 2.0, 2.3),
    "sphere": limit_states.sphere(5, 3.7),
    "quadratic": limit_states.quadratic(3, 2.0, 0.3),
    "four_branch": limit_states.four_branch(3, 2.0),
}


@pytest.mark.parametrize("name", COMMON)
def test_the_probability_is_that_of_plain_sampling(name: str) -> None:
    case = COMMON[name]
    found = failure_probability(
        case.limit_state, case.dimensions, method="plain", cov=0.01, budget=400_000, seed=3
    )
    assert found.probability == pytest.approx(case.probability, rel=4 * found.cov)


@pytest.mark.nightly
@pytest.mark.parametrize("name", COMMON)
def test_nothing_fails_nearer_than_the_distance(name: str) -> None:
    case = COMMON[name]
    found = smallest_failure(case.limit_state, case.dimensions, budget=1000)
    assert case.distance * (1 - 1e-9) <= found.distance < 1.02 * case.distance


def test_the_published_probability_of_four_branches() -> None:
    assert limit_states.four_branch().probability == pytest.approx(2.22e-3, rel=0.005)
    assert limit_states.four_branch(2, limit_states.FOUR_BRANCH_1E5).probability == pytest.approx(1e-5)


def test_a_wrong_probability_would_be_seen() -> None:
    case = COMMON["four_branch"]
    found = failure_probability(case.limit_state, 3, method="plain", cov=0.01, budget=400_000, seed=3)
    assert np.abs(found.probability / (1.1 * case.probability) - 1) > 4 * found.cov
