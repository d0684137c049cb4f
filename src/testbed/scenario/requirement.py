"""A requirement of a scenario: limits of a metric, or of a logged signal in a time window."""

from __future__ import annotations

import math

from pydantic import StrictBool, ValidationInfo, field_validator, model_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, after, refuse
from testbed.scenario.formula import Node, parse


class Requirement(Settings):
    """`{metric, at_most|at_least}`, `{signal, from_s, until_s, at_most|at_least|within + of}` or `{formula}`.

    `within: 0.5, of: 300` limits the distance from a number, `of: altitude_command_m` the distance from another signal.
    Without `until_s` the time window lasts to the end of the flight. The limits hold in the whole window, unless one of
    `eventually`, `settles_by_s` and `never_for_longer_than_s` says otherwise.
    """

    name: Text | None = None
    """Title in the verdict; by default it is made from the other keys."""
    metric: Text | None = None
    """A metric of the flight; either this, `signal` or `formula`."""
    signal: Text | None = None
    """A column of the log."""
    formula: Text | None = None
    """What is to hold in time, such as `always(eventually[0:5](abs(roll_deg) < 10))`; its robustness is the value, at least 0."""
    from_s: NonNegative | None = None
    """Start of the time window of a `signal` [s]; default: start of the flight."""
    until_s: Positive | None = None
    """End of the time window [s]; default: end of the flight."""
    at_most: Number | None = None
    """Highest value allowed."""
    at_least: Number | None = None
    """Lowest value allowed."""
    within: NonNegative | None = None
    """Largest distance from `of` allowed; for a heading, the short way round."""
    of: Number | Text | None = None
    """What `within` is measured from: a number, or another column of the log."""
    eventually: StrictBool | None = None
    """True: the limits need to be kept at one instant of the window only."""
    settles_by_s: Positive | None = None
    """The limits are kept from this time on [s], to the end of the window; takes the place of `from_s`."""
    never_for_longer_than_s: Positive | None = None
    """The limits may be left, each time for no longer than this [s]."""
    scale: Positive | None = None
    """What robustness 1 is, in the unit of the signal or metric; default: the limit, or half the distance between two limits."""

    @field_validator("formula")
    @classmethod
    def _readable(cls, text: str | None) -> str | None:
        if text is not None:
            parse(text)
        return text

    _after_start = field_validator("until_s")(after("from_s"))

    @field_validator("at_least")
    @classmethod
    def _below_the_other(cls, at_least: float | None, info: ValidationInfo) -> float | None:
        at_most = info.data.get("at_most")
        if at_least is not None and at_most is not None and at_least > at_most:
            raise refuse(f"{at_least:g} is above at_most", f"at most {at_most:g}")
        return at_least

    @field_validator("of", mode="before")
    @classmethod
    def _number_or_signal(cls, of: object) -> object:
        if isinstance(of, bool) or not isinstance(of, int | float | str | None):
            raise refuse("is neither a number nor a signal", "a number or the name of a signal")
        return of

    @model_validator(mode="after")
    def _complete(self) -> Requirement:
        subjects = [key for key in ("metric", "signal", "formula") if getattr(self, key) is not None]
        if len(subjects) != 1:
            what = f"has both {' and '.join(subjects)}" if subjects else "has no subject"
            raise refuse(what, "a metric or a signal or a formula")
        if self.formula is not None:
            return self._alone()
        if self.at_most is None and self.at_least is None and self.within is None:
            raise refuse("has no limit", "at_most, at_least or within")
        if (self.within is None) != (self.of is None):
            raise refuse("has only one of within and of", "both, as in `within: 0.5, of: altitude_command_m`")
        windowed = (self.from_s, self.until_s, self.within, *self._timings.values())
        if self.metric and any(value is not None for value in windowed):
            raise refuse("asks for a window or a distance of a metric", "at_most or at_least")
        if len(self._timings) > 1:
            raise refuse(f"has {' and '.join(self._timings)}", "one of them")
        return self

    def _alone(self) -> Requirement:
        """A formula says limits and times itself."""
        given = set(self.model_dump(exclude_none=True)) - {"name", "formula", "scale"}
        if given:
            raise refuse(f"has {' and '.join(sorted(given))} beside a formula", "the formula, name and scale")
        return self

    @property
    def parsed(self) -> Node:
        """The formula."""
        return parse(str(self.formula))

    @model_validator(mode="after")
    def _in_order(self) -> Requirement:
        settled, longest = self.settles_by_s, self.never_for_longer_than_s
        if settled is not None and self.from_s is not None:
            raise refuse("has both from_s and settles_by_s", "settles_by_s alone, where the window begins")
        if settled is not None and self.until_s is not None and self.until_s <= settled:
            raise refuse(f"until_s {self.until_s:g} is not after settles_by_s", f"more than {settled:g}")
        length = math.inf if self.until_s is None else self.until_s - (self.from_s or 0.0)
        if longest is not None and longest >= length:
            raise refuse(
                f"never_for_longer_than_s {longest:g} is no shorter than its window", f"less than {length:g}"
            )
        return self

    @property
    def _timings(self) -> dict[str, float | bool]:
        """The one key, if any, that says when in the window the limits are to be kept."""
        keys = ("eventually", "settles_by_s", "never_for_longer_than_s")
        return {key: value for key in keys if (value := getattr(self, key))}

    @property
    def begins_s(self) -> float:
        """When the limits begin to apply [s]."""
        return self.settles_by_s or self.from_s or 0.0

    @property
    def longest_s(self) -> float | None:
        """Largest value allowed, where the value is a time [s]: that of settling, or the longest one outside the limits."""
        return self.settles_by_s or self.never_for_longer_than_s

    def scale_of(self, key: str) -> float:
        """What robustness 1 is for its limit `within`, `at_most` or `at_least`, in the limit's unit: `scale`, half the distance
        between two limits, or the limit itself; 1 where that is 0."""
        limit = abs(float(getattr(self, key)))
        if self.scale is not None:
            return self.scale
        if key != "within" and self.at_least is not None and self.at_most is not None:
            return (self.at_most - self.at_least) / 2.0 or limit or 1.0
        return limit or 1.0

    @property
    def limit(self) -> str:
        """The limits in words: `within 0.5 of altitude_command_m`."""
        if self.formula is not None:
            return "robustness at least 0"
        of = self.of if isinstance(self.of, str) or self.of is None else f"{self.of:g}"
        parts = [
            f"at least {self.at_least:g}" if self.at_least is not None else "",
            f"at most {self.at_most:g}" if self.at_most is not None else "",
            f"within {self.within:g} of {of}" if self.within is not None else "",
        ]
        return " and ".join(part for part in parts if part) + self._timing

    @property
    def _timing(self) -> str:
        """When in the window the limits are to be kept, in words."""
        if self.settles_by_s is not None:
            return f" from {self.settles_by_s:g} s on at the latest"
        if self.never_for_longer_than_s is not None:
            return f", never outside for longer than {self.never_for_longer_than_s:g} s"
        return " at least once" if self.eventually else ""

    @property
    def title(self) -> str:
        """Its `name`; else signal or metric, limit and window: `altitude_m within 0.5 of 300, 15 to 60 s`."""
        if self.name:
            return self.name
        if self.formula is not None:
            return self.formula
        text = f"{self.metric or self.signal} {self.limit}"
        if self.from_s is None and self.until_s is None:
            return text
        end = "the end" if self.until_s is None else f"{self.until_s:g} s"
        return f"{text}, {self.from_s or 0:g} to {end}"
