"""Base class and number types of everything that is read from YAML."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field
from pydantic_core import PydanticCustomError

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
NonNegative = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0)]
Whole = Annotated[int, Field(strict=True, ge=0)]
Text = Annotated[str, Field(min_length=1)]


class Settings(BaseModel):
    """A model that cannot be changed and refuses unknown keys. Use `Number` and the like: they accept no text and no bool."""

    model_config = ConfigDict(frozen=True, extra="forbid", hide_input_in_errors=True)


def refuse(what: str, expected: str = "", suggestion: str = "") -> PydanticCustomError:
    """The exception that a validator raises to refuse a value; its parts become those of a `Problem`."""
    parts = {"what": what, "expected": expected, "suggestion": suggestion}
    return PydanticCustomError("refused", "{what}, expected {expected}" if expected else "{what}", parts)
