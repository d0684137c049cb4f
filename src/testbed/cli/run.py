"""`testbed run`: fly one scenario, write its folder, print its verdict."""

from __future__ import annotations

import contextlib
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Collection
from functools import partial
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.cli.command import add_file, add_junit, add_origin, add_out, add_set, checked
from testbed.cli.ending import MET, NOT_MET, later, tidily
from testbed.cli.terminal import erase, print_verdict_word, working
from testbed.inputs.problems import BadInput, Problem, collect

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup
    from testbed.flight.flight import Flight
    from testbed.reporting.flightgear import Viewer
    from testbed.scenario.load import Scenario

PURPOSE = "fly one scenario"
EXAMPLES = (
    "testbed run left_tail_fail.yaml",
    "testbed run my_scenario.yaml --set controller.type=pid --set failures.0.at_s=8 --out runs/pid",
)


def arguments(command: ArgumentParser) -> None:
    add_file(command, "scenario")
    add_out(command, "DIR", "run folder to make (default: runs/<name>)")
    command.add_argument("--no-plots", action="store_true", help="draw no figures")
    own = "fly a controller of your own: a Python class FILE.py:CLASS, a command in quotes, or a C library"
    command.add_argument("--controller", metavar="OWN", help=own)
    autopilot = "fly ArduPilot, by its SITL executable; without PATH, the one that TESTBED_ARDUPILOT names"
    command.add_argument("--autopilot", nargs="?", const="", metavar="PATH", help=autopilot)
    parameters = "with --autopilot: parameters that override those written from the aircraft"
    command.add_argument("--autopilot-parameters", type=Path, metavar="FILE", help=parameters)
    watched = "show the flight in FlightGear while it is flown, in real time"
    command.add_argument("--flightgear", metavar="HOST:PORT", help=watched)
    add_origin(command, "with --flightgear")
    add_junit(command)
    add_set(command)


def run(options: Namespace) -> int:
    """Fly one scenario into a run folder; raises BadInput with every problem at once."""
    from testbed.flight.folder import refuse_existing, refuse_unwritable
    from testbed.reporting import junit
    from testbed.reporting.attempt import add_report

    problems: list[Problem] = []
    if options.out is not None:  # before the flight, not after it
        collect(problems, lambda: refuse_existing(options.out))
    if options.junit is not None:
        collect(problems, lambda: junit.refuse(options.junit, options.out))
    with working("checking"):
        scenario = collect(problems, lambda: checked(options.scenario, options.set))
    stay = contextlib.chdir(".") if options.controller else contextlib.nullcontext()
    with stay:  # its file may lead to another folder
        controller = collect(problems, lambda: _controller(options))
    viewer = collect(problems, lambda: _viewer(options.flightgear, options.origin, scenario))
    if scenario is None or problems:
        raise BadInput(problems)
    with later():
        refuse_unwritable(options.out or _default_folder(scenario, 1))  # nor this after the flight
    from testbed.common.jit_program import estimate
    from testbed.scenario import conditions
    from testbed.simulation import fly

    estimate.tell = _compiling
    with working("flying"), stay:
        flight = fly(scenario, controller, watch=viewer)
    with working("drawing and writing"), tidily():
        folder = write(flight, options.out, partial(add_report, flight, figures=not options.no_plots))
    if options.junit is not None:
        junit.write(options.junit, flight.scenario.name, junit.tests_of(flight))
    print_verdict(flight, said=conditions.warnings(scenario))
    print(f"wrote {folder}")
    return MET if flight.passed else NOT_MET


def _compiling(seconds: float) -> None:
    """Say before the first flight how long it takes [s]."""
    erase()
    print(f"compiling the control law for the first flight: about {seconds:.0f} s, once", file=sys.stderr)


