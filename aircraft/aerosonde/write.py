"""Write the Aerosonde's JSBSim model from its published coefficients: coefficients.yaml -> aerosonde.xml and Engines/*.xml.

    python write.py            write the files
    python write.py --check    write nothing; exit 1 if a file differs from what would be written

The blocks through which actuators break are those of the v-tail, printed by `../vtail/xml_files.py`.
"""

# ruff: noqa: E501 - lines of XML stay whole

import argparse
import math
import sys
from pathlib import Path

import yaml

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "vtail"))

from xml_files import (  # noqa: E402 - the v-tail's writer is a script beside its geometry
    ALPHA,
    B2V,
    BETA,
    C2V,
    MOTOR_PROPERTIES,
    Q_RATE,
    B,
    C,
    P,
    Q,
    R,
    S,
    alpha_table,
    function,
    location,
    lost_propeller,
    motor_file,
    number,
    propeller_channel,
    propeller_file,
    properties,
    servo_channel,
    servo_properties,
    value,
)

NAME, MOTOR = "aerosonde", "propeller"
# What the air does to a surface that floats: it stands along alpha or beta. The ailerons are linked, so neither moves the other.
SURFACES = {"elevator": [(ALPHA, 1.0)], "aileron": [(ALPHA, 0.0)], "rudder": [(BETA, -1.0)]}
BASIS = {"beta": (BETA,), "p": (P, B2V), "r": (R, B2V), "q": (Q_RATE, C2V)}
AXES = {"SIDE": ("CY", ()), "ROLL": ("Cl", (B,)), "YAW": ("Cn", (B,))}


def angle(surface):
    return f"fcs/{surface}/effective-rad"


def sigmoid(alpha, rate, alpha_0):
    """Blend from attached flow (0) to a flat plate (1): equation (4.10)."""
    low, high = math.exp(-rate * (alpha - alpha_0)), math.exp(rate * (alpha + alpha_0))
    return (1 + low + high) / ((1 + low) * (1 + high))


def angle_rows(c):
    """Rows (alpha, CL, CD): lift by equation (4.9), drag blended in the same way into a plate's."""
    a, stall = c["longitudinal"], c["stall"]
    degrees = [*range(-180, -40, 10), *range(-40, 41), *range(50, 181, 10)]
    rows = []
    for alpha in map(math.radians, degrees):
        w = sigmoid(alpha, stall["transition_rate"], stall["alpha_0_rad"])
        sine, cosine = math.sin(alpha), math.cos(alpha)
        lift = (1 - w) * (a["CL_0"] + a["CL_alpha"] * alpha) + w * 2 * abs(sine) * sine * cosine
        drag = (1 - w) * (a["CD_0"] + a["CD_alpha"] * alpha) + w * (a["CD_0"] + 2 * abs(sine) ** 3)
        rows.append((alpha, lift, drag))
    return rows


def term(name, coefficient, lengths, factors, text):
    return function(name, text, Q, S, *lengths, *factors, value(coefficient)) if coefficient else ""


def longitudinal(c):
    a, rows = c["longitudinal"], angle_rows(c)
    elevator = angle("elevator")
    square = f"<abs><property>{elevator}</property></abs>"
    plate = "linear to the stall, flat plate beyond (equation 4.9)"
    return {
        "LIFT": function("CL_alpha", f"lift; {plate}", Q, S, alpha_table(rows, 1))
        + term("CL_q", a["CL_q"], (), BASIS["q"], "pitch rate")
        + term("CL_elevator", a["CL_elevator"], (), (elevator,), "elevator"),
        "DRAG": function("CD_alpha", f"drag; {plate}", Q, S, alpha_table(rows, 2))
        + term("CD_elevator", a["CD_elevator"], (), (square,), "elevator, either way"),
        "PITCH": term("Cm_0", a["Cm_0"], (C,), (), "pitch at zero lift angle")
        + term("Cm_alpha", a["Cm_alpha"], (C,), (ALPHA,), "static stability")
        + term("Cm_q", a["Cm_q"], (C,), BASIS["q"], "pitch damping")
        + term("Cm_elevator", a["Cm_elevator"], (C,), (elevator,), "elevator"),
    }


def lateral(c):
    table = {}
    for axis, (symbol, lengths) in AXES.items():
        factors = {**BASIS, "aileron": (angle("aileron"),), "rudder": (angle("rudder"),)}
        table[axis] = "".join(
            term(f"{symbol}_{k}", c["lateral"][f"{symbol}_{k}"], lengths, factors[k], k)
            for k in ("beta", "p", "r", "aileron", "rudder")
        )
    return table


