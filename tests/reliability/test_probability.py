"""Failure probabilities of limit states whose probability is known."""

from __future__ import annotations

import numpy as np
import pytest

import testbed
from testbed.inputs.problems import BadInput
from testbed.reliability import failure_probability


def linear(u: np.ndarray) -> np.ndarray:
    return 2.0 - u[:, 0]


def test_plain_sampling_has_the_exact_interval() -> None:
    result = testbed.failure_probability(linear, 3, method="plain", cov=0.1, budget=9000)
    assert result.converged and result.cov <= 0.1
    assert result.interval[0] < 0.0228 < result.interval[1]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"dimensions": 0}, "dimensions: is 0, expected a whole number from 1"),
        ({"dimensions": 2.5}, "dimensions: is 2.5"),
        ({"seed": -1}, "seed: is -1"),
        ({"cov": 0}, "cov: is 0, expected a number above 0"),
        ({"budget": 3}, "budget: is 3, expected a whole number from 10 on"),
        ({"method": "subsett"}, "is no method: subsett"),
        ({"limit_state": 7}, "limit_state: cannot be called"),
        ({"limit_state": lambda u: u}, "shape"),
        ({"limit_state": lambda u: None}, "limit_state: returned"),
    ],
)
def test_what_cannot_be_used_is_said(given: dict, said: str) -> None:
    arguments = {"limit_state": linear, "dimensions": 3, "method": "plain", **given}
    with pytest.raises(BadInput, match=said):
        failure_probability(**arguments)
