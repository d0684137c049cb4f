"""Noise, disturbances and state-function error (sections 4.1, 4.2): predicted, on the ideal plant, and flown in JSBSim.

Writes docs/results/section4_noise.md and the figures docs/figures/section4_noise.png and section4_survivable.png.

python benchmarks/section4_noise.py            # some 800 flights
python benchmarks/section4_noise.py --quick    # a few of each kind
python benchmarks/section4_noise.py --only bias remarks
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable
from pathlib import Path

from aside import aside
from section4_bias import bias_rows, remarks, transients
from section4_design import design_rows
from section4_deviation import alarm_rows, draw_noise, noise_points, noise_table, summary
from section4_jacobian import jacobian, remark_4
from section4_survivable import survivable

PAGE = Path(__file__).with_suffix(".md")
"""The page, with names in braces in place of tables."""


Section = Callable[[argparse.Namespace], Iterable[str]]


def noise_section(options: argparse.Namespace) -> Iterable[str]:
    points = noise_points(options.quick, options.seeds, options.jobs)
    draw_noise(points, options.figures / "section4_noise.png")
    return [*noise_table(points), "", summary(points)]


SECTIONS: dict[str, Section] = {
    "noise": noise_section,
    "alarms": lambda options: alarm_rows(options.quick, options.seeds, options.jobs),
    "bias": lambda options: bias_rows(options.quick, options.jobs),
    "transients": lambda options: transients(options.quick),
    "jacobian": lambda options: jacobian(),
    "remarks": lambda options: remarks(),
    "remark_4": lambda options: remark_4(),
    "design": lambda options: design_rows(options.quick, options.seeds, options.jobs),
    "survivable": lambda options: survivable(
        options.quick, options.jobs, options.figures / "section4_survivable.png"
    ),
}


ASIDE = ("noise", "bias", "design")
"""Sections whose first table stands beside the page."""


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--quick", action="store_true")
    arguments.add_argument(
        "--only", nargs="+", choices=SECTIONS, help="measure these again, and take the others from --parts"
    )
    arguments.add_argument("--jobs", type=int)
    arguments.add_argument("--seeds", type=int, default=4)
    arguments.add_argument("--parts", type=Path, default=Path("runs/section4_noise"))
    arguments.add_argument("--out", type=Path, default=Path("docs/results/section4_noise.md"))
    arguments.add_argument("--figures", type=Path, default=Path("docs/figures"))
    options = arguments.parse_args()
    if options.quick:
        options.seeds = 1
    options.parts.mkdir(parents=True, exist_ok=True)
    for name in options.only or SECTIONS:
        text = "\n".join(SECTIONS[name](options))
        (options.parts / f"{name}.md").write_text(text)
    parts = {name: (options.parts / f"{name}.md").read_text() for name in SECTIONS}
    for name in ASIDE:
        file = options.out.with_name(f"{options.out.stem}_{name}.csv")
        parts[name] = "\n".join(aside(parts[name].splitlines(), file))
    options.out.write_text(PAGE.read_text().format(seeds=options.seeds, **parts))
    print(f"wrote {options.out}")


if __name__ == "__main__":
    main()
