"""The control designer's choices for an aircraft, and their defaults: the `control` block of its YAML."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple

from testbed.inputs.base import NonNegative, Positive, Settings

Axis = Literal["p_dot", "q_dot", "r_dot", "u_dot"]
"""A state rate that can be controlled directly, by its name in `signals.RATES`."""

DERIVED: Any = None
"""Default of a setting that follows from the design model unless it is given (`controllers.scaling`)."""


class Gain(NamedTuple):
    """What is said of a gain of `Loops` in its type: where it belongs, and its value with ample authority of the actuators.

    Attributes:
        axis: whose cascade of loops it is a part of.
        ample: its value for an aircraft with ample authority and fast engines [1/s; integrals 1/s2, that of altitude as a rate of
            climb].
    """

    axis: Axis
    ample: float


class Loops(Settings):
    """Gains of the paper's outer loops [1/s unless the docstring says otherwise], and their limits.

    What is not given follows from the aircraft: the gains are those below with ample authority of the actuators, and less with
    little; V is the reference airspeed.
    """

    airspeed_kp: Annotated[NonNegative, Gain("u_dot", 0.8)] = DERIVED
    """Acceleration for an error of airspeed: 0.8, or a third of the corner of the slowest propulsor's lag if that is less."""
    airspeed_ki: Annotated[NonNegative, Gain("u_dot", 0.1)] = DERIVED
    """Acceleration for the integral of that error [1/s2]: 0.1"""
    u_dot_max: Positive = DERIVED
    """Largest acceleration that airspeed may ask for [m/s2]: 0.7, or 0.4 of the authority if that is less."""
    altitude_kp: Annotated[NonNegative, Gain("q_dot", 0.7)] = DERIVED
    """Climb rate for an error of altitude: 0.7"""
    altitude_ki: Annotated[NonNegative, Gain("q_dot", 0.18)] = DERIVED
    """Pitch for the integral of that error [rad/(m s)]: 0.18/V"""
    climb_max: Positive = DERIVED
    """Largest climb rate that altitude may ask for [m/s]: V/9, or what half of the excess thrust gives if that is less."""
    climb_kp: NonNegative = DERIVED
    """Climb rate asked for beyond that wanted, for each m/s by which the climb rate misses it [1]: makes the flight path follow
    pitch within 0.8 s, where the wing alone would be slower."""
    pitch_kp: Annotated[NonNegative, Gain("q_dot", 3.0)] = DERIVED
    """Pitch rate for an error of pitch: 3"""
    q_kp: Annotated[NonNegative, Gain("q_dot", 8.0)] = DERIVED
    """Pitch acceleration for an error of pitch rate: 8, and at least the aircraft's own damping of pitching"""
    heading_kp: Annotated[NonNegative, Gain("p_dot", 0.5)] = DERIVED
    """Turn rate for an error of heading: 0.5"""
    heading_ki: Annotated[NonNegative, Gain("p_dot", 0.02)] = DERIVED
    """Turn rate for the integral of that error [1/s2]: 0.02"""
    roll_max_deg: Positive = 30.0
    """Largest bank that heading may ask for [deg]."""
    roll_kp: Annotated[NonNegative, Gain("p_dot", 1.5)] = DERIVED
    """Roll rate for an error of bank: 1.5"""
    p_kp: Annotated[NonNegative, Gain("p_dot", 4.0)] = DERIVED
    """Roll acceleration for an error of roll rate: 4, and at least the aircraft's own damping of rolling"""
    sideslip_kp: Annotated[NonNegative, Gain("r_dot", 1.0)] = DERIVED
    """Yaw rate for sideslip: 1"""
    sideslip_ki: Annotated[NonNegative, Gain("r_dot", 0.2)] = DERIVED
    """Yaw rate for the integral of sideslip [1/s2]: 0.2"""
    r_kp: Annotated[NonNegative, Gain("r_dot", 4.0)] = DERIVED
    """Yaw acceleration for an error of yaw rate: 4, and at least the aircraft's own damping of yawing"""
    heading_error_max_deg: Positive = 20.0
    """The heading error is limited to this; likewise the next two [deg, m, m/s]."""
    altitude_error_max_m: Positive = DERIVED
    """V/3.6"""
    airspeed_error_max_m_s: Positive = DERIVED
    """V/9"""
    slow_descent_s: NonNegative = 2.0
    """Altitude that a regulator gives up for each m/s by which airspeed is more than `protect_from_m_s` below its reference, or
    below that of the design if that is less [s]."""
    protect_from_m_s: NonNegative = DERIVED
    """By default V/9."""
    fast_climb_s: NonNegative = DERIVED
    """Altitude that a regulator gains for each m/s of airspeed above its trim, if an actuator is jammed [s]: V/36. V/g would turn
    all of that airspeed into altitude, but overshoots into a stall."""
    lost_thrust_height_m: NonNegative = 8.0
    """Height that is stored as kinetic energy when one propeller of several remains [m]. It is flown faster by the difference
    between V and the root of V^2 + 2 g h. In air that sinks, the store is spent before altitude is given up: little thrust remains
    to climb with, because the tail has to balance its yawing moment, which is proportional to T/V^2."""
    lost_thrust_faster_m_s: NonNegative = DERIVED
    """In place of what `lost_thrust_height_m` gives: added to the airspeed reference when one propeller of several remains
    [m/s]."""
    lost_thrust_protect_from_m_s: NonNegative = DERIVED
    """In place of `protect_from_m_s` once a propeller has failed [m/s]. By default as much as is flown faster, so that altitude
    is given up below the reference airspeed."""


