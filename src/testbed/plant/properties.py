"""JSBSim's names of the signals that are read and written, and the factor from JSBSim's unit to SI."""

from __future__ import annotations

import math

from testbed.aircraft.description import AnyActuator, Servo
from testbed.common.signals import STATE
from testbed.common.units import DEGREES_PER_RADIAN, METRES_PER_FOOT, NEWTONS_PER_POUND

Property = tuple[str, float]
"""Name of a JSBSim property, and factor from its unit to SI."""

# Radii of the Earth's curvature where flights start, on the equator: north-south and east-west (WGS84).
_MERIDIAN_M, _EQUATOR_M = 6335439.327, 6378137.0

EARTH_DEG_S = math.degrees(7.292115e-5)
"""Rate at which the Earth turns (WGS84)."""

_OF: dict[str, Property] = {
    "north": ("position/lat-geod-rad", _MERIDIAN_M),
    "east": ("position/long-gc-rad", _EQUATOR_M),
    "altitude": ("position/h-sl-ft", METRES_PER_FOOT),
    "airspeed": ("velocities/vt-fps", METRES_PER_FOOT),
    "climb_rate": ("velocities/h-dot-fps", METRES_PER_FOOT),
    "roll": ("attitude/phi-rad", 1.0),
    "pitch": ("attitude/theta-rad", 1.0),
    "heading": ("attitude/psi-rad", 1.0),
    "alpha": ("aero/alpha-rad", 1.0),
    "beta": ("aero/beta-rad", 1.0),
    "p": ("velocities/p-rad_sec", 1.0),
    "q": ("velocities/q-rad_sec", 1.0),
    "r": ("velocities/r-rad_sec", 1.0),
    "p_dot": ("accelerations/pdot-rad_sec2", 1.0),
    "q_dot": ("accelerations/qdot-rad_sec2", 1.0),
    "r_dot": ("accelerations/rdot-rad_sec2", 1.0),
    "u_dot": ("accelerations/udot-ft_sec2", METRES_PER_FOOT),
    "v_dot": ("accelerations/vdot-ft_sec2", METRES_PER_FOOT),
    "w_dot": ("accelerations/wdot-ft_sec2", METRES_PER_FOOT),
}

STATE_PROPERTIES = tuple(_OF[name] for name in STATE)
"""By `signals.STATE`."""

ACCELERATIONS = tuple(_OF[name] for name in ("u_dot", "v_dot", "w_dot", "p_dot", "q_dot", "r_dot"))
"""Accelerations in body axes, all of which are zero in a trim."""

AIR_DATA = tuple(_OF[name] for name in ("airspeed", "alpha", "beta", "roll", "pitch", "heading"))
"""Motion through the air, and attitude: what the direction of a gust in body or wind axes depends on."""

AIR_AND_GROUND: tuple[Property, ...] = (
    ("velocities/v-north-fps", METRES_PER_FOOT),
    ("velocities/v-east-fps", METRES_PER_FOOT),
    ("atmosphere/P-psf", NEWTONS_PER_POUND / METRES_PER_FOOT**2),
    ("atmosphere/T-R", 5.0 / 9.0),
)
"""Velocity over the ground, north and east; static pressure and temperature of the air."""

# The wind is set through JSBSim's gust properties, because run_ic overwrites its wind properties.
SET_WIND_FPS = tuple(f"atmosphere/gust-{axis}-fps" for axis in ("north", "east", "down"))
TOTAL_WIND_FPS = tuple(f"atmosphere/total-wind-{axis}-fps" for axis in ("north", "east", "down"))

INTEGRATORS = tuple(
    f"simulation/integrator/{kind}/{of}"
    for kind in ("rate", "position")
    for of in ("rotational", "translational")
)
"""Properties that choose how JSBSim integrates the motion of the airframe; with 0 the airframe does not move."""


def command_property(actuator: AnyActuator) -> str:
    """Name of the property of an actuator's command: radians for a servo, throttle for a motor or engine."""
    return f"{actuator.prefix}/{'command-rad' if isinstance(actuator, Servo) else 'command-norm'}"


def position_property(actuator: AnyActuator) -> Property:
    """Property of a servo's position, or of the thrust of a motor or engine; the factor is to degrees or newtons."""
    if isinstance(actuator, Servo):
        return f"{actuator.prefix}/position-rad", DEGREES_PER_RADIAN
    return f"propulsion/engine[{actuator.engine}]/thrust-lbs", NEWTONS_PER_POUND
