"""The meaning of each log column, by patterns of names. A column without a meaning stops the build of the site."""

from __future__ import annotations

import re

from testbed.common.signals import Belief

_WORDS = "; ".join(f"{code.value} *{code.name}*: {code.meaning.replace('; ', ', ')}" for code in Belief)
_MEANINGS = (
    (r"time_s", "Time since the start of the flight."),
    (r"north_m|east_m", "True position relative to the start of the flight."),
    (r"altitude_m", "True altitude of the centre of gravity above mean sea level."),
    (r"airspeed_m_s", "True airspeed, gusts included."),
    (r"climb_rate_m_s", "True rate of climb over the ground."),
    (r"roll_deg", "True roll angle, positive right."),
    (r"pitch_deg", "True pitch angle, positive nose up."),
    (r"heading_deg", "True heading from north, 0 to 360, positive nose right."),
    (r"alpha_deg", "True angle of attack, gusts included."),
    (r"beta_deg", "True sideslip, positive with the wind from the right, gusts included."),
    (r"[pqr]_deg_s", "True body rate: p roll, q pitch, r yaw."),
    (r"\w+_command_(m|m_s|deg)", "Reference that the controller follows: it approaches the command at `command_rates`."),
    (r"[pqr]_dot_deg_s2|u_dot_m_s2", "Measured state rate: angular acceleration, or acceleration along body x."),
    (r"\w_dot_desired_\w+", "State rate that the outer loops demand."),
    (r"\w_dot_released", "1 while the axis is given up; NaN where the controller does not say."),
    (r"A_reference", "r of (6): the position that a healthy actuator would need, in the unit of the aircraft's YAML."),
    (r"A_command", "u: the position that the actuator is commanded to, in the same unit."),
    (r"A_position", "True position of the surface, or thrust of the propeller, as if fully effective, in the same unit."),
    (r"A_effectiveness", "True effectiveness: 1 is healthy, 0 is lost."),
    (r"A_effectiveness_estimate", "The controller's estimate of the effectiveness; NaN where it does not say."),
    (r"A_failed", "1 while the controller's monitor flags the actuator as failed; NaN where it does not say."),
    (r"A_belief", f"What the controller takes the actuator for; NaN where it does not say. {_WORDS}."),
    (
        r"A_believed_position",
        "Position at which a *held* actuator is thought to be, in the unit of the aircraft's YAML; NaN for others.",
    ),
    (r"\w+_measured_\w+", "Sensor reading that the controller gets."),
    (r"\w+_stuck", "1 while the controller takes this sensor for stuck; NaN where it does not say."),
    (r"\w_dot_true_\w+", "True state rate; the column without `_true` is measured."),
    (r"wind_(north|east|down)_m_s", "Velocity of the air over the ground, towards north, east, down, turbulence included."),
)  # fmt: skip


def meaning(column: str) -> str:
    """The meaning of a column; `A` stands for an actuator. Raises KeyError unless exactly one pattern fits the name."""
    found = [text for pattern, text in _MEANINGS if re.fullmatch(pattern, column)]
    if len(found) != 1:
        raise KeyError(f"{column}: {len(found)} meanings in {__file__}")
    return found[0]


def unused(columns: list[str]) -> list[str]:
    """Patterns that fit none of these columns."""
    return [pattern for pattern, _ in _MEANINGS if not any(re.fullmatch(pattern, c) for c in columns)]
