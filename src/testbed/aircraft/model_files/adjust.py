"""Write numbers of an aircraft's YAML into its JSBSim model, where the two differ; every other byte stays."""

from __future__ import annotations

import re
from collections.abc import Iterator

from testbed.aircraft.description import Aircraft
from testbed.aircraft.model_files.agreement import Difference, differences
from testbed.aircraft.model_files.check import model_files
from testbed.aircraft.model_files.safe_xml import read_bytes
from testbed.common.writing import write
from testbed.inputs.problems import BadInput

_ENCODING = "latin-1"
"""Gives each byte of any file back as it was; what is looked for is ASCII."""


def adjust(aircraft: Aircraft) -> Iterator[str]:
    """Change the model's files; yields for each number what was changed, in words.

    Raises BadInput for files that cannot be read or are outside the aircraft's folder, or a number that is not found as it
    stands, and OSError.
    """
    files = model_files(aircraft)
    if files.problems:
        raise BadInput(files.problems)
    written = set()  # two engines may share a file
    for each in differences(aircraft, files):
        if each.element not in written:
            written.add(each.element)
            file, line = each.element.file, each.element.line
            if not file.is_relative_to(aircraft.folder):
                raise BadInput(
                    [each.element.problem("is not in the aircraft's folder", f"{each.wanted:.9g}, by hand")]
                )
            text = _changed(read_bytes(file).decode(_ENCODING), each)
            write(file, text.encode(_ENCODING), within=aircraft.folder)
            yield f"{file}:{line}: {each.name} {each.said:g} -> {each.wanted:g}"


def _changed(text: str, each: Difference) -> str:
    """The text of a model's file with another number in an element."""
    begin = sum(map(len, text.splitlines(keepends=True)[: each.element.line - 1]))
    found = _pattern(each).match(text, text.find(f"<{each.element.tag}", begin))
    if found is None:
        raise BadInput(
            [each.element.problem("cannot be changed as it stands", f"{each.wanted:.9g}, by hand")]
        )
    return f"{text[: found.start(1)]}{each.wanted:.9g}{text[found.end(1) :]}"


def _pattern(each: Difference) -> re.Pattern[str]:
    """What matches the element, with its number as the first group."""
    if each.element.tag == "property":
        return re.compile(
            rf"<property\s[^>]*?\bvalue\s*=\s*[\"']([^\"']*)[\"'][^>]*>\s*{re.escape(each.name)}\s*<"
        )
    return re.compile(rf"<{each.element.tag}[^>]*>\s*([^<\s]+)\s*</")
