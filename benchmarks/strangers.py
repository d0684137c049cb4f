"""Fly a suite that differs from `open` in kind: what a lead on `open` is worth elsewhere.

    python benchmarks/strangers.py runs/strangers --word a6439874 --draws 80

Aircraft that no rule of the law was made on, with more turns, climbs, gusts and failures at a time, more of which end. Invented
after the freeze of a6439874.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pandas as pd
import yaml

import testbed
from testbed.api.benchmark import prepare
from testbed.cli.ending import BAD_INPUT
from testbed.inputs.output_file import refuse_unwritable
from testbed.inputs.problems import BadInput

ROOT = Path(__file__).parents[1]
CONTROLLERS = ("default", "indi_monitor", "l1_inversion", "indi")
AIRCRAFT: dict[str, tuple[float, list[float], list[float], float, float]] = {
    "pc7": (10.2, [62, 80], [1000, 2200], 2300, 1.64),
    "p51d": (11.3, [84, 105], [1000, 2500], 4175, 2.0),
    "pa28": (9.1, [39, 50], [800, 2000], 1000, 1.6),
    "c310": (10.7, [55, 68], [1000, 3000], 2100, 1.5),
    "fokker100": (28.0, [125, 170], [2000, 4500], 40000, 3.8),
    "f16": (9.1, [125, 190], [2000, 4500], 9000, 3.4),
    "MD11": (51.0, [160, 200], [2000, 4500], 200000, 7.0),
    "L17": (10.2, [56, 68], [1000, 2500], 1250, 1.6),
}
"""Span [m], airspeeds [m/s], altitudes [m], mass [kg] and chord [m] of each."""


def suite() -> dict[str, Any]:
    """The suite `open` with other aircraft, references, gusts, sensors and numbers of failures."""
    made = yaml.safe_load((ROOT / "scenarios" / "suites" / "open.yaml").read_text(encoding="utf-8"))
    del made["told"]
    made["suite"] = "strangers"
    made["purpose"] = (
        "aircraft that no rule of the law was made on, more turns and climbs, "
        "more failures at a time, more of them that end"
    )
    made["controllers"] = {name: made["controllers"][name] for name in CONTROLLERS}
    keys = ("span_m", "airspeed_m_s", "altitude_m", "mass_kg", "chord_m")
    made["aircraft"] = {
        name: {"adopt": name, **dict(zip(keys, numbers, strict=True)), "w20_factor": 2}
        for name, numbers in AIRCRAFT.items()
    }
    made["truth"]["share"] = 0.0
    made["references"] |= {
        "legs": {"integers": [5, 12]},
        "heading_deg": {"uniform": [-180, 180]},
        "altitude_s": {"uniform": [-3, 3]},
        "airspeed": {"uniform": [0.95, 1.08]},
    }
    made["gusts"]["share"] = 0.6
    made["sensors"] = {"mems": 1, "ideal": 1}
    made["sensor_faults"]["share"] = 0.4
    made["failures"] |= {
        "count": {"choice": [1, 2, 3], "weights": [4, 4, 2]},
        "first_s": {"uniform": [5, 100]},
        "together": 0.5,
        "ends": 0.6,
        "back": 0.5,
    }
    return made


def fly(folder: Path, word: str, draws: int) -> pd.DataFrame:
    """The table of the flights in a folder, flown as far as they are missing; raises BadInput before anything is written."""
    file, out = folder / "strangers.yaml", folder / "flights"
    text = yaml.safe_dump(suite(), sort_keys=False)
    with TemporaryDirectory() as scratch:
        tried = Path(scratch) / file.name
        tried.write_text(text, encoding="utf-8")
        prepare(tried, out, word=word, draws=draws)
    refuse_unwritable(file, is_ours=lambda _: True)
    file.write_text(text, encoding="utf-8")
    return testbed.benchmark(file, out, word=word, draws=draws, resume=out.exists())


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--word", required=True, help="from which, with the law's digest, the seed is made")
    parser.add_argument("--draws", type=int, default=80, help="flights of each controller")
    options = parser.parse_args(arguments)
    try:
        flown = fly(options.folder, options.word, options.draws)
    except BadInput as error:
        parser.exit(BAD_INPUT, f"{error}\n")
    print(flown.groupby("controller")[["survived", "held", "inside"]].mean())


if __name__ == "__main__":
    main()
