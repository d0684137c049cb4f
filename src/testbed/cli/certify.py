"""`testbed certify`: how wrong the input matrix of a scenario's design model may be, as tables; also as CSV or JSON."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from testbed.cli.command import add_file, add_number, add_out, add_set, checked, write_out
from testbed.cli.ending import MET
from testbed.cli.terminal import working
from testbed.inputs.output_file import refuse_unwritable
from testbed.inputs.problems import BadInput, Problem, collect

PURPOSE = "say how wrong the input matrix of a scenario's design model may be"
EXAMPLES = (
    "testbed certify left_tail_fail.yaml",
    "testbed certify my_scenario.yaml --error 0.2 --out certificate.json",
)

_ENDINGS = (".csv", ".json")


def arguments(command: ArgumentParser) -> None:
    add_file(command, "scenario")
    error = "relative error of all entries for which the bias of the estimates is bounded"
    add_number(command, "--error", 0.1, "FRACTION", error)
    add_out(command, "FILE", "also write all numbers into this .csv or .json file")
    add_set(command)


def run(options: Namespace) -> int:
    """Certify a scenario, print the tables, and write the file that is asked for; raises BadInput with every problem at once."""
    problems: list[Problem] = []
    if not 0.0 < options.error < 1.0:
        what = f"is {options.error:g}"
        problems.append(Problem(what, "--error", expected="a fraction between 0 and 1, such as 0.1"))
    if options.out is not None:
        collect(problems, lambda: _refuse_file(options.out))
    with working("checking"):
        scenario = collect(problems, lambda: checked(options.scenario, options.set))
    if scenario is None or problems:
        raise BadInput(problems)
    from testbed.margins.certificate import certify
    from testbed.margins.display import FORMATS, text

    with working("trimming and flying"):
        certificate = certify(scenario, options.error)
    print(text(certificate))
    if options.out is not None:
        write_out(options.out, FORMATS[options.out.suffix](certificate))
    return MET


def _refuse_file(out: Path) -> None:
    if out.suffix not in _ENDINGS:
        raise BadInput([Problem("has no known ending", str(out), expected=" or ".join(_ENDINGS))])
    refuse_unwritable(out)
