"""Probabilities of what each actuator is, from the law's own filter, against the flags that the law raises.

    python benchmarks/hypotheses.py --draws 60

Draws of the suite `open` are flown with the default law. From the filter's estimate of each effectiveness and of the model error
along the actuator's column of B, the posterior of six hypotheses is computed: works, weak, lost, held, offset, reversed. An
actuator is named broken when works and weak together have had less than 1 - `SURE` for `FOR_S`. Printed, for model errors of the
expected size and of larger ones: in how many flights a name is given before anything has failed, and how many lost actuators are
named later than the law flags them.
"""

from __future__ import annotations

import argparse
import math
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.special import ndtr

from testbed.api.benchmark import prepare
from testbed.scenario.model import Scenario
from testbed.simulation.session import Session

HYPOTHESES = ("works", "weak", "lost", "held", "offset", "reversed")
SURE, FOR_S, EVERY_S = 0.99, 0.1, 0.05
SIZES = (1.0, 2.0, 4.0)
"""Standard deviation of the model error, of that which the law expects [1]."""
PRIOR = np.log([1.0, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3])
WEAK_FROM = 0.25  # effectiveness [1] below which an actuator is as good as lost
WORKS_STD, LOST_STD, REVERSED_STD, LARGEST_OFFSET = 0.1, 0.05, 0.2, 6.0  # of effectiveness [1]; scaled units


def log_posterior(
    lam: float, variance: float, offset: float, spread: float, prior: float, size: float = 1.0
) -> np.ndarray:
    """Logarithms, up to a constant, of the probabilities of `HYPOTHESES` for one servo.

    Args:
        lam, variance: the filter's effectiveness and its variance.
        offset: model error along the actuator's column of B, as a change of its position [scaled].
        spread: the filter's variance of `offset`; less than `prior`.
        prior: the variance that the filter expects of `offset`, where the model's own error is all there is.
        size: standard deviation of the model's own error, of that which the filter expects.
    """
    # The filter's prior of b is divided out: what is left is the likelihood of the offset.
    seen = 1.0 / (1.0 / spread - 1.0 / prior)
    model_error = _normal(offset * seen / spread, size**2 * prior + seen)
    force = -math.log(2.0 * LARGEST_OFFSET)
    above, below = ((x - lam) / math.sqrt(variance + LOST_STD**2) for x in (1.0, WEAK_FROM))
    works = _normal(lam - 1.0, variance + WORKS_STD**2)
    weak = math.log(max(float(ndtr(above) - ndtr(below)) / (1.0 - WEAK_FROM), 1e-30))
    lost = _normal(lam, variance + LOST_STD**2)
    turned = _normal(lam + 1.0, variance + REVERSED_STD**2)
    used = np.logaddexp(works, weak - math.log(3.0))
    of_all = (works + model_error, weak + model_error, lost + model_error, lost + force, used + force)
    return np.array([*of_all, turned + model_error]) + PRIOR


def _normal(x: float, variance: float) -> float:
    return -0.5 * (x * x / variance + math.log(2.0 * math.pi * variance))


def probabilities(session: Session, size: float) -> np.ndarray:
    """[n, 4] of the last four `HYPOTHESES` for each actuator in use, at most one of which is broken; zeros for flagged ones."""
    controller = session.parts.controller
    memory, model = controller.memory[0], controller._records[0][0]
    n = len(memory.lambda_hat)
    expected = np.array(memory.model_error_variance)
    odds, fine = np.full((n, len(HYPOTHESES)), -np.inf), np.zeros(n)
    for i in np.flatnonzero(memory.failed == 0):
        column = np.array(model.B[:, i])
        information = float(column @ (column / expected))
        weight = column / expected / information
        variance = float(weight @ memory.P[n:, n:] @ weight)
        said = log_posterior(
            float(memory.lambda_hat[i]), max(float(memory.P[i, i]), 1e-6), float(weight @ memory.b),
            min(variance, 0.999 / information), 1.0 / information, size,
        )  # fmt: skip
        if not model.servo[i]:  # thrust has no offset and does not turn about
            said[[4, 5]] = -np.inf
        fine[i] = np.logaddexp(said[0], said[1])
        odds[i] = said - fine[i]
    broken = odds[:, 2:]
    return np.exp(broken - np.logaddexp.reduce(np.append(broken.ravel(), 0.0)))


@dataclass
class Flown:
    """What one flight gave: seconds before its first failure, what was lost then, when each actuator was first flagged, and named
    for each of `SIZES` [s]."""

    draw: int
    sound_s: float
    losses: dict[str, float]
    flagged: dict[str, float] = field(default_factory=dict)
    named: list[dict[str, float]] = field(default_factory=lambda: [{} for _ in SIZES])


def fly(draw: int, scenario: Scenario) -> Flown:
    """Fly one draw to its end."""
    with Session(scenario) as session:
        return _watched(draw, scenario, session)


def _watched(draw: int, scenario: Scenario, session: Session) -> Flown:
    names = list(session.parts.aircraft.actuators)
    failures = [each for each in scenario.failures if getattr(each, "actuator", None)]
    first = min((each.at_s for each in failures), default=math.inf)
    losses = {each.actuator: each.at_s for each in failures
              if each.type == "effectiveness" and each.at_s == first and each.value == 0.0}  # fmt: skip
    flown, since = Flown(draw, 0.0, losses), np.zeros((len(SIZES), len(names)))
    while session.ended is None:
        session.step(max(round(scenario.rate_hz * EVERY_S), 1))
        for k, size in enumerate(SIZES):
            broken = probabilities(session, size).sum(axis=1) > SURE
            since[k] = np.where(broken, since[k] + EVERY_S, 0.0)
            for i in np.flatnonzero(since[k] > FOR_S):
                flown.named[k].setdefault(names[i], session.time_s)
        for i in np.flatnonzero(session.parts.controller.memory[0].failed):
            flown.flagged.setdefault(names[i], session.time_s)
    flown.sound_s = min(first, session.time_s)
    return flown


def flights(draws: int, seed: int) -> Iterator[Flown]:
    """Fly the draws one after the other."""
    plan, _ = prepare("open", seed=seed, draws=draws, controllers=["default"])
    for draw in range(draws):
        yield fly(draw, plan.builder.scenario(plan.task(draw)))


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--draws", type=int, default=60)
    parser.add_argument("--seed", type=int, default=777)
    options = parser.parse_args(arguments)
    warnings.simplefilter("ignore")
    flown = list(flights(options.draws, options.seed))
    hours = sum(each.sound_s for each in flown) / 3600.0
    print(f"{hours:.2f} h before anything failed, {len(flown)} flights")
    _report("flags of the law", flown, [each.flagged for each in flown])
    for k, size in enumerate(SIZES):
        _report(f"names, model error {size:g} times as expected", flown, [each.named[k] for each in flown])


def _report(what: str, flown: Sequence[Flown], said: Sequence[dict[str, float]]) -> None:
    early = sum(any(at < each.sound_s for at in by.values()) for each, by in zip(flown, said, strict=True))
    losses = [(by.get(name, math.inf), each.flagged.get(name, math.inf))
              for each, by in zip(flown, said, strict=True) for name in each.losses]  # fmt: skip
    later = sum(at > flag for at, flag in losses)
    print(
        f"{what}: before anything failed in {early} flights; of {len(losses)} losses {later} later than the law's flag"
    )


if __name__ == "__main__":
    main()
