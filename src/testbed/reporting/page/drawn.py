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

_REPLAYED = ("north_m", "east_m", "altitude_m", "airspeed_m_s", "roll_deg", "pitch_deg", "heading_deg")


def can_be_replayed(log: Mapping[str, np.ndarray]) -> bool:
    """Whether a log says where the aircraft was and how it lay, in more than one row: else there is no picture of it."""
    return len(log["time_s"]) > 1 and all(name in log for name in _REPLAYED)


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
