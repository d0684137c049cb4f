"""An independent estimate of the coefficients by closed formulas, printed beside those that derive.py finds.

    python handbook.py

Sources: lifting-line and strip theory, DATCOM, Etkin and Roskam. Nothing here uses the vortex lattice, but the terms of pod,
propellers and parasite drag are those of derive.py. A gross error (sign, length, factor of two) in anything that is not shared
shows as a difference. These formulas are accurate to about a third.
"""

import math

from derive import build, drag, pod, propeller_normal_force, reference


def wing_slope(aspect, sweep=0.0):
    """Lift slope of a wing [1/rad]: DATCOM 4.1.3.2 at low speed, with the section's slope 2 pi."""
    return 2 * math.pi * aspect / (2 + math.sqrt(aspect**2 * (1 + math.tan(sweep) ** 2) + 4))


def estimate(g, m):
    area, span, chord = reference(g)
    w, t, cg = g["wing"], g["tail"], m["cg_m"]
    aspect, cl = span**2 / area, g["reference"]["lift_coefficient"]
    dihedral = math.radians(t["dihedral_deg"])
    taper = w["tip_chord_m"] / w["root_chord_m"]
    panel = 0.5 * t["panel_span_m"] * (t["root_chord_m"] + t["tip_chord_m"])
    a_wing, a_tail = wing_slope(aspect), wing_slope((2 * t["panel_span_m"]) ** 2 / (2 * panel))
    arm, height = (
        t["quarter_chord_x_m"] - cg[0],
        0.5 * t["panel_span_m"] * math.sin(dihedral) + t["root_z_m"] - cg[2],
    )
    body, props, parasite = pod(g, cg), propeller_normal_force(g, cg), drag(g, cg)

    a_roll = 2 * math.pi * aspect / (aspect + 4)  # lift slope of a wing loaded antisymmetrically
    # downwash at the tail, DATCOM 4.4.1
    k = (
        (1 / aspect - 1 / (1 + aspect**1.7))
        * (10 - 3 * taper)
        / 7
        * (1 - abs(height) / span)
        / (2 * arm / span) ** (1 / 3)
    )
    downwash = 4.44 * k**1.19
    # Lift slope of both panels, and the factor by which opposite loads on them reduce their side force: K of NACA Report 823
    # (Purser and Campbell).
    level = 2 * panel / area * a_tail * math.cos(dihedral) ** 2
    side_factor = 0.7
    upright = side_factor * 2 * panel / area * a_tail * math.sin(dihedral) ** 2
    roll_arm = 0.5 * t["panel_span_m"] * 0.97 + (t["root_z_m"] - cg[2]) * math.sin(dihedral)
    wing_arm = (cg[0] - 0.25 * w["root_chord_m"]) / chord  # quarter-chord line is straight

    hinge = math.acos(2 * (t["flap_chord_ratio"]) - 1)  # flap effectiveness, thin-aerofoil theory
    tau = 1 - (hinge - math.sin(hinge)) / math.pi
    force = panel * a_tail * tau * t["flap_viscous_factor"] / area
    return {
        "CL_alpha": a_wing + level * (1 - downwash) + props["CL_alpha"],
        "Cm_alpha": a_wing * wing_arm - level * (1 - downwash) * arm / chord
        + body["Cm_alpha"] + props["Cm_alpha"],
        "CL_q": 2 * level * arm / chord + a_wing * (1 - 2 * wing_arm),
        "Cm_q": -2 * level * (arm / chord) ** 2 - a_wing * (0.125 + 0.5 * wing_arm**2),
        "Cm_alphadot": -2 * level * (arm / chord) ** 2 * downwash,
        "downwash": downwash,
        "CY_beta": -upright + body["CY_beta"] + props["CY_beta"],
        "Cl_beta": -a_roll * math.radians(w["dihedral_deg"]) / 6 * (1 + 2 * taper) / (1 + taper)
        + body["Cl_beta"] - upright / math.sin(dihedral) * roll_arm / span,
        "Cn_beta": upright * arm / span + body["Cn_beta"] + props["Cn_beta"],
        "Cl_p": -a_roll / 8,  # elliptic lifting line
        "Cl_r": cl / 4 + 2 * upright * arm * height / span**2,
        "Cn_p": -cl / 8,
        "CY_r": 2 * upright * arm / span,
        "Cn_r": -2 * upright * (arm / span) ** 2 - w["profile_drag"] / 3 - 0.02 * cl**2,
        "CD0": parasite["CD0"],
        "CD_k": 1 / (math.pi * aspect * 0.80),
        "CL_left": force * math.cos(dihedral),
        "CY_left": side_factor * force * math.sin(dihedral),
        "Cl_left": side_factor * force * roll_arm / span,
        "Cm_left": -force * math.cos(dihedral) * arm / chord,
        "Cn_left": -side_factor * force * math.sin(dihedral) * arm / span,
    }  # fmt: skip


def main():
    g, m, c, *_ = build()
    print(f"{'':12s} derived  hand-book  ratio")
    for name, value in estimate(g, m).items():
        print(f"{name:12s} {c[name]:8.4f} {value:8.4f}   {c[name] / value:5.2f}")


if __name__ == "__main__":
    main()
