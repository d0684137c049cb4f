"""Numbers that say how well a controller did in a flight, computed from the log and the events.

A metric is a function of the flight's `Readings`, and has the name of that function. The name ends in the unit; counts and
ratios have none. The first line of the docstring is its definition, which `list` and the report print. A metric that has
no value in a flight is NaN, such as a detection delay without a detection.

A new metric is one function in `functions`, and its name in the table that follows it there.

Metrics of what a controller says of itself are not judged, and are NaN, in the flight of one that does not say it (`unjudged`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping

import numpy as np

from testbed.flight.columns import unsaid
from testbed.metrics import functions
from testbed.metrics.functions import Readings, adaptation_rates, readings

__all__ = ["TABLE", "Metric", "Readings", "adaptation_rates", "measure", "metrics_of", "readings", "unjudged"]

Metric = Callable[[Readings], float]

THEMES: dict[str, tuple[Metric, ...]] = {
    "Following the references": functions.FOLLOWING,
    "Noticing failures": (*functions.OF_FLAGS, *functions.OF_RELEASES),
    "Estimating effectiveness": functions.OF_ESTIMATES,
    "Effort of the actuators": functions.EFFORT,
}
"""The metrics, by what they are about."""
TABLE: dict[str, Metric] = {metric.__name__: metric for metrics in THEMES.values() for metric in metrics}
_OF = {
    "_effectiveness_estimate": functions.OF_ESTIMATES,
    "_failed": functions.OF_FLAGS,
    "_released": functions.OF_RELEASES,
}
"""The metrics of what a controller says, by the ends of the log's columns that they need."""


def metrics_of(columns: Iterable[str]) -> set[str]:
    """The metrics that need any of these columns of the log, which the controller fills."""
    ends = {end for end in _OF for name in columns if name.endswith(end)}
    return {metric.__name__ for end in ends for metric in _OF[end]}


def unjudged(log: Mapping[str, np.ndarray]) -> set[str]:
    """The columns of a log [rows] of which the controller said nothing, and the metrics that need them."""
    silent = unsaid(log)
    return silent | metrics_of(silent)


def measure(readings: Readings) -> dict[str, float]:
    """The value of every metric in TABLE for one flight, by name."""
    silent = unjudged(readings.log)
    return {name: math.nan if name in silent else metric(readings) for name, metric in TABLE.items()}
