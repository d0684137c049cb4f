"""Derive the v-tail: geometry.yaml -> coefficients -> vtail.xml and Engines/*.xml.

    python derive.py            write the files and print the table of coefficients
    python derive.py --check    write nothing; exit 1 if the files differ from what would be written

Needs AeroSandbox (the extra `derive`); the testbed itself never imports this file.

Wing and tail come from AeroSandbox's vortex lattice: static, damping and cross derivatives, ruddervators.
What a lattice of thin surfaces does not contain is estimated from hand-books and added: pod, propeller normal and side
force, parasite drag, stall. Each function below has one source, which its docstring names.

Signs: body axes x forward, y right, z down for moments and rates (l right wing down, m nose up, n nose
right); alpha, beta positive for air from below and from the right; ruddervators positive trailing edge down,
both of them. Rates are made dimensionless with b/2V (p, r) and c/2V (q, alpha-dot). Moments are about the
centre of gravity.
"""

import argparse
import math
import sys
from pathlib import Path

import aerosandbox as asb
import aerosandbox.numpy as np
import propeller
import xml_files
import yaml

HERE = Path(__file__).parent
SPANWISE, CHORDWISE = 14, 10  # panels of the lattice; README.md has the effect of doubling both
STEP_DEG = 1.0  # of the central differences; it may be large, because the lattice is nearly linear
RUDDERVATOR_STEP_DEG = 4.0
AXES = ("CL", "CD", "CY", "Cl", "Cm", "Cn")


# ---- masses ---------------------------------------------------------------------
def inertia_of(parts, about):
    """[Ixx, Iyy, Izz, Ixz] in kg m2 of uniform boxes about a point; Ixz is the integral of x z."""
    total = np.zeros(4)
    for part in parts:
        m, (x, y, z), (a, b, c) = part["mass_kg"], np.array(part["at_m"]) - about, part["size_m"]
        own = np.array([b * b + c * c, a * a + c * c, a * a + b * b]) / 12
        total = total + m * np.array(
            [*(own + np.array([y * y + z * z, x * x + z * z, x * x + y * y])), x * z]
        )
    return total  # x and z both change sign from structural to body axes, so Ixz does not


def balance(parts):
    """Mass [kg] and centre of gravity [m]; y is set to exactly zero, because the aircraft is symmetric."""
    mass = sum(p["mass_kg"] for p in parts)
    centre = sum(p["mass_kg"] * np.array(p["at_m"]) for p in parts) / mass
    return mass, np.array([round(centre[0], 5), 0.0, round(centre[2], 5)])


def ruddervators(g):
    """Point masses of the left and the right ruddervator."""
    t, r = g["tail"], g["ruddervator_mass"]
    s, dihedral = r["span_fraction"] * t["panel_span_m"], math.radians(t["dihedral_deg"])
    chord = 0.5 * (t["root_chord_m"] + t["tip_chord_m"])
    x = round(t["quarter_chord_x_m"] + (r["chord_fraction"] - 0.25) * chord, 5)
    y, z = round(s * math.cos(dihedral), 5), round(t["root_z_m"] + s * math.sin(dihedral), 5)
    return [
        {
            "name": f"{side} ruddervator",
            "mass_kg": r["mass_kg"],
            "at_m": [x, sign * y, z],
            "size_m": [0, 0, 0],
        }
        for side, sign in (("left", -1), ("right", 1))
    ]


def masses(g):
    fixed, moving = g["masses"], ruddervators(g)
    mass, cg = balance(fixed + moving)
    empty, empty_cg = balance(fixed)
    return {
        "mass_kg": mass, "cg_m": cg, "inertia": inertia_of(fixed + moving, cg),
        "empty_kg": empty, "empty_cg_m": empty_cg, "empty_inertia": inertia_of(fixed, empty_cg),
        "points": moving,
    }  # fmt: skip


# ---- vortex lattice -------------------------------------------------------------
def wing_surface(g):
    w = g["wing"]
    half, foil = 0.5 * w["span_m"], asb.Airfoil(w["airfoil"])
    tip_x = 0.25 * (w["root_chord_m"] - w["tip_chord_m"])  # straight quarter-chord line
    tip_z = half * math.tan(math.radians(w["dihedral_deg"]))
    stations = [((0, 0, 0), w["root_chord_m"]), ((tip_x, half, tip_z), w["tip_chord_m"])]
    sections = [asb.WingXSec(xyz_le=p, chord=c, twist=w["incidence_deg"], airfoil=foil) for p, c in stations]
    return asb.Wing(name="wing", symmetric=True, xsecs=sections)


