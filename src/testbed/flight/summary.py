"""What summary.json of a flight must hold to be believed: it may come from anybody.

Each part is a model of the keys that are read; further keys are kept as they are. Folders of earlier versions lack some keys, which
have a value here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Union

from pydantic import AfterValidator, BaseModel, ConfigDict, Discriminator, Field, Tag

from testbed.aircraft.shape import Shape
from testbed.common.signals import RATES
from testbed.flight.events import LIMITS
from testbed.flight.flight import Outcome
from testbed.inputs.base import NonNegative, Number, Positive, Whole, one_line

_Flag = Annotated[bool, Field(strict=True)]
_Word = Annotated[str, Field(strict=True)]
_Name = Annotated[_Word, AfterValidator(one_line)]
_Known = Number | None
"""A number, or None where it was not finite."""


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, extra="allow", hide_input_in_errors=True)


class Event(_Part):
    """What every event has; one of another kind is shown by its kind alone."""

    time_s: NonNegative
    kind: _Word
    actuator: _Word | None = None


class Injection(Event):
    """A failure begins or ends."""

    failure: Whole = 0
    type: _Word = ""
    active: _Flag = True
    verified: _Flag | None = True


class Detection(Event):
    """An actuator that is broken was flagged."""

    actuator: _Word
    delay_s: Number


class FalseAlarm(Event):
    """An actuator was flagged that is not broken."""

    actuator: _Word


class Release(Event):
    """A controlled rate was given up."""

    axis: Literal[RATES]  # type: ignore[valid-type]


class Recovered(Event):
    """The aircraft recovered from a failure."""

    after_s: Number


class Diagnosis(Event):
    """What the controller said."""

    text: _Word


class _Passed(_Part):
    limit: Literal[tuple(LIMITS)]  # type: ignore[valid-type]
    value: Number
    allowed: Number
    unit: _Word


class _AtStop(_Part):
    actuator: _Word
    stop: _Word


class Lost(Event):
    """The aircraft was lost."""

    limits: tuple[_Passed, ...]
    at_stop: tuple[_AtStop, ...]


_BY_KIND: dict[str, type[Event]] = {
    "injection": Injection, "detection": Detection, "false_alarm": FalseAlarm, "release": Release,
    "recovered": Recovered, "diagnosis": Diagnosis, "lost": Lost, "other": Event,
}  # fmt: skip


def _kind(event: Any) -> str:
    kind = event.get("kind") if isinstance(event, Mapping) else getattr(event, "kind", None)
    return kind if isinstance(kind, str) and kind in _BY_KIND else "other"


_AnyEvent: Any = Annotated[
    Union[tuple(Annotated[model, Tag(kind)] for kind, model in _BY_KIND.items())],  # noqa: UP007
    Discriminator(_kind),
]


class Verdict(_Part):
    """What was found of a requirement."""

    name: _Name
    passed: _Flag | None
    value: _Known
    limit: _Word = ""
    margin: _Known = None
    robustness: _Known = None
    reason: _Word = ""


class Facts(_Part):
    """What is said of an actuator."""

    name: _Name
    kind: _Word
    unit: _Word
    limits: tuple[Number, Number]
    scale: Positive


class Summary(_Part):
    """summary.json of a run folder, whole."""

    outcome: Outcome
    end_time_s: NonNegative
    events: tuple[_AnyEvent, ...]  # type: ignore[valid-type]
    requirements: tuple[Verdict, ...]
    metrics: Annotated[dict[str, _Known], Field(max_length=500)]
    actuators: Annotated[tuple[Facts, ...], Field(max_length=100)]
    warnings: tuple[_Word, ...] = ()
    shape: Shape | None = None
    flown_by: _Word = ""
    flown_by_sha256: _Word = ""
    parts_sha256: dict[str, _Word] = Field(default_factory=dict, max_length=100)
