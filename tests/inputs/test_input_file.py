"""What is read: regular files of a limited size; all else is refused in words, at once."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from testbed.inputs.input_file import read_bytes, read_text
from testbed.inputs.problems import BadInput


def refusal(path: str | Path, most: int = 100) -> str:
    with pytest.raises(BadInput) as caught:
        read_bytes(path, most, "a YAML file")
    (problem,) = caught.value.problems
    return f"{problem.what}, {problem.expected}"


def test_a_file_of_the_largest_size_is_read(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(b"x" * 100)
    assert read_bytes(file, 100, "") == b"x" * 100
    file.write_bytes(b"x" * 101)
    assert refusal(file) == "has more than 0.0001 MB, a YAML file of at most 0.0001 MB"


def test_what_is_no_regular_file_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("/dev/zero")
    for path in (tmp_path / "pipe", tmp_path / "link", "/dev/zero", "/dev/null"):
        assert refusal(path) == "is a device or a pipe, a YAML file"
    assert refusal(tmp_path) == "is a folder, a YAML file"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("none", "there is no such file, "),
        ("x" * 300, "cannot be read: File name too long, "),
        ("x/" * 2100, "cannot be read: File name too long, "),
        ("a\0b", "has a NUL character in its name, a YAML file"),
    ],
)
def test_names_that_no_file_can_have(name: str, words: str) -> None:
    assert refusal(name) == words


def test_text_is_utf_8_with_any_ends_of_lines(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_bytes(b"\xef\xbb\xbfa\r\nb\rc\n")
    assert read_text(file) == "a\nb\nc\n"
    file.write_bytes(b"\xff")
    with pytest.raises(BadInput, match="is not UTF-8 text, expected a YAML file"):
        read_text(file)
