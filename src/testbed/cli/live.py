"""`testbed live`: fly a scenario in real time in a page of a browser on this machine, and break it by hand."""

from __future__ import annotations

import shlex
from argparse import ArgumentParser, Namespace
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from testbed.cli.command import add_file, add_set, checked, whole_number
from testbed.cli.ending import MET, tidily
from testbed.cli.terminal import working
from testbed.inputs.problems import BadInput, Problem, collect

if TYPE_CHECKING:
    from testbed.reporting.flight import ReportedFlight

PURPOSE = "fly in real time in a page, and break it by hand"
EXAMPLES = ("testbed live", "testbed live stuck_ruddervator.yaml --controller my_controller.py:MyController")

_DEFAULT = "left_tail_fail.yaml"


def arguments(command: ArgumentParser) -> None:
    add_file(command, "scenario", nargs="?", default=_DEFAULT)
    own = "fly a controller class of your own in place of the scenario's"
    command.add_argument("--controller", metavar="FILE.py:CLASS", help=own)
    port = "port of this machine at which the page is (default: any free one)"
    command.add_argument("--port", type=whole_number, default=0, metavar="N", help=port)
    command.add_argument("--no-browser", action="store_true", help="open no browser, print the address only")
    add_set(command)


def run(options: Namespace) -> int:
    """Serve until Ctrl-C; raises BadInput with every problem at once."""
    if find_spec("websockets") is None:
        raise BadInput(
            [Problem("needs the package websockets", "live", expected="pip install 'testbed[live]'")]
        )
    from testbed.cli.run import own_controller
    from testbed.live.aloft import Aloft
    from testbed.live.choices import Choices
    from testbed.live.page import page
    from testbed.live.pilot import Pilot
    from testbed.live.server import LiveServer, listening

    problems: list[Problem] = []
    with working("checking"):
        scenario = collect(problems, lambda: checked(options.scenario, options.set))
    controller = collect(problems, lambda: own_controller(options.controller))
    listener = collect(problems, lambda: listening(options.port))
    if scenario is None or listener is None or problems:
        raise BadInput(problems)
    with listener:
        with working("preparing"):
            choices = Choices(options.scenario, scenario, controller, options.controller)
            pilot = Aloft(lambda line: Pilot(choices, line, _keep))
            server = LiveServer(listener, page, pilot)
        with tidily():
            server.run(partial(_ready, server.address, not options.no_browser))
    return MET


def _ready(address: str, browser: bool) -> None:
    print(f"flying at {address}\nCtrl-C ends it", flush=True)
    if browser:
        import webbrowser

        webbrowser.open(address)


def _keep(flight: ReportedFlight, controller: str | None) -> tuple[Path, str]:
    """Write the run folder of a flight; returns it, and the command that flies it again."""
    from testbed.cli.run import write
    from testbed.reporting.attempt import add_report

    folder = write(flight, None, partial(add_report, flight))
    words = ["testbed", "run", str(folder / "scenario.yaml")]
    return folder, shlex.join(words if controller is None else [*words, "--controller", controller])
