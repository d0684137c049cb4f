"""The trim of a control mode: which steady flight of the design model to fly after a failure.

After a loss of effectiveness the flight stays near the reference airspeed. A jammed actuator has a force of its own, which only
some airspeeds and path angles balance. So all of them are searched, and the flight with the most margin to the stops is taken.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from testbed.aircraft.control_design import Loops
from testbed.aircraft.design_model import DesignModel
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft
from testbed.controllers.inversion.steady_flights import (
    SteadyFlight,
    at_airspeeds,
    at_path_angles,
    level,
    path_angles,
)
from testbed.controllers.records import AIRSPEED, ALPHA, BETA, ROLL

_BEYOND_STOPS = 1.3
"""Factor on the stops within which a trim is accepted as a last resort. A model with errors of 20 % can place a trim that far
off, and regulating about a trim near the true one is better than having none."""
_BETA_MAX = 0.4
"""Sideslip [rad] beyond which a solution is no plausible trim: the design model is linear there, the aircraft is not. With 0.35 an
aerosonde with its rudder at its stop has no trim, and turns."""
_BANK_MAX = 0.35
"""Bank [rad] beyond which a straight flight is no plausible trim: there the model's side force, linear in sideslip, carries the
aircraft."""
_WINGS_LEVEL = 0.03
"""Bank [rad] up to which the wings are level, which a mode that does not control pitch must have. Where it has level flights only
with more, one at another airspeed without is preferred: the linear model balances pitch by the drag of a sideslip, and the
aircraft does not. Where pitch is controlled bank is no such balance, and a rudder that is jammed by a degree needs some."""
_ANGLE = 0.1
"""Angle of attack [rad] below the stall that is as good a margin as one scaled unit of an actuator. Gusts take both."""
_AIRSPEEDS = np.linspace(0.55, 1.8, 51)
"""Searched after a jam, in units of the reference airspeed. Drag balances a propeller at full throttle at 1.4 of it, and at up to
1.8 on a model with errors of 20 %."""
_PATH_ANGLES = np.linspace(-0.16, 0.16, 17)  # rad, searched after a jam if level flight has too little margin
_MARGIN_OF_LEVEL_FLIGHT = 0.15
"""Scaled margin that the best level trim must have after a jam, or flights that are not level are searched too: with less, the
model's error decides whether there is a level trim.

