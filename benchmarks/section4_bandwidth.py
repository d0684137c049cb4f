"""Bandwidth and saturation (the paper's 5.2): each prediction of `paper.bandwidth` beside the ideal plant and JSBSim.

    python benchmarks/section4_bandwidth.py --jobs 1

Writes docs/results/section4_bandwidth.md and its figure. Calm air, ideal sensors, the v-tail, `preset: paper` without monitor
and jam test, so that an estimate may go where it likes. *Plain* is the paper's regressor (`ablate: [actuator_model]`),
*compensated* the modelled positions. A slow servo is the failure `lag` of both tails from the start.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from aside import aside_in
from bandwidth_ideal import (
    REMAINS,
    WITHIN,
    W,
    ideal_extreme,
    ideal_late,
    ideal_reading,
    ideal_sampled,
    limits,
)
from bandwidth_limits import (
    ALL,
    BASE,
    LOSS_S,
    MODEL_LAG,
    RATES_ALONE,
    TAILS,
    Values,
    late,
    rate_limited,
    slow,
    withstood,
)
from bandwidth_page import HEADS, Row, draw, page
from flights import Record, fly_all
from paper.replay import Behind, replay

from paper import bandwidth, rate_limits
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.flight.flight import Flight, Outcome
from testbed.metrics import readings
from testbed.scenario.model import Scenario
from testbed.simulation import fly

DOCS = Path(__file__).parents[1] / "docs"
SCALE_DEG, TRAVEL_DEG = 11.459, 25.8
"""One scaled unit of a tail, and its stop by the aircraft's file [deg]."""
MOVING_S = 60.0
LAGS = (30.0, 10.0, 7.0, 5.0)
GAMMAS = (4.0, 8.0, 16.0)
AGES = (0.01, 0.03, 0.05, 0.08)


# --- the flights -------------------------------------------------------------------------------------------------------------


def law(gamma: float, epsilon: float, plain: bool) -> Values:
    parts = ["monitor", "jam_test", *(["actuator_model"] if plain else [])]
    free = {"lambda_min": 1e-3, "lambda_max": 20.0}
    return {
        "type": "adaptive_inversion",
        "preset": "paper",
        "gamma": gamma,
        "epsilon": epsilon,
        "ablate": parts,
    } | free


def weaving() -> Values:
    """Altitude references that go up and down, so that the tails' references are nearly a sine of frequency W."""
    times = np.arange(1.0, MOVING_S - 1.0, math.pi / W)
    commands = [{"at_s": round(float(t), 3), "altitude_m": 300 + 2 * (-1) ** i} for i, t in enumerate(times)]
    return {"commands": commands, "command_rates": {"altitude_m_s": 1.8}, "duration_s": MOVING_S}


def loss() -> Values:
    return {"type": "effectiveness", "actuator": TAILS[0], "at_s": LOSS_S, "value": REMAINS}


def stopped(stop_deg: float) -> Values:
    """A stop of the left tail that no law knows; or for the one that it knows, a loss that takes it there."""
    if stop_deg == TRAVEL_DEG:
        return {"type": "effectiveness", "actuator": TAILS[0], "at_s": LOSS_S, "value": 0.1}
    return {
        "type": "position_limit",
        "actuator": TAILS[0],
        "at_s": LOSS_S,
        "low": -stop_deg,
        "high": stop_deg,
    }


MOVING = [(lag, plain) for plain in (True, False) for lag in LAGS]
LIMITED = [(rate, plain) for plain in (True, False) for rate in (25.0, 20.0, 18.0, 16.0, 14.0)]
"""Rate limits of both tails that no law knows [deg/s]. With the lowest these flights swing by themselves, or are lost."""
OWN_SWING = 2.0
"""Share of the reference that moves, above which it is the loop that swings: the commands alone make 1 to 1.7."""
SAMPLED_HZ, SAMPLED = 50, (0.25, 0.5, 1.0, 1.5, 1.75)
"""Control rate of the flights with values of gamma dt that sampling limits."""
LOSSES = [(gamma, lag) for gamma in GAMMAS for lag in (30.0, 10.0, 5.0)]
LATE = [(gamma, age) for gamma in GAMMAS for age in AGES]
STOPS = [(stop_deg, plain) for plain in (True, False) for stop_deg in (2.5, 2.0, TRAVEL_DEG)]
"""Stops of the left tail, nearer than the law knows, all of them below its trim; the last is the one that it knows."""


