"""Gains that can be chosen, the largest first, each with what the errors of a scenario do to the estimates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.setup import Setup
from testbed.flight.flight import Flight
from testbed.gains.errors import ErrorSource, sources
from testbed.gains.false_alarms import false_alarm_rate
from testbed.gains.flights import answer, bias, calm, convergence_s, gusts, or_infinite
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario
from testbed.simulation import fly, start_and_setup

GUSTS = "gusts"
OFFSETS = 3.0
"""Errors that last are allowed for by this many standard deviations."""
COARSEST = 0.5
"""Largest epsilon over the position at the trim: a transient that takes a below epsilon slows the estimate."""
_STEP_SHARE, _LAG_SHARE = 0.1, 0.25
"""Largest gamma times the control step, and largest gamma over an actuator's corner: without overshoot even if its lag were not
modelled."""
_SLOWEST, _GAMMAS = 0.1, 40
_PROCESS_NOISE, _NOISES = (0.5, 0.005), 10
_SLOWEST_RATE = 1.0 / 30.0
_HOPELESS = 0.05
_UNBOUNDED = {"lambda_min": 0.01, "lambda_max": 10.0}


@dataclass(frozen=True)
class Candidate:
    """One gain, and what errors do to the n estimates with it.

    Attributes:
        gain: gamma [1/s], or process noise [1/sqrt(s)].
        parts: [sources, n] standard deviation by each error.
        noise, offset: [n] standard deviation by the errors that do not last, and by those that do.
        bias: [n] by the constant part.
        rates: [n] at which an error decays [1/s].
        intensity: [4] two-sided, of what the errors that do not last do to e at low frequency.
    """

    gain: float
    parts: np.ndarray
    noise: np.ndarray
    offset: np.ndarray
    bias: np.ndarray
    rates: np.ndarray
    intensity: np.ndarray

    def alarms(self, dt_s: float, persistence_s: float, share: float) -> np.ndarray:
        """[n] false alarms per second of actuators whose effectiveness is the threshold over `share`.

        Relative to the truth, noise and offsets are the same for any effectiveness while the force is held. Offsets count by
        `OFFSETS` standard deviations.
        """
        middle = self.middle
        found = np.full(len(middle), math.inf)
        for i in np.flatnonzero((middle > share) & np.isfinite(self.noise)):
            nu = (middle[i] / self.noise[i]) ** 2 if self.noise[i] > 0.0 else math.inf
            found[i] = false_alarm_rate(
                nu, float(self.rates[i]), dt_s, persistence_s, share / float(middle[i])
            )
        return found

    def judged(self, of: np.ndarray) -> np.ndarray:
        """[n] those of the actuators `of` [n] for which a gain can be chosen: no errors that last can bring them to zero."""
        hopeful = of & (self.middle > _HOPELESS)
        return hopeful if hopeful.any() else of

    @property
    def middle(self) -> np.ndarray:
        """[n] lowest estimate over the truth that errors which last are expected to cause."""
        return 1.0 + np.minimum(self.bias, 0.0) - OFFSETS * self.offset


@dataclass(frozen=True)
class Candidates:
    """The gains of a scenario's law; each is flown when it is asked for.

    Attributes:
        setup: what the controller is told.
        sources: every random error of the sensors.
    """

    scenario: Scenario
    settings: AdaptiveInversionSettings
    setup: Setup
    sources: list[ErrorSource]
    _flown: dict[float, Candidate] = field(default_factory=dict)

    @classmethod
    def of(cls, scenario: Scenario) -> Candidates:
        """Those of the flight in which a scenario begins; raises BadInput if its controller estimates nothing."""
        settings = scenario.controller
        if not isinstance(settings, AdaptiveInversionSettings):
            what = f"{settings.type} has no estimates to design for"
            raise BadInput(
                [scenario.source.problem(("controller", "type"), what, expected="adaptive_inversion")]
            )
        start, setup = start_and_setup(scenario)
        return cls(scenario, settings, setup, sources(scenario, start.state))

    @property
    def newton(self) -> bool:
        """Whether the estimator is the paper's (13)."""
        return self.settings.estimation == "newton"

    @property
    def positions(self) -> np.ndarray:
        """[n] of the actuators at the trim [scaled]."""
        return np.asarray(self.setup.trim_positions) / self.setup.scale

    @property
    def kinds(self) -> np.ndarray:
        """[n] servo or motor: what an actuator is for the paper's gains."""
        return np.array(["servo" if kind == "servo" else "motor" for kind in self.setup.model.kinds])

    @property
    def errors(self) -> list[tuple[str, bool]]:
        """[sources] every error in words, and whether it lasts."""
        weather = [(GUSTS, False)] if self._gusty else []
        return [(source.name, source.lasts) for source in self.sources] + weather

    @property
    def gains(self) -> np.ndarray:
        """The largest first: gamma down from what sampling and the actuators' lags allow, or values of the process noise."""
        if not self.newton:
            return np.geomspace(*_PROCESS_NOISE, _NOISES)
        fastest = min(_STEP_SHARE / self.setup.dt_s, _LAG_SHARE * float(self.setup.lags.min()))
        return np.geomspace(max(fastest, _SLOWEST), _SLOWEST, _GAMMAS)

    def per_kind(self, values: np.ndarray) -> dict[str, float]:
        """The least of values [n] for each kind of actuator; a kind that the aircraft lacks has that of the other."""
        return {
            kind: float((values[self.kinds == kind] if kind in self.kinds else values).min())
            for kind in ("servo", "motor")
        }

    def at(self, gain: float) -> Candidate:
        """What errors do with this gain."""
        if gain not in self._flown:
            self._flown[gain] = self._fly(gain)
        return self._flown[gain]

    @property
    def _gusty(self) -> bool:
        return bool(self.scenario.atmosphere.most_w20_m_s)

    def _changes(self, gain: float) -> dict[str, Any]:
        if not self.newton:
            return {"process_noise_per_root_s": gain}
        epsilon = self.per_kind(np.maximum(COARSEST * np.abs(self.positions), 1e-3))
        return {"gamma": {"servo": gain, "motor": gain}, "epsilon": epsilon, **_UNBOUNDED}

    def _fly(self, gain: float) -> Candidate:
        changes = self._changes(gain)
        still = calm(self.scenario, changes)
        flown = fly(still)
        parts, intensity = self._parts(still, flown)
        if self._gusty:
            deviation, of_gusts = gusts(self.scenario, still, self.setup)
            parts, intensity = np.vstack([parts, deviation]), intensity + of_gusts
        lasts = np.array([lasts for _, lasts in self.errors], bool)
        noise, offset = (np.sqrt(np.square(parts[of]).sum(axis=0)) for of in (~lasts, lasts))
        rates = self._rates(gain, still, changes)
        return Candidate(gain, parts, noise, offset, bias(flown, self.setup), rates, intensity)

    def _parts(self, still: Scenario, flown: Flight) -> tuple[np.ndarray, np.ndarray]:
        """[sources, n] deviation by each error of a sensor, infinite if a flight is lost, and [4] their intensity together."""
        channels = dict.fromkeys(source.channel for source in self.sources)
        answers = {channel: answer(still, flown, self.setup, channel) for channel in channels}
        parts, intensity = np.zeros((len(self.sources), len(self.setup.actuators))), np.zeros(4)
        for i, source in enumerate(self.sources):
            of_estimates, of_e = answers[source.channel]
            parts[i] = source.deviation(of_estimates, self.setup.dt_s)
            intensity += source.intensity(self.setup.dt_s) * of_e**2
        return or_infinite(parts), or_infinite(intensity)

    def _rates(self, gain: float, still: Scenario, changes: Mapping[str, Any]) -> np.ndarray:
        """[n] at which an error decays [1/s]: gamma by (22), or of the default law as flown."""
        if self.newton:
            return np.full(len(self.setup.actuators), gain)
        times = [convergence_s(still, changes, name) for name in self.setup.model.actuators]
        return np.maximum(3.0 / np.array(times), _SLOWEST_RATE)
