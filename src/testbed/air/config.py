"""The `atmosphere` block of a scenario: steady wind, 1-cosine gusts and Dryden turbulence with its severity.

Wind and gusts are velocities of the air over the ground, north, east, down: a wind of [5, 0, 0] blows towards
the north. `wind` applies them in flight.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Literal

from pydantic import Field, ValidationInfo, field_validator, model_validator

from testbed.common.signals import first_step_at
from testbed.common.units import METRES_PER_SECOND_PER_KNOT
from testbed.inputs.base import NonNegative, Number, Positive, Settings, after, refuse

# For each of MIL-F-8785C's words for turbulence the wind at 20 ft, in knots (3.7.3.1, figure of low-altitude intensities), and
# JSBSim's index of probability of exceedance, which sets the intensity above 2000 ft.
_WORDS = {"light": (15.0, 3), "moderate": (30.0, 4), "severe": (45.0, 6)}

Vector = tuple[Number, Number, Number]
PARTS = ("u", "v", "w", "p")
"""Noises of turbulence: of the gusts along the heading, to the right and down, and of that which rolls."""
COLUMNS = ("wind_north_m_s", "wind_east_m_s", "wind_down_m_s")

LASTING_S = 1e6
"""Hold of a gust that lasts to the end of any flight [s]; 12 days."""


class Gust(Settings):
    """A 1-cosine gust: rises to `magnitude_m_s` over a length or a time, holds it, and falls in the same way.

    v = V/2 (1 - cos(pi x / d)), MIL-F-8785C 3.7.1.3; without a hold it is the bump of CS-25.341 with gradient
    distance d. A length is converted to a time with the airspeed at the beginning of the gust. The direction is
    taken from the frame at the beginning too: after that it is fixed to the ground and does not turn with the aircraft.
    """

    at_s: NonNegative
    """When it begins."""
    magnitude_m_s: Vector
    """Velocity of the air along the axes of `frame`: forward, right, down, or north, east, down."""
    frame: Literal["body", "wind", "ned"] = "body"
    """Axes of `magnitude_m_s`: `body`, `wind` (x along the velocity through the air) or `ned` (north, east, down)."""
    length_m: Positive | None = None
    """Distance flown during the rise; give either this or `duration_s`."""
    duration_s: Positive | None = None
    """Duration of the rise. The whole gust takes twice this plus `hold_s`."""
    hold_s: NonNegative = 0.0
    """How long the full velocity is held."""

    @model_validator(mode="after")
    def _one_size(self) -> Gust:
        if (self.length_m is None) == (self.duration_s is None):
            what = "has no size" if self.length_m is None else "has two sizes"
            raise refuse(what, "either length_m or duration_s")
        return self

    def rise_s(self, airspeed_m_s: float) -> float:
        """Duration of the rise [s] for an aircraft that flies at this airspeed."""
        return self.duration_s or float(self.length_m or 0.0) / airspeed_m_s


class TurbulenceChange(Settings):
    """Another intensity of JSBSim's turbulence from a time on. The air follows as its filters do; 0 ends it at once."""

    at_s: NonNegative
    """When it changes."""
    w20_m_s: NonNegative
    """W20 from then on, as `turbulence_w20_m_s`."""


class Noise(Settings):
    """The first coefficients of the noise that drives `dryden` turbulence in a window of time.

    Each is a standard normal in a flight in which it is not given. So a sweep or a search that draws them as
    `{normal: [0, 1]}` draws from the same turbulence, and moves it smoothly.
    """

    from_s: NonNegative = 0.0
    """Start of the window."""
    until_s: Positive | None = None
    """End of the window, which may be after that of the flight; default: end of the flight."""
    u: tuple[Number, ...] = ()
    """Coefficients of the gust along the heading, those of low frequency first: i half-waves in the window, i = 0, 1, ..."""
    v: tuple[Number, ...] = ()
    """Those of the gust to the right."""
    w: tuple[Number, ...] = ()
    """Those of the gust downwards."""
    p: tuple[Number, ...] = ()
    """Those of the air that rotates about the x axis."""

    _after_start = field_validator("until_s")(after("from_s"))

    def window(self, rate_hz: int, steps: int) -> tuple[int, int]:
        """First control step of the window, and the step after its last, which may be after the flight's end."""
        end = steps if self.until_s is None else first_step_at(self.until_s, rate_hz)
        return first_step_at(self.from_s, rate_hz), end


