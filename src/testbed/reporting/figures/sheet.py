"""The sheet that figures of a flight are drawn on: panels above each other over one time axis, title, legend, events at the top.

It uses matplotlib's objects and not pyplot, so there is no global state, and no display is needed.
"""

from __future__ import annotations

import gc
import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from textwrap import fill
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from testbed.common.writing import write
from testbed.reporting.figures.lines import Mark, Shown, draw_panel, label_rows
from testbed.reporting.panels import Panel

DPI = 110
_WIDTH = 10.0  # inches, as all sizes here
_TOP, _BOTTOM, _GAP, _LEFT, _RIGHT = 0.72, 0.55, 0.16, 1.1, 0.25
_LANE_ROW = 0.19
_LABEL = 0.58  # from the axis to its label, with room for the numbers
_ZOOM, _BETWEEN = 2.3, 0.6
"""Width of the panels around the failure, and the gap before them, with room for numbers."""
_GRID: dict[str, Any] = {"color": "0.88", "linewidth": 0.6}
_LONGEST = 15  # characters in a line of an axis's label


class Drawing(Figure):
    """A figure that a notebook shows, also where pyplot has not been imported."""

    def _repr_png_(self) -> bytes:
        return png(self)


class Sheet:
    """A figure of one flight or several. Drawn again, it shows other panels with the same axes: making these takes longer."""

    def __init__(self) -> None:
        self.figure = Drawing(figsize=(_WIDTH, _WIDTH), dpi=DPI)
        FigureCanvasAgg(self.figure)
        self._lane = self.figure.add_axes((0.0, 0.0, 1.0, 1.0), label="events")
        self._lane.set_axis_off()
        self._axes: list[Axes] = []

    def draw(self, shown: Shown, panels: Sequence[Panel], what: str, tall: float) -> Figure:
        """The figure with these panels, each `tall` inches high, and every event marked in each."""
        span, closer = (0.0, shown.end_s), shown.zoom
        width = _WIDTH - _LEFT - _RIGHT - (_ZOOM + _BETWEEN if closer else 0.0)
        lane = label_rows(shown.marks, span, width)
        lane_height = _LANE_ROW * (max((row for _, row, _ in lane), default=-1) + 1) + 0.04
        height = _TOP + lane_height + (tall + _GAP) * len(panels) - _GAP + _BOTTOM
        self._clear(height, len(panels) * (2 if closer else 1))
        top = height - _TOP - lane_height
        columns = [(span, _LEFT, width), *([(closer, _WIDTH - _RIGHT - _ZOOM, _ZOOM)] if closer else [])]
        free = iter(self._axes)
        for start, left, wide in columns:
            for i, panel in enumerate(panels):
                axes = next(free)
                bottom = top - (tall + _GAP) * i - tall
                axes.set_position((left / _WIDTH, bottom / height, wide / _WIDTH, tall / height))
                _set_up(axes, start, wide, last=i == len(panels) - 1)
                axes.set_label("" if wide == width else "zoom")
                axes.set_ylabel(fill(panel.heading, _LONGEST) if wide == width else "", fontsize=9.5)
                _mark(axes, shown.marks)
                draw_panel(axes, panel, shown, wide * DPI)
        if closer:
            _name_zoom(self._axes[len(panels)], shown.marks)
        _title(self.figure, shown, what)
        self._write_lane(lane, span, (_LEFT, top, width, lane_height))
        _legend(self.figure, self._axes[: len(panels)])
        return self.figure

    def _clear(self, height: float, count: int) -> None:
        """Make the sheet so high, with so many empty axes."""
        self.figure.set_size_inches(_WIDTH, height)
        for artist in (*self.figure.texts, *self.figure.legends):
            artist.remove()
        for axes in (self._lane, *self._axes):
            for artist in (*axes.lines, *axes.patches, *axes.collections, *axes.texts):
                artist.remove()
            axes.set_title("")
        self._axes += [_new(self.figure) for _ in range(count - len(self._axes))]
        for i, axes in enumerate(self._axes):
            axes.set_visible(i < count)

    def _write_lane(
        self,
        lane: Sequence[tuple[Mark, int, str]],
        span: tuple[float, float],
        box: tuple[float, float, float, float],
    ) -> None:
        """Write the label of each event above the first panel, at its line; `box` is left, bottom, width, height [inches]."""
        left, bottom, width, tall = box
        high = self.figure.get_figheight()
        self._lane.set_position((left / _WIDTH, bottom / high, width / _WIDTH, tall / high))
        self._lane.set(xlim=span, ylim=(0.0, tall))
        reach = 0.1 / width * (span[1] - span[0])
        for mark, row, side in lane:
            y = _LANE_ROW * (row + 0.5)
            self._lane.plot([mark.time_s, mark.time_s], [0.0, y + 0.07], **mark.style)
            _marker(self._lane, mark, y, self._lane.transData)
            x = mark.time_s + (reach if side == "left" else -reach)
            self._lane.text(x, y, mark.label, fontsize=8.5, ha=side, va="center", color=mark.style["color"])