def tail_surfaces(g, left_deg=0.0, left_turned_deg=0.0):
    """The two tail panels, the left one with its ruddervator at `left_deg` (positive trailing edge down).

    `left_turned_deg` turns the whole left panel about its own span, nose up; so does `incidence_deg` of the geometry.
    """
    t = g["tail"]
    dihedral, foil = math.radians(t["dihedral_deg"]), asb.Airfoil(t["airfoil"])
    lattice_foil = {
        -1: foil.add_control_surface(left_deg, 1 - t["flap_chord_ratio"]),
        1: foil.add_control_surface(0.0, 1 - t["flap_chord_ratio"]),
    }

    def leading_edge(s, chord, side):
        x, z = t["quarter_chord_x_m"] - 0.25 * chord, t["root_z_m"] + s * math.sin(dihedral)
        return x, side * s * math.cos(dihedral), z

    def panel(side):
        stations = [(0.0, t["root_chord_m"]), (t["panel_span_m"], t["tip_chord_m"])]
        sections = [
            asb.WingXSec(
                xyz_le=leading_edge(s, chord, side),
                chord=chord, twist=t["incidence_deg"] + (left_turned_deg if side < 0 else 0.0),
                airfoil=lattice_foil[side],
            ) for s, chord in stations
        ]  # fmt: skip
        return asb.Wing(name="tail", symmetric=False, xsecs=sections[::side])  # listed from left to right

    return [panel(-1), panel(1)]


def reference(g):
    """Area [m2], span [m] and mean aerodynamic chord [m] of the trapezoidal wing."""
    w = g["wing"]
    taper = w["tip_chord_m"] / w["root_chord_m"]
    area = 0.5 * w["span_m"] * (w["root_chord_m"] + w["tip_chord_m"])
    return area, w["span_m"], 2 / 3 * w["root_chord_m"] * (1 + taper + taper**2) / (1 + taper)


class Lattice:
    """Vortex lattice of some surfaces, which gives coefficients about the centre of gravity.

    The surfaces are moved so that the centre of gravity is the origin, because AeroSandbox turns an aircraft about the origin of
    its geometry, whatever the reference point of the moments.
    """

    def __init__(self, g, surfaces, cg):
        self.area, self.span, self.chord = reference(g)
        self.speed = g["reference"]["airspeed_m_s"]
        about_cg = [surface.translate(-np.array(cg)) for surface in surfaces]
        self.airplane = asb.Airplane(
            wings=about_cg, xyz_ref=[0, 0, 0], s_ref=self.area, b_ref=self.span, c_ref=self.chord
        )

    def at(self, alpha_deg, beta_deg=0.0, p=0.0, q=0.0, r=0.0):
        """Coefficients by AXES at these angles [deg]; p, q, r are dimensionless."""
        v2b, v2c = 2 * self.speed / self.span, 2 * self.speed / self.chord
        op = asb.OperatingPoint(
            velocity=self.speed, alpha=alpha_deg, beta=beta_deg, p=p * v2b, q=q * v2c, r=r * v2b
        )
        run = asb.VortexLatticeMethod(
            self.airplane, op, spanwise_resolution=SPANWISE, chordwise_resolution=CHORDWISE
        ).run()
        return np.array([float(run[k]) for k in AXES])

    def slope(self, alpha_deg, name):
        """Derivative of every coefficient with one variable, per radian or per dimensionless rate."""
        if name in ("alpha", "beta"):
            h = STEP_DEG
            high = self.at(alpha_deg + h) if name == "alpha" else self.at(alpha_deg, beta_deg=h)
            low = self.at(alpha_deg - h) if name == "alpha" else self.at(alpha_deg, beta_deg=-h)
            return dict(zip(AXES, (high - low) / (2 * math.radians(h)), strict=True))
        h = 0.01
        return dict(
            zip(
                AXES,
                (self.at(alpha_deg, **{name: h}) - self.at(alpha_deg, **{name: -h})) / (2 * h),
                strict=True,
            )
        )