def aerodynamics(c):
    axes = {**longitudinal(c), **lateral(c)}
    return "".join(f'    <axis name="{name}">\n{text}    </axis>\n' for name, text in axes.items())


def flight_control(c):
    servo = servo_properties(c["assumed"]["servo"])
    text = "".join(properties(name, servo) for name in SURFACES) + properties(MOTOR, MOTOR_PROPERTIES)
    text += "".join(servo_channel(name, f"fcs/{name}", 0.0, terms) for name, terms in SURFACES.items())
    return text + propeller_channel(MOTOR, f"fcs/{MOTOR}", 0, c["motor"])


def propeller_rows(c):
    """Rows (J, CT, CP): the book's polynomials, and beyond their range what grows with the square of J."""
    p, end = c["propeller"], c["assumed"]["polynomial_to_advance"]

    def of(coefficients, j):
        inside = min(j, end)
        return (
            sum(k * inside**i for i, k in enumerate(coefficients)) * (j / inside) ** 2
            if j
            else coefficients[0]
        )

    advances = [0.05 * i for i in range(round(20 * end) + 1)] + [1.5, 2, 3, 4, 6, 10, 20, 50, 100]
    return [(j, of(p["CT"], j), 2 * math.pi * of(p["CQ"], j)) for j in advances]


def hub(c):
    return location(c["assumed"]["pusher_x_m"], 0, 0)


def model(c):
    w, j = c["wing"], c["inertia_kg_m2"]
    centre = [location(0, 0, 0, name) for name in ("AERORP", "EYEPOINT", "VRP")]
    return f"""<?xml version="1.0"?>
<!-- Written by write.py from coefficients.yaml: change those, not this. Origin: the centre of gravity; x aft, y right, z up. -->
<fdm_config name="{NAME}" version="2.0" release="BETA">
  <fileheader><author>testbed</author><filecreationdate>2026-11-22</filecreationdate><version>1</version><description>Aerosonde UAV, coefficients of Beard and McLain</description></fileheader>
  <metrics>
    <wingarea unit="M2">{number(w["area_m2"])}</wingarea><wingspan unit="M">{number(w["span_m"])}</wingspan><chord unit="M">{number(w["chord_m"])}</chord>
    {"".join(centre)}
  </metrics>
  <mass_balance>
    <!-- JSBSim expects minus the integral of x z -->
    <ixx unit="KG*M2">{number(j["Jx"])}</ixx><iyy unit="KG*M2">{number(j["Jy"])}</iyy><izz unit="KG*M2">{number(j["Jz"])}</izz>
    <ixz unit="KG*M2">{number(-j["Jxz"])}</ixz>
    <emptywt unit="KG">{number(c["mass_kg"])}</emptywt>
    {location(0, 0, 0, "CG")}
  </mass_balance>
  <ground_reactions/> <!-- none: a flight ends above the ground -->
  <propulsion>
    <engine file="{NAME}_motor"><thruster file="{NAME}_prop"><sense>1</sense>
      {hub(c)}<orient unit="DEG"><roll>0</roll><pitch>0</pitch><yaw>0</yaw></orient></thruster></engine>
  </propulsion>
  <flight_control name="{NAME}">
{flight_control(c)}  </flight_control>
  <aerodynamics>
{aerodynamics(c)}  </aerodynamics>
  <external_reactions>
{lost_propeller(MOTOR, 0, hub(c))}  </external_reactions>
</fdm_config>
"""


def texts():
    """Text of each file, by its path in the folder."""
    c = yaml.safe_load((HERE / "coefficients.yaml").read_text())
    by = "Written by write.py from coefficients.yaml."
    inertia, diameter = c["assumed"]["rotor_inertia_kg_m2"], c["propeller"]["diameter_m"]
    return {
        f"{NAME}.xml": model(c),
        f"Engines/{NAME}_prop.xml": propeller_file(
            f"{NAME}_prop", f"{by} CP = 2 pi CQ.", inertia, diameter, 2, propeller_rows(c)
        ),
        f"Engines/{NAME}_motor.xml": motor_file(f"{NAME}_motor", by, c["motor"]),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare only; exit 1 if a file differs")
    check, files = parser.parse_args().check, texts()
    if check:
        different = [
            n for n, text in files.items() if not (HERE / n).exists() or (HERE / n).read_text() != text
        ]
        print("\n".join(f"differs: {n}" for n in different) or "identical")
        return 1 if different else 0
    for name, text in files.items():
        (HERE / name).parent.mkdir(exist_ok=True)
        (HERE / name).write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
