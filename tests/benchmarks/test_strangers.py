"""The suite of aircraft that the law was not made on: it loads, and shares no aircraft with `open`."""

from __future__ import annotations

from pathlib import Path

import pytest
import strangers
import yaml

from testbed.studies.benchmark.load import load_suite


def test_it_is_a_suite_of_other_aircraft(tmp_path: Path) -> None:
    file = tmp_path / "strangers.yaml"
    file.write_text(yaml.safe_dump(strangers.suite(), sort_keys=False))
    suite, _ = load_suite(file)
    known, _ = load_suite(strangers.ROOT / "scenarios" / "suites" / "open.yaml")
    assert suite.aircraft and not set(suite.aircraft) & set(known.aircraft)
    assert tuple(suite.controllers) == strangers.CONTROLLERS


@pytest.mark.parametrize(
    ("folder", "asked", "said"),
    [
        ("new", ["--word", "w", "--draws", "0"], "--draws: is 0, expected at least 1"),
        ("new", ["--word", ""], "--word: is empty, expected a public word"),
        ("file", ["--word", "w"], "file is a file, not a folder"),
        ("file/sub", ["--word", "w"], "file is a file, not a folder"),
    ],
)
def test_what_cannot_be_flown_is_refused_and_nothing_is_written(
    folder: str, asked: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    known = strangers.suite()
    one = dict(list(known["aircraft"].items())[:1])
    monkeypatch.setattr(strangers, "suite", lambda: known | {"aircraft": one})  # each is adopted
    (tmp_path / "file").touch()
    with pytest.raises(SystemExit) as ended:
        strangers.main([str(tmp_path / folder), *asked])
    assert ended.value.code == 2 and capsys.readouterr().err.strip().endswith(said)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
