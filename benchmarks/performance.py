"""The first table of docs/results/performance.md: what a control step costs, by `closed_loop.py`.

python benchmarks/performance.py
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from blocks import write

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "results" / "performance.md"
CASES = (
    ("left_tail_fail.yaml", "the paper's", "ideal"),
    ("left_tail_fail.yaml --sensors mems", "the paper's", "MEMS"),
    ("lost_surface.yaml", "the default", "ideal"),
    ("mems_turbulence.yaml --sensors mems --turbulence 7.62", "the default", "MEMS, 25 ft/s"),
)
HEAD = "| scenario | law | sensors, weather | JSBSim's step, us | complete step, us | ratio | outside the steps, ms |"


def main() -> None:
    """Measure each case and write the table."""
    lines = [HEAD, "| --- |" + " --- |" * (HEAD.count("|") - 2)]
    for case, law, air in CASES:
        run = [sys.executable, "benchmarks/closed_loop.py", *f"scenarios/{case}".split()]
        found = json.loads(subprocess.run(run, cwd=ROOT, check=True, capture_output=True, text=True).stdout)
        outside = found["outside_ms"]
        numbers = f"{found['bare_us']:.2f} | {found['closed_loop_us']:.2f} | {found['ratio']:.2f} | {outside['sum']:.0f}"
        lines.append(f"| `{case}` | {law} | {air} | {numbers} |")
    write(PAGE, "steps", "\n".join(lines))


if __name__ == "__main__":
    main()
