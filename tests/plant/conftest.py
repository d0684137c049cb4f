"""Level flight of the v-tail at its reference condition."""

from __future__ import annotations

import pytest

from testbed.aircraft.description import Aircraft
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, trim


@pytest.fixture(scope="session")
def level(vtail: Aircraft) -> Trim:
    """18 m/s at 300 m, heading east."""
    return trim(Plant(vtail, 200), 18.0, 300.0)