def trim_angle(g, lattice):
    """Angle of attack [deg] of the reference lift coefficient."""
    a, b = lattice.at(0.0)[0], lattice.at(4.0)[0]
    return float(4.0 * (g["reference"]["lift_coefficient"] - a) / (b - a))


def by_left_panel(g, cg, alpha_deg, flap):
    """Derivatives of AXES, per rad, by the deflection of the LEFT ruddervator (`flap` 1) or by turning its panel (0)."""
    h = RUDDERVATOR_STEP_DEG
    high, low = (
        Lattice(g, [wing_surface(g), *tail_surfaces(g, flap * d, (1 - flap) * d)], cg).at(alpha_deg)
        for d in (h, -h)
    )
    return dict(zip(AXES, (high - low) / (2 * math.radians(h)), strict=True))


def left_ruddervator(g, cg, alpha_deg):
    """Derivatives of AXES by the deflection of the LEFT ruddervator, per rad; the right one is its exact mirror image."""
    slopes = by_left_panel(g, cg, alpha_deg, flap=1)
    return {axis: slope * g["tail"]["flap_viscous_factor"] for axis, slope in slopes.items()}


# ---- hand-book estimates --------------------------------------------------------
def pod(g, cg):
    """Moments and side force of the pod: Munk with DATCOM 4.2.1.1. Dihedral effect of a high wing: DATCOM 5.2.2.1."""
    f, (area, span, chord) = g["pod"], reference(g)
    volume = f["prismatic"] * f["length_m"] * f["width_m"] * f["height_m"]
    fineness = f["length_m"] / math.sqrt(f["width_m"] * f["height_m"])
    k = 0.86 + 0.014 * (fineness - 6)  # apparent-mass factor, read from the figure for fineness 5 to 9
    base = 0.5 * f["width_m"] * f["height_m"]  # cross-section where the flow separates, at the boom [m2]
    side = 2 * k * base * (f["height_m"] / f["width_m"]) / area
    aspect, depth = span**2 / area, math.sqrt(f["width_m"] * f["height_m"] / 0.7854)
    return {
        "Cm_alpha": 2 * k * volume / (area * chord),
        "Cn_beta": -2 * k * volume * (f["height_m"] / f["width_m"]) ** 0.5 / (area * span),
        "CY_beta": -side,
        "Cl_beta": 1.2 * math.sqrt(aspect) * (f["z_m"] / span) * (2 * depth / span),
    }


def propeller_normal_force(g, cg):
    """Normal force of both propellers in oblique flow: DeYoung, J. Aircraft 2 (1965), lightly loaded."""
    p, (area, span, chord) = g["propulsion"]["propeller"], reference(g)
    radius = 0.5 * p["diameter_m"]
    mean_chord = radius * np.interp(0.75, p["radius_ratio"], p["chord_ratio"])
    solidity = 4 * p["blades"] / (3 * math.pi) * mean_chord / p["diameter_m"]
    blade_angle = math.atan(p["pitch_m"] / (2 * math.pi * 0.75 * radius))
    slope = 4.25 * solidity / (1 + 2 * solidity) * math.sin(blade_angle + math.radians(8.0))
    force = 2 * slope * math.pi * radius**2 / area
    arm = cg[0] - g["propulsion"]["x_m"]
    return {
        "CL_alpha": force,
        "Cm_alpha": force * arm / chord,
        "CY_beta": -force,
        "Cn_beta": -force * arm / span,
    }


def drag(g, cg):
    """CD0 as a sum over components, and the pitching moment of drag that acts above or below the centre of gravity."""
    area, _, chord = reference(g)
    w, t = g["wing"], g["tail"]
    panel = 0.5 * t["panel_span_m"] * (t["root_chord_m"] + t["tip_chord_m"])
    tail_z = t["root_z_m"] + 0.5 * t["panel_span_m"] * math.sin(math.radians(t["dihedral_deg"]))
    items = [("wing", w["profile_drag"] * area, 0.017), ("tail", 2 * t["profile_drag"] * panel, tail_z)]
    items += [(p["name"], p["coefficient"] * p["area_m2"], p["z_m"]) for p in g["parasite"]]
    factor = 1 + g["interference"]
    return {
        "items": [(name, f / area) for name, f, _ in items],
        "CD0": factor * sum(f for _, f, _ in items) / area,
        "Cm0": factor * sum(f * (z - cg[2]) for _, f, z in items) / (area * chord),
    }


