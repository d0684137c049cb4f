"""The air of one flight: steady wind, gusts computed here in each control step, and turbulence, JSBSim's or `turbulence`.

JSBSim's has the intensities and length scales of MIL-F-8785C and the filters of MIL-STD-1797A. Its seed is derived from
that of the flight. It is switched on after the aircraft has been placed.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from testbed.air.config import COLUMNS, Atmosphere, Gust, TurbulenceChange, severity
from testbed.air.turbulence import Turbulence
from testbed.common.angles import body_from_ned, body_from_wind
from testbed.common.random_streams import engine_seed
from testbed.common.signals import first_step_at, longer

if TYPE_CHECKING:
    from testbed.plant.jsbsim import Plant


class Weather:
    """The air of one flight.

    Make it before the aircraft is placed, because the initial velocity over the ground depends on the steady wind. Call `begin`
    after the aircraft has been placed, and then `apply` in each control step from `next_step` on.

    Attributes:
        next_step: next control step at which there is something to do; infinite in calm air.
        settings: the air of the flight, with the gusts that were added to it.
        now: [3] velocity of the air in the present step, as in `wind`; always the same array, in calm air 0.
        wind: [steps, 3] velocity of the air in each step, with gusts and turbulence [m/s, north, east, down]; empty in calm air.
    """

    def __init__(self, settings: Atmosphere, plant: Plant, rate_hz: int, steps: int, seed: int) -> None:
        self.settings, self.plant, self.rate_hz, self.seed = settings, plant, rate_hz, seed
        self.next_step = math.inf if settings.is_calm else 0
        self._steps = steps
        self.now = np.zeros(3)
        self.wind = np.zeros((0 if settings.is_calm else steps, 3))
        self._steady = np.array(settings.wind_m_s)
        self._gusty = self._stirred = False
        self._turbulence = None
        if settings.is_own_turbulence:
            self._turbulence = Turbulence(settings, plant, rate_hz, steps, seed)
            self.wind = self._turbulence.wind
        self._changes = [
            (first_step_at(each.at_s, rate_hz), each.w20_m_s) for each in settings.turbulence_changes
        ]
        self._starts = list[int]()
        self._gusts = list[tuple[float, float, list[float]] | None]()
        # The first of them, whose velocity does not change now; its sum, and until when it is so if it is not zero.
        self._settled, self._held, self._held_until_s = 0, (0.0, 0.0, 0.0), math.inf
        for gust in settings.gusts:
            self._expect(gust)
        if not settings.is_calm:
            plant.set_wind(self._steady)

    def begin(self) -> None:
        """Switch turbulence on. If it were on earlier, it would disturb JSBSim's initialisation."""
        w20 = self.settings.turbulence_w20_m_s
        if self._turbulence is not None:
            self._turbulence.begin(self._steady)
        elif w20 > 0.0:
            self._stir(w20)

    def _stir(self, w20_m_s: float) -> None:
        """Set JSBSim's turbulence, whose random numbers begin with the first that there is."""
        seed = None if self._stirred else engine_seed(self.seed, "turbulence")
        self.plant.set_turbulence(w20_m_s, severity(w20_m_s), seed)
        self._stirred = True

    def log_calm(self) -> None:
        """Log the wind of calm air too, from the first step on: then a gust can be added in flight."""
        if math.isinf(self.next_step):
            self.wind, self.next_step = np.zeros((self._steps, 3)), 0

    def add(self, gust: Gust) -> None:
        """Take one more gust, which begins at or after the next control step; the wind has been logged from the first step on."""
        self.log_calm()
        self.settings = self.settings.model_copy(update={"gusts": (*self.settings.gusts, gust)})
        self._expect(gust)

    def change(self, turbulence: TurbulenceChange) -> None:
        """Take another intensity of JSBSim's turbulence, at or after the next control step; it replaces one of that time."""
        self.log_calm()
        others = [each for each in self.settings.turbulence_changes if each.at_s != turbulence.at_s]
        changes = tuple(sorted((*others, turbulence), key=lambda each: each.at_s))
        self.settings = self.settings.model_copy(update={"turbulence_changes": changes})
        first = first_step_at(turbulence.at_s, self.rate_hz)
        later = [each for each in self._changes if each[0] != first]
        self._changes = sorted([*later, (first, turbulence.w20_m_s)])

    def _expect(self, gust: Gust) -> None:
        """Plan a gust of the settings."""
        self._starts.append(first_step_at(gust.at_s, self.rate_hz))
        self._gusts.append(None)

    def lengthen(self, settings: Atmosphere, steps: int) -> None:
        """Take more control steps; `settings` are those so far, but that the window of noise given has an end."""
        self.settings, self._steps = settings, steps
        if self._turbulence is not None:
            self._turbulence.lengthen(settings.noise, steps)
            self.wind = self._turbulence.wind
        elif not math.isinf(self.next_step):
            self.wind = longer(self.wind, steps)

    def apply(self, step: int) -> None:
        """Log the wind of this step, and set that of the next. Own turbulence knows the wind without asking the plant."""
        if self._turbulence is None:
            self.wind[step] = self.plant.total_wind()
        self.now[:] = self.wind[step]
        if self._starts:
            self._put_gusts(step)
        if self._turbulence is not None:
            self._turbulence.step(step)
        while self._changes and step >= self._changes[0][0]:
            self._stir(self._changes.pop(0)[1])

    def _put_gusts(self, step: int) -> None:
        gusty = self._blowing(step)
        if gusty or self._gusty:
            put = self.plant.set_wind if self._turbulence is None else self._turbulence.over
            put(self._steady + self._gust(step))
        self._gusty = gusty

    def _blowing(self, step: int) -> bool:
        """Whether any gust has begun and is not over."""
        if self._held_until_s < math.inf:
            return True
        for start, begun in zip(self._starts, self._gusts, strict=True):
            if step >= start and (begun is None or step < start + (2.0 * begun[0] + begun[1]) * self.rate_hz):
                return True
        return False

    def columns(self, steps: int) -> dict[str, np.ndarray]:
        """Columns of the log that this weather adds."""
        return dict(zip(COLUMNS, self.wind[:steps].T, strict=True))

    def _gust(self, step: int) -> np.ndarray:
        """Sum of the velocities of all gusts at the end of this step [m/s, north, east, down].

        A gust begins with the first step at or after its `at_s`.
        """
        time_s = (step + 1) / self.rate_hz
        if time_s >= self._held_until_s:
            self._settled, self._held, self._held_until_s = 0, (0.0, 0.0, 0.0), math.inf
        north, east, down = self._held
        for i in range(self._settled, len(self._gusts)):
            if step < self._starts[i]:
                continue
            rise_s, hold_s, velocity = self._gusts[i] or self._begin(i, self.settings.gusts[i])
            since_s = time_s - self.settings.gusts[i].at_s
            share = profile(since_s, rise_s, hold_s)
            north, east, down = (
                north + share * velocity[0], east + share * velocity[1], down + share * velocity[2],
            )  # fmt: skip
            if i == self._settled and since_s > rise_s and share in (0.0, 1.0):
                # Until `until_s` neither this gust nor those before it change: their sum is held.
                until_s = time_s - since_s + rise_s + hold_s if share else math.inf
                self._settled += 1
                self._held, self._held_until_s = (north, east, down), min(self._held_until_s, until_s)
        return np.array([north, east, down])

    def _begin(self, i: int, gust: Gust) -> tuple[float, float, list[float]]:
        """Rise and hold [s] and full velocity [m/s, north, east, down] of a gust that begins now."""
        airspeed, alpha, beta, *attitude = self.plant.air_data()
        velocity = np.array(gust.magnitude_m_s)
        if gust.frame == "wind":
            velocity = body_from_wind(alpha, beta) @ velocity
        if gust.frame != "ned":
            velocity = body_from_ned(*attitude).T @ velocity
        begun = (gust.rise_s(airspeed), gust.hold_s, velocity.tolist())
        self._gusts[i] = begun
        return begun


def profile(time_s: float, rise_s: float, hold_s: float) -> float:
    """Velocity of a gust `time_s` after its beginning, as a fraction of its full velocity."""
    if time_s <= 0.0 or time_s >= 2.0 * rise_s + hold_s:
        return 0.0
    if time_s > rise_s:
        time_s = max(rise_s, time_s - hold_s)
    return 0.5 * (1.0 - math.cos(math.pi * time_s / rise_s))
