"""The figure of the missions: share held by kind of failure."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
from mission_results import FAMILIES, Row, family

from testbed.common.statistics import proportion

_MARKS = "os^Dvx+*PX"


def draw(rows: Sequence[Row], folder: Path) -> None:
    """Write `missions_families.png`, of the whole controllers."""
    rows = [row for row in rows if not row.controller.startswith("without_")]
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
