"""What errors do to the estimates, and how soon a loss is found, from flights in JSBSim.

An error of a sensor is a small step of one channel, in calm air with no other random error. The change of the estimates, over the
size of the step, is exact to first order, and differentiated it is the answer to an error of one control step. So a flight of
60 s says what noise, wander and offset of that channel do, without the scatter of random flights. Outer loops answer as they do
in any flight: what the aircraft does about a wrong reading is in it.

Gusts move the actuators, and each movement tells the estimators more than a steady position does: they are flown as they are.

A loss is flown in the scenario's own weather, with its own sensors. What an aircraft does after it moves its actuators, and so
decides how much its estimators see. A formula for constant forces is too slow for the default law by a factor of up to six, and too
quick where a demanded force passes zero. Noise moves an actuator about, too: it may bring a position into epsilon, or out of it,
and flags come up to three times as late as without.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from testbed.common.signals import RATES
from testbed.controllers.setup import Setup
from testbed.flight.flight import Flight
from testbed.gains.errors import with_error, without_chance
from testbed.scenario.load import Scenario, changed
from testbed.sensors.channels import CHANNELS, SI, Channel
from testbed.simulation import fly

GUST_SEEDS = range(1001, 1005)
_STEP_AT_S, _ANSWER_S = 30.0, 30.0  # the filter of the default law settles until then
_PROMPT_S = 0.5  # before the aircraft has moved
_STEP = 0.01  # of a reading, in its unit
_GUSTY_S, _SETTLED_S = 160.0, 20.0
_BLOCK_S = 5.0  # over which e is averaged for its intensity at low frequency
_STATES = ("airspeed", "alpha", "beta", "roll", "pitch", "p", "q", "r")


def calm(scenario: Scenario, controller: Mapping[str, Any]) -> Scenario:
    """The level flight of a scenario without chance: no weather, no random error; its estimates are not acted upon.

    Args:
        controller: changed settings of the scenario's `controller`.
    """
    settings = {f"controller.{key}": value for key, value in controller.items()}
    unwatched = {"controller.ablate": ["monitor", "jam_test", "speed_rule"]}
    seconds = {"duration_s": _STEP_AT_S + _ANSWER_S}
    level = {**level_flight(scenario), "atmosphere": {}, **settings, **unwatched, **seconds}
    return without_chance(changed(scenario, level))


def bias(flown: Flight, setup: Setup) -> np.ndarray:
    """[n] what the design model's own error and known biases add to the estimates of a calm flight; -inf if it is lost."""
    found = estimates(flown, setup)[-1] - 1.0
    return np.where(np.isnan(found), -np.inf, found)


def answer(still: Scenario, flown: Flight, setup: Setup, channel: Channel) -> tuple[np.ndarray, np.ndarray]:
    """What one unit of an error of a channel does [per SI unit]; NaN if the flight is lost.

    Args:
        flown: the calm flight `still` itself.

    Returns:
        [steps, n] change of the estimates in the steps after it has been there for one step, and [4] change of the measured error
        (10), if it stays.
    """
    stepped = fly(with_error(still, channel, _STEP, _STEP_AT_S))
    size, first = _STEP * SI[channel.unit], round(_STEP_AT_S * still.rate_hz)
    change = (estimates(stepped, setup) - estimates(flown, setup))[first - 1 :]
    e = measured_error(stepped, setup)
    prompt = first + round(_PROMPT_S * still.rate_hz)
    return np.diff(change, axis=0) / size, (e[prompt] - e[first - 1]) / size


def gusts(scenario: Scenario, still: Scenario, setup: Setup) -> tuple[np.ndarray, np.ndarray]:
    """[n] standard deviation of the estimates by the scenario's gusts alone, and [4] two-sided intensity of e at low frequency;
    infinite if a flight is lost."""
    windy = {"atmosphere": scenario.atmosphere.model_dump(mode="json"), "duration_s": _GUSTY_S}
    flights = [fly(changed(still, {**windy, "seed": seed})) for seed in GUST_SEEDS]
    first = round(_SETTLED_S * still.rate_hz)
    deviation = np.concatenate([estimates(flight, setup)[first:] for flight in flights]).std(axis=0)
    intensity = np.mean(
        [_intensity(measured_error(flight, setup)[first:], setup) for flight in flights], axis=0
    )
    return or_infinite(deviation), or_infinite(intensity)


def or_infinite(found: np.ndarray) -> np.ndarray:
    """The same, with infinity for the NaN of a flight that is lost."""
    return np.where(np.isnan(found), np.inf, found)


