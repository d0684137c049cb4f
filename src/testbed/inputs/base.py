"""Base class and number types of everything that is read from YAML."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Annotated, Any, Union

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationInfo
from pydantic_core import PydanticCustomError

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
NonNegative = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0)]
Whole = Annotated[int, Field(strict=True, ge=0)]
Text = Annotated[str, Field(min_length=1), AfterValidator(lambda text: one_line(text))]
"""A name: of more lines, it could stand on the terminal as a verdict of ours."""


class Settings(BaseModel):
    """A model that cannot be changed and refuses unknown keys. Use `Number` and the like: they accept no text and no bool."""

    model_config = ConfigDict(frozen=True, extra="forbid", hide_input_in_errors=True)


def any_of(table: Mapping[str, type[Settings]]) -> Any:
    """The type of what is one of these models, told by its key `type`."""
    return Annotated[Union[tuple(table.values())], Field(discriminator="type")]  # noqa: UP007


def retype(model: type[BaseModel], /, **types: Any) -> None:
    """Give fields of a model other types, in place, so that what refers to the model has them too once it is built again."""
    for name, kind in types.items():
        model.model_fields[name].annotation = kind
    model.model_rebuild(force=True)


def one_line(text: str) -> str:
    """The text; raises ValueError where it has a line break, the one control character that is shown as it is."""
    if "\n" in text:
        raise refuse("has a line break", "one line")
    return text


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
