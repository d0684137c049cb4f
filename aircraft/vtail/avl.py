"""The same wing and tail in AVL (Drela and Youngren), a vortex lattice of other authors, beside the lattice of derive.py.

    python avl.py            print the derivatives of both, and their ratios
    python avl.py --check    print only those that differ by more than the stated tolerance; exit 1 if there is one

Needs `optvl` (AVL as a Python package) and AeroSandbox: the extra `derive`. Both lattices are of thin surfaces and have the
same geometry, so only the terms that derive.py takes from a lattice are compared: static, rate and cross derivatives and one
ruddervator, without viscous factor. Rates are about body axes through the centre of gravity in both.
"""

import argparse
import math
import sys
import tempfile
from pathlib import Path

import numpy as np
import optvl
import yaml
from derive import AXES, HERE, Lattice, masses, reference, tail_surfaces, trim_angle, wing_surface

WING_PANELS, TAIL_PANELS = (12, 48), (12, 24)  # chordwise, spanwise of the wing and of one tail panel
ANGLE_STEP_DEG, RATE_STEP, FLAP_STEP_DEG = 1.0, 0.01, 4.0
TOLERANCE = 0.1
# Small sums of forces in the surface's plane, which converge slowly: both lattices still move towards each other when refined.
TOLERANCES = {"CY_p": 0.3, "Cn_p": 0.2}
RATES = {"p": "roll rate", "q": "pitch rate", "r": "yaw rate"}
# Chordwise and spanwise panels, both in cosine spacing. Surfaces that touch are one component: AVL gives the vortices of one
# component a finite core where they act on another.
SURFACE = "SURFACE\n{name}\n{chordwise} 1.0 {spanwise} 1.0\nCOMPONENT\n{component}\n"


def _section(x, y, z, chord, incidence, naca, control=""):
    return f"SECTION\n{x:.8f} {y:.8f} {z:.8f} {chord:.8f} {incidence:.8f}\nNACA\n{naca[-4:]}\n{control}"


def _surface(name, component, panels, sections):
    head = SURFACE.format(name=name, component=component, chordwise=panels[0], spanwise=panels[1])
    return head + "".join(sections)


def wing_text(g):
    """Both halves as one surface, from the left tip to the right one."""
    w = g["wing"]
    half, rise = 0.5 * w["span_m"], math.tan(math.radians(w["dihedral_deg"]))
    tip_x = 0.25 * (w["root_chord_m"] - w["tip_chord_m"])
    root = (0.0, 0.0, 0.0, w["root_chord_m"], w["incidence_deg"], w["airfoil"])
    left, right = (
        (tip_x, side * half, half * rise, w["tip_chord_m"], w["incidence_deg"], w["airfoil"])
        for side in (-1, 1)
    )
    return _surface("wing", 1, WING_PANELS, [_section(*left), _section(*root), _section(*right)])


def tail_text(g, side, name):
    """One tail panel with its ruddervator, positive trailing edge down; sections from left to right."""
    t = g["tail"]
    dihedral = math.radians(t["dihedral_deg"])
    control = f"CONTROL\n{name} 1.0 {1 - t['flap_chord_ratio']:.6f} 0. 0. 0. 1\n"
    sections = [
        _section(
            t["quarter_chord_x_m"] - 0.25 * chord, side * s * math.cos(dihedral), t["root_z_m"] + s * math.sin(dihedral),
            chord, t["incidence_deg"], t["airfoil"], control,
        )
        for s, chord in ((0.0, t["root_chord_m"]), (t["panel_span_m"], t["tip_chord_m"]))
    ]  # fmt: skip
    return _surface(name, 2, TAIL_PANELS, sections[::side])


def geometry_text(g, cg):
    """The AVL file of wing and tail, with moments about the centre of gravity."""
    area, span, chord = reference(g)
    head = f"{g['name']}\n0.0\n0 0 0.0\n{area} {chord} {span}\n{cg[0]} {cg[1]} {cg[2]}\n0.0\n"
    return head + wing_text(g) + tail_text(g, -1, "left_tail") + tail_text(g, 1, "right_tail")


