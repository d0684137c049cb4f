"""To the byte: with the versions of the lock, shipped flights are those that were stored."""

from __future__ import annotations

import os

import golden
import pytest

REQUIRED = os.environ.get("GOLDEN_REQUIRED") == "1"
"""Where the lock is installed, as in `.ci/run`, a test that cannot run has failed."""


@pytest.mark.parametrize("scenario", golden.FLIGHTS)
def test_a_flight_is_the_one_that_was_stored(scenario: str) -> None:
    if (wrong := golden.differences()) and not REQUIRED:
        pytest.skip(f"bytes are promised with the versions of locks/ only: {'; '.join(wrong[:3])}")
    assert not wrong
    assert golden.digest(scenario) == golden.stored_digest(scenario), (
        "`.ci/lock --keep` stores what flies now"
    )


@pytest.mark.nightly
def test_another_kernel_is_noticed() -> None:
    """Negative control, and the reason for what is promised: a kernel without FMA rounds otherwise."""
    (scenario, *_) = golden.FLIGHTS
    assert golden.digest(scenario) != golden.digest(scenario, OPENBLAS_CORETYPE="Nehalem")