def _new(figure: Figure) -> Axes:
    """Empty axes, with a look that stays."""
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.grid(True, **_GRID)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=8.5)
    axes.ticklabel_format(useOffset=False)
    axes.locator_params(axis="y", nbins=5)
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _set_up(axes: Axes, span: tuple[float, float], width: float, *, last: bool) -> None:
    """Set the time axis of a panel, of which only the `last` one has numbers; `width` in inches."""
    axes.set_xlim(*span)
    axes.tick_params(axis="x", labelbottom=last)
    axes.set_xlabel("time [s]" if last else "", fontsize=9.5)
    axes.yaxis.set_label_coords(-_LABEL / width, 0.5)


def _mark(axes: Axes, shown: Sequence[Mark]) -> None:
    """A line for each event in the axes' time."""
    first, last = axes.get_xlim()
    for mark in shown:
        if first <= mark.time_s <= last:
            axes.axvline(mark.time_s, **mark.style, alpha=0.75, zorder=1.5)


def _name_zoom(axes: Axes, shown: Sequence[Mark]) -> None:
    """Say above the first zoom what it is, and put each event's marker at its line."""
    first, last = axes.get_xlim()
    axes.set_title("around the failure", fontsize=8.5, color="0.25", pad=11)
    for mark in shown:
        if first <= mark.time_s <= last:
            _marker(axes, mark, 1.05, axes.get_xaxis_transform())


def _marker(axes: Axes, mark: Mark, y: float, transform: Any) -> None:
    colour = mark.style["color"]
    axes.plot([mark.time_s], [y], mark.marker, color=colour, markersize=5, transform=transform, clip_on=False)


def _title(figure: Figure, shown: Shown, what: str) -> None:
    height = figure.get_figheight()
    left, right = _LEFT / _WIDTH, 1 - _RIGHT / _WIDTH
    figure.text(left, 1 - 0.22 / height, shown.title, fontsize=12, fontweight="bold", va="center")
    figure.text(right, 1 - 0.22 / height, shown.ended, fontsize=10, ha="right", va="center")
    figure.text(left, 1 - 0.46 / height, what, fontsize=10, va="center", color="0.25")


def _legend(figure: Figure, panels: Sequence[Axes]) -> None:
    """One legend for all panels, with each entry once."""
    entries: dict[str, Any] = {}
    for panel in panels:
        for handle, label in zip(*panel.get_legend_handles_labels(), strict=True):
            entries.setdefault(label, handle)
    figure.legend(
        entries.values(), entries, loc="upper right", ncols=max(len(entries), 1), frameon=False, fontsize=9,
        bbox_to_anchor=(1 - _RIGHT / _WIDTH, 1 - 0.33 / figure.get_figheight()),
        borderaxespad=0.0, handlelength=2.8, columnspacing=1.4,
    )  # fmt: skip


@contextmanager
def plain_text() -> Iterator[None]:
    """While in this context, `$` in a name is a dollar, not the beginning of a formula that may be wrong.

    The garbage collector waits: matplotlib makes so many objects that it would go through all that is loaded again and again.
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        with rc_context({"text.parse_math": False}):
            yield
    finally:
        if collecting:
            gc.enable()


def png(figure: Figure) -> bytes:
    """The figure as a PNG of 256 colours, which is a third of the size of one with all."""
    figure.set_dpi(DPI)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    image = Image.frombuffer("RGBA", canvas.get_width_height(), canvas.buffer_rgba(), "raw", "RGBA", 0, 1)
    few = image.convert("RGB").quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    stream = io.BytesIO()
    few.save(stream, "png")
    return stream.getvalue()


def save(figure: Figure, folder: Path, name: str) -> Path:
    """Write `folder/figures/NAME.png`, completely or not at all; returns the file."""
    file = folder / "figures" / f"{name}.png"
    write(file, png(figure), within=folder)
    return file
