"""Blade-element-momentum theory for a propeller of stated geometry: CT(J) and CP(J).

Method: Ning, "A simple solution method for the blade element momentum equations", Wind Energy 17 (2014), in its propeller
form. Each radial station has one unknown, the inflow angle phi. Tip and hub losses are Prandtl's. Momentum theory does not
describe a rotor that is almost at rest in a stream. There induction is left out: each station is a blade element in the free
stream.

    J = V / (n D)      CT = T / (rho n^2 D^4)      CP = P / (rho n^3 D^5)
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

STATIONS = 24


@dataclass(frozen=True)
class Blade:
    """A propeller's geometry; lists are over radius_ratio = r/R."""

    diameter_m: float
    blades: int
    pitch_m: float  # geometric pitch of the chord line, the same at all radii
    radius_ratio: tuple
    chord_ratio: tuple  # c/R
    zero_lift_deg: float  # of the section
    lift_slope_rad: float
    cl_max: float
    cl_min: float
    cd_min: float  # at reynolds_reference
    cl_of_cd_min: float
    cd_growth: float  # cd = cd_min + cd_growth (cl - cl_of_cd_min)^2
    reynolds_reference: float

    def chord_m(self, r_m):
        return (
            0.5 * self.diameter_m * np.interp(2 * r_m / self.diameter_m, self.radius_ratio, self.chord_ratio)
        )

    def twist_rad(self, r_m):
        return np.arctan(self.pitch_m / (2 * np.pi * r_m))


def section(blade, alpha_rad, reynolds):
    """cl, cd of a blade section at alpha [rad]: lift linear between limits; beyond the stall faired into a flat plate."""
    zero = np.radians(blade.zero_lift_deg)
    linear = blade.lift_slope_rad * (alpha_rad - zero)
    cl = min(max(linear, blade.cl_min), blade.cl_max)
    # The exponent is between those of laminar (-1/2) and turbulent (-1/5) flow.
    friction = blade.cd_min * (reynolds / blade.reynolds_reference) ** -0.3
    cd = friction + blade.cd_growth * (cl - blade.cl_of_cd_min) ** 2
    excess = abs(linear - cl) / blade.lift_slope_rad  # angle past the stall
    w = min(excess / np.radians(15.0), 1.0)
    w = w * w * (3 - 2 * w)
    s, c = np.sin(alpha_rad), np.cos(alpha_rad)
    return (1 - w) * cl + w * 2 * s * c, (1 - w) * cd + w * (friction + 2 * s * s)


def station_loads(blade, r, v, omega, nu, induction=True):
    """Thrust [N/m] and torque [N m/m] of all blades per metre of radius and per unit of density, at radius r [m].

    Args:
        v: axial airspeed [m/s].
        omega: rotor speed [rad/s].
        nu: kinematic viscosity [m2/s].
        induction: by momentum theory; without it the element is in the free stream.
    """
    chord, twist = blade.chord_m(r), blade.twist_rad(r)
    radius, hub = 0.5 * blade.diameter_m, blade.radius_ratio[0] * 0.5 * blade.diameter_m
    sigma = blade.blades * chord / (2 * np.pi * r)

    def normal_tangential(phi, speed):
        cl, cd = section(blade, twist - phi, max(speed * chord / nu, 1e4))
        return cl * np.cos(phi) - cd * np.sin(phi), cl * np.sin(phi) + cd * np.cos(phi)

    def loss(phi):
        f = 0.5 * blade.blades / max(abs(np.sin(phi)), 1e-9)
        tip = 2 / np.pi * np.arccos(np.exp(-f * (radius - r) / r))
        root = 2 / np.pi * np.arccos(np.exp(-f * (r - hub) / hub))
        return max(tip * root, 1e-4)

    speed = np.hypot(v, omega * r)

    def residual(phi):  # Ning (2014), without the division by 1 + a and 1 - a', so that it has no poles
        cn, ct = normal_tangential(phi, speed)
        s, c, f = np.sin(phi), np.cos(phi), loss(phi)
        axial = 1 - sigma * cn / (4 * f * s * s)  # = 1 / (1 + a)
        swirl = 1 + sigma * ct / (4 * f * s * c)  # = 1 / (1 - a')
        return omega * r * s * axial - v * c * swirl

    phi = np.arctan2(v, omega * r)
    w2 = speed**2
    if induction:
        grid = np.linspace(1e-3, np.pi / 2 - 1e-3, 400)
        values = np.array([residual(x) for x in grid])
        up = np.nonzero((values[:-1] < 0) & (values[1:] >= 0))[0]
        if len(up):
            k = up[np.argmin(np.abs(grid[up] - phi))]
            phi = brentq(residual, grid[k], grid[k + 1], xtol=1e-12)
            cn, ct = normal_tangential(phi, speed)
            s, c, f = np.sin(phi), np.cos(phi), loss(phi)
            # W from the tangential component, which the wake changes least: W = omega r (1 - a') / cos(phi)
            w2 = (omega * r / (1 + sigma * ct / (4 * f * s * c)) / c) ** 2
    cn, ct = normal_tangential(phi, np.sqrt(w2))
    half = 0.5 * w2 * blade.blades * chord
    return half * cn, half * ct * r


def coefficients(blade, j, rev_s, nu=1.5e-5, induction=True):
    """(CT, CP) at advance ratio j; rev_s only sets the Reynolds number."""
    d = blade.diameter_m
    omega, v = 2 * np.pi * rev_s, j * rev_s * d
    edges = 0.5 * d * np.linspace(blade.radius_ratio[0], 1.0, STATIONS + 1)
    mid, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    loads = np.array([station_loads(blade, r, v, omega, nu, induction) for r in mid])
    thrust, torque = width @ loads
    return thrust / (rev_s**2 * d**4), torque * 2 * np.pi / (rev_s**2 * d**5)


def table(blade, rev_s, j_momentum, j_free):
    """Rows (J, CT, CP): with momentum theory at the advance ratios j_momentum, in the free stream at j_free."""
    rows = [(j, *coefficients(blade, j, rev_s)) for j in j_momentum]
    for j in j_free:  # at one airspeed a higher J means a slower rotor; this keeps W, and so the Reynolds number, about the same
        slow = rev_s * min(1.0, j_momentum[-1] / j)
        rows.append((j, *coefficients(blade, j, slow, induction=False)))
    return np.array(rows)
