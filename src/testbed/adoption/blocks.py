"""The blocks that are put between actuators and what reads them: their XML, and the model that follows them and no longer its own
flight control. docs/reference/aircraft says what each property is.
"""

from __future__ import annotations

import copy
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence

from testbed.adoption.controls import ELECTRIC, PISTON, Propulsor, Reading, Surface, places_read
from testbed.adoption.source import FOREIGN
from testbed.adoption.wiring import bare


def prefix_of(name: str) -> str:
    """The property prefix of an actuator, where no model has properties of its own."""
    return f"actuator/{name.replace('_', '-')}"


def servo_block(surface: Surface, lag_rad_s: float, rate_rad_s: float) -> tuple[dict[str, float], ET.Element]:
    """Properties with their values, and the channel, of a surface's servo.

    A free surface follows alpha and beta by `float-alpha` and `float-beta`, which are 0 until the cut model has been measured.
    """
    p = prefix_of(surface.name)
    values = {
        "command-rad": 0.0, "command-scale": 1.0, "command-bias-rad": 0.0, "override-active": 0.0, "override-rad": 0.0,
        "servo-lag-rad_sec": lag_rad_s, "servo-rate-rad_sec": rate_rad_s,
        "servo-min-rad": surface.travel[0], "servo-max-rad": surface.travel[1], "linkage-bias-rad": 0.0,
        "float-active": 0.0, "float-gain": 0.6, "float-alpha": 0.0, "float-beta": 0.0, "effectiveness": 1.0,
    }  # fmt: skip
    channel = f"""<channel name="{p}">
  <fcs_function name="{p}/demand-rad"><function>{_demand(p, "rad")}</function></fcs_function>
  <actuator name="{p}/servo"><input>{p}/demand-rad</input><lag>{p}/servo-lag-rad_sec</lag>
    <rate_limit>{p}/servo-rate-rad_sec</rate_limit>
    <clipto><min>{p}/servo-min-rad</min><max>{p}/servo-max-rad</max></clipto><output>{p}/servo-rad</output></actuator>
  <fcs_function name="{p}/incidence-rad"><function><product><value>-1</value><sum>
    <product><property>{p}/float-alpha</property><property>aero/alpha-rad</property></product>
    <product><property>{p}/float-beta</property><property>aero/beta-rad</property></product></sum></product></function></fcs_function>
  <fcs_function name="{p}/position-rad"><function><ifthen><property>{p}/float-active</property>
    <product><value>-1</value><property>{p}/float-gain</property><property>{p}/incidence-rad</property></product>
    <sum><property>{p}/servo-rad</property><property>{p}/linkage-bias-rad</property></sum></ifthen></function></fcs_function>
  <fcs_function name="{p}/effective-rad"><function>
    <product><property>{p}/effectiveness</property><property>{p}/position-rad</property></product></function></fcs_function>
{"".join(_reading(surface, each) for each in surface.readings)}</channel>"""
    return {f"{p}/{name}": value for name, value in values.items()}, ET.fromstring(channel)


def _demand(p: str, unit: str) -> str:
    return (
        f"<ifthen><property>{p}/override-active</property><property>{p}/override-{unit}</property>\n"
        f"    <sum><product><property>{p}/command-{unit}</property><property>{p}/command-scale</property></product>"
        f"<property>{p}/command-bias-{unit}</property></sum></ifthen>"
    )


def read_as(surface: Surface, reading: Reading) -> str:
    """The property that aerodynamics read instead of the model's own."""
    if reading.gain == 1.0 and not reading.magnitude and not reading.table:
        return f"{prefix_of(surface.name)}/effective-rad"
    return f"{prefix_of(surface.name)}/as-{reading.name.split('/')[-1]}"


def _reading(surface: Surface, reading: Reading) -> str:
    """A function that gives the deflection as the aerodynamics read it, where that is not in radians."""
    source, name = f"<property>{prefix_of(surface.name)}/effective-rad</property>", read_as(surface, reading)
    if name.endswith("/effective-rad"):
        return ""
    if reading.table:
        rows = "\n".join(f"      {deflection:.9g} {value:.9g}" for deflection, value in reading.table)
        variable = f"<independentVar>{prefix_of(surface.name)}/effective-rad</independentVar>"
        body = f"<table>{variable}\n    <tableData>\n{rows}\n    </tableData></table>"
    else:
        inside = f"<abs>{source}</abs>" if reading.magnitude else source
        body = f"<product>{inside}<value>{reading.gain:.12g}</value></product>"
    return f'  <fcs_function name="{name}"><function>{body}</function></fcs_function>\n'


def engine_block(propulsor: Propulsor, heard_as: Sequence[str] = ()) -> tuple[dict[str, float], ET.Element]:
    """Properties with their values, and the channel, of an engine's throttle and ignition.

    The throttle is also written to the model's command, and to the names in `heard_as`, for the model's own mixture or boost.
    """
    p, electric = prefix_of(propulsor.name), propulsor.kind in ELECTRIC
    position = f"fcs/throttle-pos-norm[{propulsor.number}]"
    heard = [f"fcs/throttle-cmd-norm[{propulsor.number}]", *heard_as, *([] if electric else [position])]
    values = {
        "command-norm": 0.0, "command-scale": 1.0, "command-bias-norm": 0.0, "override-active": 0.0, "override-norm": 0.0,
        "throttle-min-norm": propulsor.throttle[0], "throttle-max-norm": propulsor.throttle[1],
        "power-lost": 0.0, "effectiveness": 1.0,
    }  # fmt: skip
    channel = f"""<channel name="{p}">
  <fcs_function name="{p}/throttle-norm"><function>
    <max><property>{p}/throttle-min-norm</property><min><property>{p}/throttle-max-norm</property>
    {_demand(p, "norm")}</min></max></function>
    {"".join(f"<output>{name}</output>" for name in heard)}</fcs_function>
{_current(p, propulsor.number) if electric else _ignition(p, propulsor)}</channel>"""
    return {f"{p}/{name}": value for name, value in values.items()}, ET.fromstring(channel)


