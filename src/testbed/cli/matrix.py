"""`testbed matrix`: every actuator broken in every way, and whether that came out as expected."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from testbed.cli import study
from testbed.cli.command import (
    add_file,
    add_many_flights,
    add_out,
    add_set,
    add_single_runs,
    number,
    whole_number,
)

PURPOSE = "break every actuator in every way, and compare with what is expected"
EXAMPLES = (
    "testbed matrix vtail",
    "testbed matrix mems_turbulence.yaml --failures stuck effectiveness --weather calm light --seeds 3",
    "testbed matrix vtail --baseline expected.csv --controller pid --controller adaptive_inversion",
)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "broken", metavar="SCENARIO|AIRCRAFT")
    add_out(command, "DIR", "folder to make (default: runs/<name>)")
    failures = (
        "types, or failures with values such as '{type: effectiveness, value: 0}' (default: every type)"
    )
    command.add_argument("--failures", type=_value, nargs="+", metavar="TYPE", help=failures)
    severities = "1 is the value given or the catalogue's, 0 is without effect (default: 0.5 1)"
    command.add_argument("--severities", type=number, nargs="+", metavar="X", help=severities)
    weather = "calm, light, moderate, severe, or W20 in m/s (default: the scenario's)"
    command.add_argument("--weather", type=_value, nargs="+", metavar="AIR", help=weather)
    command.add_argument(
        "--seeds", type=whole_number, metavar="N", help="flights of each cell; the worst counts"
    )
    command.add_argument("--at", type=number, metavar="S", help="when each failure starts [s]")
    baseline = "what is expected of the cells: YAML, or the matrix.csv of an earlier one (default: all held)"
    command.add_argument("--baseline", type=Path, metavar="FILE", help=baseline)
    add_single_runs(command, logs="all")
    add_many_flights(command)
    add_set(command)


def _value(text: str) -> Any:
    from testbed.inputs.yaml_source import parse

    return parse(text).tree


def run(options: Namespace) -> int:
    """Fly a matrix, or one run of it; as `study.run`."""
    from testbed.api import matrix

    own = {key: getattr(options, key) for key in ("failures", "severities", "weather", "seeds", "baseline")}
    return study.run(matrix, options, options.broken, at_s=options.at, **own)
