"""`testbed identify`: find the design model that controllers use, and store it in the aircraft's folder.

It also prints what the actuators can do about each axis, and which axes controllers therefore give up from the start.
"""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.cli.command import add_out
from testbed.cli.ending import MET, NOT_MET, tidily
from testbed.cli.terminal import working
from testbed.inputs.output_file import writing
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.aircraft.description import Aircraft
    from testbed.aircraft.design_model import DesignModel

PURPOSE = "find an aircraft's design model and store it in the aircraft's folder"
EXAMPLES = (
    "testbed identify ./my_aircraft",
    "testbed identify vtail --check",
    "testbed identify ./my_aircraft --write",
    "testbed identify vtail --log runs/turns --log runs/climbs --out flown",
)


def arguments(command: ArgumentParser) -> None:
    command.add_argument("aircraft", help="name, or path of a folder such as ./name")
    check = "only compare with the stored model; exit status 1 if it differs"
    command.add_argument("--check", action="store_true", help=check)
    numbers = "first write limits, rates, lags and motor constants of the YAML into the JSBSim model"
    command.add_argument("--write", action="store_true", help=numbers)
    log = "log of healthy flight, as of `diagnose`, whose model is found instead; may be repeated"
    command.add_argument("--log", type=Path, action="append", metavar="LOG", help=log)
    columns = "YAML file that says which column of a log is what, in which unit"
    command.add_argument("--columns", type=Path, metavar="MAP", help=columns)
    add_out(
        command,
        "DIR",
        "folder for the model of --log, summary.json and report.html; NAME.json: the model alone",
    )


def run(options: Namespace) -> int:
    if options.write and (options.check or options.log):
        raise BadInput([Problem("changes the model", "--write", expected="no --check and no --log")])
    if options.log:
        return _from_logs(options)
    if options.out is not None or options.columns is not None:
        raise BadInput([Problem("is for --log", "--out" if options.out is not None else "--columns")])
    if options.write:
        _adjust(options.aircraft)
    with working("identifying"):
        same = _identify(options.aircraft, check=options.check)
    return MET if same else NOT_MET


def _adjust(name: str) -> None:
    """Write numbers of the YAML into the model, and say which. Raises BadInput."""
    from testbed.aircraft.description import load_aircraft
    from testbed.aircraft.model_files.agreement import adjust

    aircraft = load_aircraft(name)
    with tidily(), writing(aircraft.folder):
        for line in adjust(aircraft):
            print(line)


def _from_logs(options: Namespace) -> int:
    """Print what logs say of the design model, and write the model that they give. Raises BadInput."""
    from testbed.logs.entry import identify
    from testbed.logs.identified_report import table

    if options.check:
        raise BadInput([Problem("is not for --log", "--check")])
    with working("identifying"), tidily():
        found = identify(options.aircraft, options.log, options.columns, options.out)
    print(table(found, [str(log) for log in options.log]))
    if options.out is not None:
        print(f"wrote {options.out}")
    return MET


def _identify(name: str, *, check: bool) -> bool:
    """Identify the design model and store it; with `check`, only compare it with the stored one.

    Returns False if the stored model differs. Raises BadInput when the aircraft has no trim or the file cannot be written.
    """
    from testbed.aircraft.description import load_aircraft
    from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
    from testbed.plant.identification import identify

    aircraft = load_aircraft(name)
    file = aircraft.folder / DESIGN_MODEL
    model = identify(aircraft)
    print(_authority_table(aircraft, model))
    if check:
        same = file.is_file() and load_design_model(file).agrees_with(model)
        print(f"{file}: {'as identified' if same else 'differs from what is identified now'}")
        return same
    with tidily(), writing(file):
        model.save(file)
    print(f"wrote {file}")
    return True


def _authority_table(aircraft: Aircraft, model: DesignModel) -> str:
    """Authority and disturbance by gusts of each axis, and the axes that `released: auto` gives up."""
    from testbed.common.signals import RATES
    from testbed.controllers import released_axes
    from testbed.controllers.setup import stops

    limits, priorities = stops(aircraft), aircraft.control.priorities
    released = released_axes.released_from_start(model, limits, priorities)
    lines = [
        f"authority of each axis against gusts at W20 = {released_axes.REFERENCE_W20_M_S:g} m/s, the other axes kept as they are:"
    ]
    for one in released_axes.authorities(model, limits, RATES, range(len(model.actuators))):
        unit = "m/s2" if one.axis == "u_dot" else "rad/s2"
        need = released_axes.MARGIN[one.axis]
        lines.append(
            f"  {one.axis}  {one.authority:8.2f} {unit:6}  gusts {one.disturbance:6.2f} (1 sigma)  "
            f"{one.authority / one.disturbance:5.1f} sigma of {need:g} needed"
        )
    lines.append(f"given up from the start: {', '.join(released) or 'nothing'}")
    return "\n".join(lines)
