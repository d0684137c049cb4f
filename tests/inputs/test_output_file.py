"""A file to be written is refused before the work, never written over, and whole or absent."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from testbed.inputs.output_file import refuse_unwritable, written
from testbed.inputs.problems import BadInput


def refused(file: Path) -> str:
    with pytest.raises(BadInput) as error:
        refuse_unwritable(file)
    return str(error.value)


def test_nothing_is_written_over(tmp_path: Path) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_text("mine")
    (tmp_path / "link").symlink_to("nothing")
    for file in (mine, tmp_path, tmp_path / "link", Path(os.devnull)):
        assert refused(file) == f"{file}: exists already, expected a file that does not exist yet"
    refuse_unwritable(mine, lambda file: file.read_text() == "mine")
    with pytest.raises(BadInput):
        refuse_unwritable(mine, lambda file: file.read_text() == "ours")
    with pytest.raises(BadInput, match="exists already"):
        refuse_unwritable(Path(os.devnull), lambda _: True)


def test_what_cannot_be_made_is_refused_in_words(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert refused(tmp_path / "file/below").endswith("/file is a file, not a folder")
    assert refused(tmp_path / ("x" * 300)).endswith("cannot be written: File name too long")
    assert "has a NUL character in its name" in refused(tmp_path / "a\0b")
    assert "/proc/x" in refused(Path("/proc/x/y"))


def test_a_path_that_can_be_made_is_left_free(tmp_path: Path) -> None:
    file = tmp_path / "new" / "file"
    refuse_unwritable(file)
    assert list(file.parent.iterdir()) == []
    with written(file) as stream:
        stream.write(b"all")
    assert [(each.name, each.read_text()) for each in file.parent.iterdir()] == [("file", "all")]


def test_a_full_disk_names_the_file_that_was_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "file"
    with pytest.raises(BadInput) as error, written(file) as stream:
        stream.write(b"a part")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "partial")
    assert str(error.value) == f"{file}: cannot be written: No space left on device"
    assert list(tmp_path.iterdir()) == []
