"""Write the JSBSim files of the v-tail from the numbers of derive.py.

Left and right are printed from the same number, so that mirror images agree to the last digit.
"""

# ruff: noqa: E501 - lines of XML stay whole

import math

Q, S, B, C = "aero/qbar-psf", "metrics/Sw-sqft", "metrics/bw-ft", "metrics/cbarw-ft"
ALPHA, BETA, ALPHADOT = "aero/alpha-rad", "aero/beta-rad", "aero/alphadot-rad_sec"
P, Q_RATE, R = "velocities/p-aero-rad_sec", "velocities/q-aero-rad_sec", "velocities/r-aero-rad_sec"
B2V, C2V = "aero/bi2vel", "aero/ci2vel"
SIDES = (("left", -1), ("right", 1))
LATTICE = "vortex lattice (AeroSandbox)"


def number(x):
    """A number with six digits; rounding errors near zero, and negative zero, are printed as 0."""
    return f"{x:.6g}" if abs(x) > 1e-12 else "0"


def function(name, text, *factors):
    inside = "".join(f if f.startswith("<") else f"<property>{f}</property>" for f in factors)
    return (
        f'      <function name="aero/coefficient/{name}">\n        <description>{text}</description>\n'
        f"        <product>{inside}</product>\n      </function>\n"
    )


def value(x):
    return f"<value>{number(x)}</value>"


def alpha_table(rows, column):
    data = "\n".join(f"            {row[0]:.6f} {number(row[column])}" for row in rows)
    return (
        f'<table>\n          <independentVar lookup="row">{ALPHA}</independentVar>\n          <tableData>\n{data}\n'
        "          </tableData></table>"
    )


def ruddervators(axis, c, area, *lengths):
    """The terms of both ruddervators in one axis. Longitudinal terms are equal, lateral ones opposite."""
    text = f"one ruddervator, trailing edge down positive, with its panel's slipstream; {LATTICE} x viscous factor"
    out = ""
    for side, _ in SIDES:
        lateral = -1 if axis in ("CY", "Cl", "Cn") and side == "right" else 1
        out += function(
            f"{axis}_{side}",
            text,
            Q,
            S,
            *lengths,
            f"aero/{side}-tail/loading-rad",
            value(lateral * c[f"{axis}_left"]),
        )
    return out


def flap_drag(c):
    out = ""
    for side, _ in SIDES:
        angle = f"fcs/{side}-ruddervator/effective-rad"
        square = f"<pow><sin><property>{angle}</property></sin><value>2</value></pow>"
        text = "profile drag of one deflected ruddervator; hand-book (plain flap, sine squared)"
        out += function(f"CD_{side}_profile", text, Q, S, square, value(c["CD_left2"]))
    return out


def rates(axis, c):
    """Roll- and yaw-rate terms of a lateral axis."""
    lengths = () if axis == "CY" else (B,)
    extra = {"Cn_r": " + profile drag of the wing (strip theory)"}
    return "".join(
        function(
            f"{axis}_{k}",
            f"{word} rate; {LATTICE}{extra.get(f'{axis}_{k}', '')}",
            Q,
            S,
            *lengths,
            prop,
            B2V,
            value(c[f"{axis}_{k}"]),
        )
        for k, word, prop in (("p", "roll", P), ("r", "yaw", R))
    )


def aerodynamics(c):
    stall = "straight line to the stall, flat plate beyond"
    both = f"{LATTICE} + propellers' normal force (DeYoung)"
    axes = {
        "LIFT": function("CL_alpha", f"lift; {both}; {stall}", Q, S, alpha_table(c["angles"], 1))
        + function("CL_q", f"pitch rate; {LATTICE}", Q, S, Q_RATE, C2V, value(c["CL_q"]))
        + function("CL_alphadot", "lag of downwash; lattice's tail and downwash gradient", "aero/qbarUW-psf", S, ALPHADOT, C2V, value(c["CL_alphadot"]))
        + ruddervators("CL", c, S),
        "DRAG": function("CD_alpha", f"parasite build-up (hand-book) + induced ({LATTICE}); {stall}", Q, S, alpha_table(c["angles"], 2))
        + ruddervators("CD", c, S)
        + flap_drag(c),
        "SIDE": function("CY_beta", f"sideslip; {LATTICE} + pod (slender body) + propellers", Q, S, BETA, value(c["CY_beta"]))
        + rates("CY", c)
        + ruddervators("CY", c, S),
        "ROLL": function("Cl_beta", f"dihedral effect; {LATTICE} + high wing on pod (DATCOM)", Q, S, B, BETA, value(c["Cl_beta"]))
        + rates("Cl", c)
        + ruddervators("Cl", c, S, B),
        "PITCH": function("Cm_alpha", f"pitch; {LATTICE} + pod (Munk) + propellers + drag arms; {stall}", Q, S, C, alpha_table(c["angles"], 3))
        + function("Cm_q", f"pitch damping; {LATTICE}", Q, S, C, Q_RATE, C2V, value(c["Cm_q"]))
        + function("Cm_alphadot", "lag of downwash; lattice's tail and downwash gradient", "aero/qbarUW-psf", S, C, ALPHADOT, C2V, value(c["Cm_alphadot"]))
        + ruddervators("Cm", c, S, C),
        "YAW": function("Cn_beta", f"weathercock; {LATTICE} - pod (Munk) - propellers", Q, S, B, BETA, value(c["Cn_beta"]))
        + rates("Cn", c)
        + ruddervators("Cn", c, S, B),
    }  # fmt: skip
    return "".join(f'    <axis name="{name}">\n{text}    </axis>\n' for name, text in axes.items())


