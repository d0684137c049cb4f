"""Skeleton generator: writes vtail.xml and the engine files from numbers (to be replaced by derive.py)."""
from pathlib import Path
import numpy as np
here = Path(__file__).parent
S, b, c = 0.55, 2.0, 0.28
kF = 0.09                      # m2/rad panel normal force per qbar per rad
G = np.radians(42.0); arm = 0.9; rollarm = 0.06; droll = 0.0
# per-surface coefficients, trailing edge down positive; left panel normal points up and to the right (+y) -> left: Y +
surf = {}
for side, sg in (("left", 1.0), ("right", -1.0)):
    lift = kF*np.cos(G)/S
    Y = sg*kF*np.sin(G)/S
    # roll: force up on left panel at y<0 rolls right (+); spanwise arm rollarm total
    l = sg*kF*rollarm/(S*b)
    m = -kF*np.cos(G)*arm/(S*c)
    n = -sg*kF*np.sin(G)*arm/(S*b)
    surf[side] = (lift, Y, l, m, n)

def func(name, desc, *terms, const=None):
    t = "".join(f"<property>{x}</property>" for x in terms)
    v = "" if const is None else f"<value>{const:.6g}</value>"
    return f'      <function name="aero/coefficient/{name}"><description>{desc}</description><product>{t}{v}</product></function>\n'
q, Sw, bw, cw = "aero/qbar-psf", "metrics/Sw-sqft", "metrics/bw-ft", "metrics/cbarw-ft"
al, be = "aero/alpha-rad", "aero/beta-rad"
P, Q, R = "velocities/p-aero-rad_sec", "velocities/q-aero-rad_sec", "velocities/r-aero-rad_sec"
bi, ci = "aero/bi2vel", "aero/ci2vel"
a0 = np.radians(2.0)
CLa = 5.2
CL0 = 0.45 - CLa*np.radians(3.0)
aero = ""
aero += '    <axis name="LIFT">\n'
aero += func("CL0", "lift at zero alpha", q, Sw, const=CL0)
aero += func("CL_alpha", "lift slope", q, Sw, al, const=CLa)
aero += func("CL_q", "lift due to pitch rate", q, Sw, Q, ci, const=7.0)
for s in surf: aero += func(f"CL_{s}", "ruddervator lift", q, Sw, f"fcs/{s}-ruddervator/effective-rad", const=surf[s][0])
aero += '    </axis>\n    <axis name="DRAG">\n'
aero += func("CD0", "zero-lift drag", q, Sw, const=0.035)
aero += f'      <function name="aero/coefficient/CD_i"><description>induced drag</description><product><property>{q}</property><property>{Sw}</property><pow><sum><value>{CL0:.6g}</value><product><value>{CLa}</value><property>{al}</property></product></sum><value>2</value></pow><value>0.05</value></product></function>\n'
aero += '    </axis>\n    <axis name="SIDE">\n'
aero += func("CY_beta", "side force", q, Sw, be, const=-0.35)
aero += func("CY_p", "", q, Sw, P, bi, const=0.0)
aero += func("CY_r", "", q, Sw, R, bi, const=0.15)
for s in surf: aero += func(f"CY_{s}", "ruddervator side force", q, Sw, f"fcs/{s}-ruddervator/effective-rad", const=surf[s][1])
aero += '    </axis>\n    <axis name="ROLL">\n'
aero += func("Cl_beta", "dihedral", q, Sw, bw, be, const=-0.05)
aero += func("Cl_p", "roll damping", q, Sw, bw, P, bi, const=-0.48)
aero += func("Cl_r", "roll due to yaw", q, Sw, bw, R, bi, const=0.10)
for s in surf: aero += func(f"Cl_{s}", "ruddervator roll", q, Sw, bw, f"fcs/{s}-ruddervator/effective-rad", const=surf[s][2])
aero += '    </axis>\n    <axis name="PITCH">\n'
thrust_z, T = 0.06, 5.94
trim = np.radians(2.8)
qb = 0.5*1.19*18**2
alpha_trim = np.radians(3.0)
Cm0 = -(2*surf["left"][3]*trim) + 1.2*alpha_trim - thrust_z*T/(qb*S*c)
aero += func("Cm0", "", q, Sw, cw, const=Cm0)
aero += func("Cm_alpha", "", q, Sw, cw, al, const=-1.2)
aero += func("Cm_q", "", q, Sw, cw, Q, ci, const=-14.0)
aero += func("Cm_alphadot", "", q, Sw, cw, "aero/alphadot-rad_sec", ci, const=-4.0)
for s in surf: aero += func(f"Cm_{s}", "ruddervator pitch", q, Sw, cw, f"fcs/{s}-ruddervator/effective-rad", const=surf[s][3])
aero += '    </axis>\n    <axis name="YAW">\n'
aero += func("Cn_beta", "", q, Sw, bw, be, const=0.075)
aero += func("Cn_p", "", q, Sw, bw, P, bi, const=-0.04)
aero += func("Cn_r", "", q, Sw, bw, R, bi, const=-0.12)
for s in surf: aero += func(f"Cn_{s}", "ruddervator yaw", q, Sw, bw, f"fcs/{s}-ruddervator/effective-rad", const=surf[s][4])
aero += '    </axis>\n'

