"""Draw each aircraft as its replay shows it, of one figure for the gallery.

    python benchmarks/aircraft_pictures.py FOLDER... --out docs/figures/gallery.png

A FOLDER is an aircraft's name or folder. What its actuators move is coloured.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.aircraft.conventional_shape import shape_of
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.shape import Shape
from testbed.plant.identification import stored

COLUMNS, SIDE_IN, DOTS_PER_IN = 7, 1.5, 100
YAW, PITCH = math.radians(35.0), math.radians(28.0)  # of the view: from ahead, from the left and from above
STILL, MOVED, POWER = "#b8c2cc", "#3f51b5", "#e0a030"


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--out", type=Path, default=Path("docs/figures/gallery.png"))
    options = parser.parse_args(arguments)
    found = {Path(folder).name: load_aircraft(folder) for folder in options.folders}
    shapes = {name: shape_of(aircraft, stored(aircraft)) for name, aircraft in found.items()}
    figure(shapes).savefig(options.out, dpi=DOTS_PER_IN, metadata={"Software": None})


def figure(shapes: dict[str, Shape]) -> Figure:
    """A picture of each, with its name and span."""
    rows = math.ceil(len(shapes) / COLUMNS)
    drawn = Figure(figsize=(COLUMNS * SIDE_IN, rows * SIDE_IN), layout="constrained")
    for place, (name, shape) in enumerate(shapes.items(), 1):
        axes = drawn.add_subplot(rows, COLUMNS, place)
        axes.set_title(f"{name}, {shape.span_m:.3g} m", fontsize=7)
        axes.set_axis_off()
        axes.set_aspect("equal")
        draw(axes, shape)
    return drawn


def draw(axes: Axes, shape: Shape) -> None:
    """Panels, bodies and propulsors, the farthest first."""
    reach = 0.6 * max(shape.span_m, *(abs(b.start[0] - b.end[0]) for b in shape.bodies), 1e-3)
    points_per_m = 72.0 * SIDE_IN * 0.8 / (2.0 * reach)
    for panel in shape.panels:
        corners = np.array(panel.points)
        colour = STILL if panel.actuator is None else MOVED
        x, y, depth = seen(corners)
        axes.fill(x, y, facecolor=colour, edgecolor="#455a64", linewidth=0.4, zorder=depth.mean() / reach)
    for body in shape.bodies:
        x, y, depth = seen(np.array([body.start, body.end]))
        width = 2.0 * body.radius_m * points_per_m
        axes.plot(x, y, color="#8a97a3", linewidth=width, solid_capstyle="round", zorder=depth.mean() / reach)
    turn = np.linspace(0.0, 2.0 * math.pi, 25)
    for motor in shape.propulsors:
        ring = 0.5 * motor.diameter_m * np.stack([0.0 * turn, np.cos(turn), np.sin(turn)], axis=1)
        x, y, depth = seen(np.array(motor.at) + ring)
        axes.fill(
            x, y, facecolor=POWER, alpha=0.5, edgecolor=POWER, linewidth=0.6, zorder=depth.mean() / reach
        )
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)


def seen(points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Right, up and nearness [k] of points in body axes [k, 3], as one sees them."""
    x, y, z = points.T
    ahead, right = x * math.cos(YAW) - y * math.sin(YAW), x * math.sin(YAW) + y * math.cos(YAW)
    return (
        -right,
        ahead * -math.sin(PITCH) - z * math.cos(PITCH),
        ahead * math.cos(PITCH) - z * math.sin(PITCH),
    )


if __name__ == "__main__":
    main()
