"""Figure 3 of the paper, drawn from the flying law on an ideal plant."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from paper.ideal import approach_trajectories

# Lines differ in dashes and not only in shade, so that they can be told apart in print.
_DASHES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))


def figure_3(path: Path, gammas: Sequence[float] = (0.5, 1.0, 2.0, 4.0, 8.0)) -> Path:
    """Draw the paper's figure 3: how estimates approach the truth (22), with time zero where they are within 1 % of it."""
    figure = Figure(figsize=(7.0, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots()
    for index, curve in enumerate(approach_trajectories(gammas)):
        which = index // 2
        shade = str(0.6 * which / max(len(gammas) - 1, 1))
        label = rf"$\gamma$ = {curve.gamma:g} s$^{{-1}}$" if curve.sign > 0 else None
        dashes = _DASHES[which % len(_DASHES)]
        axes.plot(curve.time, curve.estimate, color=shade, linestyle=dashes, label=label, linewidth=1.6)
    axes.axhline(1.0, color="0.75", linewidth=0.8, zorder=0)
    axes.set_xlabel("time before the estimate is within 1 % of the truth [s]")
    axes.set_ylabel(r"estimate over truth, $\hat\lambda_{ii} / \lambda_{ii}$ [-]")
    axes.set_title("Approach trajectories of the effectiveness estimates, positive and negative")
    axes.set_ylim(0.0, 2.0)
    axes.legend(loc="center left", facecolor="white", framealpha=1.0, edgecolor="none")
    figure.savefig(path, dpi=150)
    return path
