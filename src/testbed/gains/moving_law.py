"""The weighted estimator in weather, whose gusts move the actuators.

Each movement tells the filter more than a steady position does, which it can hardly tell from an error of the model that lasts.
So its variances and gains are lower than those of the trimmed flight, and errors move its estimates less: by a third on the
v-tail in moderate turbulence. The positions are those of a flight in this weather; the errors are drawn anew.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.signal import lfilter

from testbed.gains.error_sources import ErrorSource
from testbed.gains.loss_flights import level_flight
from testbed.gains.trimmed_law import TrimmedLaw
from testbed.gains.trimmed_steps import follow_moving
from testbed.scenario.load import Scenario, changed
from testbed.simulation import fly

_FLOWN_S, _SETTLING = 200.0, 10  # length, and the part of it in which the filter settles is one in this many
_SEED = 1001
_FEW = 1e-4  # change of an estimate that stays away from its bounds


@dataclass(frozen=True)
class MovingLaw:
    """The weighted estimator along one flight.

    Attributes:
        law: the same in the trimmed flight.
        phi: [steps, 4, n] regressor, behind the lags.
    """

    law: TrimmedLaw
    phi: np.ndarray

    @classmethod
    def of(cls, law: TrimmedLaw, scenario: Scenario) -> MovingLaw:
        """Along a healthy level flight in the scenario's weather."""
        log = fly(
            changed(
                scenario,
                {**level_flight(scenario), "sensors": "ideal", "seed": _SEED, "duration_s": _FLOWN_S},
            )
        ).log
        model, setup = law.model, law.setup
        pressure = np.square(log.airspeed_m_s.to_numpy() / float(model.airspeed))
        columns = []
        for j, (name, kind) in enumerate(zip(setup.model.actuators, setup.model.kinds, strict=True)):
            position = log[f"{name}_position"].to_numpy()
            acting = np.radians(position) * pressure if kind == "servo" else position
            columns.append(np.outer(acting / setup.scale[j], np.array(model.B)[:, j]))
        filtered = [law.filtered(column) for column in columns]
        return cls(law, np.ascontiguousarray(np.stack(filtered, axis=2)))

    def deviation(self, sources: Sequence[ErrorSource], **changes: Any) -> np.ndarray:
        """[n] standard deviation of the estimates by these errors together, to first order; `changes` as of the law."""
        each = [drawn(source, len(self.phi), k, self.law.setup.dt_s) for k, source in enumerate(sources)]
        e = self.law.filtered(np.sum(each, axis=0))
        c, s, _, _, w = self.law.steady_filter(**changes)
        size = _FEW / (np.abs(e).max() or 1.0)
        out = np.empty((len(e), self.phi.shape[2]))
        follow_moving(size * e, self.phi, w.P_h, self.law.model, c, s, out)
        found: np.ndarray = out[len(out) // _SETTLING :].std(axis=0) / size
        return found


def drawn(source: ErrorSource, steps: int, number: int, dt_s: float) -> np.ndarray:
    """[steps, 4] what an error does to e, drawn at random."""
    noise = np.random.default_rng([_SEED, number]).normal(size=steps)
    if source.correlation_time_s:
        kept = math.exp(-dt_s / source.correlation_time_s)
        noise = lfilter([math.sqrt(1.0 - kept * kept)], [1.0, -kept], noise)
    return source.std * np.column_stack([lfilter(row, [1.0], noise) for row in source.response.T])
