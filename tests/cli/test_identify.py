"""`testbed identify`: the stored design model is the one that is identified."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from command_line import Called, in_this_process

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL


@pytest.mark.nightly
def test_identify_writes_what_it_then_agrees_with(tmp_path: Path) -> None:
    """On a copy of the v-tail: written anew it is the stored one; a changed number is noticed, and mended."""
    folder = shutil.copytree(load_aircraft("vtail").folder, tmp_path / "aircraft" / "vtail")
    model = folder / DESIGN_MODEL
    name = str(folder)
    assert in_this_process(tmp_path, "identify", name, "--check").returncode == 0
    text = model.read_text()
    model.write_text(text.replace('"altitude_m": 300', '"altitude_m": 301'))
    assert model.read_text() != text
    differs = in_this_process(tmp_path, "identify", name, "--check")
    assert differs.returncode == 1
    assert differs.stdout.endswith(f"\n{model}: differs from what is identified now\n")
    assert in_this_process(tmp_path, "identify", name).stdout.endswith(f"\nwrote {model}\n")
    assert in_this_process(tmp_path, "identify", name, "--check").returncode == 0
    model.write_text("{}")
    damaged = in_this_process(tmp_path, "identify", name, "--check")
    assert damaged.returncode == 2
    assert damaged.stderr.startswith(f"{model}: is no design model: ")
    assert in_this_process(tmp_path, "identify", "vtial").returncode == 2


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["", "--out", "new"], "no model is given, expected a model of the jsbsim package"),
        (
            ["c172"],
            "no model 'c172', expected a model of the jsbsim package or the folder of a model, did you mean c172",
        ),
        (["c172p", "--out", "file"], "file: exists already, expected --out with a new folder"),
        (["c172p", "--out", "file/below"], "file/below: cannot be written: file is a file, not a folder"),
        (["c172p", "--out", "x" * 300], "x: cannot be written: File name too long"),
        (["c172p", "--out", "a\x1b[31mb"], "has control characters in its name"),
    ],
)
def test_what_cannot_be_adopted_is_refused_at_once(
    here: Path, called: Called, arguments: list[str], words: str
) -> None:
    (here / "file").touch()
    status, out, err = called("adopt", *arguments)
    assert (status, out) == (2, "") and words in err, err
    assert [path.name for path in here.iterdir()] == ["file"]


@pytest.mark.parametrize("command", [["identify", "vtail", "--log"], ["diagnose"]])
def test_a_log_that_is_not_there_is_said_to_be_missing(
    here: Path, called: Called, command: list[str]
) -> None:
    (here / "turns").mkdir()
    status, out, err = called(*command, "turms")
    assert (status, out) == (2, "") and err == "turms: there is no such file or folder, did you mean turns?\n"


def adjusted(tmp_path: Path, number: str, other: str) -> Path:
    """An aircraft of which the YAML says another number than the model."""
    folder = Path(shutil.copytree(load_aircraft("vtail").folder, tmp_path / "vtail"))
    description = folder / "vtail.yaml"
    text = description.read_text()
    assert text.count(number) >= 1
    description.write_text(text.replace(number, other, 1))
    return folder


@pytest.mark.parametrize(
    ("number", "other", "was", "now"),
    [
        ("lag_rad_s: 30", "lag_rad_s: 20", 'value="30', 'value="20'),
        ("rate_limit: 401.07", "rate_limit: 300", 'value="7', 'value="5.23598776'),
    ],
)
def test_write_changes_one_number_of_the_model(
    tmp_path: Path, number: str, other: str, was: str, now: str
) -> None:
    folder = adjusted(tmp_path, number, other)
    before = (folder / "vtail.xml").read_text().splitlines()
    done = in_this_process(tmp_path, "identify", str(folder), "--write")
    assert done.returncode == 0, done.stderr
    after = (folder / "vtail.xml").read_text().splitlines()
    (changed,) = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert was in changed[0] and now in changed[1]
    assert in_this_process(tmp_path, "identify", str(folder), "--check").returncode == 0


def test_write_leaves_a_file_outside_the_folder(tmp_path: Path) -> None:
    folder = adjusted(tmp_path, "lag_rad_s: 30", "lag_rad_s: 20")
    outside = tmp_path / "outside.xml"
    (folder / "vtail.xml").rename(outside)
    before = outside.read_bytes()
    (folder / "vtail.xml").symlink_to(outside)
    assert in_this_process(tmp_path, "identify", str(folder), "--write").returncode == 2
    assert outside.read_bytes() == before
