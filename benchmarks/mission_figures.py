"""Figures of the missions: share held by kind of failure, and what each part of the law brings."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
from mission_results import FAMILIES, Row, family, held_more

from testbed.common.statistics import proportion

_MARKS = "os^Dvx+*PX"


def draw(rows: Sequence[Row], reference: str, folder: Path) -> None:
    """Write `missions_families.png`, and `missions_ablation.png` if ablations were flown."""
    _families([row for row in rows if not row.controller.startswith("without_")], folder)
    if any(row.controller.startswith("without_") for row in rows):
        _ablation(rows, reference, folder)


def _families(rows: Sequence[Row], folder: Path) -> None:
    names = list(dict.fromkeys(row.controller for row in rows))
    kinds = [kind for kind in FAMILIES if any(family(row.mission) == kind for row in rows)]
    figure, axes = plt.subplots(figsize=(8, 0.62 * len(kinds) + 1.6), layout="constrained")
    for j, name in enumerate(names):
        of = [[r.held for r in rows if r.controller == name and family(r.mission) == kind] for kind in kinds]
        known = [proportion(sum(held), len(held)) for held in of]
        places = [i + 0.07 * (j - len(names) / 2) for i in range(len(kinds))]
        shares = [p.estimate for p in known]
        low = [p.estimate - p.low for p in known]
        high = [p.high - p.estimate for p in known]
        axes.errorbar(shares, places, xerr=(low, high), fmt=_MARKS[j % len(_MARKS)], ms=4, lw=0.8, label=name)
    axes.set_yticks(range(len(kinds)), kinds)
    axes.invert_yaxis()
    axes.set_xlabel("share of flights held (95 % interval)")
    axes.grid(axis="x", alpha=0.3)
    figure.legend(loc="outside lower center", ncols=4, fontsize="small")
    figure.savefig(folder / "missions_families.png", dpi=110)
    plt.close(figure)


def _ablation(rows: Sequence[Row], reference: str, folder: Path) -> None:
    whole = [row for row in rows if row.controller == reference]
    names = [n for n in dict.fromkeys(row.controller for row in rows) if n.startswith("without_")]
    found = [(n, held_more(whole, [row for row in rows if row.controller == n])) for n in names]
    known = [(name, d) for name, d in found if d is not None]
    figure, axes = plt.subplots(figsize=(7, 0.45 * len(known) + 1.1), layout="constrained")
    for i, (_, d) in enumerate(known):
        axes.errorbar([100 * d.difference], [i], xerr=[[100 * (d.difference - d.low)], [100 * (d.high - d.difference)]],
                      fmt="o", color="C0", capsize=3)  # fmt: skip
    axes.axvline(0.0, color="0.5", lw=0.8)
    axes.set_yticks(range(len(known)), [name.replace("_", " ") for name, _ in known])
    axes.invert_yaxis()
    axes.set_xlabel("points of flights held that the whole law has more (paired, 95 %)")
    figure.savefig(folder / "missions_ablation.png", dpi=110)
    plt.close(figure)
