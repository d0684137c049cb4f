"""Verdicts as JUnit XML, which continuous integration servers show: a test for each requirement, flight or cell."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from testbed.common.text import printable
from testbed.common.writing import write as write_file
from testbed.flight.flight import Flight
from testbed.inputs.output_file import refuse_unwritable
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.story import story
from testbed.reporting.words import number

_ROOT = '<testsuites name="testbed"'


class Test(NamedTuple):
    """One test: its name, what was not as it should be in a line ("" if nothing), the text below it, and why it was skipped."""

    name: str
    failure: str = ""
    text: str = ""
    skipped: str = ""


def write(file: Path, name: str, tests: Iterable[Test]) -> None:
    """Write the tests of a run, a sweep or a matrix of this name, whole or not at all. Raises OSError."""
    found, name = list(tests), printable(name)
    counts = {
        "tests": str(len(found)),
        "failures": str(sum(bool(test.failure) for test in found)),
        "skipped": str(sum(bool(test.skipped) for test in found)),
    }
    root = ElementTree.Element("testsuites", {"name": "testbed"})
    suite = ElementTree.SubElement(root, "testsuite", {"name": name, **counts})
    for test in found:
        case = ElementTree.SubElement(suite, "testcase", {"classname": name, "name": printable(test.name)})
        if test.failure:
            failed = ElementTree.SubElement(case, "failure", {"message": printable(test.failure)})
            failed.text = "\n".join(map(printable, test.text.splitlines()))
        elif test.skipped:
            ElementTree.SubElement(case, "skipped", {"message": printable(test.skipped)})
    ElementTree.indent(root)
    write_file(file, ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n")


def refuse(file: Path, folder: Path | None) -> None:
    """Raise BadInput where `write` could not write, would replace a file that is none of ours, or one of the output folder."""
    with suppress(OSError, ValueError):  # of a name that `refuse_unwritable` refuses
        if folder is not None and file.resolve().is_relative_to(folder.resolve()):
            what = f"is in {folder}, which holds the results"
            raise BadInput([Problem(what, str(file), expected="a file beside it")])
    refuse_unwritable(file, _is_ours)


def _is_ours(file: Path) -> bool:
    with file.open(encoding="utf-8", errors="replace") as stream:
        return _ROOT in stream.read(200)


def tests_of(flight: Flight) -> Iterator[Test]:
    """A test of how the flight ended, and one of each requirement; each that failed has the flight's story."""
    told, ended = "\n".join(story(flight)), f"it {flight.outcome.sentence} ({flight.end_time_s:g} s)"
    yield Test("flown to the end", ended if flight.outcome.is_lost else "", told)
    for requirement in flight.requirements:
        reason = f" ({requirement['reason']})" if requirement.get("reason") else ""
        said = f"{requirement['name']}: {number(requirement['value'])}{reason}"
        if requirement["passed"] is None:
            yield Test(requirement["name"], skipped=requirement["reason"])
        else:
            yield Test(requirement["name"], "" if requirement["passed"] else said, told)
