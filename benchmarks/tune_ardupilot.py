"""Gains of ArduPlane, with the budget of the others: six settings on the draws of `tune_rivals`.

    python benchmarks/tune_ardupilot.py ARDUPLANE --draws 36 --jobs 2

A setting is factors of the parameters that are written from the aircraft (`ardupilot_parameters`), the same for all aircraft. The
best holds most draws, or of equal ones is within the limits longest: it is what is written. A flight that ends in an error is lost.
"""

from __future__ import annotations

import argparse
import re
import tempfile
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import yaml
from tune_rivals import _row, draw, judged, tasks

from testbed.controllers.external.ardupilot import ArduPilot
from testbed.controllers.external.ardupilot_parameters import text, written
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import parse
from testbed.scenario.load import scenario_from
from testbed.simulation import fly

RATES, ANGLES, ENERGY = "_RATE_[PI]$", "2SRV_TCONST$", "TECS_TIME_CONST$"
SETTINGS: tuple[Mapping[str, float], ...] = (
    {}, {ENERGY: 0.625}, {ENERGY: 0.375},
    {ENERGY: 0.625, RATES: 1.6}, {ENERGY: 0.625, RATES: 0.6}, {ENERGY: 0.625, ANGLES: 1.6},
)  # fmt: skip
"""Of each, the factor of the parameters that an expression finds."""


def flown(task: tuple[str, int, str, Mapping[str, float]]) -> tuple[float, float, float]:
    """`judged` of the draw of a seed and aircraft, flown by an executable with a setting."""
    path, seed, aircraft, factors = task

    def controller(setup: Setup) -> ArduPilot:
        found = {
            name: value * factor
            for name, value in written(setup).items()
            for pattern, factor in factors.items()
            if re.search(pattern, name)
        }
        with tempfile.NamedTemporaryFile("w", suffix=".parm") as file:
            file.write(text(found))
            file.flush()
            return ArduPilot(setup, path, file.name)

    scenario = scenario_from(parse(yaml.safe_dump(draw(seed, aircraft)), "draw"))
    try:
        return judged(fly(scenario, controller))
    except BadInput as error:
        print(seed, aircraft, error)
        return 0.0, 0.0, 0.0


def main() -> None:
    """Fly, and print a row for each setting."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("executable", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("--draws", type=int, default=36)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    aircraft = ["vtail", "vtail_aft", "aerosonde"]
    print(f"| factors | survived | held | within limits | {' | '.join(aircraft)} |\n|{' --- |' * 7}")
    with ProcessPoolExecutor(options.jobs) as pool:
        for factors in SETTINGS:
            plan = [(options.executable, *task, factors) for task in tasks(options.draws, aircraft)]
            print(_row(str(factors), np.array(list(pool.map(flown, plan))), len(aircraft)), flush=True)


if __name__ == "__main__":
    main()
