"""Rare failures and smallest failures of a limit state in standard normal space. Nothing here knows of flights.

A limit state takes [n, d] standard normal coordinates and returns [n] values; a value at or below 0 is a failure. The
distance of a point from the origin is then how unlikely it is: the density falls with exp(-distance^2 / 2).
`failure_probability` says how often it fails, by one of `probability.TABLE`. `smallest_failure` finds the failure
nearest to the origin. Both call the limit state with whole batches, whose points depend on the seed and on the values
returned before, and on nothing else.
"""

from __future__ import annotations

from testbed.reliability.limit_state import LimitState
from testbed.reliability.probability import failure_probability
from testbed.reliability.results import FailureProbability, Level, SmallestFailure, Step
from testbed.reliability.smallest import smallest_failure

__all__ = [
    "FailureProbability",
    "Level",
    "LimitState",
    "SmallestFailure",
    "Step",
    "failure_probability",
    "smallest_failure",
]