def props(name, vals):
    return "".join(f'    <property value="{v}">fcs/{name}/{k}</property>\n' for k, v in vals.items())
fcs = ""
lim = np.radians(25.8)
for s in ("left", "right"):
    n = f"{s}-ruddervator"
    fcs += props(n, {"command-rad": 0, "command-scale": 1, "command-bias-rad": 0, "override-active": 0, "override-rad": 0, "servo-lag-rad_sec": 30, "servo-rate-rad_sec": 7, "servo-min-rad": -lim, "servo-max-rad": lim, "linkage-bias-rad": 0, "float-active": 0, "float-gain": 0.8, "effectiveness": 1})
for i, s in enumerate(("left", "right")):
    n = f"{s}-propeller"
    fcs += props(n, {"command-norm": 0, "command-scale": 1, "command-bias-norm": 0, "override-active": 0, "override-norm": 0, "throttle-min-norm": 0, "throttle-max-norm": 1, "power-lost": 0, "effectiveness": 1})
for s in ("left", "right"):
    n = f"fcs/{s}-ruddervator"
    fcs += f'''    <channel name="{s} ruddervator">
      <fcs_function name="{n}/demand-rad"><function><ifthen><property>{n}/override-active</property><property>{n}/override-rad</property>
        <sum><product><property>{n}/command-rad</property><property>{n}/command-scale</property></product><property>{n}/command-bias-rad</property></sum></ifthen></function></fcs_function>
      <actuator name="{n}/servo"><input>{n}/demand-rad</input><lag>{n}/servo-lag-rad_sec</lag><rate_limit>{n}/servo-rate-rad_sec</rate_limit>
        <clipto><min>{n}/servo-min-rad</min><max>{n}/servo-max-rad</max></clipto><output>{n}/servo-rad</output></actuator>
      <fcs_function name="{n}/incidence-rad"><function><sum><value>0</value><property>aero/alpha-rad</property></sum></function></fcs_function>
      <fcs_function name="{n}/position-rad"><function><ifthen><property>{n}/float-active</property>
        <product><value>-1</value><property>{n}/float-gain</property><property>{n}/incidence-rad</property></product>
        <sum><property>{n}/servo-rad</property><property>{n}/linkage-bias-rad</property></sum></ifthen></function></fcs_function>
      <fcs_function name="{n}/effective-rad"><function><product><property>{n}/effectiveness</property><property>{n}/position-rad</property></product></function></fcs_function>
    </channel>
'''
for i, s in enumerate(("left", "right")):
    n = f"fcs/{s}-propeller"
    fcs += f'''    <channel name="{s} propeller">
      <!-- without power no current flows: the motor is held at the voltage that it generates, and windmills -->
      <fcs_function name="{n}/throttle-norm"><function><ifthen><property>{n}/power-lost</property>
        <product><property>propulsion/engine[{i}]/propeller-rpm</property><value>{1/(230*22.2):.6g}</value></product>
        <max><property>{n}/throttle-min-norm</property><min><property>{n}/throttle-max-norm</property>
        <ifthen><property>{n}/override-active</property><property>{n}/override-norm</property>
        <sum><product><property>{n}/command-norm</property><property>{n}/command-scale</property></product><property>{n}/command-bias-norm</property></sum></ifthen></min></max></ifthen></function>
        <output>fcs/throttle-pos-norm[{i}]</output></fcs_function>
    </channel>
'''
prop, ext = "", ""
yy, zz, xx = 0.30, -thrust_z, -0.15
for i, (s, sg, sense) in enumerate((("left", -1, -1), ("right", 1, 1))):
    prop += f'''    <engine file="vtail_motor"><thruster file="vtail_prop"><sense>{sense}</sense>
      <location unit="M"><x>{xx}</x><y>{sg*yy}</y><z>{zz}</z></location><orient unit="DEG"><roll>0</roll><pitch>0</pitch><yaw>0</yaw></orient></thruster></engine>
'''
    n = f"fcs/{s}-propeller"
    loss = f"<difference><property>{n}/effectiveness</property><value>1</value></difference>"
    ext += f'''    <force name="{s}-propeller-loss" frame="BODY"><function name="{n}/lost-thrust-lbs"><product>{loss}<property>propulsion/engine[{i}]/thrust-lbs</property></product></function>
      <location unit="M"><x>{xx}</x><y>{sg*yy}</y><z>{zz}</z></location><direction><x>1</x><y>0</y><z>0</z></direction></force>
    <moment name="{s}-propeller-loss-torque" frame="BODY"><function><product>{loss}<property>propulsion/engine[{i}]/propeller-torque-ftlb</property></product></function>
      <direction><x>1</x><y>0</y><z>0</z></direction></moment>
'''
xml = f'''<?xml version="1.0"?>
<fdm_config name="vtail" version="2.0" release="BETA">
  <fileheader><author>testbed</author><filecreationdate>2026-11-21</filecreationdate><version>1</version><description>Small v-tail UAV</description></fileheader>
  <metrics><wingarea unit="M2">{S}</wingarea><wingspan unit="M">{b}</wingspan><chord unit="M">{c}</chord>
    <htailarea unit="M2">0</htailarea><htailarm unit="M">0</htailarm><vtailarea unit="M2">0</vtailarea><vtailarm unit="M">0</vtailarm>
    <location name="AERORP" unit="M"><x>0</x><y>0</y><z>0</z></location><location name="EYEPOINT" unit="M"><x>0</x><y>0</y><z>0</z></location><location name="VRP" unit="M"><x>0</x><y>0</y><z>0</z></location></metrics>
  <mass_balance><ixx unit="KG*M2">0.22</ixx><iyy unit="KG*M2">0.32</iyy><izz unit="KG*M2">0.62</izz><emptywt unit="KG">4.95</emptywt>
    <location name="CG" unit="M"><x>-0.01</x><y>0</y><z>0</z></location>
    <pointmass name="left ruddervator"><weight unit="KG">0.025</weight><location name="POINTMASS" unit="M"><x>0.99</x><y>-0.15</y><z>0</z></location></pointmass>
    <pointmass name="right ruddervator"><weight unit="KG">0.025</weight><location name="POINTMASS" unit="M"><x>0.99</x><y>0.15</y><z>0</z></location></pointmass></mass_balance>
  <ground_reactions>
    <contact type="STRUCTURE" name="BELLY"><location unit="M"><x>0</x><y>0</y><z>-0.15</z></location><static_friction>0.5</static_friction><dynamic_friction>0.4</dynamic_friction><spring_coeff unit="N/M">5000</spring_coeff><damping_coeff unit="N/M/SEC">200</damping_coeff></contact>
  </ground_reactions>
  <propulsion>
{prop}  </propulsion>
  <flight_control name="vtail">
{fcs}  </flight_control>
  <aerodynamics>
{aero}  </aerodynamics>
  <external_reactions>
{ext}  </external_reactions>
</fdm_config>
'''
(here/"vtail.xml").write_text(xml)
J = np.linspace(0, 1.4, 29)
CT = 0.1*(1-(J/0.95)**1.6); CP = 0.06*(1-(J/1.0)**2.2)
CT = np.maximum(CT, -0.08); CP = np.maximum(CP, -0.03)
tab = lambda y: "\n".join(f"      {a:.3f} {v:.6f}" for a, v in zip(J, y))
(here/"Engines/vtail_prop.xml").write_text(f'''<?xml version="1.0"?>
<propeller name="vtail_prop" version="1.1">
  <ixx unit="KG*M2">3.0e-4</ixx><diameter unit="M">0.4826</diameter><numblades>2</numblades><gearratio>1</gearratio><constspeed>0</constspeed>
  <table name="C_THRUST" type="internal"><tableData>
{tab(CT)}
  </tableData></table>
  <table name="C_POWER" type="internal"><tableData>
{tab(CP)}
  </tableData></table>
</propeller>
''')
(here/"Engines/vtail_motor.xml").write_text('''<?xml version="1.0"?>
<brushless_dc_motor name="vtail_motor"><maxvolts unit="VOLTS">22.2</maxvolts><velocityconstant>230</velocityconstant><coilresistance unit="OHMS">0.2</coilresistance><noloadcurrent unit="AMPERES">0.6</noloadcurrent></brushless_dc_motor>
''')
