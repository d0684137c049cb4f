"""Schemas accept every shipped file and refuse what the program refuses; stored ones are those of the code."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml
from command_line import ROOT, Called
from jsonschema import Draft202012Validator

from testbed.aircraft.shipped import aircraft_names, files_in
from testbed.cli.init import TEMPLATES
from testbed.cli.schema import TABLE, model_of, schema_of

FILES = {
    "aircraft": [ROOT / "aircraft" / name / f"{name}.yaml" for name in aircraft_names()],
    "matrix": [*files_in("scenarios/matrices")],
    "scenario": [*files_in("scenarios"), TEMPLATES / "scenario.yaml"],
    "search": [*files_in("scenarios/searches")],
    "suite": [*files_in("scenarios/suites")],
    "sweep": [*files_in("scenarios/sweeps"), TEMPLATES / "sweep.yaml"],
}
MINIMAL = {"name": "a", "aircraft": "vtail", "duration_s": 10}


@cache
def validator(kind: str) -> Draft202012Validator:
    return Draft202012Validator(schema_of(model_of(kind)))


def errors(kind: str, tree: Any) -> list[str]:
    return [error.message for error in validator(kind).iter_errors(tree)]


@pytest.mark.parametrize("kind", TABLE)
def test_shipped_files_are_accepted_and_name_their_schema(kind: str) -> None:
    assert FILES[kind]
    for file in FILES[kind]:
        text = file.read_text(encoding="utf-8")
        assert errors(kind, yaml.safe_load(text)) == [], file
        words, _, schema = text.splitlines()[0].partition("$schema=")
        assert words == "# yaml-language-server: ", file
        if file.parent != TEMPLATES:  # `init` writes the schemas beside those
            stored = (file.parent / schema).resolve()  # in the checkout, or beside the installed files
            assert stored.read_bytes() == (ROOT / "schemas" / f"{kind}.json").read_bytes()


@pytest.mark.parametrize("kind", TABLE)
def test_the_stored_schema_is_that_of_the_code(kind: str, called: Called) -> None:
    status, out, _ = called("schema", kind)
    stored = (ROOT / "schemas" / f"{kind}.json").read_text(encoding="utf-8")
    assert status == 0
    assert out == stored, f"testbed schema {kind} --out schemas/{kind}.json"


@pytest.mark.parametrize(
    "change",
    [
        {"durations": 3},
        {"rate_hz": 1.5},
        {"aircraft": {"mass_kg": 5}},
        {"aircraft": {"name": "vtail", "mass_kg": -5}},
        {"failures": [{"type": "effectivness", "actuator": "left_propeller", "at_s": 1}]},
        {"controller": {"type": "pid", "gamma": 2}},
    ],
)
def test_mistakes_are_refused(change: dict[str, Any]) -> None:
    assert errors("scenario", MINIMAL) == []
    assert errors("scenario", {**MINIMAL, **change})


def test_what_is_written_short_is_accepted() -> None:
    assert errors("scenario", {**MINIMAL, "sensors": "mems"}) == []
    assert errors("scenario", {**MINIMAL, "sensors": "memes"})
    short = {"type": "adaptive_inversion", "released": "auto", "gamma": 2.0}
    assert errors("scenario", {**MINIMAL, "controller": short}) == []
    assert (
        errors("scenario", {**MINIMAL, "aircraft": {"name": "./mine", "coefficients": {"Cm_q": 0.9}}}) == []
    )
    assert errors("scenario", {**MINIMAL, "initial": {"altitude_m": 300}}) == []
    assert errors("sweep", {"scenario": "a.yaml", "vary": {"x": {"norm": {"loc": 0, "scale": 1}}}}) == []
    assert errors("sweep", {"scenario": "a.yaml", "vary": {"x": 3}})


def test_keys_have_their_meanings() -> None:
    schema = json.dumps(schema_of(model_of("scenario")))
    assert "Control steps per second." in schema
    assert "Mass with everything on board [kg]." in schema


def test_a_schema_is_written_into_a_file(called: Called, tmp_path: Path) -> None:
    file = tmp_path / "new" / "scenario.json"
    status, out, _ = called("schema", "scenario", "--out", str(file))
    assert (status, out) == (0, f"wrote {file}\n")
    assert json.loads(file.read_text(encoding="utf-8"))["title"] == "Scenario"