def _powered(p: str) -> str:
    """1 with power, 0 without."""
    return f"<difference><value>1</value><property>{p}/power-lost</property></difference>"


def _current(p: str, number: int) -> str:
    """Functions by which an electric engine has no throttle without power."""
    return f"""  <fcs_function name="{p}/current-norm"><function>
    <product><property>{p}/throttle-norm</property>{_powered(p)}</product></function>
    <output>fcs/throttle-pos-norm[{number}]</output></fcs_function>
  <fcs_function name="{p}/powered"><function><product><value>1</value>{_powered(p)}</product></function>
    <output>propulsion/engine[{number}]/set-running</output></fcs_function>
"""


def _ignition(p: str, propulsor: Propulsor) -> str:
    """Functions that stop a piston engine by its ignition, and any other by its fuel."""
    if propulsor.kind == PISTON:
        switch, value = "magneto_cmd", f"<product><value>3</value>{_powered(p)}</product>"
    else:
        switch, value = "cutoff_cmd", f"<sum><value>0</value><property>{p}/power-lost</property></sum>"
    return f"""  <fcs_function name="{p}/selected"><function><value>{propulsor.number}</value></function>
    <output>propulsion/active_engine</output></fcs_function>
  <fcs_function name="{p}/ignition"><function>{value}</function>
    <output>propulsion/{switch}</output></fcs_function>
  <fcs_function name="{p}/deselected"><function><value>-1</value></function>
    <output>propulsion/active_engine</output></fcs_function>
"""


def engine_losses(propulsor: Propulsor) -> list[ET.Element]:
    """External force, and for a propeller moment, by which an engine's effectiveness acts."""
    p, engine = prefix_of(propulsor.name), f"propulsion/engine[{propulsor.number}]"
    less = f"<difference><property>{p}/effectiveness</property><value>1</value></difference>"
    place, direction = (
        "".join(f"<{axis}>{value:.9g}</{axis}>" for axis, value in zip("xyz", values, strict=True))
        for values in (propulsor.location_m, propulsor.direction)
    )
    force = f"""<force name="{propulsor.name}-loss" frame="BODY"><function name="{p}/lost-thrust-lbs">
  <product>{less}<property>{engine}/thrust-lbs</property></product></function>
  <location unit="M">{place}</location><direction>{direction}</direction></force>"""
    moment = f"""<moment name="{propulsor.name}-loss-torque" frame="BODY"><function>
  <product>{less}<property>{engine}/propeller-torque-ftlb</property></product></function>
  <direction>{direction}</direction></moment>"""
    return [ET.fromstring(text) for text in ([force, moment] if propulsor.propeller else [force])]


def cut(
    tree: ET.Element,
    surfaces: Iterable[tuple[Surface, float, float]],
    propulsors: Iterable[Propulsor],
) -> ET.Element:
    """A new model with the blocks; each surface is given with its servo's lag and rate limit [rad/s]."""
    tree = copy.deepcopy(tree)
    control = _section(tree, "flight_control")
    for surface, lag, rate in surfaces:
        _add(control, *servo_block(surface, lag, rate))
        _rename(tree, {each.name: read_as(surface, each) for each in surface.readings})
    for propulsor in propulsors:
        _add(control, *engine_block(propulsor, _heard_as(tree, propulsor)))
        _section(tree, "external_reactions").extend(engine_losses(propulsor))
    return tree


def _section(tree: ET.Element, tag: str) -> ET.Element:
    """The model's section of this tag, made where there is none; of several the last, which runs last."""
    found = tree.findall(tag)
    if found:
        return found[-1]
    section = ET.Element(tag, {"name": "adopted"} if tag == "flight_control" else {})
    aerodynamics = next((i for i, each in enumerate(tree) if each.tag == "aerodynamics"), len(tree))
    tree.insert(aerodynamics, section)
    return section


def _add(control: ET.Element, values: Mapping[str, float], channel: ET.Element) -> None:
    """Append a block: its channel runs after all of the model's own."""
    for name, value in values.items():
        ET.SubElement(control, "property", {"value": f"{value:.9g}"}).text = name
    control.append(channel)


def _rename(tree: ET.Element, new_names: Mapping[str, str]) -> None:
    for name, element in list(places_read(tree)):
        if name in new_names:
            sign = "-" if (element.text or "").strip().startswith("-") else ""
            element.text = sign + new_names[bare(element.text)]


def _heard_as(tree: ET.Element, propulsor: Propulsor) -> list[str]:
    """FlightGear's names of this engine's throttle that the model reads."""
    index = f"[{propulsor.number}]" if propulsor.number else ""
    names = {f"{FOREIGN}controls/engines/engine{i}/throttle" for i in (index, f"[{propulsor.number}]")}
    declared = {(each.text or "").strip() for each in tree.iter("property")}
    return sorted(names & declared)


def set_property(tree: ET.Element, name: str, value: float) -> None:
    """Change the value of a property that the model declares."""
    for element in tree.iter("property"):
        if element.text == name:
            element.set("value", f"{value:.9g}")
