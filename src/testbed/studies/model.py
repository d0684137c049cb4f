"""The models of sweep, search and matrix files: every key with default, range and meaning."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, field_validator, model_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, Whole, refuse
from testbed.scenario.model import MAX_NAME
from testbed.studies.drawing.distributions import Distribution

MOST_FLIGHTS = 10_000_000
"""Most runs of a sweep, and most flights, which are runs times variants. Ten million flights take weeks."""
MOST_LEVELS = 100_000
"""Most levels of one value in a grid."""


class StopWhen(Settings):
    """Stop as soon as P(all requirements met) is known to +- `half_width` at this `confidence`, for every variant."""

    half_width: Annotated[Number, Field(gt=0, lt=0.5)]
    """Half of the width of the confidence interval."""
    confidence: Annotated[Number, Field(gt=0, lt=1)] = 0.95
    """Confidence of the interval."""


class Study(Settings):
    """What all kinds of study share: a scenario, what varies, and what is compared under the same variations."""

    word: ClassVar[str]
    """The kind in a word: the name of its command, and of its file in the study's folder."""
    free: ClassVar[tuple[str, ...]]
    """Keys on which no flight depends, and which may differ when the study is resumed."""

    name: Text | None = Field(default=None, max_length=MAX_NAME)
    """Title of the study; default: the file's name."""
    scenario: Text | dict[str, Any]
    """Path of a scenario file, relative to the study's file; or the scenario itself."""
    seed: Whole = 1
    """Seed from which everything random is drawn."""
    set: dict[str, Any] = {}  # noqa: RUF012  (pydantic copies it)
    """Changes to the scenario for all flights, by dotted paths."""
    vary: dict[str, Distribution] = {}  # noqa: RUF012
    """Values that vary: a distribution for each dotted path."""
    compare: dict[str, Annotated[list[Any], Field(min_length=1)]] = {}  # noqa: RUF012
    """Variants that are flown with the same variations: a list of values for each dotted path; of several, all combinations."""
    controllers: dict[str, Text] = {}  # noqa: RUF012
    """Controllers of one's own among those compared, by what they were made of: FILE.py:CLASS, or a file's name. `--controller`
    fills it in; a file runs no code."""
    time_limit_s: Positive = 300.0
    """Wall time [s] after which a flight counts as hung."""

    def settings(self) -> dict[str, Any]:
        """The keys of this kind, which other kinds do not have, as the file in the study's folder says them."""
        raise NotImplementedError

    @field_validator("vary", "compare")
    @classmethod
    def _not_the_seed(cls, paths: dict[str, Any]) -> dict[str, Any]:
        if "seed" in paths:
            raise refuse("names seed", "other values: every run has a seed of its own already")
        return paths

    @model_validator(mode="after")
    def _unambiguous(self) -> Study:
        if (variants := math.prod(map(len, self.compare.values()))) > MOST_FLIGHTS:
            raise refuse(f"compares {variants} variants", f"at most {MOST_FLIGHTS}")
        for name, reference in self.controllers.items():
            if not reference:
                raise refuse(f"has {name} without a file", "FILE.py:CLASS, or the name of a file")
        for one in self.vary:
            for other in [*self.compare, *self.vary]:
                if f"{one}.".startswith(f"{other}.") and (one != other or other in self.compare):
                    raise refuse(f"gives {one} two meanings", f"not also {other}")
        return self