def ruddervator_drag(g):
    """CD of one plain flap divided by sin^2 of its deflection: 1.7 (cf/c)^1.38 Sf/S (Young, ARC R&M 2622)."""
    t = g["tail"]
    panel = 0.5 * t["panel_span_m"] * (t["root_chord_m"] + t["tip_chord_m"])
    return 1.7 * t["flap_chord_ratio"] ** 1.38 * panel / reference(g)[0]


def rotary_profile_drag(g):
    """Yaw damping by the wing's profile drag: strip theory, Cn_r = -cd/3 for a nearly rectangular wing."""
    return -g["wing"]["profile_drag"] / 3


def downwash(g, cg, alpha_deg):
    """Derivatives by the rate of alpha: the tail is in the downwash that left the wing l/V earlier (Etkin; Roskam VI).

    The downwash gradient d(epsilon)/d(alpha) follows from the tail's share of Cm_alpha behind the wing and alone: their ratio
    is 1 - d(epsilon)/d(alpha).
    """
    alone = Lattice(g, [*tail_surfaces(g)], cg).slope(alpha_deg, "alpha")
    wing = Lattice(g, [wing_surface(g)], cg).slope(alpha_deg, "alpha")
    whole = Lattice(g, [wing_surface(g), *tail_surfaces(g)], cg).slope(alpha_deg, "alpha")
    gradient = 1 - (whole["Cm"] - wing["Cm"]) / alone["Cm"]
    travel = 2 * (g["tail"]["quarter_chord_x_m"] - 0.25 * g["wing"]["root_chord_m"]) / reference(g)[2]
    return {
        "gradient": gradient,
        "CL_alphadot": alone["CL"] * gradient * travel,
        "Cm_alphadot": alone["Cm"] * gradient * travel,
    }


def slipstream_reach(g, c, alpha, beta):
    """Share of the LEFT tail panel, by chord, inside the slipstream of its own propeller at angles in rad.

    The slipstream is a cylinder of the propeller's diameter (its contraction is 1 % at cruise, 3 % at 11 N). Its axis leaves the
    hub along the free stream, and behind the wing it follows the downwash.
    """
    t, prop = g["tail"], g["propulsion"]
    dihedral, radius = math.radians(t["dihedral_deg"]), 0.5 * prop["propeller"]["diameter_m"]
    distance, behind_wing = (
        t["quarter_chord_x_m"] - prop["x_m"],
        t["quarter_chord_x_m"] - 0.25 * g["wing"]["root_chord_m"],
    )
    washed = c["downwash"] * (alpha + c["CL0"] / c["CL_alpha"])
    y = -prop["y_m"] - math.tan(beta) * distance
    z = prop["z_m"] + math.tan(alpha) * distance - washed * behind_wing
    s = (np.arange(400) + 0.5) / 400
    chord = t["root_chord_m"] + s * (t["tip_chord_m"] - t["root_chord_m"])
    across = -s * t["panel_span_m"] * math.cos(dihedral) - y
    up = t["root_z_m"] + s * t["panel_span_m"] * math.sin(dihedral) - z
    return float(np.sum(chord * (across**2 + up**2 < radius**2)) / np.sum(chord))


def slipstream(g, c, left, turned):
    """What the tail in the propellers' slipstream needs; `left` and `turned` are the derivatives of `by_left_panel`.

    `flap_per_turn`: deflection of a ruddervator [rad] that has the lift of its panel turned by one rad.
    `reach`: (alphas, betas, rows) of `slipstream_reach`, in rad.
    """
    alphas, betas = ([math.radians(d) for d in range(-low, low + 1, 5)] for low in (20, 30))
    t = g["tail"]
    return {
        "active": g["propulsion"]["slipstream"],
        "disc_m2": 0.25 * math.pi * g["propulsion"]["propeller"]["diameter_m"] ** 2,
        "distance_m": t["quarter_chord_x_m"] - g["propulsion"]["x_m"],
        "flap_per_turn": turned["CL"] / left["CL"],
        "reach": (alphas, betas, [[slipstream_reach(g, c, a, b) for b in betas] for a in alphas]),
    }


