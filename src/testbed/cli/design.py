"""`testbed design`: gains of the estimator for a scenario's sensors and turbulence, as text and as YAML to be pasted."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from testbed.cli.command import add_file, add_number, add_out, add_set, checked, number, write_out
from testbed.cli.ending import MET, NOT_MET
from testbed.cli.terminal import working
from testbed.inputs.output_file import refuse_unwritable

if TYPE_CHECKING:
    from testbed.gains.design import Design
    from testbed.gains.verdict import ActuatorDesign

PURPOSE = "gains of the estimator from a scenario's noise, as YAML"
EXAMPLES = (
    "testbed design mems_turbulence.yaml",
    "testbed design my_scenario.yaml --within 2 --out gains.yaml",
)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "scenario")
    add_number(command, "--deviation", 0.1, "SIGMA", "tolerated standard deviation of an estimate")
    add_number(command, "--false-alarms", 0.1, "RATE", "tolerated false alarms per hour")
    add_number(command, "--keep", 0.2, "EFFECTIVENESS", "effectiveness that must not be flagged")
    within = "time in which an estimate has to converge"
    command.add_argument("--within", type=number, metavar="SECONDS", help=within)
    add_out(command, "FILE", "write the YAML into this file too")
    add_set(command)


def run(options: Namespace) -> int:
    """Print gains for a scenario and what they are expected to do.

    Raises BadInput when the scenario or a tolerance cannot be used, or the file cannot be written.
    """
    from testbed.gains.design import design

    if options.out is not None:
        refuse_unwritable(options.out)
    with working("checking"):
        scenario = checked(options.scenario, options.set)
    with working("designing"):
        found = design(
            scenario,
            deviation=options.deviation,
            false_alarms_per_hour=options.false_alarms,
            keep=options.keep,
            within_s=options.within,
        )
    print("\n".join(_sentences(found)))
    print(yaml_of(found), end="")
    if options.out is not None:
        write_out(options.out, yaml_of(found))
    return MET if found.possible else NOT_MET


def yaml_of(found: Design) -> str:
    """The `controller` block of a scenario."""
    return "".join(
        ["controller:\n", *(f"  {key}: {_value(value)}\n" for key, value in found.controller.items())]
    )


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key}: {_value(one)}' for key, one in value.items())}}}"
    return value if isinstance(value, str) else f"{value:g}"


def _sentences(found: Design) -> Iterator[str]:
    from testbed.common.signals import RATES

    yield f"{found.scenario.name}: level flight at {found.scenario.initial.airspeed_m_s:g} m/s"
    yield from _table(found.actuators)
    often = (
        f"{found.false_alarms_per_hour:.2g} an hour"
        if math.isfinite(found.false_alarms_per_hour)
        else "at once"
    )
    yield (
        f"false alarms: {often} with actuators at {found.tolerance.keep:g} "
        f"({found.tolerance.false_alarms_per_hour:g} tolerated)"
    )
    rates = zip(RATES, found.disturbance, strict=True)
    yield (
        f"noise of the rates, root of the two-sided intensity: {', '.join(f'{rate} {x:.2g}' for rate, x in rates)}"
    )
    for sentence in found.impossible:
        yield f"IMPOSSIBLE  {sentence}"
    for sentence in found.advice:
        yield f"would help  {sentence}"


def _table(actuators: tuple[ActuatorDesign, ...]) -> Iterator[str]:
    width = max(len(one.name) for one in actuators)
    yield f"{'':{width}}  position  noise  offset    bias  converges  flagged                 largest error"
    for one in actuators:
        largest = "{} {:.2g}".format(*one.shares[0]) if one.shares else "none"
        yield (
            f"{one.name:{width}}  {one.position:8.3f}  {one.noise:5.3f}  {one.offset:6.3f}  {one.bias:+6.3f}  "
            f"{one.convergence_s:7.2f} s  {_flagged(one):<22}  {largest}"
        )


def _flagged(one: ActuatorDesign) -> str:
    """Time to the flag: the median of the flights, and their range."""
    if math.isinf(one.detection_s):
        return "never"
    found = f"{one.detection_s:.2f} s"
    if one.soonest_s == one.latest_s:
        return found
    latest = "never" if math.isinf(one.latest_s) else f"{one.latest_s:.2f}"
    return f"{found} ({one.soonest_s:.2f} to {latest})"