class Sweep(Study):
    """One study by sampling: a scenario, what varies, and what is compared under the same variations."""

    word = "sweep"
    free = ("name", "runs", "stop_when")

    runs: Annotated[int, Field(strict=True, gt=0, le=MOST_FLIGHTS)] | None = None
    """Number of runs. Default: 1000; with `cases` or a grid, all of their points."""
    sampling: Literal["sobol", "latin_hypercube", "halton", "random", "grid"] = "sobol"
    """Sampling method: how the runs cover the ranges of the varied values."""
    levels: Annotated[int, Field(strict=True, gt=1, le=MOST_LEVELS)] = 5
    """Number of levels of each continuous value in a grid."""
    cases: Text | None = None
    """CSV table used instead of `vary`: a row for each run, a column for each dotted path; relative to the sweep's file."""
    stop_when: StopWhen | None = None

    @model_validator(mode="after")
    def _varies(self) -> Sweep:
        if self.cases is not None and self.vary:
            raise refuse("has both vary and cases", "one of them")
        if self.cases is None and not self.vary:
            raise refuse("varies nothing", "vary, or cases: table.csv")
        return self

    def settings(self) -> dict[str, Any]:
        """As `Study.settings`; the table of cases is kept beside the file."""
        shown: dict[str, Any] = {"runs": self.runs}
        shown |= {"cases": "cases.csv"} if self.cases is not None else {"sampling": self.sampling}
        if self.sampling == "grid":
            shown["levels"] = self.levels
        return shown if self.stop_when is None else {**shown, "stop_when": self.stop_when.model_dump()}


Goal = Literal["smallest", "probability"]
GOALS: tuple[Goal, ...] = ("smallest", "probability")


class Search(Study):
    """One search: a scenario, what varies, and what is looked for. Keys that it shares with a sweep mean the same."""

    word = "search"
    free = ("name", "budget", "cov", "method", "starts")

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
        """As `Study.settings`; those of the other goal are left out."""
        names = ["goal", "requirement", "budget", "nominal"]
        names += ["cov", "method"] if self.goal == "probability" else ["starts"]
        return {name: value for name in names if (value := getattr(self, name)) not in (None, {})}


Result = Literal["held", "survived", "lost", "no result", "not possible"]
RESULTS: tuple[Result, ...] = ("held", "survived", "lost", "no result", "not possible")
"""What comes of a cell, the best first: every requirement met; flown to the end; aircraft lost; not flown; does not fit."""
WEATHERS = ("calm", "light", "moderate", "severe")
Severity = Annotated[Number, Field(gt=0, le=10)]


class Expected(Settings):
    """What is expected of the cells that have these values; a key that is left out leaves it open."""

    actuator: Text | None = None
    failure: Text | None = None
    severity: Severity | None = None
    weather: Text | None = None
    controller: Text | None = None
    result: Result


class Matrix(Study):
    """Each actuator broken alone in each way. Keys that it shares with a sweep mean the same."""

    word = "matrix"
    free = ("name", "baseline")

    failures: list[Text | dict[str, Any]] = Field(default=[], max_length=1000)
    """Types of failure, or failures with values of their own and no actuator; default: every type."""
    severities: list[Severity] = Field(default=[0.5, 1.0], min_length=1, max_length=100)
    """How strong each failure is: 0 has no effect, 1 the values of `failures`, or those of the catalogue; values in between are in
    proportion. A failure whose values have no such measure is flown once."""
    weather: list[Text | NonNegative] = Field(default=[], max_length=100)
    """`calm`, a word of MIL-F-8785C for turbulence (`light`, `moderate`, `severe`), or its W20 [m/s]; default: the scenario's."""
    seeds: Annotated[int, Field(strict=True, ge=1, le=1000)] = 1
    """Flights of each cell, with seeds of their own; the worst of them counts."""
    at_s: NonNegative | None = None
    """When each failure starts; default: when the first of the scenario does, else 10."""
    baseline: list[Expected] = Field(default=[], max_length=100_000)
    """What is expected of the cells; the last entry that is about a cell counts. Default: each is held."""

    @field_validator("weather")
    @classmethod
    def _known(cls, weather: list[str | float]) -> list[str | float]:
        for each in weather:
            if isinstance(each, str) and each not in WEATHERS:
                raise refuse(f"has {each!r}", f"{', '.join(WEATHERS)} or a W20 in m/s")
        return weather

    @model_validator(mode="after")
    def _varies_cells_only(self) -> Matrix:
        if self.vary:
            raise refuse("varies values", "no vary: its cells are what varies")
        return self

    def settings(self) -> dict[str, Any]:
        """As `Study.settings`."""
        own = set(Matrix.model_fields) - set(Study.model_fields)
        return self.model_dump(mode="json", include=own, exclude_none=True)
