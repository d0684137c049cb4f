"""What makes a property a surface's position: a stick, or a name of JSBSim's, and a moment."""

import xml.etree.ElementTree as ET

import pytest

from testbed.adoption.wiring import STICKS, Wiring

MODEL = ET.fromstring("""<fdm_config>
  <flight_control><channel name="all">
    <summer name="Pitch Sum"><input>fcs/elevator-cmd-norm</input><input>-fcs/trim</input></summer>
    <aerosurface_scale name="Tail"><input>fcs/pitch-sum</input><output>fcs/flipper-pos-rad</output></aerosurface_scale>
    <switch name="fcs/canard-pos-rad"><default value="0"/><test value="-fcs/flipper-pos-rad">gear/gear-pos-norm lt 1</test></switch>
    <kinematic name="Flaps"><input>fcs/flap-cmd-norm</input><output>fcs/flap-pos-deg</output></kinematic>
  </channel></flight_control>
  <aerodynamics>
    <function name="aero/tail"><property>fcs/flipper-pos-rad</property></function>
    <axis name="LIFT"><function name="aero/cl"><property>fcs/flap-pos-deg</property></function></axis>
    <axis name="Pitch"><function name="aero/cm"><product><property>aero/tail</property><value>2</value></product></function></axis>
  </aerodynamics>
  <external_reactions><force name="jet"><function><p>fcs/vane-pos-rad[0]</p></function></force></external_reactions>
</fdm_config>""")


@pytest.mark.parametrize("name", ["fcs/flipper-pos-rad", "fcs/canard-pos-rad"])
def test_a_stick_is_followed_through_components_and_switches(name):
    wiring = Wiring(MODEL)
    assert wiring.follows([name], [STICKS["pitch"]])
    assert not wiring.follows([name], [STICKS["roll"], "fcs/flap-cmd-norm"])


def test_flaps_follow_their_own_command_alone():
    wiring = Wiring(MODEL)
    assert not wiring.follows(["fcs/flap-pos-deg"], STICKS.values())
    assert wiring.follows(["fcs/flap-pos-deg"], ["fcs/flap-cmd-norm"])


def test_what_turns_the_aircraft_is_read_by_a_moment_or_an_external_reaction():
    wiring = Wiring(MODEL)
    assert wiring.turns(["fcs/flipper-pos-rad"]), "through a function of its own"
    assert wiring.turns(["fcs/vane-pos-rad"])
    assert not wiring.turns(["fcs/flap-pos-deg"]), "lift alone"
