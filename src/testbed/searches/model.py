"""The model of a search file: every key with default, range and meaning."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from testbed.inputs.base import Number, Text, refuse
from testbed.sweeps.model import MOST_FLIGHTS, Study

Goal = Literal["smallest", "probability"]
GOALS: tuple[Goal, ...] = ("smallest", "probability")


class Search(Study):
    """One search: a scenario, what varies, and what is looked for. Keys that it shares with a sweep mean the same."""

    goal: Goal
    """What is looked for: the `smallest` failure that breaks a requirement, or the `probability` that one is broken."""
    requirement: Text | None = None
    """Name of the requirement that is to be broken; default: any of the scenario's."""
    budget: Annotated[int, Field(strict=True, ge=20, le=MOST_FLIGHTS)] = 2000
    """Most flights of each search. Every variant, and every option of a `choice`, is a search of its own."""
    cov: Annotated[Number, Field(gt=0, le=1)] = 0.3
    """For a probability: the coefficient of variation at which the search ends."""
    method: Literal["subset", "importance", "adaptive", "plain"] = "subset"
    """For a probability: subset simulation, importance sampling about the design points or about all failures, or plain
    sampling as the check of them."""
    starts: Annotated[int, Field(strict=True, ge=1, le=100)] = 3
    """For the smallest failure: number of independent starts, of which the nearest failure counts."""
    nominal: dict[str, Number] = {}  # noqa: RUF012
    """Value from which distance is measured, by dotted path: one end of the value's range. Default: the value with which a failure
    has no effect if that is an end of the range, else the median."""

    @model_validator(mode="after")
    def _varies(self) -> Search:
        if not self.vary:
            raise refuse("varies nothing", "vary")
        for path in self.nominal:
            if path not in self.vary:
                raise refuse(f"has a nominal {path}, which does not vary", f"one of {', '.join(self.vary)}")
        return self

    def settings(self) -> dict[str, Any]:
        """What is said of the search itself, beside what it shares with a sweep."""
        names = ["goal", "requirement", "budget", "nominal"]
        names += ["cov", "method"] if self.goal == "probability" else ["starts"]
        return {name: value for name in names if (value := getattr(self, name)) not in (None, {})}
