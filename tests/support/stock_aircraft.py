"""Aircraft of the jsbsim package, their surfaces and throttles behind failure blocks as docs/reference/aircraft.md has them."""

from __future__ import annotations

import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

import jsbsim
import yaml

ROOT = Path(jsbsim.get_default_root_dir())
PISTON = "<product><value>3</value><difference><value>1</value>{lost}</difference></product>"
IGNITION = {"magneto_cmd": PISTON, "cutoff_cmd": "<sum>{lost}</sum>"}


def servo_block(p: str, travel: tuple[float, float], lag: float, rate: float) -> tuple[str, str]:
    """Properties and channel of a servo with this prefix; travel [rad], lag [rad/s], rate [rad/s]."""
    healthy = {
        "command-rad": 0, "command-scale": 1, "command-bias-rad": 0, "override-active": 0, "override-rad": 0,
        "servo-lag-rad_sec": lag, "servo-rate-rad_sec": rate, "servo-min-rad": travel[0], "servo-max-rad": travel[1],
        "linkage-bias-rad": 0, "float-active": 0, "float-gain": 0.6, "effectiveness": 1,
    }  # fmt: skip
    position = f"<sum>{of(p, 'servo-rad')}{of(p, 'linkage-bias-rad')}</sum>"
    floating = f"<product><value>-1</value>{of(p, 'float-gain')}{of(p, 'incidence-rad')}</product>"
    channel = f"""<channel name="{p}">
    {function(p, "demand-rad", demand(p, "rad"))}
    <actuator name="{p}/servo"><input>{p}/demand-rad</input><lag>{p}/servo-lag-rad_sec</lag>
      <rate_limit>{p}/servo-rate-rad_sec</rate_limit>
      <clipto><min>{p}/servo-min-rad</min><max>{p}/servo-max-rad</max></clipto><output>{p}/servo-rad</output></actuator>
    {function(p, "incidence-rad", "<property>aero/alpha-rad</property>")}
    {function(p, "position-rad", f"<ifthen>{of(p, 'float-active')}{floating}{position}</ifthen>")}
    {function(p, "effective-rad", f"<product>{of(p, 'effectiveness')}{of(p, 'position-rad')}</product>")}
    {function(p, "effective-mag-rad", f"<abs>{of(p, 'effective-rad')}</abs>")}
    </channel>"""
    return properties(p, healthy), channel


def engine_block(p: str, engine: int, switch: str) -> tuple[str, str]:
    """Properties and channel of an engine with this prefix; `switch` is the property that stops it."""
    healthy = {
        "command-norm": 0, "command-scale": 1, "command-bias-norm": 0, "override-active": 0, "override-norm": 0,
        "throttle-min-norm": 0, "throttle-max-norm": 1, "power-lost": 0, "effectiveness": 1,
    }  # fmt: skip
    throttle = (
        f"<max>{of(p, 'throttle-min-norm')}<min>{of(p, 'throttle-max-norm')}{demand(p, 'norm')}</min></max>"
    )
    ignition = IGNITION[switch].format(lost=of(p, "power-lost"))
    channel = f"""<channel name="{p}">
    {function(p, "throttle-norm", throttle, f"fcs/throttle-pos-norm[{engine}]")}
    {function(p, "selected", f"<sum><value>{engine}</value></sum>", "propulsion/active_engine")}
    {function(p, "ignition", ignition, f"propulsion/{switch}")}
    {function(p, "deselected", "<sum><value>-1</value></sum>", "propulsion/active_engine")}
    </channel>"""
    return properties(p, healthy), channel


def loss(p: str, engine: int, location: str, propeller: bool) -> str:
    """External reactions that take away the lost part of an engine's thrust and torque."""
    lost = f"<difference>{of(p, 'effectiveness')}<value>1</value></difference>"
    read = f"<property>propulsion/engine[{engine}]"
    ahead = "<direction><x>1</x><y>0</y><z>0</z></direction>"
    force = f"""<force name="{p}-loss" frame="BODY"><function name="{p}/lost-thrust-lbs"><product>{lost}
      {read}/thrust-lbs</property></product></function>{location}{ahead}</force>"""
    moment = f"""<moment name="{p}-loss-torque" frame="BODY"><function><product>{lost}
      {read}/propeller-torque-ftlb</property></product></function>{ahead}</moment>"""
    return force + (moment if propeller else "")


def of(p: str, tail: str) -> str:
    return f"<property>{p}/{tail}</property>"


def function(p: str, tail: str, body: str, output: str = "") -> str:
    to = f"<output>{output}</output>" if output else ""
    return f'<fcs_function name="{p}/{tail}"><function>{body}</function>{to}</fcs_function>'


def demand(p: str, unit: str) -> str:
    scaled = f"<product>{of(p, f'command-{unit}')}{of(p, 'command-scale')}</product>"
    ordinary = f"<sum>{scaled}{of(p, f'command-bias-{unit}')}</sum>"
    return f"<ifthen>{of(p, 'override-active')}{of(p, f'override-{unit}')}{ordinary}</ifthen>"


def properties(p: str, healthy: Mapping[str, float]) -> str:
    return "".join(f'<property value="{value}">{p}/{name}</property>' for name, value in healthy.items())


