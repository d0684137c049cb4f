"""A scenario for an adopted aircraft, written into its folder: a turn, and one surface lost on the way."""

from __future__ import annotations

from pathlib import Path

from testbed.adoption.draft import Draft, Servo
from testbed.common.writing import write_new

FILE = "first_flight.yaml"
_DURATION_S, _TURN_S, _TURN_DEG, _FAILURE_S = 60, 5, 30, 20


def write_first_flight(draft: Draft, folder: Path, name: str) -> None:
    """Write the scenario. It begins at the aircraft's reference, as every scenario does that says nothing else."""
    lost = _broken(draft).surface.name
    lines = [
        f"# A turn by {_TURN_DEG} deg in which a surface is lost. Change it, or begin scenarios of your own with it.",
        f"name: {name} without its {lost.replace('_', ' ')}",
        "aircraft: .   # this folder",
        f"duration_s: {_DURATION_S}",
        "controller: {type: adaptive_inversion}",
        "commands:",
        f"  - {{at_s: {_TURN_S}, heading_deg: {_TURN_DEG}}}",
        "failures:   # `testbed list failures` names the types",
        f"  - {{type: effectiveness, actuator: {lost}, at_s: {_FAILURE_S}, value: 0}}",
        "requirements:",
        "  - {signal: heading_deg, from_s: 30, within: 15, of: heading_command_deg}",
    ]
    write_new(folder / FILE, "\n".join(lines) + "\n")


def _broken(draft: Draft) -> Servo:
    """The first surface that rolls the aircraft, else the last of all."""
    rolling = (servo for servo in draft.servos if servo.surface.stick == "roll")
    return next(rolling, draft.servos[-1])