It is asked of the best one alone. Asked of each, it would exclude the trims at some airspeeds by the estimated position of the jam,
and so decide by an uncertain number whether the aircraft has to slow down."""
_MARGIN_TO_DESCEND = 0.3
"""Scaled margin that level flight must have after a jam, or the aircraft is too fast: it has no margin to descend with."""
_NEARLY_LEVEL = 0.03
"""With a stuck motor, a flight whose path angle [rad] is smaller than this is taken for level: this is a third of an aircraft's
drag over its weight. Altitude is held then, and given up only while the aircraft is too slow."""
_ROUNDING = 1e-9  # added to a scaled margin, so that a position exactly at its stop is within it
_MARGIN_ENOUGH = 1.0  # scaled margin beyond which more is no better
_MARGIN_OF_A_GLIDE = 0.5  # the same in a descent: half of it is worth less than the altitude that it costs
_MARGIN_FOR_AIRSPEED, _MARGIN_FOR_SLOPE = 1.0, 3.0
"""Extra scaled margin that makes up for an airspeed twice the wanted one, and for a path angle of 1 rad, or in a glide for sinking
or climbing at the reference airspeed."""

_EVERYTHING = ("airspeed", "altitude", "heading")

Preference = Callable[[SteadyFlight], np.ndarray]
"""[m] how good each of m flights is; the best is the one with the highest number."""
Attempt = tuple[SteadyFlight, tuple[str, ...], Preference, float]
"""Flights, the outputs held in them, which is preferred, and the factor on the stops within which they must be."""


class NoSteadyFlight(ValueError):
    """With these actuators the design model has no steady flight, or none that can be stabilised."""


def steady_flight(
    degraded: DegradedAircraft, loops: Loops, title: str
) -> tuple[SteadyFlight, tuple[str, ...]]:
    """Steady flight with the actuators that remain, and the outputs that can be held in it.

    With three actuators or more, the flight is level at the reference airspeed, or faster if there is no trim at that. If one
    motor of several remains, the search begins `lost_thrust_faster_m_s` higher. Airspeed, altitude and heading are held.

    With two, of which at least one is a motor, the flight is level at an unknown airspeed; altitude and heading are held. So it is
    with any number of surfaces and a motor that is stuck: drag balances its thrust at one airspeed.
    Without a motor the flight is a glide; airspeed and heading are held.

    Where there is no level trim, the flight climbs or descends, at any airspeed; airspeed and heading are held, or at last
    heading alone.

    Args:
        title: what failed, for the message.

    Raises:
        NoSteadyFlight: fewer than two actuators remain, or none of these flights has a trim.
    """
    if degraded.available.sum() < 2:
        raise NoSteadyFlight(f"{title}: one actuator cannot hold altitude and heading")
    search = _after_a_jam if degraded.jammed else _after_losses
    for flights, held, preference, stop_factor in search(degraded, loops):
        flight = _best(flights.only(margins(degraded, flights, stop_factor) >= 0.0), preference)
        if flight is not None:
            return flight, held
    raise NoSteadyFlight(f"{title}: no steady flight within the stops, level, climbing or descending")


class AirspeedRange(NamedTuple):
    """Airspeeds at which a mode may be flown level [m/s].

    Attributes:
        low, high: a commanded airspeed is kept between these.
        too_fast: above this, level flight has no margin.
    """

    low: float
    high: float
    too_fast: float


def airspeed_range(degraded: DegradedAircraft, flight: SteadyFlight, held: tuple[str, ...]) -> AirspeedRange:
    """Airspeeds at which the mode with this trim may be flown.

    After a loss, any, but in a glide for want of thrust that of the trim, as where airspeed cannot be held. After a jam, those at
    which level flight has the margin of the trim, or enough of it; that of the trim where altitude cannot be held.
    """
    airspeed = float(flight.state[AIRSPEED])
    if "airspeed" not in held:
        return AirspeedRange(airspeed, airspeed, airspeed if _has_motor(degraded) else math.inf)
    glides = "altitude" not in held and not _has_motor(degraded) and not degraded.servos.all()
    if not degraded.jammed and not glides:
        return AirspeedRange(0.0, math.inf, math.inf)
    if "altitude" not in held:
        return AirspeedRange(airspeed, airspeed, airspeed)
    flights = _level_anywhere(degraded)
    margin, airspeeds = margins(degraded, flights), flights.state[:, AIRSPEED]
    needed = min(_MARGIN_ENOUGH, float(margins(degraded, flight.only(np.newaxis))[0])) - 1e-6
    roomy, flyable = airspeeds[margin >= needed], airspeeds[margin > _MARGIN_TO_DESCEND]
    too_fast = max(flyable, default=airspeed)
    fastest = degraded.model.airspeed_m_s * _AIRSPEEDS[-1]
    return AirspeedRange(
        float(min(roomy, default=airspeed)),
        float(max(roomy, default=airspeed)),
        math.inf if too_fast >= fastest - 1e-6 else float(max(too_fast, airspeed)),
    )


def _best(flights: SteadyFlight, preference: Preference) -> SteadyFlight | None:
    return flights.only(int(np.argmax(preference(flights)))) if len(flights.state) else None


def _after_losses(degraded: DegradedAircraft, loops: Loops) -> Iterator[Attempt]:
    """Attempts in the order in which they are made, when no actuator is jammed: the nearest airspeed is the best."""
    reference, motor = degraded.model.airspeed_m_s, _has_motor(degraded)
    around = reference + np.array([0.0, -2.0, 2.0, -4.0, 4.0, 8.0])
    if degraded.available.sum() < 3 or not motor:
        if motor:
            yield level(degraded, around), ("altitude", "heading"), _nearest(reference), 1.0
            yield _at_any_airspeed(degraded), ("airspeed", "heading"), _nearest_level(degraded), 1.0
        elif not degraded.servos.all():
            yield _at_any_airspeed(degraded), ("airspeed", "heading"), _nearest_level(degraded), 1.0
        yield at_airspeeds(degraded, around), ("airspeed", "heading"), _nearest(reference), 1.0
        return
    wanted = _wanted(degraded, loops)
    faster = wanted + np.array([0.0, 1.0, 2.0, 4.0, 8.0])
    near = _wings_level(degraded, at_path_angles(degraded, faster, np.zeros(5)))
    anywhere = _wings_level(degraded, _level_anywhere(degraded))
    level_flights = ((near, 1.0), (near, _BEYOND_STOPS), (anywhere, 1.0))
    at_any = [(flights, _EVERYTHING, _nearest(wanted), stops) for flights, stops in level_flights]
    at_one = _wings_level(degraded, _level_at_one(degraded)), ("altitude", "heading"), _nearest(wanted), 1.0
    yield from (*at_any, at_one) if degraded.pitch_controlled else (at_one, *at_any)
    at_paths = _wings_level(degraded, _anywhere(degraded))
    yield at_paths, ("airspeed", "heading"), _roomiest(degraded, wanted), 1.0
    yield _at_any_airspeed(degraded), ("heading",), _nearest_level(degraded), 1.0


def _after_a_jam(degraded: DegradedAircraft, loops: Loops) -> Iterator[Attempt]:
    """Attempts in the order in which they are made, when an actuator is jammed: the most margin is the best."""
    wanted = _wanted(degraded, loops)
    preference = _roomiest(degraded, wanted)
    if degraded.available.sum() < 3 or not _has_motor(degraded):
        if _has_motor(degraded):
            yield _level_at_one(degraded), ("altitude", "heading"), preference, 1.0
        elif degraded.thrusts:
            yield from _with_stuck_thrust(degraded)
        yield _at_any_airspeed(degraded), ("airspeed", "heading"), preference, 1.0
        return
    flights, one = _level_anywhere(degraded), _wings_level(degraded, _level_at_one(degraded))
    at_any, at_one = (_wings_level(degraded, flights), _EVERYTHING), (one, ("altitude", "heading"))
    in_order = (at_any, at_one) if degraded.pitch_controlled else (at_one, at_any)
    for level_flights, held in (*in_order, (flights, _EVERYTHING)):
        if margins(degraded, level_flights).max(initial=0.0) > _MARGIN_OF_LEVEL_FLIGHT:
            yield level_flights, held, preference, 1.0
    yield _wings_level(degraded, _anywhere(degraded)), ("airspeed", "heading"), preference, 1.0
    yield flights, _EVERYTHING, preference, _BEYOND_STOPS
    yield _at_any_airspeed(degraded), ("heading",), _nearest_level(degraded), 1.0


def _with_stuck_thrust(degraded: DegradedAircraft) -> Iterator[Attempt]:
    """Attempts when the only motors that give thrust are stuck: level at the airspeed that their thrust gives, or a glide."""
    yield _level_at_one(degraded), ("altitude", "heading"), _fastest, 1.0
    flights = _at_any_airspeed(degraded)
    nearly_level = flights.only(np.abs(path_angles(flights)) < _NEARLY_LEVEL)
    yield nearly_level, ("altitude", "heading"), _fastest, 1.0
    yield flights, ("airspeed", "heading"), _nearest_level(degraded), 1.0


def _at_any_airspeed(degraded: DegradedAircraft) -> SteadyFlight:
    return at_airspeeds(degraded, degraded.model.airspeed_m_s * _AIRSPEEDS)


def _level_anywhere(degraded: DegradedAircraft) -> SteadyFlight:
    return at_path_angles(degraded, degraded.model.airspeed_m_s * _AIRSPEEDS, np.zeros(len(_AIRSPEEDS)))


def _level_at_one(degraded: DegradedAircraft) -> SteadyFlight:
    """Level flights of an aircraft that has them at one airspeed only, which is an unknown."""
    return level(degraded, degraded.model.airspeed_m_s * _AIRSPEEDS[::6])


def _wings_level(degraded: DegradedAircraft, flights: SteadyFlight) -> SteadyFlight:
    """Those with `_WINGS_LEVEL`, or all where pitch is controlled."""
    return flights.only((np.abs(flights.state[:, ROLL]) < _WINGS_LEVEL) | degraded.pitch_controlled)


def _anywhere(degraded: DegradedAircraft) -> SteadyFlight:
    """Flights at every second airspeed and all path angles."""
    airspeeds, angles = np.meshgrid(degraded.model.airspeed_m_s * _AIRSPEEDS[::2], _PATH_ANGLES)
    return at_path_angles(degraded, airspeeds.ravel(), angles.ravel())


def _nearest(airspeed: float) -> Preference:
    return lambda flights: -np.abs(flights.state[:, AIRSPEED] - airspeed)


def _fastest(flights: SteadyFlight) -> np.ndarray:
    """With thrust that is stuck, the fastest level flight is the one without sideslip, and on the stable side of least drag: an
    aircraft that has become slow there has thrust to spare. Slower than least drag, altitude that is held by the elevator alone
    leaves the airspeed unstable, and the regulator's gains grow without limit: a T-6's to 4900 rad/s2 per rad."""
    return flights.state[:, AIRSPEED]


def _by_margin(degraded: DegradedAircraft, enough: float, worth: Preference) -> Preference:
    """Most margin up to `enough`, and what else is `worth` margin."""
    return lambda flights: np.minimum(margins(degraded, flights), enough) + worth(flights)


def _roomiest(degraded: DegradedAircraft, wanted: float) -> Preference:
    """Most margin, but not far from the airspeed that is wanted, nor for a steep path."""

    def worth(flights: SteadyFlight) -> np.ndarray:
        change = np.abs(flights.state[:, AIRSPEED] - wanted) / degraded.model.airspeed_m_s
        return -(_MARGIN_FOR_AIRSPEED * change + _MARGIN_FOR_SLOPE * np.abs(path_angles(flights)))

    return _by_margin(degraded, _MARGIN_ENOUGH, worth)


def _nearest_level(degraded: DegradedAircraft) -> Preference:
    """Most margin, but not for a fast descent or climb, at any airspeed: altitude is worth more."""

    def worth(flights: SteadyFlight) -> np.ndarray:
        climb = np.sin(path_angles(flights)) * flights.state[:, AIRSPEED] / degraded.model.airspeed_m_s
        return -_MARGIN_FOR_SLOPE * np.abs(climb)

    return _by_margin(degraded, _MARGIN_OF_A_GLIDE, worth)


def margins(degraded: DegradedAircraft, flights: SteadyFlight, stop_factor: float = 1.0) -> np.ndarray:
    """[m] scaled distance to the nearest stop, or to the largest plausible angle, of each of m flights; negative beyond it.

    A distance to a stop is worth what it balances of gusts, whose moments grow with airspeed. The moments of surfaces grow with its
    square, and thrust does not grow. So a distance of thrust counts less above the reference airspeed, in proportion to V_0/V, and
    one of a surface less below it, in proportion to V/V_0.

    Args:
        stop_factor: the stops are multiplied by this.
    """
    used, state = degraded.used, flights.state
    least, most = degraded.bounds(state[:, AIRSPEED])
    low = np.maximum(stop_factor * degraded.limits[:, 0], least)[:, used]
    high = np.minimum(stop_factor * degraded.limits[:, 1], most)[:, used]
    positions = flights.positions[:, used]
    airspeed_ratio = state[:, [AIRSPEED]] / degraded.model.airspeed_m_s
    worth = np.minimum(np.where(degraded.servos[used], airspeed_ratio, 1.0 / airspeed_ratio), 1.0)
    to_stops = (worth * np.minimum(positions - low, high - positions)).min(axis=1, initial=np.inf)
    to_stall = (degraded.model.stall_alpha_rad - state[:, ALPHA]) / _ANGLE
    to_sideslip = (_BETA_MAX - np.abs(state[:, BETA])) / _ANGLE
    to_bank = (_BANK_MAX - np.abs(state[:, ROLL])) / _ANGLE
    return np.minimum.reduce([to_stops, to_stall, to_sideslip, to_bank]) + _ROUNDING


def lost_thrust(model: DesignModel, failed: Sequence[int], forces: np.ndarray) -> bool:
    """Whether one motor or engine of several remains, and the failed ones give less than half of their thrust at the trim.

    Args:
        forces: [n] of each failed actuator, 0 if it is lost [rad or N]. An aircraft that has only one motor has lost none.
    """
    motors = [i for i, kind in enumerate(model.kinds) if kind != "servo"]
    lost = [i for i in motors if i in failed and forces[i] < 0.5 * model.trim[i]]
    return len(lost) > 0 and len(motors) == len(lost) + 1


def _wanted(degraded: DegradedAircraft, loops: Loops) -> float:
    """Airspeed to fly at if there is a trim: the reference, or faster with one remaining motor."""
    lost = lost_thrust(
        degraded.model, degraded.unused, degraded.effective * degraded.positions * degraded.scale
    )
    return degraded.model.airspeed_m_s + (loops.lost_thrust_faster_m_s if lost else 0.0)


def _has_motor(degraded: DegradedAircraft) -> bool:
    """Whether a motor or engine is available."""
    return any(degraded.available[i] for i, kind in enumerate(degraded.model.kinds) if kind != "servo")
