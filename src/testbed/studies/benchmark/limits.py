"""What *held* means in a benchmark: how far a flight may stray from its references."""

from __future__ import annotations

from typing import Any

from testbed.inputs.base import NonNegative, Positive, Settings


class Limits(Settings):
    """A flight is held if it is flown to the end and never farther from its references than this."""

    altitude_spans: NonNegative
    """Distance from the reference of altitude in wing spans, to which is added:"""
    altitude_s: NonNegative
    """how far the aircraft flies in this time [s] at the airspeed with which it begins."""
    heading_deg: Positive
    """Distance from the reference of heading [deg]."""

    def requirements(self, span_m: float, airspeed_m_s: float) -> list[dict[str, Any]]:
        """The requirements that a flight of an aircraft of this span, which begins at this airspeed, meets if it is held."""
        altitude_m = self.altitude_spans * span_m + self.altitude_s * airspeed_m_s
        return [
            {"name": "altitude", "metric": "altitude_error_max_m", "at_most": float(f"{altitude_m:.6g}")},
            {"name": "heading", "metric": "heading_error_max_deg", "at_most": self.heading_deg},
        ]