def flights() -> Iterator[Values]:
    for lag, plain in MOVING:
        yield {**weaving(), "failures": slow(lag), "controller": law(3.0, WITHIN, plain)}
    for rate, plain in LIMITED:
        yield {**weaving(), "failures": rate_limited(rate), "controller": law(3.0, WITHIN, plain)}
    for gamma_dt in SAMPLED:
        controller = law(gamma_dt * SAMPLED_HZ, 0.05, False)
        yield {"failures": [loss()], "rate_hz": SAMPLED_HZ, "controller": controller}
    for gamma, lag in LOSSES:
        yield {"failures": [*slow(lag), loss()], "controller": law(gamma, 0.05, True)}
    for sensors in (ALL, RATES_ALONE):
        for gamma, age in LATE:
            yield {"failures": [loss()], "controller": law(gamma, 0.05, False), **late(age, sensors)}
    for stop_deg, plain in STOPS:
        yield {"failures": [stopped(stop_deg)], "controller": law(8.0, 0.05, plain), "duration_s": 120}


FOUND = ("share", "fastest", "reading", "lowest", "reading_same_r", "lowest_same_r")


def fly_and_read(scenario: Scenario) -> Flight:
    """Fly, and add what is measured of the left tail: the mean estimate once settled, the lowest after a loss, how much of the
    reference moves; and the first two once more for (13) alone with this reference. Of an aircraft that was lost nothing is."""
    flight = fly(scenario)
    if flight.outcome is not Outcome.completed:
        return replace(flight, metrics={**flight.metrics, **dict.fromkeys(FOUND, math.nan)})
    log = readings(flight)
    r = log.log[f"{TAILS[0]}_reference"] / SCALE_DEG
    alone = replay_of(scenario, r, log.log[f"{TAILS[0]}_effectiveness"])
    settled = slice(-8 * round(2.0 * math.pi / W * scenario.rate_hz), None)
    after = slice(round(LOSS_S * scenario.rate_hz), None)
    amplitude = float(math.sqrt(2.0) * r[settled].std())
    found = {"share": amplitude / float(abs(r[settled].mean())), "fastest": amplitude * W}
    for name, estimate in (("", log.log[f"{TAILS[0]}_effectiveness_estimate"]), ("_same_r", alone)):
        found[f"reading{name}"] = float(estimate[settled].mean())
        found[f"lowest{name}"] = float(estimate[after].min())
    return replace(flight, metrics={**flight.metrics, **found})


