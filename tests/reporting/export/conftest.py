"""A flight with a failure in moving air, as every format writes it."""

from __future__ import annotations

from pathlib import Path

import pytest
from short_flights import scenario

from testbed.flight.flight import Flight
from testbed.simulation import fly


@pytest.fixture(scope="package")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Flight:
    """Three seconds of the v-tail in a wind from the west; a failure with a comma in its words, after 1 s."""
    failure = "{type: intermittent, actuator: left_ruddervator, at_s: 1.0, value: 0.3, on_s: 0.6, off_s: 0.6}"
    settings = [
        f"failures=[{failure}]",
        "atmosphere={wind_m_s: [0, 5, 0]}",
        "commands=[{at_s: 0.2, heading_deg: 100}]",
    ]
    return fly(scenario(Path(tmp_path_factory.mktemp("flown")), "pid", 3.0, *settings))