def reach_table(c, sign):
    """Share of a tail panel inside its propeller's slipstream, by alpha and beta; the right one is the left one mirrored."""
    alphas, betas, rows = c["slipstream"]["reach"]
    head = " ".join(f"{b:.6f}" for b in betas)
    data = "\n".join(
        f"            {a:.6f} {' '.join(map(number, row[::-sign]))}"
        for a, row in zip(alphas, rows, strict=True)
    )
    return (
        f'<table>\n          <independentVar lookup="row">{ALPHA}</independentVar>'
        f'<independentVar lookup="column">{BETA}</independentVar>\n          <tableData>\n'
        f"            {head}\n{data}\n          </tableData></table>"
    )


def tail_loading(g, m, c, reference):
    """Deflection that gives a ruddervator in the free stream the load of its panel in the slipstream.

    In the slipstream the speed along the propeller's axis is (1 + w) times the airspeed. The load of a panel goes with the product
    of that speed and the air's velocity across the panel. The panel's own incidence and its ruddervator turn the faster stream:
    their load grows by (1 + w)^2 - 1. The velocity across the panel that comes from alpha, beta and rates does not change: its load
    grows by w (Jameson, NASA CR-1632, 1970; Smelt and Davies, ARC R&M 1788, 1937).
    """
    s, t, chord = c["slipstream"], g["tail"], reference[2]
    dihedral, own = math.radians(t["dihedral_deg"]), math.radians(t["incidence_deg"])
    arm = 2 * (t["quarter_chord_x_m"] - m["cg_m"][0]) / chord
    text = ""
    for side, sign in SIDES:
        n, w = f"fcs/{side}-ruddervator", f"<property>fcs/{side}-slipstream/excess</property>"
        along_alpha, along_beta = across(c["downwash"], dihedral, sign)
        text += f"""    <function name="aero/{side}-tail/loading-rad">
      <description>ruddervator's deflection, and the change of its panel's load by the slipstream as more deflection</description>
      <sum><property>{n}/effective-rad</property>
        <product>{reach_table(c, sign)}
          {w}
          <sum><product><sum><value>2</value>{w}</sum><sum><property>{n}/effective-rad</property>{value(s["flap_per_turn"] * own)}</sum></product>
            <product>{value(s["flap_per_turn"])}<sum>{value(zero_incidence(g, c) - own)}
              <product><property>{ALPHA}</property>{value(along_alpha)}</product><product><property>{BETA}</property>{value(along_beta)}</product>
              <product><property>{Q_RATE}</property><property>{C2V}</property>{value(arm * math.cos(dihedral))}</product>
              <product><property>{R}</property><property>{C2V}</property>{value(-sign * arm * math.sin(dihedral))}</product></sum></product></sum></product></sum>
    </function>
"""
    return text


def across(gradient, dihedral, sign):
    """Incidence of the air at a tail panel per rad of alpha and of beta; `sign` is -1 for the left panel."""
    return (1 - gradient) * math.cos(dihedral), sign * math.sin(dihedral)


def zero_incidence(g, c):
    """Incidence of a panel at zero alpha and beta [rad]: its own, less the downwash, which is zero at zero lift.

    A panel's own incidence is about its own span; of the downwash it meets the part across it.
    """
    dihedral = math.radians(g["tail"]["dihedral_deg"])
    return (
        math.radians(g["tail"]["incidence_deg"])
        - math.cos(dihedral) * c["downwash"] * c["CL0"] / c["CL_alpha"]
    )


