"""What each column of a log means, by patterns of their names; a column without a meaning stops the site's build."""

from __future__ import annotations

import re

_MEANINGS = (
    (r"time_s", "Time since the start of the flight."),
    (r"north_m|east_m", "True position from where the flight began."),
    (r"altitude_m", "True altitude of the centre of gravity above mean sea level."),
    (r"airspeed_m_s", "True airspeed, gusts included."),
    (r"climb_rate_m_s", "True rate of climb over the ground."),
    (r"roll_deg", "True roll angle, positive right."),
    (r"pitch_deg", "True pitch angle, positive nose up."),
    (r"heading_deg", "True heading from north, 0 to 360, positive nose right."),
    (r"alpha_deg", "True angle of attack, gusts included."),
    (r"beta_deg", "True sideslip, positive with the wind from the right, gusts included."),
    (r"[pqr]_deg_s", "True body rate: p roll, q pitch, r yaw."),
    (r"\w+_command_(m|m_s|deg)", "Reference that the controller is given: the command, approached at `command_rates`."),
    (r"[pqr]_dot_deg_s2|u_dot_m_s2", "Measured state rate: angular acceleration, or acceleration along body x."),
    (r"\w_dot_desired_\w+", "State rate that the outer loops ask for."),
    (r"\w_dot_released", "1 while the axis is given up."),
    (r"A_reference", "r of (6): the position that a healthy actuator would need, in the unit of the aircraft's YAML."),
    (r"A_command", "u: the position that the actuator is commanded to, in the same unit."),
    (r"A_position", "What the servo or the propeller does, as if it were fully effective, in the same unit."),
    (r"A_effectiveness", "True effectiveness: 1 is healthy, 0 is lost."),
    (r"A_effectiveness_estimate", "The controller's estimate of it."),
    (r"A_failed", "1 while the controller's monitor flags the actuator as failed."),
    (r"\w+_measured_\w+", "Reading of the sensor, as the controller gets it."),
    (r"\w_dot_true_\w+", "True state rate, beside the measured one."),
    (r"wind_(north|east|down)_m_s", "Velocity of the air over the ground, towards north, east, down, turbulence included."),
)  # fmt: skip


def meaning(column: str) -> str:
    """What a column means; `A` stands for an actuator. Raises KeyError for a column that nobody has explained."""
    found = [text for pattern, text in _MEANINGS if re.fullmatch(pattern, column)]
    if len(found) != 1:
        raise KeyError(f"{column}: {len(found)} meanings in {__file__}")
    return found[0]


def unused(columns: list[str]) -> list[str]:
    """Patterns that no column has."""
    return [pattern for pattern, _ in _MEANINGS if not any(re.fullmatch(pattern, c) for c in columns)]
