"""What a part of the default law brings in the flights that it is for: draws of `open` in which only these fail.

    python benchmarks/parts_where_they_act.py runs/parts --draws 240

One folder of `testbed benchmark` for each kind of flight; `benchmark_page.py --acts runs/parts/*` takes them into the page. In the
suite itself few flights have any one kind of failure, and a part that decides them alone hardly shows in the mean of all.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import yaml

import testbed

ROOT = Path(__file__).parents[1]
Entry = dict[str, Any]


def _of(*families: str) -> Callable[[Entry], bool]:
    return lambda entry: entry["family"] in families


def _thrust(entry: Entry) -> bool:
    return _of("lost", "weak", "on and off", "brown-out")(entry) and entry["type"] != "surface_lost"


KINDS: dict[str, tuple[str, Callable[[Entry], bool]]] = {
    "jams": ("jam_test", _of("jammed near trim", "jammed far from trim", "floats")),
    "reversed": ("jam_test", _of("reversed")),
    "offsets": ("offset_test", _of("offset")),
    "late": ("lateness", lambda entry: entry["type"] in ("lag", "delay")),
    "thrust": ("speed_rule", _thrust),
    "recoveries": ("probing", _of("lost", "jammed near trim", "jammed far from trim", "floats")),
    "stuck_sensors": ("sensor_guard", lambda entry: True),
}
"""Kinds of flights: the part that they are for, and which entries of the suite's failures are drawn. Recoveries all end."""


def suite_of(kind: str) -> dict[str, Any]:
    """The suite `open` with one kind of failure, one or two of them, and two controllers. Of stuck sensors: in each flight one,
    beside any failures."""
    part, wanted = KINDS[kind]
    suite = yaml.safe_load((ROOT / "scenarios" / "suites" / "open.yaml").read_text(encoding="utf-8"))
    del suite["told"]
    suite["suite"] = kind
    suite["controllers"] = {
        "default": {"type": "adaptive_inversion"},
        f"no_{part}": {"type": "adaptive_inversion", "ablate": [part]},
    }
    failures, faults = suite["failures"], suite["sensor_faults"]
    if kind == "stuck_sensors":
        suite["sensors"] = {"mems": 1}
        faults |= {"share": 1.0, "faults": [each for each in faults["faults"] if each["type"] == "stuck"]}
        return suite
    failures["types"] = [each for each in failures["types"] if wanted(each)]
    failures["count"] = {"choice": [1, 2], "weights": [3, 1]}
    if kind == "recoveries":
        failures["ends"] = 1.0
    if kind == "thrust":
        failures["types"] = [{**each, "of": "motor"} for each in failures["types"]]
    return suite


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--draws", type=int, default=240, help="flights of each controller in each kind")
    parser.add_argument("--seed", type=int, default=4242)
    parser.add_argument("--kind", choices=KINDS, action="append", help="only these")
    options = parser.parse_args(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    for kind in options.kind or KINDS:
        file, out = options.folder / f"{kind}.yaml", options.folder / kind
        file.write_text(yaml.safe_dump(suite_of(kind), sort_keys=False), encoding="utf-8")
        flown = testbed.benchmark(file, out, seed=options.seed, draws=options.draws, resume=out.exists())
        print(flown.groupby("controller")[["survived", "held", "inside"]].mean(), flush=True)


if __name__ == "__main__":
    main()
