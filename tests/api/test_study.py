"""Each kind of study has what the command line and `testbed.load` ask of it."""

from __future__ import annotations

import inspect
from importlib import import_module
from pathlib import Path

import pytest

import testbed
from testbed.api.load import STUDIES, kind_of
from testbed.api.study import Kind
from testbed.studies.model import Matrix, Search, Study, Sweep

FUNCTIONS = {name for name, _ in inspect.getmembers(Kind, inspect.isfunction) if not name.startswith("_")}


@pytest.mark.parametrize("name", STUDIES)
def test_a_kind_has_every_function_of_the_protocol(name: str) -> None:
    kind = import_module(f"testbed.api.{name}")
    for function in FUNCTIONS:
        asked = set(inspect.signature(getattr(Kind, function)).parameters) - {"self"}
        assert asked <= set(inspect.signature(getattr(kind, function)).parameters), function
    prepared = inspect.signature(kind.prepare).parameters
    assert list(prepared)[:3] == ["file", "out", "settings"]
    assert {"seed", "resume", "controllers"} <= set(prepared)
    assert callable(getattr(testbed, name))


def test_the_protocol_is_not_empty() -> None:
    assert {"fly", "finish", "rebuild", "answer", "met"} == FUNCTIONS


@pytest.mark.parametrize("model", [Sweep, Search, Matrix])
def test_the_folder_of_a_kind_is_known_by_its_file(tmp_path: Path, model: type[Study]) -> None:
    (tmp_path / f"{model.word}.yaml").touch()
    assert kind_of(tmp_path) == model.word in STUDIES
    assert set(model.free) <= set(model.model_fields)
