"""A requirement of a scenario: limits of a metric, or of a logged signal in a time window."""

from __future__ import annotations

from pydantic import ValidationInfo, field_validator, model_validator

from testbed.inputs.base import NonNegative, Number, Positive, Settings, Text, refuse


class Requirement(Settings):
    """`{metric, at_most|at_least}` or `{signal, from_s, until_s, at_most|at_least|within + of}`.

    `within: 0.5, of: 300` limits the distance from a number, `of: altitude_command_m` the distance from another signal.
    Without `until_s` the time window lasts to the end of the flight.
    """

    name: Text | None = None
    """Title in the verdict; by default it is made from the other keys."""
    metric: Text | None = None
    """A metric of the flight; either this or `signal`."""
    signal: Text | None = None
    """A column of the log."""
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

    @field_validator("until_s")
    @classmethod
    def _after_start(cls, until_s: float | None, info: ValidationInfo) -> float | None:
        start = info.data.get("from_s")
        if until_s is not None and start is not None and until_s <= start:
            raise refuse(f"{until_s:g} s is not after from_s", f"more than {start:g}")
        return until_s

    @field_validator("of", mode="before")
    @classmethod
    def _number_or_signal(cls, of: object) -> object:
        if isinstance(of, bool) or not isinstance(of, int | float | str | None):
            raise refuse("is neither a number nor a signal", "a number or the name of a signal")
        return of

    @model_validator(mode="after")
    def _complete(self) -> Requirement:
        if (self.metric is None) == (self.signal is None):
            raise refuse(
                "has both metric and signal" if self.metric else "has no subject", "a metric or a signal"
            )
        if self.at_most is None and self.at_least is None and self.within is None:
            raise refuse("has no limit", "at_most, at_least or within")
        if (self.within is None) != (self.of is None):
            raise refuse("has only one of within and of", "both, as in `within: 0.5, of: altitude_command_m`")
        if self.metric and (self.within is not None or self.from_s is not None or self.until_s is not None):
            raise refuse("asks for a window or a distance of a metric", "at_most or at_least")
        return self

    @property
    def limit(self) -> str:
        """The limits in words: `within 0.5 of altitude_command_m`."""
        of = self.of if isinstance(self.of, str) or self.of is None else f"{self.of:g}"
        parts = [
            f"at least {self.at_least:g}" if self.at_least is not None else "",
            f"at most {self.at_most:g}" if self.at_most is not None else "",
            f"within {self.within:g} of {of}" if self.within is not None else "",
        ]
        return " and ".join(part for part in parts if part)

    @property
    def title(self) -> str:
        """Its `name`; else signal or metric, limit and window: `altitude_m within 0.5 of 300, 15 to 60 s`."""
        if self.name:
            return self.name
        text = f"{self.metric or self.signal} {self.limit}"
        if self.from_s is None and self.until_s is None:
            return text
        end = "the end" if self.until_s is None else f"{self.until_s:g} s"
        return f"{text}, {self.from_s or 0:g} to {end}"
