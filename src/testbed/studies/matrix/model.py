"""The model of a matrix file: every key with default, range and meaning."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, field_validator, model_validator

from testbed.inputs.base import NonNegative, Number, Settings, Text, refuse
from testbed.studies.model import Study

Result = Literal["held", "survived", "lost", "no result", "not possible"]
RESULTS: tuple[Result, ...] = ("held", "survived", "lost", "no result", "not possible")
"""What comes of a cell, the best first: every requirement met; flown to the end; aircraft lost; not flown; does not fit."""
WORDS = ("calm", "light", "moderate", "severe")
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
            if isinstance(each, str) and each not in WORDS:
                raise refuse(f"has {each!r}", f"{', '.join(WORDS)} or a W20 in m/s")
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
