"""The package as it is imported: ten names, quickly, each from its own module when it is first used."""

from __future__ import annotations

import json
import re
import subprocess
import sys

import pytest
from command_line import ROOT

import testbed

PROJECT = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
HEAVY = ("numpy", "pandas", "matplotlib", "numba", "scipy", "jsbsim", "pyarrow", "yaml", "pydantic")


def run(program: str) -> str:
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout


def test_its_names_are_shown_and_there() -> None:
    raised = ["BadInput", "Stopped"]
    called = [
        "adopt",
        "benchmark",
        "compare",
        "design",
        "diagnose",
        "failure_probability",
        "fly",
        "linearise",
        "load",
        "matrix",
        "merge",
        "search",
        "sweep",
        "use",
    ]
    assert dir(testbed) == ["BadInput", "Session", "Stopped", "__version__", *called]
    assert all(callable(getattr(testbed, name)) for name in called)
    assert all(issubclass(getattr(testbed, name), Exception) for name in raised)
    assert testbed.__version__ and testbed.__version__[0].isdigit()
    with pytest.raises(AttributeError, match="has no attribute 'land'"):
        testbed.land  # noqa: B018


def test_importing_it_imports_nothing_heavy() -> None:
    program = f"import sys, testbed; dir(testbed); print(sorted(set({HEAVY}) & set(sys.modules)))"
    assert run(program) == "[]\n"


def test_reading_needs_no_simulator() -> None:
    simulator = ("numba", "jsbsim", "testbed.simulation", "testbed.plant.jsbsim")
    program = f"import sys, testbed; testbed.load; print(sorted(set({simulator}) & set(sys.modules)))"
    assert run(program) == "[]\n"


def test_its_version_is_said_twice_and_alike() -> None:
    version = re.search(r'^version = "(.+)"$', PROJECT, flags=re.MULTILINE)
    assert version and f"\nversion: {version[1]}\n" in (ROOT / "CITATION.cff").read_text()


def test_every_python_that_it_names_is_locked_and_tested() -> None:
    named = re.findall(r"Python :: (3\.\d+)", PROJECT)
    workflow = (ROOT / ".github" / "workflows" / "ci.yml").read_text()
    assert named and f"python: {json.dumps(named)}" in workflow
    locked = {f"py{version.replace('.', '')}" for version in named}
    assert {file.stem for file in (ROOT / "locks").glob("*.txt")} == locked
    assert set(json.loads((ROOT / "locks" / "digests.json").read_text())) == locked
    assert f'requires-python = ">={named[0]}"' in PROJECT