def fairing(alpha, start, end):
    """Smooth step in |alpha| from 0 (attached flow, below `start`) to 1 (flat plate, above `end`); angles in rad."""
    x = min(max((abs(alpha) - start) / (end - start), 0.0), 1.0)
    return x * x * (3 - 2 * x)


def stalled(g, cg, alpha):
    """CL, CD, Cm of wing and tail as flat plates: normal force 1.2 sin(alpha) (Hoerner 3-16, aspect ratio 7).

    The wing's force acts at 35 % of the root chord at small alpha, and moves back to 52 % at 90 deg.
    """
    area, _, chord = reference(g)
    t = g["tail"]
    share = (
        (t["root_chord_m"] + t["tip_chord_m"])
        * t["panel_span_m"]
        * math.cos(math.radians(t["dihedral_deg"]))
        / area
    )
    normal = 1.2 * math.sin(alpha)
    centre = (0.25 + 0.175 * min(abs(alpha) / (math.pi / 2), 1.0) + 0.1) * g["wing"]["root_chord_m"]
    arm, tail_arm = centre - cg[0], t["quarter_chord_x_m"] - cg[0]
    total = normal * (1 + share)
    return total * math.cos(alpha), total * math.sin(alpha), -normal * (arm + share * tail_arm) / chord


def angle_tables(g, cg, c):
    """Rows (alpha [rad], CL, CD, Cm), -180 to 180 deg: line and parabola in attached flow, flat plate when stalled."""
    start = math.radians(g["wing"]["cl_max_alpha_deg"])
    degrees = [
        *range(-180, -90, 15),
        *range(-90, -30, 10),
        *range(-30, -14, 2),
        *(k / 2 for k in range(-28, 49)),
        26,
        28,
        30,
        *range(40, 91, 10),
        *range(105, 181, 15),
    ]
    rows = []
    for deg in degrees:
        a = math.radians(deg)
        w = fairing(a, start, start + math.radians(9.0))
        cl, cm = c["CL0"] + c["CL_alpha"] * a, c["Cm0"] + c["Cm_alpha"] * a
        cd = c["CD0"] + c["CD_k"] * (cl - c["CD_CL"]) ** 2
        plate = stalled(g, cg, a)
        rows.append(
            (
                a,
                (1 - w) * cl + w * plate[0],
                (1 - w) * cd + w * (c["CD0"] + plate[1]),
                (1 - w) * cm + w * plate[2],
            )
        )
    return rows


# ---- putting it together --------------------------------------------------------
def polar(lattice):
    """k, CL1 and floor of CD = floor + k (CL - CL1)^2, fitted to the lattice's induced drag at three angles of attack."""
    cl, cd = np.array([lattice.at(a)[:2] for a in (-2.0, 3.0, 8.0)]).T
    k, b, a = np.polyfit(cl, cd, 2)
    return k, -b / (2 * k), a - b * b / (4 * k)


def coefficients(g, cg):
    lattice = Lattice(g, [wing_surface(g), *tail_surfaces(g)], cg)
    body, props, parasite = pod(g, cg), propeller_normal_force(g, cg), drag(g, cg)
    trim_deg = trim_angle(g, lattice)
    by = {name: lattice.slope(trim_deg, name) for name in ("alpha", "beta", "p", "q", "r")}
    at_trim, wake = lattice.at(trim_deg), downwash(g, cg, trim_deg)
    c = {"trim_deg": trim_deg, "downwash": wake["gradient"]}
    c["CL_alpha"] = by["alpha"]["CL"] + props["CL_alpha"]
    c["CL0"] = at_trim[0] - by["alpha"]["CL"] * math.radians(trim_deg)
    c["Cm_alpha"] = by["alpha"]["Cm"] + body["Cm_alpha"] + props["Cm_alpha"]
    c["Cm0"] = at_trim[4] - by["alpha"]["Cm"] * math.radians(trim_deg) + parasite["Cm0"]
    k, cl1, floor = polar(lattice)
    viscous = 0.38 * g["wing"]["profile_drag"]  # growth of section drag with lift (Obert)
    c["CD_k"], c["CD_CL"], c["CD0"] = (
        k + viscous,
        k * cl1 / (k + viscous),
        parasite["CD0"] + floor + k * cl1**2 * viscous / (k + viscous),
    )
    c["CY_beta"] = by["beta"]["CY"] + body["CY_beta"] + props["CY_beta"]
    c["Cl_beta"] = by["beta"]["Cl"] + body["Cl_beta"]
    c["Cn_beta"] = by["beta"]["Cn"] + body["Cn_beta"] + props["Cn_beta"]
    for force in ("CY", "Cl", "Cn"):
        for rate in ("p", "r"):
            c[f"{force}_{rate}"] = by[rate][force]
    c["Cn_r"] += rotary_profile_drag(g)
    c["CL_q"], c["Cm_q"] = by["q"]["CL"], by["q"]["Cm"]
    c["CL_alphadot"], c["Cm_alphadot"] = wake["CL_alphadot"], wake["Cm_alphadot"]
    left = left_ruddervator(g, cg, trim_deg)
    c.update({f"{name}_left": left[name] for name in AXES})
    c["CD_left2"] = ruddervator_drag(g)
    c["slipstream"] = slipstream(g, c, left, by_left_panel(g, cg, trim_deg, flap=0))
    c["lattice"] = {**{f"{f}_{v}": by[v][f] for v in by for f in AXES}}
    c["angles"] = angle_tables(g, cg, c)
    return c, parasite


