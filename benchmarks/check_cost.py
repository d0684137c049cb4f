"""What the checks of each flight cost a sweep: flights with and without them, in turns in one process.

    python benchmarks/check_cost.py [FLIGHTS]

The checks are those that every flight makes before it begins: that its aircraft's files are those that were loaded before in a
process of their own, and that every name in its scenario is one. Times are computing times of this process, which a busy
machine changes less than those of the clock. The share of the checks is also measured directly, by their own time.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from typing import Any
from unittest import mock

from testbed import simulation
from testbed.plant import jsbsim
from testbed.scenario.load import Scenario
from testbed.simulation import check
from testbed.studies.load import load_sweep

SWEEP = "scenarios/sweeps/left_tail_monte_carlo.yaml"
CHECKS = ((jsbsim, "assure"), (check, "unknown_names"))


def main(flights: int) -> None:
    """Print flights per second with and without the checks, what they cost, and their own time a flight."""
    plan = load_sweep(SWEEP, [f"runs={flights}"])
    scenarios = [plan.builder.scenario(plan.task(k * len(plan.variants))) for k in range(flights)]
    simulation.fly(scenarios[0])  # imports, compiled code, trimmed start
    own, used = _timed_checks(scenarios)
    without, with_checks = zip(
        *(_pair(scenario, k % 2 == 0) for k, scenario in enumerate(scenarios)), strict=True
    )
    quick = [statistics.quantiles(seconds)[0] for seconds in (without, with_checks)]
    for words, seconds in (("without checks", without), ("with checks", with_checks)):
        print(f"{words}: {1.0 / statistics.median(seconds):.2f} flights/s")
    print(
        f"cost, by the quicker quarter of {flights} flights each: {100.0 * (quick[1] / quick[0] - 1.0):+.2f} %"
    )
    print(f"own time of the checks: {1e3 * own:.2f} ms a flight, {100.0 * own / used:.3f} % of it")


def _pair(scenario: Scenario, first: bool) -> tuple[float, float]:
    """Computing time of a flight without and with checks [s]; `first` says whether that without is flown first."""
    kinds = (_without, simulation.fly) if first else (simulation.fly, _without)
    seconds = {kind: _seconds(kind, scenario) for kind in kinds}
    return seconds[_without], seconds[simulation.fly]


def _without(scenario: Scenario) -> Any:
    with mock.patch.object(*CHECKS[0], lambda *_: None), mock.patch.object(*CHECKS[1], lambda *_: []):
        return simulation.fly(scenario)


def _seconds(function: Callable[[Scenario], Any], scenario: Scenario) -> float:
    begun = time.process_time()
    function(scenario)
    return time.process_time() - begun


def _timed_checks(scenarios: list[Scenario]) -> tuple[float, float]:
    """Median computing time of the checks, and of the whole flight [s]."""
    inside: list[float] = []

    def timed(check: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any) -> Any:
            begun = time.process_time()
            try:
                return check(*arguments)
            finally:
                inside[-1] += time.process_time() - begun

        return call

    patches = [mock.patch.object(place, name, timed(getattr(place, name))) for place, name in CHECKS]
    whole = []
    for patch in patches:
        patch.start()
    for scenario in scenarios:
        inside.append(0.0)
        whole.append(_seconds(simulation.fly, scenario))
    for patch in patches:
        patch.stop()
    return statistics.median(inside), statistics.median(whole)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 40)
