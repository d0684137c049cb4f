"""What the benchmarks of section 4 of the paper count; and the fourth remark after (32), flown."""

from __future__ import annotations

import numpy as np
import prediction_errors
import pytest
import section4_bias
import section4_flights
import section4_jacobian
import section4_survivable


def test_alarms_are_counted_after_the_persistence() -> None:
    """Below for more than 0.1 s at 200 Hz is 21 steps; two excursions, of which one is too short."""
    estimate = np.ones(200)
    estimate[10:31], estimate[50:70] = 0.5, 0.5
    assert section4_flights.alarms(estimate, 0.6, 0.1) == 1
    assert section4_flights.alarms(estimate, 0.6, 0.0) == 2
    assert section4_flights.alarms(estimate, 0.4, 0.0) == 0


def test_the_range_of_survivable_factors_ends_at_the_first_that_is_not() -> None:
    flown = [(0.5, True), (0.8, False), (0.9, True), (1.1, True), (2.0, True)]
    low, high = section4_survivable.survived(flown)
    assert (low, high) == (0.9, 2.0)
    assert section4_survivable.words(low, high, [factor for factor, _ in flown]) == "0.9 to > 2"


def test_the_remarks_agree_with_their_predictions() -> None:
    """The third contradicts the paper's condition both ways; the fourth flags just beyond the limit only."""
    rows = list(section4_bias.remarks())
    third = [line for line in rows if line.startswith("| 3.")]
    assert "it diverges | by n/r > 1 it ends at 2 | ends at 2.0000" in third[0]
    assert "it does not | by n/r > 1 it diverges | grows at 2.000" in third[1]
    assert rows[-1].endswith("| flagged; not |")


def test_the_fourth_remark_is_flown() -> None:
    """A bias that takes the estimates just below the threshold flags healthy propellers in JSBSim; one short of it does not."""
    *_, short, beyond = section4_jacobian.remark_4()
    assert short.endswith("| not flagged | not flagged |")
    assert "| flagged | flagged at " in beyond


def test_eq_38_flown_the_jacobian_of_a_wrong_model_is_what_e_changes_by() -> None:
    """(38) with estimates at the truth: its last term, integrated with the rolling of the flight, is e within 10 %.

    With the model as it is the term is zero, and e a fifth of that.
    """
    predicted, flown = section4_jacobian.changes_of_e(section4_jacobian.flown("Cl_p", 0.5), "Cl_p", 0.5)
    size = np.sqrt(np.square(predicted).mean())
    assert np.sqrt(np.square(flown).mean()) == pytest.approx(size, rel=0.1)
    assert np.sqrt(np.square(flown - predicted).mean()) < 0.15 * size
    nothing, left = section4_jacobian.changes_of_e(section4_jacobian.flown("Cl_p", 1.0), "Cl_p", 1.0)
    assert not nothing.any() and np.sqrt(np.square(left).mean()) < 0.25 * size


def test_errors_are_relative_to_the_prediction() -> None:
    pairs = [(2.0, 1.0), (1.0, 1.1), (1.0, float("inf")), (float("nan"), 1.0)]
    assert prediction_errors.relative_errors(pairs) == pytest.approx([-0.5, 0.1])
    *_, line = prediction_errors.summary({"gain": pairs})
    assert line == "| gain | 2 | 30.0 % | -50.0 % | +10.0 % |"