def _intensity(e: np.ndarray, setup: Setup) -> np.ndarray:
    """[4] that of e [steps, 4]: the variance of its means over blocks, times their length."""
    block = round(_BLOCK_S / setup.dt_s)
    means = e[: len(e) // block * block].reshape(-1, block, len(RATES)).mean(axis=1)
    return np.asarray(_BLOCK_S * means.var(axis=0))


def estimates(flight: Flight, setup: Setup) -> np.ndarray:
    """[steps, n] estimates of a flight; NaN after its end, if it is lost."""
    columns = [f"{name}_effectiveness_estimate" for name in setup.model.actuators]
    return _whole(flight, flight.log[columns].to_numpy())


def _whole(flight: Flight, found: np.ndarray) -> np.ndarray:
    """What was logged, as long as the flight was planned, with NaN after its end."""
    missing = flight.scenario.steps - len(found)
    return np.pad(found, ((0, missing), (0, 0)), constant_values=np.nan)


def measured_error(flight: Flight, setup: Setup) -> np.ndarray:
    """[steps, 4] e (10) of healthy actuators: measured rates less those of the design model at the measured state."""
    log = flight.log
    x = {}
    for _, _, name, unit in CHANNELS:
        if name in _STATES:
            column = log.get(f"{name}_measured_{unit}", log[f"{name}_{unit}"])
            x[name] = column.to_numpy() * SI[unit]
    rates = [log[f"{rate}_m_s2"] if rate == "u_dot" else np.radians(log[f"{rate}_deg_s2"]) for rate in RATES]
    kinds = zip(setup.model.actuators, setup.model.kinds, strict=True)
    positions = [
        np.radians(log[f"{name}_position"]) if kind == "servo" else log[f"{name}_position"]
        for name, kind in kinds
    ]
    modelled = setup.model.rates(x, np.column_stack(positions), np.ones(len(positions)))
    return _whole(flight, np.column_stack(rates) - modelled[:, : len(RATES)])


SEEDS = range(1001, 1006)
"""Seeds of the flights of each loss in weather or with sensors that err; else one flight says all."""
_LOST_AT_S, _AFTER_S = 15.0, 25.0
_FOUND = 1.0 - math.exp(-1.0)
_HALF = 0.5


def detection_s(scenario: Scenario, controller: Mapping[str, Any], actuator: str) -> list[float]:
    """From the total loss of an actuator to its flag, of each flight from the scenario's initial one; infinite for never.

    Args:
        controller: changed settings of the scenario's `controller`.
    """
    found = []
    for flight in _flights(scenario, controller, actuator, 0.0):
        flags = [e for e in flight.events if e["kind"] == "detection" and e["actuator"] == actuator]
        found.append(float(flags[0]["delay_s"]) if flags else math.inf)
    return found


def convergence_s(scenario: Scenario, controller: Mapping[str, Any], actuator: str) -> float:
    """Three times the time in which 63 % of a loss of half are found: median of flights as in `detection_s`, infinite for never."""
    times = []
    for flight in _flights(scenario, controller, actuator, _HALF):
        log = flight.log
        after = log.loc[log.time_s >= _LOST_AT_S, f"{actuator}_effectiveness_estimate"].to_numpy()
        found = after <= 1.0 - _HALF * _FOUND
        times.append(3.0 * float(np.argmax(found) + 1) / scenario.rate_hz if found.any() else math.inf)
    return float(np.median(times))


def level_flight(scenario: Scenario) -> dict[str, Any]:
    """Settings with which a scenario is flown straight and level as it begins, with nothing broken and nothing required."""
    level = {"at_s": 0, **scenario.initial.model_dump()}
    return {"commands": [level], "failures": [], "requirements": [], "log_hz": scenario.rate_hz}


def _flights(
    scenario: Scenario, controller: Mapping[str, Any], actuator: str, left: float
) -> Iterator[Flight]:
    """The flights of one loss, one for each seed."""
    settings = {
        **level_flight(scenario),
        **{f"controller.{key}": value for key, value in controller.items()},
        "controller.ablate": [],
        "failures": [{"type": "effectiveness", "actuator": actuator, "at_s": _LOST_AT_S, "value": left}],
        "duration_s": _LOST_AT_S + _AFTER_S,
    }
    differ = scenario.atmosphere.most_w20_m_s or scenario.sensors != without_chance(scenario).sensors
    for seed in SEEDS if differ else SEEDS[:1]:
        yield fly(changed(scenario, {**settings, "seed": seed}))
