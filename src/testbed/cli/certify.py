"""`testbed certify`: how wrong the input matrix of a scenario's design model may be, as tables; also as CSV or JSON."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from pathlib import Path

from testbed.cli.checked import checked
from testbed.cli.command import add_file, add_number, add_out, add_set
from testbed.cli.interrupts import tidily
from testbed.cli.status import MET
from testbed.cli.working import working
from testbed.inputs.output_file import refuse_unwritable, written
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
    problems: list[Problem] = [*_wrong_error(options.error), *_wrong_file(options.out)]
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
        with tidily(), written(options.out) as stream:
            stream.write(FORMATS[options.out.suffix](certificate).encode())
        print(f"wrote {options.out}")
    return MET


def _wrong_error(error: float) -> Iterator[Problem]:
    if not 0.0 < error < 1.0:
        yield Problem(f"is {error:g}", "--error", expected="a fraction between 0 and 1, such as 0.1")


def _wrong_file(out: Path | None) -> Iterator[Problem]:
    if out is not None and out.suffix not in _ENDINGS:
        yield Problem("has no known ending", str(out), expected=" or ".join(_ENDINGS))
    elif out is not None:
        found: list[Problem] = []
        collect(found, lambda: refuse_unwritable(out))
        yield from found
