"""The model of a sweep file, and what it shares with a search: every key with default, range and meaning."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from testbed.inputs.base import Number, Positive, Settings, Text, Whole, refuse
from testbed.scenario.model import MAX_NAME
from testbed.sweeps.drawing.distributions import Distribution

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
    """What a sweep and a search share: a scenario, what varies, and what is compared under the same variations."""

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
    """Controllers of one's own among those compared, each FILE.py:CLASS. `--controller` fills it in; a file runs no code."""
    time_limit_s: Positive = 300.0
    """Wall time [s] after which a flight counts as hung."""

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
            if not reference.rpartition(":")[0]:
                raise refuse(f"has {name}: {reference!r}", "FILE.py:CLASS")
        for one in self.vary:
            for other in [*self.compare, *self.vary]:
                if f"{one}.".startswith(f"{other}.") and (one != other or other in self.compare):
                    raise refuse(f"gives {one} two meanings", f"not also {other}")
        return self


class Sweep(Study):
    """One study by sampling: a scenario, what varies, and what is compared under the same variations."""

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