def location(x, y, z, name=""):
    label = f' name="{name}"' if name else ""
    return f'<location{label} unit="M"><x>{number(x)}</x><y>{number(y)}</y><z>{number(z)}</z></location>'


def metrics(g, m, reference):
    area, span, chord = reference
    t = g["tail"]
    panels = t["panel_span_m"] * (t["root_chord_m"] + t["tip_chord_m"])
    level, upright = (
        math.cos(math.radians(t["dihedral_deg"])) ** 2,
        math.sin(math.radians(t["dihedral_deg"])) ** 2,
    )
    arm = t["quarter_chord_x_m"] - m["cg_m"][0]
    return f"""    <wingarea unit="M2">{number(area)}</wingarea><wingspan unit="M">{number(span)}</wingspan><chord unit="M">{number(chord)}</chord>
    <htailarea unit="M2">{number(panels * level)}</htailarea><htailarm unit="M">{number(arm)}</htailarm>
    <vtailarea unit="M2">{number(panels * upright)}</vtailarea><vtailarm unit="M">{number(arm)}</vtailarm>
    {location(*m["cg_m"], "AERORP")}{location(*m["cg_m"], "EYEPOINT")}{location(*m["cg_m"], "VRP")}
"""


def mass_balance(m):
    ixx, iyy, izz, ixz = m["empty_inertia"]
    # JSBSim expects minus the integral of x z (default negated_crossproduct_inertia)
    text = f"""    <ixx unit="KG*M2">{number(ixx)}</ixx><iyy unit="KG*M2">{number(iyy)}</iyy><izz unit="KG*M2">{number(izz)}</izz>
    <ixz unit="KG*M2">{number(-ixz)}</ixz>
    <emptywt unit="KG">{number(m["empty_kg"])}</emptywt>
    {location(*m["empty_cg_m"], "CG")}
    <!-- inertia/pointmass-weight-lbs[0] left, [1] right: set to zero when the surface is lost -->
"""
    for p in m["points"]:
        text += f'    <pointmass name="{p["name"]}"><weight unit="KG">{number(p["mass_kg"])}</weight>{location(*p["at_m"], "POINTMASS")}</pointmass>\n'
    return text


def hub(g, sign):
    p = g["propulsion"]
    return location(p["x_m"], sign * p["y_m"], p["z_m"])


def propulsion(g):
    return "".join(
        f"""    <engine file="{g["name"]}_motor"><thruster file="{g["name"]}_prop"><sense>{g["propulsion"][f"{side}_sense"]}</sense>
      {hub(g, sign)}<orient unit="DEG"><roll>0</roll><pitch>0</pitch><yaw>0</yaw></orient></thruster></engine>
"""
        for side, sign in SIDES
    )


def properties(block, values):
    return "".join(
        f'    <property value="{number(v)}">fcs/{block}/{k}</property>\n' for k, v in values.items()
    )


def servo_channel(name, n, zero, terms):
    """From command to effective deflection of the servo whose block is `n`.

    The air meets its surface at `zero` + sum of value x property over `terms` [rad], which a floating surface aligns with.
    """
    incidence = "".join(f"<product><property>{p}</property>{value(v)}</product>" for p, v in terms)
    return f'''    <channel name="{name}">
      <fcs_function name="{n}/demand-rad"><function><ifthen><property>{n}/override-active</property><property>{n}/override-rad</property>
        <sum><product><property>{n}/command-rad</property><property>{n}/command-scale</property></product><property>{n}/command-bias-rad</property></sum></ifthen></function></fcs_function>
      <actuator name="{n}/servo"><input>{n}/demand-rad</input><lag>{n}/servo-lag-rad_sec</lag><rate_limit>{n}/servo-rate-rad_sec</rate_limit>
        <clipto><min>{n}/servo-min-rad</min><max>{n}/servo-max-rad</max></clipto><output>{n}/servo-rad</output></actuator>
      <!-- incidence of the air at this panel: what a free surface aligns with -->
      <fcs_function name="{n}/incidence-rad"><function><sum>{value(zero)}
        {incidence}</sum></function></fcs_function>
      <fcs_function name="{n}/position-rad"><function><ifthen><property>{n}/float-active</property>
        <product><value>-1</value><property>{n}/float-gain</property><property>{n}/incidence-rad</property></product>
        <sum><property>{n}/servo-rad</property><property>{n}/linkage-bias-rad</property></sum></ifthen></function></fcs_function>
      <fcs_function name="{n}/effective-rad"><function><product><property>{n}/effectiveness</property><property>{n}/position-rad</property></product></function></fcs_function>
    </channel>
'''