class Avl:
    """AVL's coefficients by `AXES`: CL, CD, CY in wind axes, moments in body axes about the centre of gravity."""

    def __init__(self, g, cg):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "aircraft.avl"
            file.write_text(geometry_text(g, cg))
            self.solver = optvl.OVLSolver(geo_file=str(file))
        self.solver.set_avl_fort_arr(
            "CASE_L", "LSA_RATES", False
        )  # rates about body axes, not stability axes

    def at(self, alpha_deg, beta_deg=0.0, left_deg=0.0, **rates):
        """Coefficients at these angles [deg]; p, q, r are dimensionless."""
        solver = self.solver
        solver.set_variable("alpha", alpha_deg)
        solver.set_variable("beta", beta_deg)
        for name, full in RATES.items():
            solver.set_variable(full, rates.get(name, 0.0))
        solver.set_control_deflection("left_tail", left_deg)
        solver.execute_run()
        return self._coefficients(math.radians(alpha_deg), math.radians(beta_deg))

    def _coefficients(self, alpha, beta):
        f = self.solver.get_total_forces()
        along = f["CX"] * math.cos(alpha) + f["CZ"] * math.sin(alpha)  # in the plane of symmetry
        drag = -along * math.cos(beta) - f["CY"] * math.sin(beta)
        side = f["CY"] * math.cos(beta) - along * math.sin(beta)
        lift = f["CX"] * math.sin(alpha) - f["CZ"] * math.cos(alpha)
        return np.array([lift, drag, side, f["Cl"], f["Cm"], f["Cn"]])

    def slope(self, alpha_deg, name):
        """Derivative of every coefficient with one variable, per radian or per dimensionless rate."""
        if name in RATES:
            ends = [self.at(alpha_deg, **{name: sign * RATE_STEP}) for sign in (1, -1)]
            return _named(ends, 2 * RATE_STEP)
        step = FLAP_STEP_DEG if name == "left" else ANGLE_STEP_DEG
        changes = {"alpha": (step, 0, 0), "beta": (0, step, 0), "left": (0, 0, step)}[name]
        ends = [self.at(alpha_deg + s * changes[0], s * changes[1], left_deg=s * changes[2]) for s in (1, -1)]
        return _named(ends, 2 * math.radians(step))


def _named(ends, width):
    return dict(zip(AXES, map(float, (ends[0] - ends[1]) / width), strict=True))


def lattice_flap(g, cg, alpha_deg):
    """The left ruddervator in derive.py's lattice, in inviscid flow."""
    ends = [
        Lattice(g, [wing_surface(g), *tail_surfaces(g, s * FLAP_STEP_DEG)], cg).at(alpha_deg) for s in (1, -1)
    ]
    return _named(ends, 2 * math.radians(FLAP_STEP_DEG))


def columns(g):
    """Rows (name, derive.py's lattice, AVL) of every derivative that the lattice gives."""
    cg = masses(g)["cg_m"]
    lattice, avl = Lattice(g, [wing_surface(g), *tail_surfaces(g)], cg), Avl(g, cg)
    alpha_deg = trim_angle(g, lattice)
    pairs = {name: (lattice.slope(alpha_deg, name), avl.slope(alpha_deg, name))
             for name in ("alpha", "beta", "p", "q", "r")}  # fmt: skip
    pairs["left"] = lattice_flap(g, cg, alpha_deg), avl.slope(alpha_deg, "left")
    symmetric, lateral = ("CL", "Cm"), ("CY", "Cl", "Cn")
    of = {"alpha": symmetric, "q": symmetric, "left": symmetric + lateral}
    return [(f"{axis}_{name}", ours[axis], theirs[axis])
            for name, (ours, theirs) in pairs.items() for axis in of.get(name, lateral)]  # fmt: skip


def disagrees(name, ours, theirs):
    return abs(ours - theirs) > TOLERANCES.get(name, TOLERANCE) * abs(theirs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="print differences only; exit 1 if there is one")
    check = parser.parse_args().check
    rows = columns(yaml.safe_load((HERE / "geometry.yaml").read_text()))
    if check:
        rows = [row for row in rows if disagrees(*row)]
    for name, ours, theirs in rows:
        print(f"{name:10s} lattice {ours: .5f}  AVL {theirs: .5f}  ratio {ours / theirs:.3f}")
    print("" if rows or not check else "agree")
    return 1 if check and rows else 0


if __name__ == "__main__":
    sys.exit(main())
