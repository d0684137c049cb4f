"""What the picture of a flight is drawn from, in a page of one flight and of several."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from testbed.aircraft.conventional_shape import conventional
from testbed.common.signals import Belief
from testbed.flight.breakage import failure_times_s
from testbed.flight.flight import Flight
from testbed.reporting.page.phases import of_flight
from testbed.reporting.panels import has_estimates


def drawn(flight: Flight, log: Mapping[str, np.ndarray]) -> dict[str, Any]:
    """Phases, failures, actuators, the words of beliefs, and the shape, as `web/src/scene.js` and `timeline.js` read them."""
    return {
        "phases": of_flight(flight),
        "failures_s": failure_times_s(flight.events),
        "actuators": flight.actuators,
        "beliefs": {belief.value: belief.name for belief in Belief},
        "estimates": has_estimates(log, flight.actuators),
        "shape": (flight.shape or conventional()).model_dump(),
    }
