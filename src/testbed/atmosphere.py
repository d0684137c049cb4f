"""The air: steady wind, 1-cosine gusts and Dryden turbulence.

Wind and gusts are velocities of the air over the ground, north, east, down: a wind of [5, 0, 0] blows towards
the north. Turbulence is JSBSim's (intensities and lengths of MIL-F-8785C, filters of MIL-STD-1797A), seeded
from the flight's own stream and switched on once the aircraft is placed.
"""

from __future__ import annotations

import math
from typing import Literal, Protocol

import numpy as np
from pydantic import Field, ValidationInfo, field_validator, model_validator

from testbed.frames import body_from_ned, body_from_wind
from testbed.settings import NonNegative, Number, Positive, Settings, refuse
from testbed.streams import engine_seed
from testbed.units import METRES_PER_SECOND_PER_KNOT

# Wind at 20 ft of MIL-F-8785C's words for turbulence, in knots (3.7.3.1, figure of low-altitude intensities).
_WORDS_KT = {"light": 15.0, "moderate": 30.0, "severe": 45.0}
# JSBSim's index of probability of exceedance for each, which sets the intensity above 2000 ft.
_SEVERITY = {"light": 3, "moderate": 4, "severe": 6}

Vector = tuple[Number, Number, Number]
COLUMNS = ("wind_north_m_s", "wind_east_m_s", "wind_down_m_s")


class Gust(Settings):
    """A 1-cosine gust: rises to `magnitude_m_s` over a length or a time, holds it, and falls in the same way.

    v = V/2 (1 - cos(pi x / d)), MIL-F-8785C 3.7.1.3; without a hold it is the bump of CS-25.341 with gradient
    distance d. The length is flown through at the airspeed that the aircraft has when the gust begins. The
    direction is that of the frame at this moment: it stays with the air and does not turn with the aircraft.
    """

    at_s: NonNegative
    magnitude_m_s: Vector
    """Velocity of the air along x, y, z: forward, right, down of the body or the flight path (wind)."""
    frame: Literal["body", "wind", "ned"] = "body"
    length_m: Positive | None = None
    duration_s: Positive | None = None
    """Distance, or time, of the rise; the whole gust takes twice this and `hold_s`."""
    hold_s: NonNegative = 0.0

    @model_validator(mode="after")
    def _one_size(self) -> Gust:
        if (self.length_m is None) == (self.duration_s is None):
            what = "has no size" if self.length_m is None else "has two sizes"
            raise refuse(what, "either length_m or duration_s")
        return self

    def rise_s(self, airspeed_m_s: float) -> float:
        """Time of the rise [s] at this airspeed."""
        return self.duration_s or float(self.length_m or 0.0) / airspeed_m_s


class Atmosphere(Settings):
    """Steady wind, blowing towards north, east, down; gusts; turbulence by MIL-F-8785C's wind at 20 ft."""

    wind_m_s: Vector = (0.0, 0.0, 0.0)
    turbulence: Literal["light", "moderate", "severe"] | None = None
    """MIL-F-8785C's words for W20 = 15, 30 and 45 kt; instead of `turbulence_w20_m_s`."""
    turbulence_w20_m_s: NonNegative = Field(default=0.0, validate_default=True)
    gusts: tuple[Gust, ...] = ()

    @field_validator("turbulence_w20_m_s")
    @classmethod
    def _of_word(cls, w20: float, info: ValidationInfo) -> float:
        word = info.data.get("turbulence")
        if word is None:
            return w20
        meant = _WORDS_KT[word] * METRES_PER_SECOND_PER_KNOT
        if w20 not in (0.0, meant):
            raise refuse(f"is {w20:g}, and turbulence is {word}, which is {meant:.4g}", "one of the two")
        return meant

    @property
    def is_calm(self) -> bool:
        """Whether the air does not move at all."""
        return not (any(self.wind_m_s) or self.turbulence_w20_m_s or self.gusts)


