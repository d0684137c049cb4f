"""Entries: written, flown again in part, and refused in a sentence where they cannot be compared."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from suite_files import flown, tree, written
from sweep_files import run

from testbed.api.benchmark import verify
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput

ROOT = Path(__file__).parents[3]
OWN = ROOT / "examples" / "my_controller.py"
MINE = f"mine={OWN}:MyController"


@pytest.fixture(scope="module")
def entered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a suite and an entry, `entry.yaml`, of two draws."""
    folder = tmp_path_factory.mktemp("entered")
    flown(
        written(folder), folder / "out", draws=2, controllers=["default", MINE], entry=folder / "entry.yaml"
    )
    return folder


@pytest.mark.nightly
def test_what_was_flown_is_confirmed(entered: Path) -> None:
    same, lines = verify(entered / "entry.yaml", entered / "tiny.yaml", controllers=[MINE], draws=1, jobs=1)
    assert same
    assert lines == ["2 of 2 flights are the same to the last bit"]


def test_the_code_to_run_is_said_by_who_checks(entered: Path) -> None:
    with pytest.raises(BadInput, match="its class was not given"):
        verify(entered / "entry.yaml", entered / "tiny.yaml")


def changed(entered: Path, to: Path, old: str, new: str) -> Path:
    text = (entered / "entry.yaml").read_text()
    assert old in text
    to.write_text(text.replace(old, new))
    return to


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("version", 2, "is of tiny 2, and this is tiny 1"),
        ("suite_sha256", "0" * 64, "another content of its suite"),
        ("aircraft_sha256", "0" * 64, "another content of its aircraft"),
        ("law_sha256", "0" * 64, "other code of the shipped controllers"),
        ("environment", {"python": "2.7"}, "was flown with python 2.7, this is 3"),
        ("draws", 3, "has 2 flights of 3"),
        ("controllers", {}, "at least 1"),
    ],
)
def test_an_entry_that_cannot_be_compared_is_refused(
    entered: Path, tmp_path: Path, key: str, value: object, said: str
) -> None:
    said_there = yamlfile.read(entered / "entry.yaml").tree | {key: value}
    file = tmp_path / "entry.yaml"
    file.write_text(yamlfile.dump(said_there))
    with pytest.raises(BadInput, match=said):
        verify(file, entered / "tiny.yaml", controllers=[MINE])


def test_scores_that_are_not_those_of_the_flights_are_refused(entered: Path, tmp_path: Path) -> None:
    said = yamlfile.read(entered / "entry.yaml").tree
    said["controllers"]["mine"]["held"]["estimate"] = 0.75  # of two flights
    (tmp_path / "entry.yaml").write_text(yamlfile.dump(said))
    with pytest.raises(BadInput, match="its flights say"):
        verify(tmp_path / "entry.yaml", entered / "tiny.yaml", controllers=[MINE])


def test_other_code_is_refused(entered: Path, tmp_path: Path) -> None:
    (tmp_path / "my_controller.py").write_text(OWN.read_text() + "# changed\n")
    with pytest.raises(BadInput, match="other code of mine"):
        verify(
            entered / "entry.yaml",
            entered / "tiny.yaml",
            controllers=[f"mine={tmp_path / 'my_controller.py'}:MyController"],
        )


@pytest.mark.nightly
def test_a_flight_that_was_made_up_is_found(entered: Path, tmp_path: Path) -> None:
    """Marks that say of every flight of one's own that it was held."""
    said = yamlfile.read(entered / "entry.yaml").tree
    mine = said["controllers"]["mine"]
    mine["flights"] = " ".join(f"h{mark[1:]}" for mark in mine["flights"].split())
    for key in ("held", "survived"):
        mine[key]["estimate"] = 1.0
    before = yamlfile.read(entered / "entry.yaml").tree["controllers"]["mine"]["flights"]
    assert mine["flights"] != before, "it would be no lie"
    (tmp_path / "entry.yaml").write_text(yamlfile.dump(said))
    same, lines = verify(tmp_path / "entry.yaml", entered / "tiny.yaml", controllers=[MINE], draws=2, jobs=1)
    assert not same
    assert any("mine: did not end as the entry says" in line for line in lines)


