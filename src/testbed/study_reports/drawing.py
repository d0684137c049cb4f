"""What the figures of sweeps and searches share: axes of one look, and a file for each figure that there is data for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from testbed.reporting.figures.sheet import Drawing, plain_text, save

Draw = Callable[..., Figure | None]


def draw_all(table: Mapping[str, Draw], folder: Path, *of: object) -> list[Path]:
    """Draw every figure of a table that shows something of these into folder/figures; returns the files."""
    with plain_text():
        drawn = ((name, draw(*of)) for name, draw in table.items())
        return [save(figure, folder, name) for name, figure in drawn if figure is not None]


def figure(
    width: float, height: float, rows: int = 1, columns: int = 1, share: bool = False
) -> tuple[Figure, np.ndarray]:
    """(a figure of this size [inches], its axes [rows, columns], of which all `share` x and those of a row y)."""
    made = Drawing(figsize=(width, height), layout="constrained")
    axes = made.subplots(rows, columns, squeeze=False, sharex=share, sharey="row" if share else False)
    for each in axes.flat:
        each.grid(alpha=0.3)
    return made, axes


def legend(axes: Axes, beside: bool = False) -> None:
    """A legend of what has a name, in the axes or beside them; none if nothing has."""
    if axes.get_legend_handles_labels()[1]:
        where = {"loc": "center left", "bbox_to_anchor": (1.0, 0.5), "frameon": False} if beside else {}
        axes.legend(fontsize=8, **cast(dict[str, Any], where))
