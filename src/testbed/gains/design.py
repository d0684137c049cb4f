"""Gains from noise: the paper's "knowledge of the spectral intensity ... could be used to set gamma and epsilon", made a rule.

For the paper's law (13), with s_i the noise of actuator i, a_i its position at the trim (see `false_alarms`):

1. gamma is the largest with which noise moves no estimate by more than the tolerated deviation, and no monitor is expected to flag
   a working actuator more often than tolerated. It is never above what the control step and the slowest actuator allow.
2. epsilon is the position below which the same gamma would exceed the deviation, and no more than |a_i| / 2.
3. The threshold is half the effectiveness that must not be flagged, or less where errors that last bring the estimate that low.

The default law's gain is its process noise, in place of gamma: the random walk of effectiveness that its Kalman filter expects.

Errors that last longer than an estimate takes to converge (offsets, the model's own error at this trim) move every estimate by
n/a whatever the gains. If they alone exceed what is tolerated, no gain helps.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from testbed.gains.candidates import Candidates
from testbed.gains.choice import Chosen, Tolerance, choose
from testbed.gains.flights import convergence_s, detection_s
from testbed.gains.verdict import ActuatorDesign, advice, shortcomings
from testbed.inputs.problems import BadInput, Problem
from testbed.scenario.load import Scenario, changed, load_scenario

_NONE = 1e-9  # standard deviation that is none


@dataclass(frozen=True)
class Design:
    """Gains for one scenario, with what they are expected to do.

    Attributes:
        controller: keys of the scenario's `controller` block.
        impossible: why what is asked cannot be had, in sentences; empty if it can.
        advice: what would help.
        false_alarms_per_hour: of the aircraft, with every actuator at the effectiveness that must not be flagged.
        disturbance: [4] root of the two-sided intensity of all noise at low frequency, by `signals.RATES` [unit per root hertz].
    """

    scenario: Scenario
    tolerance: Tolerance
    controller: Mapping[str, Any]
    actuators: tuple[ActuatorDesign, ...]
    false_alarms_per_hour: float
    impossible: tuple[str, ...]
    advice: tuple[str, ...]
    disturbance: tuple[float, ...]

    @property
    def possible(self) -> bool:
        """Whether all that is asked can be had."""
        return not self.impossible


def design(
    scenario: Scenario | str | Path,
    *,
    deviation: float = 0.1,
    false_alarms_per_hour: float = 0.1,
    keep: float = 0.2,
    within_s: float | None = None,
    set: Mapping[str, Any] | None = None,
) -> Design:
    """Gains, threshold and persistence of `adaptive_inversion` for the sensors and the turbulence of a scenario.

    They are for the trimmed flight in which the scenario begins. The law is the scenario's own: gamma and epsilon for
    `preset: paper`, the process noise for the default.

    Args:
        scenario: a scenario, or the path of its file.
        deviation: tolerated standard deviation of an estimate of a healthy actuator [1].
        false_alarms_per_hour: tolerated flags on actuators that work, of the whole aircraft.
        keep: effectiveness down to which an actuator must not be flagged.
        within_s: time in which an estimate has to converge; None for as fast as the rest allows.
        set: settings to change, as `--set` does.

    Raises:
        BadInput: the scenario cannot be used, its controller has no estimates, or a tolerance is out of range.
    """
    tolerance = Tolerance(deviation, false_alarms_per_hour, keep, within_s)
    if problems := list(_out_of_range(tolerance)):
        raise BadInput(problems)
    if not isinstance(scenario, Scenario):
        scenario = load_scenario(scenario, set or {})
    elif set:
        scenario = changed(scenario, set)
    return _designed(scenario, tolerance)


def _out_of_range(tolerance: Tolerance) -> Iterator[Problem]:
    for option, value, low, high in (
        ("--deviation", tolerance.deviation, 0.0, 1.0),
        ("--false-alarms", tolerance.false_alarms_per_hour, 0.0, math.inf),
        ("--keep", tolerance.keep, 0.0, 1.0),
        ("--within", tolerance.within_s, 0.0, math.inf),
    ):
        if value is not None and not low < value < high:
            limit = f"more than 0 and less than {high:g}" if high < math.inf else "more than 0"
            yield Problem(f"is {value:g}", option, expected=limit)


def _designed(scenario: Scenario, tolerance: Tolerance) -> Design:
    candidates = Candidates.of(scenario)
    chosen = choose(candidates, tolerance)
    settings = {key: value for key, value in chosen.settings.items() if key not in ("type", "preset")}
    actuators = tuple(
        _actuator(i, candidates, chosen, settings) for i in range(len(candidates.setup.actuators))
    )
    return Design(
        scenario,
        tolerance,
        chosen.settings,
        actuators,
        3600.0 * chosen.false_alarms_per_s,
        tuple(shortcomings(actuators, tolerance)),
        tuple(advice(actuators, tolerance)),
        tuple(map(float, np.sqrt(chosen.predicted.intensity))),
    )


def _actuator(i: int, candidates: Candidates, chosen: Chosen, settings: Mapping[str, Any]) -> ActuatorDesign:
    scenario, model = candidates.scenario, candidates.setup.model
    kind, name = model.kinds[i], model.actuators[i]
    flagged = detection_s(scenario, settings, name)
    predicted = chosen.predicted
    rate, parts = float(predicted.rates[i]), predicted.parts[:, i]
    return ActuatorDesign(
        name=name,
        kind=kind,
        position=float(candidates.positions[i]),
        noise=float(predicted.noise[i]),
        offset=float(predicted.offset[i]),
        bias=float(predicted.bias[i]),
        convergence_s=3.0 / rate if candidates.newton else convergence_s(scenario, settings, name),
        detection_s=float(np.median(flagged)),
        soonest_s=min(flagged),
        latest_s=max(flagged),
        met=bool(chosen.met[i]),
        shares=tuple(
            (candidates.errors[k][0], float(parts[k])) for k in np.argsort(-parts) if parts[k] > _NONE
        ),
    )
