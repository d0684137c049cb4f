"""Read a suite's file, and the controllers that are to fly it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from testbed.aircraft.shipped import find_suite
from testbed.controllers.user.own import OwnController, own_controllers
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.validation import validated
from testbed.studies.benchmark.model import Suite
from testbed.studies.drawing.builder import TYPE, Variant


def load_suite(file: str | Path) -> Suite:
    """The suite in a file, or a shipped one by its name; raises BadInput with every problem of its keys."""
    return validated(Suite, yamlfile.read(find_suite(file)))


def chosen(
    suite: Suite, given: Sequence[str]
) -> tuple[dict[str, Mapping[str, Any]], dict[str, OwnController]]:
    """The controllers to fly, by name: those of the suite with their settings, and the user's own.

    Args:
        given: each NAME of one in the suite, to fly no others of it; or NAME=FILE.py:CLASS, to fly that too.
    """
    names = [text for text in given if "=" not in text]
    problems = [
        Problem(
            f"{suite.suite} has no controller {name!r}",
            "--controller",
            None,
            "",
            *guess(name, suite.controllers),
        )
        for name in names
        if name not in suite.controllers
    ]
    if problems:
        raise BadInput(problems)
    own = own_controllers([text for text in given if "=" in text])
    taken = [
        Problem(f"{name} is a controller of {suite.suite}", "--controller", expected="another name")
        for name in own
        if name in suite.controllers
    ]
    if taken:
        raise BadInput(taken)
    return {name: each for name, each in suite.controllers.items() if name in names or not names}, own


def variants(
    shipped: Mapping[str, Mapping[str, Any]], own: Mapping[str, OwnController]
) -> tuple[Variant, ...]:
    """What is compared: each controller with its values of the scenario."""
    return (
        *(Variant(name, {"controller": dict(settings)}) for name, settings in shipped.items()),
        *(Variant(name, {TYPE: name}) for name in own),
    )


def digest_of(suite: Suite) -> str:
    """SHA-256 of what a suite says, from which its flights are drawn; comments, order and controllers do not count."""
    said = suite.model_dump(mode="json", exclude={"controllers", "told", "purpose", "time_limit_s"})
    return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()
