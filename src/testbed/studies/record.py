"""What is kept of one flight of a study: its record, its error history, and perhaps its log.

A flight without a result, such as one that crashed its process, has an outcome of NO_RESULT, a reason, and none of what a flight
is measured by.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import AfterValidator, ConfigDict, Field, TypeAdapter, with_config
from typing_extensions import TypedDict

from testbed.flight.flight import Outcome

NO_RESULT = ("invalid", "error", "timeout", "crashed")
"""Outcomes of a flight without a result: refused as input, ended by an exception, hung, ended with its process."""

OUTCOMES = (*map(str, Outcome), *NO_RESULT)
"""All outcomes of a flight of a study."""

MIXED = "the same, or --mixed, which marks in the table what was flown otherwise"
"""What is expected of an environment that differs from the one in which a study was begun."""


def _known(outcome: str) -> str:
    if outcome not in OUTCOMES:
        raise ValueError("is no outcome of a flight")
    return outcome


_Number = Annotated[int, Field(ge=0)]
_Verdict = tuple[bool | None, float, float]
_MOST = Field(max_length=500)
"""More columns than that would take minutes to summarise and draw."""


@dataclass(frozen=True)
class Task:
    """One flight of a study: the numbers of its run and its variant, and the seed and the values drawn for the run."""

    run: _Number
    variant: _Number
    seed: _Number
    values: dict[str, Any]


@dataclass(frozen=True)
class Record(Task):
    """A flight, and how it went.

    `requirements` has (passed, value, robustness) of each requirement, NaN where there is no value. `passed` is None for what
    cannot be judged: a requirement on what the controller does not say, and a flight in which nothing can. `reason` says why there
    is no result. `environment` says what was other than where the study was begun, where that was asked for.
    """

    outcome: Annotated[str, AfterValidator(_known)]
    passed: bool | None
    reason: str = ""
    end_time_s: float = math.nan
    robustness: float = math.nan
    metrics: Annotated[dict[str, float], _MOST] = field(default_factory=dict)
    requirements: Annotated[tuple[_Verdict, ...], _MOST] = ()
    environment: str = ""


@dataclass(frozen=True)
class Flown:
    """What is kept of one flight: its record, its error history (see `folder.logs`), and its log as Parquet, or b""."""

    record: Record
    history: bytes = b""
    log: bytes = b""


def key_of(k: int) -> bytes:
    """The key by which flight number k of a sweep is stored (see `folder.store`)."""
    return k.to_bytes(8, "big")


@with_config(ConfigDict(extra="allow"))
class Begun(TypedDict, total=False):
    """What a study was begun with (see `folder.begin`); folders of earlier versions lack some of it."""

    fly: str
    aircraft_sha256: str
    versions: dict[str, str]
    arithmetic: dict[str, str]
    controllers_sha256: dict[str, str]
    parts_sha256: dict[str, str]


CHECKED, BEGUN = TypeAdapter(Record), TypeAdapter(Begun)
"""They read a record, and what a study was begun with, from JSON, with the type and the range of each value checked."""