def replay_of(scenario: Scenario, r: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """The left tail's estimate by (13) alone, in the condition of a flight."""
    chosen = scenario.controller
    assert isinstance(chosen, AdaptiveInversionSettings)
    plain = "actuator_model" in chosen.ablate
    lag = min([MODEL_LAG, *(getattr(failure, "lag_rad_s", MODEL_LAG) for failure in scenario.failures)])
    limits = [failure.value / SCALE_DEG for failure in scenario.failures if failure.type == "rate_limit"]
    late_by = scenario.sensors.of("gyro").delay_s
    behind = Behind(lag, 0.0 if plain else MODEL_LAG, late_by, min(limits, default=math.inf))
    return replay(r, truth, behind, chosen.gamma.servo, chosen.epsilon.servo, 1.0 / scenario.rate_hz)


# --- predictions beside measurements -----------------------------------------------------------------------------------------


def servo(lag: float) -> complex:
    return bandwidth.lag(W, 1.0 / lag)


def no_reading(record: Record) -> str:
    """Why a flight with commands that move has no reading, or empty."""
    if record["outcome"] != "completed":
        return "lost"
    return "swings by itself" if record["metrics"]["share"] > OWN_SWING else ""


def unread(what: str) -> Row:
    return Row(what, *[math.nan] * 5)


def moving_row(lag: float, plain: bool, record: Record) -> Row:
    found, modelled = record["metrics"], 1.0 if plain else servo(MODEL_LAG)
    if without := no_reading(record):
        return unread(f"{'plain' if plain else 'compensated'}, servo {lag:g} rad/s: {without}")
    share = found["share"]
    predicted = bandwidth.offset_reading_within(servo(lag) / modelled, share)
    ideal = ideal_reading(lag, 0.0 if plain else MODEL_LAG, share)
    what = (
        f"{'plain' if plain else 'compensated'}, servo {lag:g} rad/s (w tau {W / lag:.2g}), share {share:.1f}"
    )
    return Row(what, W / lag, predicted, ideal, found["reading_same_r"], found["reading"])


def limited_row(rate: float, plain: bool, record: Record) -> Row:
    found, modelled = record["metrics"], 1.0 if plain else servo(MODEL_LAG)
    if without := no_reading(record):
        return unread(f"{'plain' if plain else 'compensated'}, {rate:g} deg/s: {without}")
    share, limit = found["share"], rate / SCALE_DEG / found["fastest"]
    predicted = rate_limits.rate_limited_offset_reading(share, limit, servo(MODEL_LAG), modelled)
    ideal = ideal_reading(MODEL_LAG, 0.0 if plain else MODEL_LAG, share, limit)
    what = f"{'plain' if plain else 'compensated'}, {rate:g} deg/s (R / A w {limit:.2f}), share {share:.1f}"
    return Row(what, limit, predicted, ideal, found["reading_same_r"], found["reading"])


def sampled_row(gamma_dt: float, record: Record) -> Row:
    found = record["metrics"]
    what = f"gamma {gamma_dt * SAMPLED_HZ:g} /s at {SAMPLED_HZ} Hz (gamma dt {gamma_dt:g})"
    predicted = bandwidth.sampled_extreme(1.0, REMAINS, gamma_dt)
    return Row(what, gamma_dt, predicted, ideal_sampled(gamma_dt), found["lowest_same_r"], found["lowest"])


def loss_row(gamma: float, lag: float, record: Record) -> Row:
    found, x = record["metrics"], gamma / lag
    what = f"gamma {gamma:g} /s, servo {lag:g} rad/s (gamma tau {x:.2g})"
    predicted = bandwidth.extreme(1.0, REMAINS, x)
    return Row(what, x, predicted, ideal_extreme(gamma, lag), found["lowest_same_r"], found["lowest"])


def late_row(gamma: float, age: float, record: Record) -> Row:
    found, x = record["metrics"], gamma * age
    what = f"gamma {gamma:g} /s, {1000 * age:g} ms old (gamma T {x:.2g})"
    predicted = bandwidth.late_extreme(1.0, REMAINS, x)
    return Row(what, x, predicted, ideal_late(gamma, age), found["lowest_same_r"], found["lowest"])


def stop_row(stop_deg: float, plain: bool, record: Record) -> Row:
    known = stop_deg == TRAVEL_DEG
    what = (
        "the known stop, after a loss to 0.1"
        if known
        else f"a stop at {stop_deg:g} deg that it does not know"
    )
    predicted = bandwidth.stop_reading(stop_deg, TRAVEL_DEG) * (0.1 if known else 1.0)
    name = "plain" if plain else "compensated"
    return Row(f"{name}, {what}", stop_deg, predicted, math.nan, math.nan, record["metrics"]["reading"])


def measured(jobs: int | None) -> dict[str, list[Row]]:
    planned = [(1, values) for values in flights()]
    flown = iter(fly_all(BASE, planned, jobs, "section4_bandwidth:fly_and_read"))
    return {
        "moving": [moving_row(*case, next(flown)) for case in MOVING],
        "limited": [limited_row(*case, next(flown)) for case in LIMITED],
        "sampled": [sampled_row(case, next(flown)) for case in SAMPLED],
        "lag": [loss_row(*case, next(flown)) for case in LOSSES],
        "late": [late_row(*case, next(flown)) for case in LATE],
        "mixed": [late_row(*case, next(flown)) for case in LATE],
        "stops": [stop_row(*case, next(flown)) for case in STOPS],
    }


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--jobs", type=int, help="processes (default: one a core)")
    parser.add_argument("--docs", type=Path, default=DOCS, help="where results/ and figures/ are")
    options = parser.parse_args(arguments)
    rows = measured(options.jobs)
    text = page(rows, list(limits()), withstood(options.jobs))
    for group in ("limited", "lag", "late", "mixed"):
        heading = HEADS[group].splitlines()[0]
        text = aside_in(text, heading, options.docs / "results" / f"section4_bandwidth_{group}.csv")
    (options.docs / "results" / "section4_bandwidth.md").write_text(text, encoding="utf-8")
    draw(rows, options.docs / "figures" / "section4_bandwidth.png")
    print(text)


if __name__ == "__main__":
    main()
