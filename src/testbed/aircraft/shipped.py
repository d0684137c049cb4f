"""Aircraft and scenarios that come with the testbed, found from any folder.

Paths are tested by `os.path`, because pathlib raises OSError for a name that is too long.
"""

from __future__ import annotations

import importlib.util
import os
from pathlib import Path

from testbed.inputs.problems import BadInput, Problem, did_you_mean, guess, one_of

_FOLDER = "a folder with a YAML file of its name, beside the scenario or else in the present folder"


def data_root() -> Path:
    """The folder of `aircraft/` and `scenarios/`: inside an installed package, else the repository's root."""
    package = Path(__file__).resolve().parents[1]
    return package / "data" if (package / "data").is_dir() else package.parents[1]


def aircraft_names() -> list[str]:
    """Names of the aircraft that come with the testbed."""
    return sorted(
        p.parent.name for p in (data_root() / "aircraft").glob("*/*.yaml") if p.stem == p.parent.name
    )


def is_folder_name(name: str) -> bool:
    """Whether a scenario's `aircraft` is a path to a folder, not one of `aircraft_names()`."""
    return "/" in name or "\\" in name or name in (".", "..")


def find_aircraft(name: str) -> Path:
    """The YAML of an aircraft given by name or by folder; raises BadInput when there is none."""
    folder = Path(os.path.realpath(name)) if is_folder_name(name) else data_root() / "aircraft" / name
    file = folder / f"{folder.name}.yaml"
    if os.path.exists(file):
        return file
    names = aircraft_names()
    if is_folder_name(name):
        raise BadInput([_no_folder(name, folder)])
    close = f"./{name}" if _is_aircraft(Path(name)) else did_you_mean(name, names)
    if not close and _is_jsbsim_model(name):
        how = f"./{name}, after `testbed adopt {name}`"
        raise BadInput([Problem(f"no aircraft {name!r}, but JSBSim has a model of this name", expected=how)])
    expected = f"{one_of(names)} or a folder as ./{name}"
    raise BadInput([Problem(f"no aircraft {name!r}", expected=expected, suggestion=close)])


def _is_jsbsim_model(name: str) -> bool:
    """Whether the jsbsim package has a model of this name, which can be adopted."""
    found = importlib.util.find_spec("jsbsim")
    if found is None:
        return False
    return os.path.isfile(Path(str(found.origin)).parent / "aircraft" / name / f"{name}.xml")


def _is_aircraft(folder: Path) -> bool:
    return os.path.isfile(folder / f"{folder.name}.yaml")


def _folder_name(folder: Path) -> str:
    """A folder as `find_aircraft` takes it: with a slash in it, so that it is no name of a shipped aircraft."""
    return str(folder) if is_folder_name(str(folder)) else f"./{folder}"


def _no_folder(name: str, folder: Path) -> Problem:
    """What is wrong with a path that leads to no aircraft's folder."""
    if os.path.isfile(folder):
        beside = _folder_name(Path(name).parent) if _is_aircraft(folder.parent) else ""
        return Problem(f"{name!r} is a file", expected="an aircraft's folder", suggestion=beside)
    above = Path(name).parent if Path(name).name not in ("", "..") else Path(name) / ".."  # `.` has no name
    near = [
        _folder_name(above / each) for each in _names_in(folder.parent) if _is_aircraft(folder.parent / each)
    ]
    what = f"{name!r} has no {folder.name}.yaml" if os.path.isdir(folder) else f"there is no folder {name!r}"
    inside = _names_in(folder)
    if own := [file for file in inside if file.endswith(".yaml") and f"{file[:-5]}.xml" in inside]:
        return Problem(what, expected=f"{min(own)} renamed to {folder.name}.yaml")
    return Problem(what, expected=_FOLDER, suggestion=did_you_mean(name, near))


def _names_in(folder: Path) -> list[str]:
    """Names of what is in a folder; none if it cannot be read."""
    try:
        return os.listdir(folder)
    except OSError:
        return []


def find_scenario(path: str | Path) -> Path:
    """A scenario, sweep or search by its path, else the shipped file with that path or name; raises BadInput when there is none."""
    for candidate in (Path(path), data_root() / path):
        if os.path.exists(candidate):
            return candidate
    for file in shipped_files():
        if file.name == str(path):
            return file
    shipped = {file.stem: str(file.relative_to(data_root())) for file in shipped_files()}
    folder = Path(path).parent
    beside = {Path(name).stem: str(folder / name) for name in _names_in(folder) if name.endswith(".yaml")}
    known = shipped | beside
    close = known.get(did_you_mean(Path(path).stem, known), "")
    raise BadInput([Problem("there is no such file", str(path), suggestion=close)])


def find_suite(name: str | Path) -> Path:
    """A benchmark's suite by its path, or a shipped one by its name; raises BadInput when there is none."""
    if os.path.exists(name):
        return Path(name)
    shipped = {file.stem: file for file in files_in("scenarios/suites")}
    if str(name) in shipped:
        return shipped[str(name)]
    raise BadInput([Problem("there is no such suite", str(name), None, "", *guess(name, shipped))])


def shipped_files() -> list[Path]:
    """Scenario files, and those of studies, that come with the testbed."""
    return [
        file
        for folder in ("scenarios", "scenarios/sweeps", "scenarios/searches", "scenarios/matrices")
        for file in files_in(folder)
    ]


def files_in(folder: str) -> list[Path]:
    """YAML files in a folder that comes with the testbed, such as `scenarios`."""
    return sorted((data_root() / folder).glob("*.yaml"))
