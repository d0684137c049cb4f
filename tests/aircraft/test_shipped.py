"""Aircraft and scenarios that come with the testbed are found by name from any folder; a mistyped name is answered."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from testbed.aircraft.shipped import (
    aircraft_names,
    data_root,
    files_in,
    find_aircraft,
    find_scenario,
    is_folder_name,
    shipped_files,
)
from testbed.inputs.problems import BadInput


def test_there_are_shipped_things() -> None:
    assert "vtail" in aircraft_names()
    assert {p.stem for p in files_in("scenarios")} >= {
        "left_tail_fail", "right_tail_fail", "left_propeller_fail", "right_propeller_fail"
    }  # fmt: skip


def test_an_aircraft_by_name_and_by_folder(vtail_copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert find_aircraft("vtail") == data_root() / "aircraft/vtail/vtail.yaml"
    assert find_aircraft(str(vtail_copy)) == vtail_copy / "vtail.yaml"
    monkeypatch.chdir(vtail_copy.parent)
    assert find_aircraft("./vtail") == vtail_copy / "vtail.yaml"
    assert find_aircraft("vtail") != vtail_copy / "vtail.yaml", "a name alone is a shipped aircraft"


@pytest.mark.parametrize(("name", "folder"), [("vtail", False), ("a/b", True), (".", True), ("..", True)])
def test_what_is_a_folder(name: str, folder: bool) -> None:
    assert is_folder_name(name) == folder


def test_an_unknown_aircraft(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(BadInput, match=r"no aircraft 'vtial', expected .*vtail.*, did you mean vtail\?"):
        find_aircraft("vtial")
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "heavy" / "heavy.yaml"
    file.parent.mkdir()
    file.write_text("")
    (tmp_path / "empty").mkdir()
    (tmp_path / "copied").mkdir()
    for name in ("vtail.yaml", "vtail.xml", "shape.yaml"):
        (tmp_path / "copied" / name).touch()
    assert find_aircraft("./heavy") == file
    for name, problem in {
        "./hevy": r"there is no folder './hevy', .* did you mean \./heavy\?",
        "./empty": r"'./empty' has no empty\.yaml",
        "./copied": r"has no copied\.yaml, expected vtail\.yaml renamed to copied\.yaml",
        "./heavy/heavy.yaml": r"is a file, expected an aircraft's folder, did you mean \./heavy\?",
        "/": "'/' has no ",
        "./": r"\./' has no .*",
        "heavy": r"no aircraft 'heavy', .* did you mean \./heavy\?",
    }.items():
        with pytest.raises(BadInput, match=problem):
            find_aircraft(name)


def test_a_scenario_from_any_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The file of that path comes first, then the shipped one."""
    monkeypatch.chdir(tmp_path)
    name = os.path.join("scenarios", "left_tail_fail.yaml")
    assert find_scenario(name) == data_root() / name
    own = tmp_path / name
    own.parent.mkdir()
    own.write_text("")
    assert find_scenario(name).resolve() == own


def test_a_shipped_scenario_sweep_or_search_by_its_name_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file of that name in the folder comes first. No two shipped files share a name."""
    monkeypatch.chdir(tmp_path)
    names = [file.name for file in shipped_files()]
    assert len(set(names)) == len(names)
    assert [find_scenario(name) for name in names] == shipped_files()
    (tmp_path / "left_tail_fail.yaml").write_text("")
    assert find_scenario("left_tail_fail.yaml") == Path("left_tail_fail.yaml")


def test_an_unknown_scenario(tmp_path: Path) -> None:
    with pytest.raises(
        BadInput, match=r"left_tial_fail\.yaml: there is no such file, did you mean scenarios/left_tail"
    ):
        find_scenario("scenarios/left_tial_fail.yaml")
    (tmp_path / "climb.yaml").write_text("")
    with pytest.raises(BadInput, match=r"did you mean .*climb\.yaml"):
        find_scenario(tmp_path / "clibm.yaml")
    for typo, meant in (
        ("left_tail_monte_calro", "sweeps/left_tail_monte"),
        ("smallest_gsut", "searches/smallest"),
    ):
        with pytest.raises(BadInput, match=rf"did you mean scenarios/{meant}"):
            find_scenario(typo)


def test_a_model_of_jsbsim_is_not_shipped_but_can_be_adopted() -> None:
    with pytest.raises(
        BadInput, match=r"no aircraft 'c172p', .* expected \./c172p, after `testbed adopt c172p`"
    ):
        find_aircraft("c172p")


@pytest.mark.parametrize("name", ["x" * 300, "./" + "x" * 300, "x/" * 3000])
def test_a_name_longer_than_any_file_can_have(name: str) -> None:
    with pytest.raises(BadInput, match=r"no aircraft|there is no folder"):
        find_aircraft(name)