class Atmosphere(Settings):
    """Steady wind, gusts, and turbulence with the intensity that MIL-F-8785C gives for a wind at 20 ft."""

    model: Literal["jsbsim", "dryden_8785c", "dryden_1797b"] = "jsbsim"
    """Whose turbulence: JSBSim's, or Dryden's of MIL-F-8785C or MIL-HDBK-1797B, which are the same but for notation."""
    wind_m_s: Vector = (0.0, 0.0, 0.0)
    """Steady wind over the ground; it blows towards north, east, down."""
    turbulence: Literal["light", "moderate", "severe"] | None = None
    """MIL-F-8785C's words for W20 = 15, 30 and 45 kt; instead of `turbulence_w20_m_s`."""
    turbulence_w20_m_s: NonNegative = Field(default=0.0, validate_default=True)
    """W20 of MIL-F-8785C, the wind at 20 ft, which sets the intensity of turbulence; 0 is none."""
    turbulence_changes: tuple[TurbulenceChange, ...] = ()
    """Later intensities of JSBSim's turbulence, in order of time."""
    gusts: tuple[Gust, ...] = ()
    noise: Noise | None = None
    """Coefficients of the noise of a `dryden` model; what is not given comes from the seed."""

    @field_validator("turbulence_w20_m_s")
    @classmethod
    def _of_word(cls, w20: float, info: ValidationInfo) -> float:
        word = info.data.get("turbulence")
        if word is None:
            return w20
        meant = _WORDS[word][0] * METRES_PER_SECOND_PER_KNOT
        if w20 not in (0.0, meant):
            raise refuse(f"is {w20:g}, and turbulence is {word}, which is {meant:.4g}", "one of the two")
        return meant

    @field_validator("turbulence_changes")
    @classmethod
    def _in_order(
        cls, changes: tuple[TurbulenceChange, ...], info: ValidationInfo
    ) -> tuple[TurbulenceChange, ...]:
        if changes and info.data.get("model") != "jsbsim":
            raise refuse("only JSBSim's turbulence changes in flight", "model: jsbsim, or no changes")
        if any(one.at_s >= other.at_s for one, other in pairwise(changes)):
            raise refuse("are not in order of time", "each at_s later than the one before")
        return changes

    @field_validator("noise")
    @classmethod
    def _given(cls, noise: Noise | None, info: ValidationInfo) -> Noise | None:
        if noise is not None and info.data.get("model") == "jsbsim":
            raise refuse("JSBSim's turbulence draws its own noise", "model: dryden_8785c, or no noise")
        return noise

    @property
    def is_own_turbulence(self) -> bool:
        """Whether there is turbulence that the testbed makes, not JSBSim."""
        return self.model != "jsbsim" and self.turbulence_w20_m_s > 0.0

    @property
    def most_w20_m_s(self) -> float:
        """The strongest turbulence that there is, by its W20 [m/s]."""
        return max(self.turbulence_w20_m_s, *(each.w20_m_s for each in self.turbulence_changes), 0.0)

    @property
    def is_calm(self) -> bool:
        """Whether the air does not move at all."""
        return not (any(self.wind_m_s) or self.turbulence_w20_m_s or self.turbulence_changes or self.gusts)


def severity(w20_m_s: float) -> int:
    """JSBSim's index of severity for a wind at 20 ft [m/s]: that of the nearest of MIL-F-8785C's words; 0, which is none, for 0."""
    if not w20_m_s:
        return 0
    knots = w20_m_s / METRES_PER_SECOND_PER_KNOT
    return min(_WORDS.values(), key=lambda word: abs(word[0] - knots))[1]


class WindChange(Settings):
    """Another steady wind from now on, reached as a gust is: v = V/2 (1 - cos(pi t / duration))."""

    wind_m_s: Vector
    """The wind over the ground in place of the one so far; it blows towards north, east, down."""
    duration_s: Positive = 1.0
    """How long the change takes."""

    def gust(self, at_s: float, so_far_m_s: Vector) -> Gust:
        """The gust that makes this change, beginning at a time [s]; its hold is longer than any flight."""
        north, east, down = (new - old for new, old in zip(self.wind_m_s, so_far_m_s, strict=True))
        return Gust(
            at_s=at_s,
            magnitude_m_s=(north, east, down),
            frame="ned",
            duration_s=self.duration_s,
            hold_s=LASTING_S,
        )