def make(model: str, surfaces: Mapping[str, str], description: dict, folder: Path, switch: str = "") -> Path:
    """Write an aircraft's folder; returns it.

    Args:
        surfaces: the property that the aerodynamics read, for the name of each servo.
        description: the contents of the YAML.
        switch: the property that stops the model's engines.
    """
    shutil.copytree(ROOT / "aircraft" / model, folder, dirs_exist_ok=True)
    (folder / "Engines").mkdir(exist_ok=True)
    text = (ROOT / "aircraft" / model / f"{model}.xml").read_text()
    text = re.sub(
        r"<(input|output)\b[^>]*?(/>|>.*?</\1>)",
        lambda m: "" if "name=" in m[0] or "port=" in m[0] else m[0],
        text,
        flags=re.S,
    )
    for file in re.findall(r'(?:engine|thruster) file="([^"]+)"', text):
        if not (folder / "Engines" / f"{file}.xml").is_file():
            shutil.copy(ROOT / "engine" / f"{file}.xml", folder / "Engines")
    for file in re.findall(r'system file="([^"]+)"', text):
        (folder / "Systems").mkdir(exist_ok=True)
        if not (folder / "Systems" / f"{file.removesuffix('.xml')}.xml").is_file():
            name = f"{file.removesuffix('.xml')}.xml"
            plain = ElementTree.parse(ROOT / "systems" / name)  # its own entities written out
            plain.write(folder / "Systems" / name)
    head, mark, aerodynamics = text.partition("<aerodynamics")
    values, channels, reactions = "", "", ""
    places = re.findall(r"<thruster.*?(<location.*?</location>)", text, flags=re.S)
    for name, actuator in description["actuators"].items():
        p = actuator["prefix"]
        if actuator["kind"] == "servo":
            low, high = (limit / 57.29577951308232 for limit in actuator["limits"])
            block = servo_block(
                p, (low, high), actuator["lag_rad_s"], actuator["rate_limit"] / 57.29577951308232
            )
            read = surfaces[name]
            aerodynamics = re.sub(rf"\b{read}\b", f"{p}/effective-rad", aerodynamics)
            magnitude = read.replace("fcs/", "fcs/mag-")
            aerodynamics = re.sub(rf"\b{magnitude}\b", f"{p}/effective-mag-rad", aerodynamics)
        else:
            block = engine_block(p, actuator["engine"], switch)
            reactions += loss(
                p, actuator["engine"], places[actuator["engine"]], "propeller" in description["description"]
            )
        values, channels = values + block[0], channels + block[1]
    text = (head + mark + aerodynamics).replace("</flight_control>", f"{values}{channels}</flight_control>")
    if reactions:
        text = text.replace(
            "</fdm_config>", f"<external_reactions>{reactions}</external_reactions></fdm_config>"
        )
    (folder / f"{model}.xml").unlink()
    (folder / f"{folder.name}.xml").write_text(text)
    (folder / f"{folder.name}.yaml").write_text(
        yaml.safe_dump({**description, "model": folder.name}, sort_keys=False)
    )
    return folder


def servo(prefix: str, degrees: float, scale: float = 5.73) -> dict:
    """The YAML of a servo with this travel to either side [deg]."""
    motion = {"rate_limit": 90.0, "lag_rad_s": 20.0, "scale": scale}
    return {"kind": "servo", "prefix": prefix, "unit": "deg", "limits": [-degrees, degrees], **motion}


def engine(prefix: str, number: int, limits: tuple[float, float], scale: float) -> dict:
    """The YAML of an engine; limits and scale [N]."""
    what = {"kind": "engine", "prefix": prefix, "engine": number, "unit": "N"}
    return {**what, "limits": list(limits), "scale": scale}


AXES = ["p_dot", "q_dot", "r_dot", "u_dot"]
CONVENTIONAL = {
    "aileron": "fcs/left-aileron-pos-rad",
    "elevator": "fcs/elevator-pos-rad",
    "rudder": "fcs/rudder-pos-rad",
}
SERVOS = {name: servo(f"fcs/{name}-block", 16.0 if name == "rudder" else 20.0) for name in CONVENTIONAL}


def c172p(folder: Path) -> Path:
    """A light single with its piston engine, made in this folder."""
    start = [
        {"set": {"propulsion/fuel_freeze": 1.0}},
        {"set": {"fcs/mixture-cmd-norm[0]": 0.9, "propulsion/starter_cmd": 1.0}, "run_s": 25.0},
    ]
    actuators = {**SERVOS, "throttle": engine("fcs/throttle-block", 0, (-100.0, 2100.0), 500.0)}
    return make(
        "c172p",
        CONVENTIONAL,
        described(folder, "propeller", 1000.0, 45.0, actuators, start),
        folder,
        "magneto_cmd",
    )


def jet(folder: Path) -> Path:
    """A 737 with both throttles of its turbines, made in this folder."""
    running = {f"propulsion/engine[{i}]/set-running": 1.0 for i in (0, 1)}
    start = [
        {"set": {"propulsion/fuel_freeze": 1.0, "gear/gear-cmd-norm": 0.0}},
        {"set": running, "run_s": 10.0},
    ]
    throttles = {
        f"{side}_throttle": engine(f"fcs/{side}-throttle-block", i, (1000.0, 59000.0), 20000.0)
        for i, side in enumerate(("left", "right"))
    }
    contents = described(folder, "jet", 3000.0, 144.0, {**SERVOS, **throttles}, start)
    return make("737", CONVENTIONAL, contents, folder, "cutoff_cmd")


def glider(folder: Path) -> Path:
    """A sailplane, made in this folder."""
    contents = described(folder, "glider", 1000.0, 30.0, dict(SERVOS), [])
    return make("SGS", CONVENTIONAL, {**contents, "axes": AXES[:3]}, folder)


def described(
    folder: Path, what: str, altitude: float, airspeed: float, actuators: dict, start: list
) -> dict:
    """The contents of a YAML."""
    return {
        "name": folder.name,
        "description": what,
        "reference": {"altitude_m": altitude, "airspeed_m_s": airspeed},
        "axes": AXES,
        "envelope": {"alpha_max_deg": 25.0, "beta_max_deg": 40.0, "roll_max_deg": 110.0},
        "actuators": actuators,
        "start": start,
    }
