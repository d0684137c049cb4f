"""Read and check a scenario before anything flies: the first step of `testbed run`, and of `testbed validate`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from testbed.scenario.load import Scenario


def checked(file: str, settings: Sequence[str] = ()) -> Scenario:
    """The scenario in a file, completely checked. Conditions that its controller is not made for are printed on stderr."""
    from testbed.scenario import conditions
    from testbed.scenario.load import load_scenario
    from testbed.simulation.check import check

    scenario = load_scenario(file, settings)
    check(scenario)
    for warning in conditions.warnings(scenario):
        print(f"WARNING: {warning}", file=sys.stderr)
    return scenario
