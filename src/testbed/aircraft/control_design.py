"""What the control designer chose for an aircraft: the `control` block of its YAML."""

from __future__ import annotations

from typing import Literal

from testbed.inputs.base import NonNegative, Positive, Settings

Axis = Literal["p_dot", "q_dot", "r_dot", "u_dot"]
"""A state rate that can be controlled directly, by its name in `signals.RATES`."""


class Loops(Settings):
    """Gains of the paper's outer loops [1/s unless the docstring says otherwise], and their limits."""

    airspeed_kp: NonNegative = 0.8
    airspeed_ki: NonNegative = 0.1
    """[1/s2]"""
    u_dot_max: Positive = 0.7
    """Largest acceleration that airspeed may ask for [m/s2]."""
    altitude_kp: NonNegative = 0.7
    altitude_ki: NonNegative = 0.01
    """[rad/(m s)]"""
    climb_max: Positive = 2.0
    """Largest climb rate that altitude may ask for [m/s]."""
    pitch_kp: NonNegative = 3.0
    q_kp: NonNegative = 8.0
    heading_kp: NonNegative = 0.5
    heading_ki: NonNegative = 0.02
    """[1/s2]"""
    roll_max_deg: Positive = 25.0
    roll_kp: NonNegative = 1.5
    p_kp: NonNegative = 4.0
    sideslip_kp: NonNegative = 1.0
    sideslip_ki: NonNegative = 0.2
    """[1/s2]"""
    r_kp: NonNegative = 4.0
    heading_error_max_deg: Positive = 20.0
    """The loops see at most this error."""
    altitude_error_max_m: Positive = 5.0
    airspeed_error_max_m_s: Positive = 2.0
    slow_descent_s: NonNegative = 2.0
    """Height that a regulator gives up for each m/s that airspeed is more than `protect_from_m_s` too low [s]."""
    protect_from_m_s: NonNegative = 2.0
    lost_thrust_protect_from_m_s: NonNegative = 0.7
    """In place of `protect_from_m_s` once a propeller has failed [m/s]."""
    lost_thrust_faster_m_s: NonNegative = 1.5
    """Added to the airspeed reference when one propeller of several is left [m/s]: the yaw that its thrust makes has to
    be balanced by the tail, and falls with T/V^2."""


class StateDeviations(Settings):
    """Largest acceptable deviation of each state from its reference or trim [m/s, rad, rad/s, m]."""

    airspeed: Positive = 1.0
    alpha: Positive = 0.2
    beta: Positive = 0.2
    p: Positive = 0.6
    q: Positive = 0.5
    r: Positive = 0.5
    roll: Positive = 0.4
    pitch: Positive = 0.2
    heading: Positive = 0.15
    altitude: Positive = 1.5


class IntegralDeviations(Settings):
    """Largest acceptable integral of each error [m, m s, rad s]."""

    airspeed: Positive = 5.0
    altitude: Positive = 5.0
    heading: Positive = 0.4


class RegulatorWeights(Settings):
    """Weights of the linear-quadratic regulator by Bryson's rule: one over the square of the largest deviation."""

    states: StateDeviations = StateDeviations()
    integrals: IntegralDeviations = IntegralDeviations()
    actuator: Positive = 1.0
    """Largest acceptable deviation of an actuator from its trim position, in units of its `scale`."""


class GustDensity(Settings):
    """What gusts do to each rate beyond the design model, as the root of a two-sided spectral density
    [rad/s2 per sqrt(Hz); u_dot m/s2 per sqrt(Hz)]."""

    p_dot: Positive = 2.0
    q_dot: Positive = 0.5
    r_dot: Positive = 0.15
    u_dot: Positive = 0.08


class TrimModelError(Settings):
    """Standard deviation of what the design model leaves out of each rate at its own trim [rad/s2; u_dot m/s2]."""

    p_dot: Positive = 0.3
    q_dot: Positive = 0.3
    r_dot: Positive = 0.1
    u_dot: Positive = 0.1


class ControlDesign(Settings):
    """Priorities and gains for one aircraft."""

    release: dict[str, tuple[Axis, ...]] = {}  # noqa: RUF012  (pydantic copies it)
    """Axes to give up when an actuator is lost; `a+b`, in the aircraft's order, names a combination."""
    priorities: tuple[Axis, ...] = ("q_dot", "u_dot", "r_dot", "p_dot")
    """Axes from the last to be given up to the first, for combinations that `release` does not list."""
    condition_max: Positive = 50.0
    """A mode whose remaining scaled input matrix has a larger condition number is refused."""
    disturbance: GustDensity = GustDensity()
    """Measurement noise of the weighted estimation."""
    model_error_std: TrimModelError = TrimModelError()
    """Least model error that the weighted estimation expects."""
    model_error_time_s: Positive = 10.0
    """How long the model's error stays about the same (correlation time) [s]."""
    coefficient_error: NonNegative = 0.2
    """Relative error to expect of each of the design model's coefficients."""
    loops: Loops = Loops()
    regulator: RegulatorWeights = RegulatorWeights()
