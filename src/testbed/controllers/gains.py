"""What the control designer chose for an aircraft: the `control` block of its YAML."""

from __future__ import annotations

from typing import Annotated

from annotated_types import Ge, Gt
from pydantic import BaseModel, ConfigDict

Positive = Annotated[float, Gt(0)]


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Loops(_Frozen):
    """Gains of the paper's PID outer loops [1/s unless the name says otherwise], and their limits."""

    airspeed_kp: float = 0.8
    airspeed_ki: float = 0.1
    u_dot_max: float = 0.7
    altitude_kp: float = 0.7
    altitude_ki: float = 0.01
    climb_max: float = 2.0
    pitch_kp: float = 3.0
    q_kp: float = 8.0
    heading_kp: float = 0.5
    heading_ki: float = 0.02
    roll_max_deg: float = 25.0
    roll_kp: float = 1.5
    p_kp: float = 4.0
    sideslip_kp: float = 1.0
    sideslip_ki: float = 0.2
    r_kp: float = 4.0
    heading_error_max_deg: float = 20.0
    altitude_error_max_m: float = 5.0
    airspeed_error_max_m_s: float = 2.0
    slow_descent_s: float = 2.0
    """Height that a regulator gives up for each m/s that airspeed is more than `protect_from_m_s` low [s]."""
    protect_from_m_s: float = 2.0
    lost_thrust_protect_from_m_s: float = 0.7
    """The same with a propeller lost [m/s]."""
    lost_thrust_faster_m_s: float = 1.5
    """Airspeed to add to the reference with one propeller left: the yaw of it grows with T/V^2 [m/s]."""


class RegulatorWeights(_Frozen):
    """Largest acceptable deviation of each state, integral and scaled actuator (Bryson's rule)."""

    states: dict[str, Positive] = {
        "airspeed": 1.0, "alpha": 0.2, "beta": 0.2, "p": 0.6, "q": 0.5, "r": 0.5,
        "roll": 0.4, "pitch": 0.2, "heading": 0.15, "altitude": 1.5,
    }  # fmt: skip
    integrals: dict[str, Positive] = {"airspeed": 5.0, "altitude": 5.0, "heading": 0.4}
    actuator: Positive = 1.0


class ControlDesign(_Frozen):
    """Priorities and gains for one aircraft.

    Attributes:
        release: axes given up when an actuator is lost; `a+b` names a combination.
        priorities: axes from the last to be given up to the first, for combinations not listed.
        condition_max: scaled condition number above which a mode is refused.
        disturbance: what gusts do to each rate beyond the design model, as the root of a two-sided spectral density
            [rad/s2 or m/s2 per sqrt(Hz)]; the weights of weighted estimation.
        doubt: standard deviation of what the design model leaves out of each rate even at its trim [rad/s2 or m/s2].
        doubt_s: how long that stays about the same [s].
        model_doubt: relative error to expect of each of the design model's coefficients.
    """

    release: dict[str, list[str]] = {}
    priorities: list[str] = ["q_dot", "u_dot", "r_dot", "p_dot"]
    condition_max: Positive = 50.0
    disturbance: dict[str, Positive] = {"p_dot": 2.0, "q_dot": 0.5, "r_dot": 0.15, "u_dot": 0.08}
    doubt: dict[str, Positive] = {"p_dot": 0.3, "q_dot": 0.3, "r_dot": 0.1, "u_dot": 0.1}
    doubt_s: Positive = 10.0
    model_doubt: Annotated[float, Ge(0)] = 0.2
    loops: Loops = Loops()
    regulator: RegulatorWeights = RegulatorWeights()
