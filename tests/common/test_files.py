"""Files are replaced whole or not at all; names become file names."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from testbed.common.files import cache_home, plain, replacing, slug


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


def test_numpy_and_tuples_become_pythons_own_types() -> None:
    value = {
        "numbers": (np.float64(0.1), np.int32(2), np.bool_(True)),
        "array": np.arange(3.0),
        7: "text",
    }
    found = plain(value)
    assert found == {"numbers": [0.1, 2, True], "array": [0.0, 1.0, 2.0], "7": "text"}
    assert [type(item) for item in found["numbers"]] == [float, int, bool]


def test_what_is_not_finite_is_none_at_any_depth() -> None:
    value = {"a": math.nan, "b": [math.inf, {"c": np.float64(-math.inf)}], "d": np.array([1.0, math.nan])}
    found = plain(value)
    assert found == {"a": None, "b": [None, {"c": None}], "d": [1.0, None]}
    json.dumps(found, allow_nan=False)


@pytest.mark.parametrize(
    ("chosen", "home", "expected"),
    [
        ("/caches", "/home/me", "/caches"),
        ("", "/home/me", "/home/me/.cache"),
        (None, "/home/me", "/home/me/.cache"),
        ("caches", "/home/me", "/home/me/.cache"),
        ("caches", "", None),
        (None, "me", None),
    ],
)
def test_caches_are_neither_in_the_working_folder_nor_in_the_root_folder(
    chosen: str | None, home: str, expected: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    if chosen is not None:
        monkeypatch.setenv("XDG_CACHE_HOME", chosen)
    monkeypatch.setenv("HOME", home)
    assert cache_home() == (None if expected is None else Path(expected))
