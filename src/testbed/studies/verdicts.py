"""How each flight of a sweep ended, in a word, and which requirement it missed by most."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from testbed.flight.flight import Outcome
from testbed.scenario.requirement import Requirement
from testbed.studies.plan import Plan

if TYPE_CHECKING:
    import pandas as pd

STATES = ("passed", "missed", "lost", "no result", "not judged")
"""Passed; flown to the end with a requirement missed; ended early; not flown; flown to the end, and the controller says nothing of
what is required."""
_LOST = {str(outcome) for outcome in Outcome if outcome is not Outcome.completed}


class Missed(NamedTuple):
    """The requirement that a flight missed by most: its number, the worst value, the margin (negative), and how many others.

    Value and margin are NaN where there is no value, such as after the flight has ended.
    """

    number: int
    value: float
    margin: float
    others: int


def state(outcome: str, passed: bool | None) -> str:
    """One of STATES."""
    if passed is None:
        return "not judged"
    if passed:
        return "passed"
    if outcome in _LOST:
        return "lost"
    return "missed" if outcome == Outcome.completed else "no result"


def judged(verdicts: pd.Series) -> pd.Series:
    """Those of a column of verdicts that are one, as bools."""
    return verdicts.dropna().astype(bool)


def counted(verdicts: pd.Series) -> str:
    """`11 of 12`, of those that were judged; `, 3 not judged` besides."""
    known = judged(verdicts)
    others = f", {len(verdicts) - len(known)} not judged" if len(known) < len(verdicts) else ""
    return f"{int(known.sum())} of {len(known)}{others}"


def requirements_of(plan: Plan) -> Sequence[Requirement]:
    """The requirements of the scenario, in order."""
    return plan.builder.scenario(plan.task(0)).requirements


def missed(requirements: Sequence[Requirement], row: Mapping[Any, Any]) -> Missed | None:
    """The requirement that a flight missed by most, as a share of its limit; None if it has met all, or was not flown.

    Args:
        row: the flight's row of the table, by column.
    """
    found = []
    for j, requirement in enumerate(requirements):
        if row.get(f"requirements.{j}.passed") in (False, 0):
            value = row.get(f"requirements.{j}.value")
            number = math.nan if value is None else float(value)
            found.append((_share(requirement, number), j, number, margin(requirement, number)))
    if not found:
        return None
    _, j, number, short = min(found)
    return Missed(j, number, short, len(found) - 1)


def said_of(plan: Plan, row: Mapping[Any, Any]) -> str:
    """How a flight ended if early, and what it missed by most: `missed altitude_error_max_m at most 5 (12.3) and 1 more`.

    Empty for a flight that was not lost and missed nothing.
    """
    if row["reason"]:
        return str(row["reason"])
    ended = "" if row["outcome"] == Outcome.completed else f"{row['outcome']} at {row['end_time_s']:.4g} s"
    short = missed(requirements := requirements_of(plan), row)
    if short is None:
        unjudged = "not judged: the controller says nothing of what is required"
        return unjudged if row["passed"] is None else ended
    more = f" and {short.others} more" if short.others else ""
    missed_most = f"missed {requirements[short.number].title} ({short.value:.4g}){more}"
    return "; ".join(filter(None, [ended, missed_most]))


def margin(requirement: Requirement, value: float) -> float:
    """Distance of a requirement's worst value from its limit, negative where it is missed; NaN without a value."""
    if requirement.longest_s is not None:
        return requirement.longest_s - value
    limits = [most - value for most in (requirement.within, requirement.at_most) if most is not None]
    limits += [] if requirement.at_least is None else [value - requirement.at_least]
    return min(limits, default=math.nan)


def _share(requirement: Requirement, value: float) -> float:
    """The margin as a share of the limit; 0, which is the least missed, without a value."""
    short = margin(requirement, value)
    limits = (requirement.longest_s, requirement.within, requirement.at_most, requirement.at_least)
    limit = next(each for each in limits if each is not None)
    return 0.0 if math.isnan(short) else short / max(abs(limit), 1e-9)