def ruddervator_channel(g, side, sign, gradient, zero):
    along_alpha, along_beta = across(gradient, math.radians(g["tail"]["dihedral_deg"]), sign)
    terms = [(ALPHA, along_alpha), (BETA, along_beta)]
    return servo_channel(f"{side} ruddervator", f"fcs/{side}-ruddervator", zero, terms)


SQUARE_FEET, FEET, NO_PRESSURE_PSF = 0.3048**2, 0.3048, 0.5


def slipstream_channel(c, index, side):
    """Excess of speed far behind a propeller over the airspeed: actuator disc (Glauert), lagged by the way to the tail.

    (1 + w)^2 - 1 = T / (qbar A). A broken propeller's stream is that of what is left of its thrust.
    """
    n, s = f"fcs/{side}-slipstream", c["slipstream"]
    return f"""      <fcs_function name="{n}/at-disc"><function><product><property>fcs/slipstream-active</property>
        <difference><sqrt><max><value>0</value><sum><value>1</value><quotient>
          <product><property>fcs/{side}-propeller/effectiveness</property><property>propulsion/engine[{index}]/thrust-lbs</property></product>
          <product>{value(s["disc_m2"] / SQUARE_FEET)}<max>{value(NO_PRESSURE_PSF)}<property>{Q}</property></max></product></quotient></sum></max></sqrt><value>1</value></difference></product></function></fcs_function>
      <fcs_function name="{n}/lag-rad_sec"><function><product><property>velocities/vt-fps</property>{value(FEET / s["distance_m"])}</product></function></fcs_function>
      <lag_filter name="{n}/excess"><input>{n}/at-disc</input><c1>{n}/lag-rad_sec</c1></lag_filter>
"""


def propeller_channel(name, n, index, motor, more=""):
    """From command to throttle of the motor whose block is `n`; `more` are further components."""
    volts_per_rpm = 1 / (motor["velocity_constant_rpm_v"] * motor["max_volts"])
    return f'''    <channel name="{name}">
      <!-- without power no current flows: the motor is held at the voltage that it generates, and windmills -->
      <fcs_function name="{n}/throttle-norm"><function><ifthen><property>{n}/power-lost</property>
        <product><property>propulsion/engine[{index}]/propeller-rpm</property>{value(volts_per_rpm)}</product>
        <max><property>{n}/throttle-min-norm</property><min><property>{n}/throttle-max-norm</property>
        <ifthen><property>{n}/override-active</property><property>{n}/override-norm</property>
        <sum><product><property>{n}/command-norm</property><property>{n}/command-scale</property></product><property>{n}/command-bias-norm</property></sum></ifthen></min></max></ifthen></function>
        <output>fcs/throttle-pos-norm[{index}]</output></fcs_function>
{more}    </channel>
'''


MOTOR_PROPERTIES = {
    "command-norm": 0, "command-scale": 1, "command-bias-norm": 0, "override-active": 0, "override-norm": 0,
    "throttle-min-norm": 0, "throttle-max-norm": 1, "power-lost": 0, "effectiveness": 1,
}  # fmt: skip


def servo_properties(servo):
    limit = math.radians(servo["limit_deg"])
    return {
        "command-rad": 0, "command-scale": 1, "command-bias-rad": 0, "override-active": 0, "override-rad": 0,
        "servo-lag-rad_sec": servo["lag_rad_s"], "servo-rate-rad_sec": servo["rate_rad_s"], "servo-min-rad": -limit,
        "servo-max-rad": limit, "linkage-bias-rad": 0, "float-active": 0, "float-gain": servo["float_gain"], "effectiveness": 1,
    }  # fmt: skip


def flight_control(g, c):
    zero = zero_incidence(g, c)
    text = f'    <property value="{int(c["slipstream"]["active"])}">fcs/slipstream-active</property>\n'
    text += "".join(properties(f"{side}-ruddervator", servo_properties(g["servo"])) for side, _ in SIDES)
    text += "".join(properties(f"{side}-propeller", MOTOR_PROPERTIES) for side, _ in SIDES)
    text += "".join(ruddervator_channel(g, side, sign, c["downwash"], zero) for side, sign in SIDES)
    motor = g["propulsion"]["motor"]
    return text + "".join(
        propeller_channel(
            f"{side} propeller", f"fcs/{side}-propeller", i, motor, slipstream_channel(c, i, side)
        )
        for i, (side, _) in enumerate(SIDES)
    )


