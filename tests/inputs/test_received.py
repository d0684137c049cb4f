"""Folders of others: their links are refused in words, and nothing outside of them changes."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from figure_flights import broken
from sweep_files import fly_here, written

import testbed
from testbed.cli.commands import main
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.inputs.received import read_json, refuse_links
from testbed.studies.load import load_sweep


@pytest.fixture
def victim(tmp_path: Path) -> Path:
    folder = tmp_path / "victim"
    folder.mkdir()
    (folder / "file").write_text("mine")
    return folder


def test_folders_without_end_are_refused(tmp_path: Path) -> None:
    """A path of thousands of folders is longer than a system opens."""
    handle = os.open(tmp_path, os.O_RDONLY)
    for _ in range(300):
        os.mkdir("a" * 100, dir_fd=handle)
        handle, above = os.open("a" * 100, os.O_RDONLY, dir_fd=handle), handle
        os.close(above)
    os.close(handle)
    with pytest.raises(BadInput, match="is nested too deeply"):
        refuse_links(tmp_path)


def said(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, str]:
    status = main(list(map(str, arguments)))
    return status, capsys.readouterr().err


@pytest.mark.parametrize(
    "name", ["report.html", "figures", ".report.html.partial", "summary.json", "log.csv", "deep/inside"]
)
def test_a_run_folder_with_a_link_is_refused(
    name: str, victim: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_run_folder(broken(), tmp_path / "run")
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).unlink(missing_ok=True)
    (folder / name).symlink_to(victim / "file" if name != "figures" else victim)
    status, err = said(capsys, "report", folder)
    expected = "is a link, expected files and folders alone in a folder that is read back"
    if name == "log.csv":
        expected = f"{folder / name}: {expected}"
    assert (status, expected in err) == (2, True), err
    assert os.listdir(victim) == ["file"] and (victim / "file").read_text() == "mine"
    with pytest.raises(BadInput, match="is a link"):
        testbed.load(folder)


def test_a_hard_link_loses_its_other_name(victim: Path, tmp_path: Path) -> None:
    folder = write_run_folder(broken(), tmp_path / "run")
    (folder / "report.html").hardlink_to(victim / "file")
    main(["report", str(folder)])
    assert (victim / "file").read_text() == "mine" and (folder / "report.html").stat().st_nlink == 1


@pytest.mark.parametrize("name", ["results.csv", "logs", "flights", ".summary.json.partial", "cases.csv"])
def test_a_sweep_folder_with_a_link_is_refused(
    name: str, victim: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sweep = written(tmp_path)
    folder = fly_here(load_sweep(sweep, ["runs=1"]), tmp_path / "out")
    (folder / name).unlink(missing_ok=True)
    (folder / name).symlink_to(victim)
    for arguments in (["report", folder], ["sweep", sweep, "--runs", 2, "--out", folder, "--resume"]):
        status, err = said(capsys, *arguments)
        assert status == 2 and f"{folder / name}: is a link" in err
    assert os.listdir(victim) == ["file"]


def test_pipes_and_sockets_are_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "log.csv")
    with pytest.raises(BadInput, match="is a device or a pipe"):
        refuse_links(tmp_path)


WRONG: dict[str, tuple[Callable[[], bytes], str]] = {
    "no JSON": (lambda: b"{", "cannot be read"),
    "a key twice": (lambda: b'{"a": 1, "a": 2}', "a key stands twice"),
    "too deep": (lambda: b"[" * 100_000 + b"]" * 100_000, "is nested too deeply"),
    "a lone surrogate": (lambda: rb'{"a": "\ud800"}', "surrogates not allowed"),
    "a number of many digits": (lambda: b"1" * 10_000, "cannot be read"),
    "too large": (lambda: b" " * 20_000_001, "has more than 20 MB"),
    "no text": (lambda: b"\xff", "is not UTF-8 text"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_json_that_we_do_not_write_is_refused_in_words(wrong: str, tmp_path: Path) -> None:
    file = tmp_path / "summary.json"
    make, words = WRONG[wrong]
    file.write_bytes(make())
    with pytest.raises(BadInput, match=words) as caught:
        read_json(file, "a summary")
    assert str(file) in str(caught.value)
