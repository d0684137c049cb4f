"""The properties that an aircraft's JSBSim model must have for each servo and motor, read from the v-tail's model.

The meanings are written here. Initial values are read from the XML, and the failures that write each property from the
failure types. The build of the site stops if a property of the XML has no meaning here, or if one here is not in the XML.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from xml.etree import ElementTree

import model_tables

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.scenario.model import Scenario

Markdown = Callable[[Sequence[str], Iterable[Sequence[str]]], str]

_SERVO = {
    "command-rad": ("rad", "Written by the testbed each control step: the command."),
    "command-scale": ("1", "Factor on the command."),
    "command-bias-rad": ("rad", "Added to the scaled command, before the servo."),
    "override-active": ("0 or 1", "1: the servo follows `override-rad` in place of the command."),
    "override-rad": ("rad", "See `override-active`."),
    "servo-lag-rad_sec": ("rad/s", "Bandwidth of the servo's first-order lag."),
    "servo-rate-rad_sec": ("rad/s", "Rate limit of the servo."),
    "servo-min-rad": ("rad", "Lower stop of the servo."),
    "servo-max-rad": ("rad", "Upper stop of the servo."),
    "linkage-bias-rad": ("rad", "Added behind the servo: a bent linkage."),
    "float-active": ("0 or 1", "1: the surface is free and trails with the local flow."),
    "float-gain": ("1", "Gain of a free surface: it stands at minus this gain times `incidence-rad`."),
    "effectiveness": ("1", "Factor on the surface's aerodynamic force: 1 is healthy, 0 is lost."),
    "demand-rad": ("rad", "Function: what the servo is asked for, after scale, bias and override."),
    "servo-rad": ("rad", "Output of the JSBSim `<actuator>` component, which must be called `PREFIX/servo`."),
    "incidence-rad": ("rad", "Function: angle of the local flow at the surface, with which a free surface trails."),
    "position-rad": ("rad", "Function: where the surface stands. Logged as `A_position`."),
    "effective-rad": ("rad", "Function: `effectiveness` times `position-rad`. All aerodynamic coefficients of the surface use it."),
    "servo/malfunction/fail_stuck": ("0 or 1", "JSBSim's own property of the component `PREFIX/servo`: 1 freezes its output."),
}  # fmt: skip
_MOTOR = {
    "command-norm": ("0 to 1", "Written by the testbed each control step: the throttle."),
    "command-scale": ("1", "Factor on the command."),
    "command-bias-norm": ("throttle", "Added to the scaled command."),
    "override-active": ("0 or 1", "1: the motor follows `override-norm` in place of the command."),
    "override-norm": ("throttle", "See `override-active`."),
    "throttle-min-norm": ("throttle", "Lowest throttle."),
    "throttle-max-norm": ("throttle", "Highest throttle."),
    "power-lost": ("0 or 1", "1: no current flows, and the propeller windmills."),
    "effectiveness": ("1", "Factor on the propeller's thrust and torque: 1 is healthy, 0 is lost."),
    "throttle-norm": ("throttle", "Function: what the engine gets, written to `fcs/throttle-pos-norm[ENGINE]`."),
    "lost-thrust-lbs": (
        "lbf",
        "External force along body x: (`effectiveness` - 1) times the engine's thrust, which cancels the lost part of the "
        "thrust. An external moment does the same for the torque.",
    ),
}  # fmt: skip


def servo(markdown: Markdown) -> str:
    """Properties below a servo's prefix."""
    return _table(markdown, "servo", _SERVO)


def motor(markdown: Markdown) -> str:
    """Properties below a motor's prefix."""
    return _table(markdown, "motor", _MOTOR)


def _table(markdown: Markdown, kind: str, meanings: dict[str, tuple[str, str]]) -> str:
    aircraft = load_aircraft("vtail")
    name = next(name for name, actuator in aircraft.actuators.items() if actuator.kind == kind)
    prefix = aircraft.actuators[name].prefix
    values, written = initial_values(aircraft, prefix), writers(aircraft, name, prefix)
    unexplained = (set(values) | set(written)) - set(meanings)
    missing = set(meanings) - set(values) - set(written)
    if unexplained or missing:
        raise KeyError(f"{prefix}: not explained {sorted(unexplained)}, not in the model {sorted(missing)}")
    rows = [
        (f"`{tail}`", unit, values.get(tail, ""), meaning, ", ".join(f"`{t}`" for t in written.get(tail, ())))
        for tail, (unit, meaning) in meanings.items()
    ]
    return markdown(("below the prefix", "unit", "healthy", "meaning", "written by the failures"), rows)


def initial_values(aircraft: Aircraft, prefix: str) -> dict[str, str]:
    """Names below a prefix that the model defines, each with its initial value; functions have none."""
    root = ElementTree.parse(aircraft.folder / f"{aircraft.model}.xml").getroot()
    found = {}
    for element in root.iter():
        name = element.get("name") or "" if element.tag != "property" else (element.text or "").strip()
        if element.tag == "output":
            name = (element.text or "").strip()
        defines = element.tag in ("fcs_function", "function", "output") or element.get("value") is not None
        if defines and name.startswith(f"{prefix}/"):
            found[name.removeprefix(f"{prefix}/")] = element.get("value", "")
    return found


def writers(aircraft: Aircraft, actuator: str, prefix: str) -> dict[str, list[str]]:
    """Failure types that write each property below a prefix."""
    found: dict[str, list[str]] = {}
    kind = aircraft.actuators[actuator].kind
    for name, failure in model_tables.alternatives(Scenario, "failures").items():
        if kind not in failure.examples:
            continue
        fields = {"type": name, "actuator": actuator, "at_s": 1.0, **failure.examples[kind]}
        for variant in (fields, *_variants(name, fields)):
            for full in failure.model_validate(variant).properties(aircraft):
                tail = re.sub(f"^{re.escape(prefix)}/", "", full)
                if tail != full and name not in found.setdefault(tail, []):
                    found[tail].append(name)
    return found


def _variants(name: str, fields: dict[str, object]) -> list[dict[str, object]]:
    """The same failure with options that write other properties."""
    options: dict[str, dict[str, object]] = {
        "float": {"gain": 0.5},
        "motor_stop": {"braked": True},
        "position_limit": {"low": 0.1, "high": 0.4},
    }
    return [{**fields, **options[name]}] if name in options else []
