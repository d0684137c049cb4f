"""What has been tried against the program, by class, and what came of each attempt: the tests that hold `trust.md`.

    nice python benchmarks/attacks.py [FILE [EXPRESSION]]

It runs the tests of CLASSES, those of the night among them, and writes FILE, docs/explanation/attacks.csv by default, with a row
for each: class, attempt, outcome, test. An outcome is `held`, `FAILED`, or `not tried` where the machine lacks what it needs.

With an EXPRESSION, as of pytest's -k, only those tests are run, and all other rows of FILE stay.
"""

from __future__ import annotations

import csv
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).parents[1]
TABLE = ROOT / "docs" / "explanation" / "attacks.csv"
HEADER = ("class", "attempt", "outcome", "test")
CLASSES = {
    "writing": ("common/test_writing.py", "common/test_opened.py", "inputs/test_received.py", "inputs/test_output_file.py"),
    "reading": (
        "studies/folder/test_store.py", "studies/folder/test_reading.py", "studies/folder/test_logs.py", "flight/test_damage.py",
        "inputs/test_input_file.py", "inputs/test_yaml_source.py", "inputs/test_overrides.py",
    ),
    "logs": ("logs/test_mapped.py", "logs/test_dataflash.py", "logs/test_ulog.py"),
    "models": ("cli/test_hostile_models.py", "aircraft/model_files/test_check.py", "aircraft/model_files/test_safe_xml.py",
               "plant/test_first_load.py"),
    "pages": ("reporting/test_text_from_outside.py", "reporting/test_html.py", "common/test_text.py", "cli/test_terminal.py",
              "inputs/test_base.py", "study_reports/test_benchmark.py"),
    "caches": ("common/test_private.py", "common/test_jit_cache.py"),
    "bytes": ("studies/test_mixed.py", "studies/folder/test_begin.py", "api/test_merge.py", "common/test_arithmetic.py"),
    "faults": (
        "studies/flying", "flight/test_full_disk.py", "studies/folder/test_full_disk.py", "cli/test_interrupts.py",
        "cli/test_start_checks.py",
    ),
}  # fmt: skip
"""The tests of each class, in `tests/`."""


def rows(results: ElementTree.Element) -> Iterator[tuple[str, str, str, str]]:
    """A row of the table for each test of a JUnit file."""
    for case in results.iter("testcase"):
        file = case.get("classname", "").removeprefix("tests.").replace(".", "/") + ".py"
        name, _, which = case.get("name", "").partition("[")
        attempt = name.removeprefix("test_").replace("_", " ") + (f": {which[:-1]}" if which else "")
        yield class_of(file), attempt[:200], _outcome(case), f"{file}::{name}"


def class_of(file: str) -> str:
    """The class of the tests in a file."""
    return next(name for name, files in CLASSES.items() if file.startswith(files))


def _outcome(case: ElementTree.Element) -> str:
    if case.find("failure") is not None or case.find("error") is not None:
        return "FAILED"
    return "not tried" if case.find("skipped") is not None else "held"


def _beside(file: Path, found: list[tuple[str, str, str, str]]) -> list[tuple[str, str, str, str]]:
    """These rows, and those of a table that are not of the same attempts, in the order of CLASSES."""
    with file.open(newline="", encoding="utf-8") as stream:
        before = [
            (kind, attempt, outcome, test) for kind, attempt, outcome, test in [*csv.reader(stream)][1:]
        ]
    anew = {(attempt, test) for _, attempt, _, test in found}
    kept = [row for row in before if (row[1], row[3]) not in anew]
    return sorted([*kept, *found], key=lambda row: list(CLASSES).index(row[0]))


def main(file: str | Path = TABLE, expression: str = "") -> int:
    """Run the tests and write the table; returns how many failed."""
    file = Path(file)
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "tests.xml"
        tests = [str(ROOT / "tests" / each) for files in CLASSES.values() for each in files]
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-n",
            "0",
            "-q",
            "-p",
            "no:cacheprovider",
            "-m",
            "nightly or not nightly",
            *(["-k", expression] if expression else []),
        ]
        subprocess.run([*command, f"--junitxml={result}", *tests], cwd=ROOT, check=False)
        found = list(rows(ElementTree.parse(result).getroot()))
    if expression:
        found = _beside(file, found)
    with file.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream, lineterminator="\n").writerows([HEADER, *found])
    for name in CLASSES:
        outcomes = [outcome for kind, _, outcome, _ in found if kind == name]
        print(f"{name}: {', '.join(f'{outcomes.count(each)} {each}' for each in sorted(set(outcomes)))}")
    return sum(outcome == "FAILED" for _, _, outcome, _ in found)


if __name__ == "__main__":
    sys.exit(min(main(*sys.argv[1:]), 1))
