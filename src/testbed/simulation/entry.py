"""Fly a whole scenario: a loop over a `Session` to which nothing is done."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from testbed.controllers.setup import Setup
from testbed.reporting.flight import ReportedFlight
from testbed.scenario.model import Scenario
from testbed.simulation.session import Session

Watch = Callable[[float, np.ndarray], object]
"""Looks at a flight while it is flown: called with time [s] and row of truth of each control step."""


def fly(
    scenario: Scenario | str | Path,
    controller: Callable[[Setup], Any] | None = None,
    *,
    set: Mapping[str, Any] | None = None,
    watch: Watch | None = None,
) -> ReportedFlight:
    """Fly a scenario. The same scenario, aircraft and controller give the same flight, to the last bit.

    Nothing is written; `ReportedFlight.save` writes a run folder as `testbed run` does.

    Args:
        scenario: the path of a scenario's YAML file, or a `Scenario`; a shipped file is found from any folder.
        controller: a class of your own that flies in place of the scenario's controller. It has
            `__init__(self, setup)` and `update(self, time_s, state, reference)`, as `examples/my_controller.py` shows.
        set: settings to change, as `--set` does: {"sensors": "mems", "failures.0.value": 0.5}, by dotted paths.
        watch: called in each control step with its time [s] and its row of truth (see `flight.columns.Recorded`), which it must
            not change; it may wait, so that the flight is shown in real time.

    Returns:
        The finished flight: `passed`, `outcome`, `log` (a DataFrame), `events`, `metrics`, `requirements`, `plot()`, `save()`.
        An aircraft that is lost is an outcome, not an exception.

    Raises:
        BadInput: the scenario, a name in it, its aircraft, or your controller cannot be used.
    """
    with Session(scenario, controller, set=set) as session:
        loop = session.loop  # its steps prepare nothing for what could be done to the flight
        while loop.outcome is None:
            loop.advance(loop.steps if watch is None else loop.done + 1)
            if watch is not None:
                watch((loop.done - 1) / loop.parts.scenario.rate_hz, loop.rows.truth[loop.done - 1])
        flight, plan = session.flight(), session.parts.plan
    return replace(flight, files=plan.files()) if plan.has_folder else flight
