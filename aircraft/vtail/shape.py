"""Write shape.yaml, what a replay shows of the v-tail, from geometry.yaml: `python aircraft/vtail/shape.py [--check]`."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import yaml

FOLDER = Path(__file__).parent
ORIGIN_X_M, ORIGIN_Z_M = (
    0.09,
    -0.08,
)  # about the centre of gravity, in the structural frame (x aft, y right, z up)
HEAD = "# What a replay of a flight shows. Written by shape.py from geometry.yaml; body axes, m.\n"

Point = list[float]


def body(x: float, y: float, z: float) -> Point:
    """A point of the structural frame in body axes."""
    return [round(ORIGIN_X_M - x, 4), round(y, 4), round(ORIGIN_Z_M - z, 4)]


def wing(g: dict) -> list[dict]:
    """Both halves of the wing, about the quarter chord of the root."""
    half, rise = 0.5 * g["span_m"], 0.5 * g["span_m"] * math.tan(math.radians(g["dihedral_deg"]))
    root, tip = g["root_chord_m"], g["tip_chord_m"]
    sweep = 0.25 * (root - tip)
    halves = []
    for side in (-1.0, 1.0):
        corners = ((0, 0, 0), (sweep, side * half, rise), (sweep + tip, side * half, rise), (root, 0, 0))
        halves.append({"points": [body(*corner) for corner in corners]})
    return halves


def tail(g: dict) -> list[dict]:
    """The fixed panel and the ruddervator of each side."""
    slope, span = math.radians(g["dihedral_deg"]), g["panel_span_m"]
    tip_y, tip_z = span * math.cos(slope), g["root_z_m"] + span * math.sin(slope)
    panels = []

    def corner(side: float, share: float, chord: float) -> Point:
        """A point at the root or the tip (share 0 or 1), this part of the chord behind the leading edge."""
        length = g["root_chord_m"] + share * (g["tip_chord_m"] - g["root_chord_m"])
        x = g["quarter_chord_x_m"] + (chord - 0.25) * length
        return body(x, side * share * tip_y, g["root_z_m"] + share * (tip_z - g["root_z_m"]))

    for name, side in (("left", -1.0), ("right", 1.0)):
        hinge = 1.0 - g["flap_chord_ratio"]
        for front, back, more in ((0.0, hinge, {}), (hinge, 1.0, {"actuator": f"{name}_ruddervator"})):
            ends = ((0.0, front), (1.0, front), (1.0, back), (0.0, back))
            panels.append({"points": [corner(side, share, chord) for share, chord in ends], **more})
    return panels


def shape(g: dict) -> dict:
    """The whole shape."""
    pod, props, fin = g["pod"], g["propulsion"], g["tail"]
    nose, stern = pod["nose_x_m"], pod["nose_x_m"] + pod["length_m"]
    bodies = [
        {
            "start": body(nose, 0, pod["z_m"]),
            "end": body(stern, 0, pod["z_m"]),
            "radius_m": 0.5 * pod["height_m"] * 0.7,
        },
        {
            "start": body(stern - 0.1, 0, pod["z_m"]),
            "end": body(fin["quarter_chord_x_m"], 0, fin["root_z_m"]),
            "radius_m": 0.016,
        },
    ]
    discs = []
    for name, side in (("left", -1.0), ("right", 1.0)):
        y = side * props["y_m"]
        bodies.append(
            {
                "start": body(props["x_m"], y, props["z_m"]),
                "end": body(0.08, y, props["z_m"]),
                "radius_m": 0.027,
            }
        )
        at, diameter = body(props["x_m"], y, props["z_m"]), props["propeller"]["diameter_m"]
        discs.append({"at": at, "diameter_m": diameter, "actuator": f"{name}_propeller"})
    return {
        "span_m": g["wing"]["span_m"],
        "panels": [*wing(g["wing"]), *tail(fin)],
        "bodies": bodies,
        "propulsors": discs,
    }


def text_of(g: dict) -> str:
    """The file's text."""
    return HEAD + yaml.safe_dump(shape(g), sort_keys=False, default_flow_style=None, width=130)


def main() -> int:
    """Write the file, or with --check compare it."""
    text = text_of(yaml.safe_load((FOLDER / "geometry.yaml").read_text(encoding="utf-8")))
    file = FOLDER / "shape.yaml"
    if "--check" in sys.argv:
        return 0 if file.read_text(encoding="utf-8") == text else 1
    file.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
