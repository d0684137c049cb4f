"""Blocks have every property that failures and receipts use, and aircraft with them fly and break."""

import xml.etree.ElementTree as ET

from testbed.adoption.blocks import engine_block, prefix_of, servo_block
from testbed.adoption.controls import PISTON, TURBINE, Propulsor, Reading, Surface
from testbed.injection.receipt import MOTOR, SERVO

_SERVO = [name for name in SERVO if "malfunction" not in name]  # which JSBSim makes itself
SURFACE = Surface("left_aileron", (Reading("fcs/left-aileron-pos-rad"),), (-0.3, 0.2), "roll")


def names(block):
    values, channel = block
    return (
        set(values) | {each.get("name") for each in channel} | {each.text for each in channel.iter("output")}
    )


def test_a_servos_block_is_whole():
    prefix = prefix_of("left_aileron")
    assert prefix == "actuator/left-aileron"
    assert {f"{prefix}/{name}" for name in (*_SERVO, "servo-rad", "position-rad", "effective-rad")} <= names(
        servo_block(SURFACE, 20.0, 1.0)
    )


def test_an_engines_block_is_whole_and_stops_its_own_kind():
    for kind, switch in ((PISTON, "propulsion/magneto_cmd"), (TURBINE, "propulsion/cutoff_cmd")):
        engine = Propulsor("engine", 2, kind, True, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
        found = names(engine_block(engine, ["fg/controls/engines/engine[2]/throttle"]))
        assert {f"actuator/engine/{name}" for name in (*MOTOR, "throttle-norm")} <= found
        assert {switch, "fcs/throttle-pos-norm[2]", "fg/controls/engines/engine[2]/throttle"} <= found


def test_other_representations_follow_the_deflection():
    table = ((-0.3, -1.0), (0.2, 1.0))
    readings = (
        Reading("fcs/mag-elevator-pos-deg", gain=57.3, magnitude=True),
        Reading("fcs/elevator-pos-norm", table=table),
    )
    _, channel = servo_block(Surface("elevator", readings, (-0.3, 0.2), "pitch"), 20.0, 1.0)
    found = {each.get("name"): ET.tostring(each, encoding="unicode") for each in channel}
    assert "<abs>" in found["actuator/elevator/as-mag-elevator-pos-deg"]
    assert "0.2 1" in found["actuator/elevator/as-elevator-pos-norm"]
