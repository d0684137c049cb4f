"""All that a page may ask for: a closed vocabulary, each message checked before anything is done.

What is to break, to be flown or to blow is written as in a scenario, and is checked by `Session` as a scenario is.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, StrictBool, TypeAdapter, ValidationError

from testbed.inputs.base import NonNegative, Number, Settings, Text, Whole
from testbed.inputs.problems import BadInput, Problem

MOST_BYTES = 4096
"""Longest message of a page."""
AS_GIVEN = "as given"
"""The controller or the sensors that the command or the scenario names."""
_MOST_SAID = 3  # problems that are named


class _Message(Settings):
    id: Whole
    """Number with which the answer names the message."""


class Pause(_Message):
    """Stop the time, or let it run again."""

    do: Literal["pause"]
    on: StrictBool


class Speed(_Message):
    """Fly this many times as fast as real time."""

    do: Literal["speed"]
    times: Annotated[Number, Field(ge=0.25, le=16.0)]


class Break(_Message):
    """Break something now; `failure` is one of a scenario's `failures` or `sensors.faults`, without a time."""

    do: Literal["break"]
    failure: dict[str, Any]


class Mend(_Message):
    """End every failure of an actuator, or every fault of a sensor."""

    do: Literal["mend"]
    actuator: Text


class Order(_Message):
    """Command something now; `command` is one of a scenario's `commands`, without a time."""

    do: Literal["order"]
    command: dict[str, Any]


class Blow(_Message):
    """Blow a gust, or change the wind; `air` as of `Session.blow`."""

    do: Literal["blow"]
    air: dict[str, Any]


class Save(_Message):
    """Write a run folder of the flight so far."""

    do: Literal["save"]


class Rewind(_Message):
    """Go back to this time [s]: what was done by hand from then on is gone."""

    do: Literal["rewind"]
    time_s: NonNegative


class Restart(_Message):
    """Begin again, with all that was done by hand gone."""

    do: Literal["restart"]


class Ghosts(_Message):
    """Let these types of controllers, and no others, fly the same past and present beside the flight."""

    do: Literal["ghosts"]
    controllers: tuple[Text, ...]


class Choose(_Message):
    """Fly something else: a scenario or an aircraft, a controller, and sensors, each one of those that `choices` of the page's
    facts has."""

    do: Literal["choose"]
    flight: Text
    controller: Text
    sensors: Text = AS_GIVEN


Act = Break | Mend | Order | Blow
"""What changes a flight."""
Message = Annotated[
    Act | Pause | Speed | Save | Rewind | Restart | Ghosts | Choose, Field(discriminator="do")
]
_MESSAGE: TypeAdapter[Any] = TypeAdapter(Message)


def read(text: str | bytes) -> Any:
    """The message in a text of JSON; raises BadInput for anything that is not one."""
    try:
        return _MESSAGE.validate_json(text)
    except ValidationError as error:
        found = error.errors(include_url=False, include_input=False, include_context=False)
        places = [(".".join(map(str, each["loc"])), each["msg"]) for each in found[:_MOST_SAID]]
        raise BadInput([Problem(what, "message", path=place) for place, what in places]) from None
