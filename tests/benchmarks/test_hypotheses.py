"""Which hypothesis is the likeliest, where there is no doubt about it."""

from __future__ import annotations

import pytest
from hypotheses import HYPOTHESES, log_posterior


@pytest.mark.parametrize(
    ("lam", "offset", "named"),
    [
        (1.0, 0.0, "works"),
        (0.5, 0.0, "weak"),
        (0.0, 0.0, "lost"),
        (0.0, 3.0, "held"),
        (1.0, 3.0, "offset"),
        (-1.0, 0.0, "reversed"),
    ],
)
def test_what_is_sure_is_named(lam: float, offset: float, named: str) -> None:
    said = log_posterior(lam, 0.001, offset, 0.009, 0.01)
    assert HYPOTHESES[int(said.argmax())] == named


def test_where_the_model_may_be_more_wrong_an_offset_is_less_likely() -> None:
    works, offset = HYPOTHESES.index("works"), HYPOTHESES.index("offset")
    said = [log_posterior(1.0, 0.001, 0.5, 0.005, 0.01, size) for size in (1.0, 2.0, 4.0)]
    ratios = [each[offset] - each[works] for each in said]
    assert ratios == sorted(ratios, reverse=True) and ratios[0] > 0.0 > ratios[-1]
