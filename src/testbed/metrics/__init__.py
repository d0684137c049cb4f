"""Numbers that say how a controller coped, each a function of a finished flight's readings, judged by truth.

Adding a metric is one function in the module of its subject and its name in that module's TABLE. Its name
ends in its unit (counts and ratios have none); the first line of its docstring is its definition, which
`list` and the report print. A metric without a value in a flight (no detection, no delay) is NaN.
"""

from __future__ import annotations

from collections.abc import Callable

from testbed.metrics import effort, estimation, monitoring, tracking
from testbed.metrics.flight_view import Readings, adaptation_rates, readings

__all__ = ["TABLE", "Metric", "Readings", "adaptation_rates", "measure", "readings"]

Metric = Callable[[Readings], float]

TABLE: dict[str, Metric] = {
    function.__name__: function
    for function in (*tracking.TABLE, *monitoring.TABLE, *estimation.TABLE, *effort.TABLE)
}


def measure(readings: Readings) -> dict[str, float]:
    """Every metric of the table."""
    return {name: metric(readings) for name, metric in TABLE.items()}
