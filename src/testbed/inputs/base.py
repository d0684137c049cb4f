"""Base class and number types of everything that is read from YAML."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationInfo
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


def after(start: str) -> Callable[[float | None, ValidationInfo], float | None]:
    """A validator of a time [s] that refuses one which is not after that of the key `start`, where both are given."""

    def checked(time_s: float | None, info: ValidationInfo) -> float | None:
        start_s = info.data.get(start)
        if time_s is not None and start_s is not None and time_s <= start_s:
            raise refuse(f"{time_s:g} s is not after {start}", f"more than {start_s:g}")
        return time_s

    return checked