def severity(w20_m_s: float) -> int:
    """JSBSim's index of the word that is nearest to a wind at 20 ft."""
    knots = w20_m_s / METRES_PER_SECOND_PER_KNOT
    return _SEVERITY[min(_WORDS_KT, key=lambda word: abs(_WORDS_KT[word] - knots))]


class Air(Protocol):
    """What weather needs of the plant."""

    def set_wind(self, ned_m_s: np.ndarray) -> None: ...
    def set_turbulence(self, w20_m_s: float, severity: int, seed: int) -> None: ...
    def total_wind(self) -> tuple[float, float, float]: ...
    def air_data(self) -> tuple[float, float, float, float, float, float]: ...


class Weather:
    """The air of one flight.

    Made before the aircraft is placed, so that it is placed in the steady wind; `begin` once it is; then
    `apply` each control step from `next_step` on.

    Attributes:
        next_step: next control step at which there is something to do; infinite in calm air.
        wind: [steps, 3] the air's velocity in each step, turbulence included [m/s, north, east, down].
    """

    def __init__(self, settings: Atmosphere, plant: Air, rate_hz: int, steps: int, seed: int) -> None:
        self.settings, self.plant, self.rate_hz, self.seed = settings, plant, rate_hz, seed
        self.next_step = math.inf if settings.is_calm else 0
        self.wind = np.zeros((0 if settings.is_calm else steps, 3))
        self._steady = np.array(settings.wind_m_s)
        self._gusts: list[tuple[float, float, np.ndarray] | None] = [None] * len(settings.gusts)
        if not settings.is_calm:
            plant.set_wind(self._steady)

    def begin(self) -> None:
        """Turbulence on: only now, because it disturbs JSBSim's initialisation."""
        w20 = self.settings.turbulence_w20_m_s
        if w20 > 0.0:
            self.plant.set_turbulence(w20, severity(w20), engine_seed(self.seed, "turbulence"))

    def apply(self, step: int) -> None:
        """Note the wind of this step and set that of the next."""
        self.wind[step] = self.plant.total_wind()
        if self._gusts:
            self.plant.set_wind(self._steady + self._gust(step))

    def columns(self, steps: int) -> dict[str, np.ndarray]:
        """Columns of the log that this weather adds."""
        return {} if self.settings.is_calm else dict(zip(COLUMNS, self.wind[:steps].T, strict=True))

    def _gust(self, step: int) -> np.ndarray:
        """Sum of all gusts once the step is taken; one begins with the first step at or after `at_s`."""
        total = np.zeros(3)
        for i, gust in enumerate(self.settings.gusts):
            if step < math.ceil(gust.at_s * self.rate_hz - 1e-9):
                continue
            begun = self._gusts[i] or self._begin(i, gust)
            total += profile((step + 1) / self.rate_hz - gust.at_s, begun[0], begun[1]) * begun[2]
        return total

    def _begin(self, i: int, gust: Gust) -> tuple[float, float, np.ndarray]:
        """Rise and hold [s] and velocity north-east-down, fixed from now on."""
        airspeed, alpha, beta, *attitude = self.plant.air_data()
        velocity = np.array(gust.magnitude_m_s)
        if gust.frame == "wind":
            velocity = body_from_wind(alpha, beta) @ velocity
        if gust.frame != "ned":
            velocity = body_from_ned(*attitude).T @ velocity
        begun = (gust.rise_s(airspeed), gust.hold_s, velocity)
        self._gusts[i] = begun
        return begun


def profile(time_s: float, rise_s: float, hold_s: float) -> float:
    """Fraction of its magnitude that a gust has this long after its beginning."""
    if time_s <= 0.0 or time_s >= 2.0 * rise_s + hold_s:
        return 0.0
    if time_s > rise_s:
        time_s = max(rise_s, time_s - hold_s)
    return 0.5 * (1.0 - math.cos(math.pi * time_s / rise_s))