def blade_of(g):
    p = g["propulsion"]["propeller"]
    spec = {name: p[name] for name in propeller.Blade.__dataclass_fields__}
    return propeller.Blade(**{k: tuple(v) if isinstance(v, list) else v for k, v in spec.items()})


def propeller_table(g):
    momentum = [round(0.05 * k, 2) for k in range(41)]
    free = [2.5, 3, 4, 5, 7, 10, 15, 20, 30, 50, 100]  # advance ratios from windmilling to almost at rest
    return propeller.table(blade_of(g), g["propulsion"]["propeller"]["reynolds_rev_s"], momentum, free)


def stated_geometry():
    return yaml.safe_load((HERE / "geometry.yaml").read_text())


def build(g=None):
    """Geometry, masses, coefficients, parasite drag, propeller table, and the text of each file by its name."""
    g = g or stated_geometry()
    m = masses(g)
    c, parasite = coefficients(g, m["cg_m"])
    table = propeller_table(g)
    files = xml_files.write(g, m, c, table, reference(g))
    return g, m, c, parasite, table, files


def report(g, m, c, parasite):
    area, span, chord = reference(g)
    print(f"S {area:.4f} b {span:.3f} c {chord:.4f}  mass {m['mass_kg']:.3f} cg {m['cg_m']}")
    print("Ix Iy Iz Ixz " + " ".join(f"{x:.4f}" for x in m["inertia"]), " sum of points:", m["points"][0])
    for name in [k for k in c if k not in ("angles", "lattice", "slipstream")]:
        print(f"  {name:12s} {c[name]: .5f}   lattice {c['lattice'].get(name, float('nan')): .5f}")
    print("  parasite " + ", ".join(f"{name} {cd:.4f}" for name, cd in parasite["items"]))
    force = math.hypot(c["CL_left"], c["CY_left"]) * area
    print(f"  ruddervator: kF {force:.4f} m2/rad, arm {-c['Cm_left'] * chord / c['CL_left']:.3f} m,"
          f" roll arm {c['Cl_left'] * span * area / force:.4f} m")  # fmt: skip
    nd, ld = 2 * c["Cn_left"], 2 * c["Cl_left"]
    scale = 0.5 * 1.19 * 324 * area * span
    nb, lb = c["Cn_beta"] * scale / m["inertia"][2], abs(c["Cl_beta"]) * scale / m["inertia"][0]
    nd, ld = abs(nd) * scale / m["inertia"][2], abs(ld) * scale / m["inertia"][0]
    print(f"  n_d {nd:.2f} l_d {ld:.2f} n_b {nb:.2f} l_b {lb:.2f}  D {nd * lb - nb * ld:.1f} (1/s4)")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare only; exit 1 if a file differs")
    check = parser.parse_args().check
    g, m, c, parasite, _, files = build()
    different = [n for n, text in files.items() if not (HERE / n).exists() or (HERE / n).read_text() != text]
    if check:
        print("\n".join(f"differs: {n}" for n in different) or "identical")
        return 1 if different else 0
    for name, text in files.items():
        (HERE / name).write_text(text)
    report(g, m, c, parasite)
    return 0


if __name__ == "__main__":
    sys.exit(main())