def lost_propeller(n, index, place):
    """Force and moment that remove (1 - effectiveness) of a propeller's thrust and torque, in the same step."""
    loss = f"<difference><property>fcs/{n}/effectiveness</property><value>1</value></difference>"
    return f"""    <force name="{n}-loss" frame="BODY"><function name="fcs/{n}/lost-thrust-lbs"><product>{loss}<property>propulsion/engine[{index}]/thrust-lbs</property></product></function>
      {place}<direction><x>1</x><y>0</y><z>0</z></direction></force>
    <moment name="{n}-loss-torque" frame="BODY"><function><product>{loss}<property>propulsion/engine[{index}]/propeller-torque-ftlb</property></product></function>
      <direction><x>1</x><y>0</y><z>0</z></direction></moment>
"""


def external_reactions(g):
    return "".join(
        lost_propeller(f"{side}-propeller", i, hub(g, sign)) for i, (side, sign) in enumerate(SIDES)
    )


def aircraft(g, m, c, reference):
    return f"""<?xml version="1.0"?>
<!-- Written by derive.py from geometry.yaml: change those, not this. -->
<fdm_config name="{g["name"]}" version="2.0" release="BETA">
  <fileheader><author>testbed</author><filecreationdate>2026-11-21</filecreationdate><version>2</version><description>Small v-tail UAV</description></fileheader>
  <metrics>
{metrics(g, m, reference)}  </metrics>
  <mass_balance>
{mass_balance(m)}  </mass_balance>
  <ground_reactions/> <!-- none: a flight ends above the ground, and each contact point would cost time in every step -->
  <propulsion>
{propulsion(g)}  </propulsion>
  <flight_control name="{g["name"]}">
{flight_control(g, c)}  </flight_control>
  <aerodynamics>
{tail_loading(g, m, c, reference)}{aerodynamics(c)}  </aerodynamics>
  <external_reactions>
{external_reactions(g)}  </external_reactions>
</fdm_config>
"""


def propeller_file(name, comment, inertia, diameter_m, blades, table):
    """`table`: rows (J, CT, CP)."""

    def rows(column):
        return "\n".join(f"      {row[0]:.3f} {row[column]:.6f}" for row in table)

    return f"""<?xml version="1.0"?>
<!-- {comment} -->
<propeller name="{name}" version="1.1">
  <ixx unit="KG*M2">{number(inertia)}</ixx><diameter unit="M">{number(diameter_m)}</diameter><numblades>{blades}</numblades><gearratio>1</gearratio><constspeed>0</constspeed>
  <table name="C_THRUST" type="internal"><tableData>
{rows(1)}
  </tableData></table>
  <table name="C_POWER" type="internal"><tableData>
{rows(2)}
  </tableData></table>
</propeller>
"""


def own_propeller_file(g, table):
    p, motor = g["propulsion"]["propeller"], g["propulsion"]["motor"]
    inertia = p["mass_kg"] * (p["gyration_ratio"] * 0.5 * p["diameter_m"]) ** 2 + motor["can_inertia_kg_m2"]
    comment = """Written by derive.py: blade-element momentum theory (propeller.py) on the blade of geometry.yaml. Inertia: propeller and motor bell.
     Rows past J = 2 are the windmilling and standing rotor; table in J, so their values grow with J squared."""
    return propeller_file(f"{g['name']}_prop", comment, inertia, p["diameter_m"], p["blades"], table)


def motor_file(name, comment, motor):
    return f"""<?xml version="1.0"?>
<!-- {comment} -->
<brushless_dc_motor name="{name}">
  <maxvolts unit="VOLTS">{number(motor["max_volts"])}</maxvolts><velocityconstant>{number(motor["velocity_constant_rpm_v"])}</velocityconstant>
  <coilresistance unit="OHMS">{number(motor["resistance_ohm"])}</coilresistance><noloadcurrent unit="AMPERES">{number(motor["no_load_current_a"])}</noloadcurrent>
</brushless_dc_motor>
"""


def write(g, m, c, table, reference):
    """Text of each file, by its path in the aircraft's folder."""
    name = g["name"]
    return {
        f"{name}.xml": aircraft(g, m, c, reference),
        f"Engines/{name}_prop.xml": own_propeller_file(g, table),
        f"Engines/{name}_motor.xml": motor_file(
            f"{name}_motor",
            "Written by derive.py. Resistance is motor, speed controller, wires and battery.",
            g["propulsion"]["motor"],
        ),
    }
