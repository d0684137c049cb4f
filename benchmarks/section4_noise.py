"""Noise, disturbances and state-function error (sections 4.1, 4.2): predicted, on the ideal plant, and flown in JSBSim.

Writes docs/results/section4_noise.md and the figures docs/figures/section4_noise.png and section4_survivable.png.

python benchmarks/section4_noise.py            # some 800 flights
python benchmarks/section4_noise.py --quick    # a few of each kind
"""

from __future__ import annotations

import argparse
from pathlib import Path

from section4_bias import bias_rows, remarks
from section4_design import design_rows
from section4_deviation import alarm_rows, draw_noise, noise_points, noise_table, summary
from section4_survivable import survivable

PAGE = Path(__file__).with_suffix(".md")
"""The page, with names in braces in place of tables."""


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument("--jobs", type=int)
    arguments.add_argument("--seeds", type=int, default=4)
    arguments.add_argument("--out", type=Path, default=Path("docs/results/section4_noise.md"))
    arguments.add_argument("--figures", type=Path, default=Path("docs/figures"))
    options = arguments.parse_args()
    quick, jobs, seeds = options.quick, options.jobs, 1 if options.quick else options.seeds
    points = noise_points(quick, seeds, jobs)
    draw_noise(points, options.figures / "section4_noise.png")
    options.out.write_text(
        PAGE.read_text().format(
            seeds=seeds,
            noise="\n".join(noise_table(points)),
            summary=summary(points),
            alarms="\n".join(alarm_rows(quick, seeds, jobs)),
            bias="\n".join(bias_rows(quick, jobs)),
            remarks="\n".join(remarks()),
            design="\n".join(design_rows(quick, seeds, jobs)),
            survivable="\n".join(survivable(quick, jobs, options.figures / "section4_survivable.png")),
        )
    )
    print(f"wrote {options.out}")


if __name__ == "__main__":
    main()
