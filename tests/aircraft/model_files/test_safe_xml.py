"""XML of unknown origin is read without entities, and within limits."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from testbed.aircraft.model_files.safe_xml import MAX_BYTES, MAX_DEPTH, MAX_ELEMENTS, read_bytes, read_xml
from testbed.inputs.problems import BadInput


def test_elements_have_their_text_attributes_and_lines(tmp_path: Path) -> None:
    file = tmp_path / "a.xml"
    file.write_text("<a>\n<!-- c --><b u='1'> x\n y </b>\n<b/></a>")
    root = read_xml(file)
    first, second = root.all("b")
    assert (first.text, first.attributes, first.line, first.path) == ("x\n y", {"u": "1"}, 2, "a/b")
    assert (second.line, root.first("b"), root.first("c")) == (4, first, None)
    assert [e.tag for e in root.walk()] == ["a", "b", "b"]
    assert str(first.problem("is x", "1")) == f"{file}:2: a/b: is x, expected 1"


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("", 1, "no element found"),
        ("<a>\n<b></a>", 2, "mismatched tag"),
        ("<a>\n&b;</a>", 2, "undefined entity"),
        ("\n<!DOCTYPE a><a/>", 2, "document type declaration"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>", 1, "document type declaration"),
        ("<!DOCTYPE a SYSTEM '/etc/passwd'><a/>", 1, "document type declaration"),
        ("<?xml version='1.0' encoding='nonsense'?><a/>", 1, "is not XML"),
        ("<a>" * (MAX_DEPTH + 1), 1, f"at most {MAX_DEPTH} elements inside each other"),
        ("<a>" + "<b/>" * MAX_ELEMENTS + "</a>", 1, f"at most {MAX_ELEMENTS}"),
        ("<a>\n<b>", 2, "the file ends too early"),
        ("<a>\n<b c='", 2, "the file ends too early"),
    ],
)
def test_what_is_not_plain_elements_is_refused_with_its_line(
    tmp_path: Path, text: str, line: int, words: str
) -> None:
    file = tmp_path / "a.xml"
    file.write_text(text)
    with pytest.raises(BadInput, match=words) as caught:
        read_xml(file)
    (problem,) = caught.value.problems
    assert (problem.file, problem.line) == (str(file), line)


def test_only_regular_files_of_some_size_are_read(tmp_path: Path) -> None:
    pipe, large = tmp_path / "pipe", tmp_path / "large"
    os.mkfifo(pipe)
    with large.open("wb") as stream:
        stream.truncate(MAX_BYTES + 1)
    for file, words in ((pipe, "no regular file"), (large, "at most 8 MB"), (tmp_path, "no regular file"),
                        (tmp_path / "none", "cannot be read: No such file")):  # fmt: skip
        with pytest.raises(BadInput, match=words):
            read_bytes(file)