def _controller(options: Namespace) -> Callable[[Setup], object] | None:
    """The user's controller or autopilot; None if the scenario's flies. Raises BadInput for options that do not go together."""
    if options.autopilot is None:
        if options.autopilot_parameters is not None:
            what = Problem("is for an autopilot", "--autopilot-parameters", expected="--autopilot")
            raise BadInput([what])
        return own_controller(options.controller)
    if options.controller is not None:
        raise BadInput([Problem("flies alone", "--autopilot", expected="no --controller beside it")])
    from testbed.controllers.external.reference import autopilot

    return autopilot(options.autopilot, options.autopilot_parameters)


def own_controller(reference: str | None) -> Callable[[Setup], object] | None:
    """The user's controller class, from `FILE.py:CLASS`; None for None."""
    if reference is None:
        return None
    from testbed.controllers.user.loader import load_controller

    return load_controller(reference)


def _viewer(address: str | None, origin: str | None, scenario: Scenario | None) -> Viewer | None:
    """What shows the flight in FlightGear at `HOST:PORT`; None for None. Raises BadInput for an origin that nothing would use."""
    if address is None and origin is not None:
        raise BadInput(
            [Problem("is for FlightGear", "--origin", expected="--flightgear HOST:PORT beside it")]
        )
    if address is None or scenario is None:
        return None
    from testbed.aircraft.changes import load_with_changes
    from testbed.plant.identification import stored
    from testbed.reporting.export.place import DEFAULT_ORIGIN, parse_origin
    from testbed.reporting.flightgear import Viewer, address_of, facts_of

    place = DEFAULT_ORIGIN if origin is None else parse_origin(origin)
    aircraft = load_with_changes(scenario.aircraft)
    return Viewer(address_of(address), facts_of(aircraft.actuators, stored(aircraft)), place)


def write(flight: Flight, out: Path | None, add: Callable[[Path], object]) -> Path:
    """Write the run folder: `out`, or else the first of runs/<name>, runs/<name>-2, ... that does not exist; returns it."""
    from testbed.flight.folder import FolderExists, write_run_folder

    if out is not None:
        return write_run_folder(flight, out, add)
    for i in count(1):
        with contextlib.suppress(FolderExists):
            return write_run_folder(flight, _default_folder(flight.scenario, i), add)
    raise AssertionError("unreachable: count() does not end")


def _default_folder(scenario: Scenario, i: int) -> Path:
    return Path("runs") / (scenario.slug if i == 1 else f"{scenario.slug}-{i}")


_NAMED = 3
"""Requirements that are named of those not judged."""


def print_verdict(flight: Flight, said: Collection[str] = ()) -> None:
    """The story of the flight, then the requirements that were missed, and its warnings but those that were `said` before it."""
    from testbed.reporting.run_report import told
    from testbed.reporting.story import diagnoses, story
    from testbed.reporting.words import DIGITS, number

    code = f" ({flight.flown_by_sha256[:DIGITS]})" if flight.flown_by_sha256 else ""
    by = f", flown by {flight.flown_by}{code}" if flight.flown_by else ""
    print(f"{flight.scenario.name}: {flight.outcome.sentence}, {flight.end_time_s:g} s{by}")
    for line in [*story(flight), *diagnoses(flight)]:
        print(f"  {line}")
    missed = [requirement for requirement in flight.requirements if requirement["passed"] is False]
    for requirement in missed:
        reason = f" ({requirement['reason']})" if requirement.get("reason") else ""
        print("  ", end="")
        print_verdict_word("NOT MET", good=False)
        print(f"  {requirement['name']}: {number(requirement['value'])}{told(flight, requirement)}{reason}")
    if flight.judged is None:
        print(flight.verdict, end="")
    else:
        print_verdict_word(flight.verdict, flight.judged)
    print(f": {flight.counted}")
    unjudged = [requirement["name"] for requirement in flight.requirements if requirement["passed"] is None]
    if unjudged:
        more = f" and {len(unjudged) - _NAMED} more" if unjudged[_NAMED:] else ""
        print(f"  not judged, as the controller does not say it: {'; '.join(unjudged[:_NAMED])}{more}")
    for warning in [text for text in flight.warnings if text not in said]:
        print(f"WARNING: {warning}", file=sys.stderr)