LOOP_GAINS = {
    name: entry
    for name, info in Loops.model_fields.items()
    for entry in info.metadata
    if isinstance(entry, Gain)
}
"""The gains of the outer loops, by name."""


class StateDeviations(Settings):
    """Largest acceptable deviation of each state from its reference or trim [m/s, rad, rad/s, m]; by default V/18 of airspeed and
    V/12 of altitude."""

    airspeed: Positive = DERIVED
    alpha: Positive = 0.2
    beta: Positive = 0.2
    p: Positive = 0.6
    q: Positive = 0.5
    r: Positive = 0.5
    roll: Positive = 0.4
    pitch: Positive = 0.2
    heading: Positive = 0.15
    altitude: Positive = DERIVED


class IntegralDeviations(Settings):
    """Largest acceptable integral of each error [m, m s, rad s]; by default V/3.6 of airspeed and altitude."""

    airspeed: Positive = DERIVED
    altitude: Positive = DERIVED
    heading: Positive = 0.4


class RegulatorWeights(Settings):
    """Weights of the linear-quadratic regulator by Bryson's rule: one over the square of the largest acceptable deviation."""

    states: StateDeviations = StateDeviations()
    integrals: IntegralDeviations = IntegralDeviations()
    actuator: Positive = 1.0
    """Largest acceptable deviation of an actuator from its trim position, in units of its `scale`."""


class PerRate(Settings):
    """A number for each controlled rate."""

    p_dot: Positive = DERIVED
    q_dot: Positive = DERIVED
    r_dot: Positive = DERIVED
    u_dot: Positive = DERIVED


class AllocationWeights(PerRate):
    """Weights of the least squares that says what gives way when actuators reach their stops: of a miss of each rate
    [1 per rad/s2; u_dot 1 per m/s2], and of a deviation from the trim positions [1 per unit of an actuator's `scale`].

    A miss of airspeed is made up for later, a miss of attitude may not be. The deviation decides where the rates do not. By default
    an axis weighs 1 per rad/s2, or less where it has more authority than a more important one: in units of authority, its miss
    never counts for more."""

    u_dot: Positive = 0.15
    deviation: Positive = 0.001


class GustDensity(PerRate):
    """Disturbance of each rate by gusts that the design model does not predict, as the root of its two-sided spectral density
    [rad/s2 per sqrt(Hz); u_dot m/s2 per sqrt(Hz)]; by default from the design model's derivatives by angle of attack, sideslip
    and roll rate."""


class TrimModelError(PerRate):
    """Standard deviation of the design model's error in each rate at its own trim [rad/s2; u_dot m/s2]; by default that of 0.005
    rad of angle of attack and of sideslip, and 0.1 m/s2."""


class ControlDesign(Settings):
    """Priorities and gains for one aircraft."""

    release: dict[str, tuple[Axis, ...]] = {}  # noqa: RUF012  (pydantic copies it)
    """Axes to give up when an actuator is lost, by its name; `a+b`, in the order of `actuators`, names a combination."""
    priorities: tuple[Axis, ...] = ("q_dot", "u_dot", "r_dot", "p_dot")
    """Axes by priority: the last one is given up first. Used when `release` leaves more axes than actuators."""
    condition_max: Positive = 50.0
    """A mode whose remaining scaled input matrix has a larger condition number is refused."""
    disturbance: GustDensity = GustDensity()
    """Disturbance by gusts that the weighted estimation assumes, as its measurement noise."""
    model_error_std: TrimModelError = TrimModelError()
    """Least model error that the weighted estimation assumes."""
    model_error_time_s: Positive = 10.0
    """Correlation time of the model error in the weighted estimation [s]."""
    coefficient_error: NonNegative = 0.2
    """Relative standard deviation of each coefficient of the design model that the weighted estimation assumes."""
    allocation: AllocationWeights = AllocationWeights()
    loops: Loops = Loops()
    regulator: RegulatorWeights = RegulatorWeights()