def test_a_suite_with_mistakes_is_refused_with_their_lines(tmp_path: Path) -> None:
    suite = tree()
    suite["controllers"]["fixed"] = {"type": "fixed_invrsion"}
    suite["failures"]["types"][0]["type"] = "efectiveness"
    done = run(tmp_path, "benchmark", written(tmp_path, suite))
    assert done.returncode == 2
    assert (
        "controllers.fixed.type: unknown type 'fixed_invrsion', did you mean fixed_inversion?" in done.stderr
    )
    assert "failures.types.0.type: 'efectiveness' is not known, did you mean effectiveness?" in done.stderr
    assert done.stderr.count("tiny.yaml:") == len(done.stderr.splitlines())


def test_an_unknown_suite_or_controller_is_answered(tmp_path: Path) -> None:
    done = run(tmp_path, "benchmark", "opne")
    assert (done.returncode, done.stderr) == (2, "opne: there is no such suite, did you mean open?\n")
    done = run(tmp_path, "benchmark", written(tmp_path), "--controller", "defualt")
    assert done.stderr == "--controller: tiny has no controller 'defualt', did you mean default?\n"


@pytest.mark.nightly
def test_an_entry_is_confirmed_in_another_checkout_and_nothing_else_is(entered: Path, tmp_path: Path) -> None:
    """In a copy of the files of the repository, as a stranger has it, beside which nothing of the author is."""
    shutil.copyfile(ROOT / "pyproject.toml", tmp_path / "pyproject.toml")
    for name in ("aircraft", "benchmarks", "scenarios", "src"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__", "runs"))
    shutil.copytree(entered, tmp_path / "leaderboard" / "mine", ignore=shutil.ignore_patterns("out"))
    mine = tmp_path / "leaderboard" / "mine"
    shutil.copyfile(OWN, mine / OWN.name)

    def verified(suite: Path = mine / "tiny.yaml") -> subprocess.CompletedProcess[str]:
        said = ["--verify", "leaderboard/mine/entry.yaml", "--draws", "2", "--jobs", "1"]
        own = ["--controller", f"mine=leaderboard/mine/{OWN.name}:MyController"]
        line = [sys.executable, "-m", "testbed", "benchmark", str(suite), *said, *own]
        here = {**os.environ, "PYTHONPATH": str(tmp_path / "src")}
        return subprocess.run(line, cwd=tmp_path, env=here, capture_output=True, text=True)

    done = verified()
    assert (done.returncode, done.stdout) == (0, "4 of 4 flights are the same to the last bit\n"), done.stderr
    known, law = (mine / "entry.yaml").read_text(), tmp_path / "src" / "testbed" / "controllers" / "pid.py"
    held = re.search(r"held:\n +estimate: (.*)", known)
    assert held
    for old, new, said in (
        (held[0], held[0].replace(held[1], "0.123"), "is 0.123, and its flights say"),
        ("code_sha256: ", "code_sha256: 0", "other code of mine"),
        ("version: 1\n", "version: 2\n", "is of tiny 2, and this is tiny 1"),
    ):
        (mine / "entry.yaml").write_text(known.replace(old, new, 1))
        done = verified()
        assert (done.returncode, done.stderr.count("\n"), said in done.stderr) == (2, 1, True), done.stderr
    (mine / "entry.yaml").write_text(known)
    law.write_text(law.read_text() + "# changed\n")
    assert "other code of the shipped controllers" in verified().stderr


@pytest.mark.nightly
def test_an_entry_of_another_processor_says_so(entered: Path, tmp_path: Path) -> None:
    said = yamlfile.read(entered / "entry.yaml").tree
    mine = said["controllers"]["mine"]
    mine["flights"] = " ".join(f"{mark[0]}0000000000" for mark in mine["flights"].split())
    for kernel, digits, words in (
        ("Other", "0", "the BLAS kernel: Other, this is"),
        (
            said["arithmetic"]["kernel"],
            said["arithmetic"]["matrices"],
            "though this machine calculates alike",
        ),
    ):
        said["arithmetic"] |= {"kernel": kernel, "matrices": digits}
        (tmp_path / "entry.yaml").write_text(yamlfile.dump(said))
        same, lines = verify(
            tmp_path / "entry.yaml", entered / "tiny.yaml", controllers=[MINE], draws=1, jobs=1
        )
        assert same and "1 ended the same with other digits" in lines[1] and words in lines[1]
