"""Files are replaced whole or not at all; names become file names."""

from __future__ import annotations

from pathlib import Path

import pytest

from testbed.common.files import replacing, slug


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("Left tail, failure!", "left-tail-failure"),
        ("a/../b", "a-b"),
        ("--x--", "x"),
        ("5 m", "5-m"),
        ("äö", "other"),
    ],
)
def test_slug(name: str, expected: str) -> None:
    assert slug(name, otherwise="other") == expected


def test_a_file_is_replaced_when_all_is_written(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    file.write_text("old")
    with replacing(file) as partial:
        partial.write_text("new")
        assert file.read_text() == "old", "a reader meanwhile sees the old contents"
    assert file.read_text() == "new"
    assert list(tmp_path.iterdir()) == [file]


def test_after_an_error_the_old_file_is_there(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    file.write_text("old")
    with pytest.raises(RuntimeError), replacing(file) as partial:
        partial.write_text("ne")
        raise RuntimeError
    assert file.read_text() == "old"
    assert list(tmp_path.iterdir()) == [file]
