"""Results as people see them."""

from __future__ import annotations

import numpy as np

from testbed.reliability import failure_probability, smallest_failure


def tail(u: np.ndarray) -> np.ndarray:
    return 4.0 - u[:, 0]


def test_a_probability_is_one_line_and_a_table_of_its_levels() -> None:
    found = failure_probability(tail, 3)
    line, html = repr(found), found._repr_html_()
    assert line.startswith(f"<FailureProbability {found.probability:.3g} (") and "\n" not in line
    assert html.count("<tr>") == 1 + len(found.levels)
    needed = (1 - found.probability) / found.probability / found.cov**2
    assert f"Plain sampling needs about {needed:.2g} evaluations" in html


def test_what_is_not_known_is_said_first() -> None:
    found = failure_probability(lambda u: np.full(len(u), 1.0), 3, budget=500)
    assert "c.o.v. unknown" in repr(found) and "not known well: The limit state is flat" in repr(found)
    assert "Plain sampling" not in found._repr_html_()


def test_a_smallest_failure_is_one_line_and_its_way() -> None:
    found = smallest_failure(tail, 3, budget=300)
    assert repr(found).startswith("<SmallestFailure at 4")
    assert found._repr_html_().count("<tr>") == 1 + min(10, len(found.path))
    assert "not found" in repr(smallest_failure(lambda u: np.ones(len(u)), 2, budget=50))
