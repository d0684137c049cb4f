"""Bandwidth and saturation (the paper's 5.2): each prediction of `testbed.theory.bandwidth` beside the ideal plant and JSBSim.

    python benchmarks/section4_bandwidth.py --jobs 1

Writes docs/results/section4_bandwidth.md and its figure. Calm air, ideal sensors, the v-tail, `preset: paper` without monitor
and jam test, so that an estimate may go where it likes. *Plain* is the paper's regressor (`ablate: [actuator_model]`),
*compensated* the modelled positions. A slow servo is the failure `lag` of both tails from the start.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from flights import Record, fly_all

from testbed.controllers.config import AdaptiveInversionSettings
from testbed.flight.flight import Flight
from testbed.metrics import readings
from testbed.scenario.model import Scenario
from testbed.simulation import fly
from testbed.theory import bandwidth
from testbed.theory.ideal import IdealLoop, IdealPlant, Tuning
from testbed.theory.replay import Behind, replay

matplotlib.use("agg")
import matplotlib.pyplot as plt

DOCS = Path(__file__).parents[1] / "docs"
TAILS = ("left_ruddervator", "right_ruddervator")
SCALE_DEG, MODEL_LAG = 11.459, 30.0
"""One scaled unit of a tail [deg], and the lag of its servo by the aircraft's file [rad/s]."""
W, WITHIN = 4.0, 2.0
"""Frequency [rad/s] of the commands that move, and an epsilon within which all of them are."""
LOSS_S, REMAINS = 20.0, 0.2
MOVING_S = 60.0
BASE = """\
name: bandwidth
aircraft: vtail
duration_s: 30
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion, preset: paper}
"""
LAGS = (30.0, 10.0, 7.0, 5.0)
GAMMAS = (4.0, 8.0, 16.0)
AGES = (0.01, 0.03, 0.05, 0.08)
Values = dict[str, Any]


@dataclass(frozen=True)
class Row:
    """A prediction beside what was measured.

    Attributes:
        predicted: by a closed form, or by an equation integrated.
        ideal: by the flying law on the ideal plant, in the same condition.
        same_r: by (13) alone for the reference that was flown (`theory.replay`).
        flown: in JSBSim.
    """

    what: str
    x: float
    predicted: float
    ideal: float
    same_r: float
    flown: float


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


def slow(lag: float) -> list[Values]:
    """Failures that make both tails' servos slow from the start."""
    if lag >= MODEL_LAG:
        return []
    return [{"type": "lag", "actuator": name, "at_s": 0, "lag_rad_s": lag} for name in TAILS]


def weaving() -> Values:
    """Altitude references that go up and down, so that the tails' references are nearly a sine of frequency W."""
    times = np.arange(1.0, MOVING_S - 1.0, math.pi / W)
    commands = [{"at_s": round(float(t), 3), "altitude_m": 300 + 2 * (-1) ** i} for i, t in enumerate(times)]
    return {"commands": commands, "command_rates": {"altitude_m_s": 3}, "duration_s": MOVING_S}


def loss() -> Values:
    return {"type": "effectiveness", "actuator": TAILS[0], "at_s": LOSS_S, "value": REMAINS}


RATES_ALONE = ("gyro", "accelerometer")
ALL = (*RATES_ALONE, "attitude", "airspeed", "alpha", "beta")
"""All that the measured rates and f_m are made of."""


def late(age: float, sensors: Sequence[str] = ALL) -> Values:
    """Sensors of this age [s]."""
    return {"sensors": {name: {"delay_s": age} for name in sensors}}


MOVING = [(lag, plain) for plain in (True, False) for lag in LAGS]
LOSSES = [(gamma, lag) for gamma in GAMMAS for lag in (30.0, 10.0, 5.0)]
LATE = [(gamma, age, sensors) for sensors in (ALL, RATES_ALONE) for gamma in GAMMAS for age in AGES]


def flights() -> Iterator[Values]:
    for lag, plain in MOVING:
        yield {**weaving(), "failures": slow(lag), "controller": law(3.0, WITHIN, plain)}
    for gamma, lag in LOSSES:
        yield {"failures": [*slow(lag), loss()], "controller": law(gamma, 0.05, True)}
    for gamma, age, sensors in LATE:
        yield {"failures": [loss()], "controller": law(gamma, 0.05, False), **late(age, sensors)}


def fly_and_read(scenario: Scenario) -> Flight:
    """Fly, and add what is measured of the left tail: the mean estimate once settled, the lowest after a loss, how much of the
    reference moves; and the first two once more for (13) alone with this reference."""
    flight = fly(scenario)
    log = readings(flight)
    r = log.log[f"{TAILS[0]}_reference"] / SCALE_DEG
    alone = replay_of(scenario, r, log.log[f"{TAILS[0]}_effectiveness"])
    settled = slice(-8 * round(2.0 * math.pi / W * scenario.rate_hz), None)
    after = slice(round(LOSS_S * scenario.rate_hz), None)
    found = {"share": float(math.sqrt(2.0) * r[settled].std() / abs(r[settled].mean()))}
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
    behind = Behind(lag, 0.0 if plain else MODEL_LAG, scenario.sensors.of("gyro").delay_s)
    return replay(r, truth, behind, chosen.gamma.servo, chosen.epsilon.servo, 1.0 / scenario.rate_hz)


# --- the ideal plant ---------------------------------------------------------------------------------------------------------


def ideal_reading(lag: float, modelled: float, share: float) -> float:
    """The estimate of r_0 (1 + share sin W t) within epsilon, once it has settled; `modelled` 0 is the plain law."""
    dt = 0.005
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag), Tuning(1.0, WITHIN, dt), 1.0)
    loop._models["lag"][0] = modelled
    r = 0.25 * (1.0 + share * np.sin(W * dt * np.arange(round(600.0 / dt))))
    period = round(2.0 * math.pi / W / dt)
    return float(loop.fly(np.tile(r[:, None], (1, 4)), 1.0).lambda_hat[-8 * period :, 0].mean())


def ideal_extreme(gamma: float, lag: float) -> float:
    """Lowest estimate after a loss to REMAINS, behind an unmodelled lag."""
    loop = IdealLoop(IdealPlant(np.eye(4), lag=lag, modelled=False), Tuning(gamma, 1e-6, 5e-4), 1.0)
    loop.start_at(np.ones(4))
    return float(loop.fly(np.ones((16000, 4)), REMAINS).lambda_hat.min())


def ideal_late(gamma: float, age: float) -> float:
    """Lowest estimate after a loss to REMAINS with rates of this age: what they differ from the present ones is a disturbance."""
    dt, estimate, lowest = 1e-3, 1.0, 1.0
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-6, dt), 1.0)
    effects = [1.0] * round(age / dt)
    for _ in range(round(4.0 / dt)):
        effects.append(REMAINS / estimate)
        late = effects.pop(0) - REMAINS / estimate
        estimate = float(loop.fly(np.ones((1, 4)), REMAINS, np.full(4, late)).lambda_hat[1, 0])
        lowest = min(lowest, estimate)
    return lowest


# --- predictions beside measurements -----------------------------------------------------------------------------------------


def servo(lag: float) -> complex:
    return bandwidth.lag(W, 1.0 / lag)


def moving_row(lag: float, plain: bool, record: Record) -> Row:
    found, modelled = record["metrics"], 1.0 if plain else servo(MODEL_LAG)
    share = found["share"]
    predicted = bandwidth.offset_reading_within(servo(lag) / modelled, share)
    ideal = ideal_reading(lag, 0.0 if plain else MODEL_LAG, share)
    what = (
        f"{'plain' if plain else 'compensated'}, servo {lag:g} rad/s (w tau {W / lag:.2g}), share {share:.1f}"
    )
    return Row(what, W / lag, predicted, ideal, found["reading_same_r"], found["reading"])


def loss_row(gamma: float, lag: float, record: Record) -> Row:
    found, x = record["metrics"], gamma / lag
    what = f"gamma {gamma:g} /s, servo {lag:g} rad/s (gamma tau {x:.2g})"
    predicted = bandwidth.extreme(1.0, REMAINS, x)
    return Row(what, x, predicted, ideal_extreme(gamma, lag), found["lowest_same_r"], found["lowest"])


def late_row(gamma: float, age: float, sensors: Sequence[str], record: Record) -> Row:
    found, x = record["metrics"], gamma * age
    which = "all" if sensors == ALL else "the rates alone"
    what = f"gamma {gamma:g} /s, {which} {1000 * age:g} ms old (gamma T {x:.2g})"
    predicted = bandwidth.late_extreme(1.0, REMAINS, x)
    return Row(what, x, predicted, ideal_late(gamma, age), found["lowest_same_r"], found["lowest"])


def measured(jobs: int | None) -> dict[str, list[Row]]:
    planned = [(1, values) for values in flights()]
    flown = iter(fly_all(BASE, planned, jobs, "section4_bandwidth:fly_and_read"))
    return {
        "moving": [moving_row(*case, next(flown)) for case in MOVING],
        "lag": [loss_row(*case, next(flown)) for case in LOSSES],
        "late": [late_row(*case, next(flown)) for case in LATE],
    }


# --- how slow a servo, how late a sensor -------------------------------------------------------------------------------------

LAWS: Mapping[str, Values] = {
    "the paper, plain": {"type": "adaptive_inversion", "preset": "paper", "ablate": ["actuator_model"]},
    "the paper, compensated": {"type": "adaptive_inversion", "preset": "paper"},
    "default": {"type": "adaptive_inversion"},
    "indi, monitored": {"type": "indi", "monitor": True},
    "l1_inversion": {"type": "l1_inversion"},
}
SLOWER = (30.0, 20.0, 15.0, 12.0, 10.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0)
OLDER = (0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2)
ROUTE = {
    "duration_s": 60,
    "command_rates": {"heading_deg_s": 4, "altitude_m_s": 1},
    "commands": [
        {"at_s": 8, "heading_deg": 120}, {"at_s": 22, "altitude_m": 310}, {"at_s": 30, "heading_deg": 90}
    ],
}  # fmt: skip
ALTITUDE_M, HEADING_DEG = 5.0, 15.0


def withstood(jobs: int | None) -> dict[str, tuple[float, float]]:
    """For each law the slowest servo [rad/s] and the oldest sensors [s] with which it holds, and all faster or younger ones too."""
    weak = {"type": "effectiveness", "actuator": TAILS[0], "at_s": LOSS_S, "value": 0.3}
    planned = [
        (1, {**ROUTE, "controller": settings, **values})
        for settings in LAWS.values()
        for values in (
            *({"failures": [*slow(lag), weak]} for lag in SLOWER),
            *({"failures": [weak], **late(age)} for age in OLDER),
        )
    ]
    flown = iter(fly_all(BASE, planned, jobs))
    return {
        name: (
            last_held(SLOWER, [next(flown) for _ in SLOWER]),
            last_held(OLDER, [next(flown) for _ in OLDER]),
        )
        for name in LAWS
    }


def last_held(values: Sequence[float], records: Sequence[Record]) -> float:
    """The last value before the first that is not held; NaN if the first is not."""
    last = math.nan
    for value, record in zip(values, records, strict=True):
        if not held(record):
            break
        last = value
    return last


def held(record: Record) -> bool:
    """Flown to the end, near its references from the start on, with no healthy actuator flagged."""
    found = record["metrics"]
    near = found["altitude_error_max_m"] <= ALTITUDE_M and found["heading_error_max_deg"] <= HEADING_DEG
    return bool(record["outcome"] == "completed" and near and not found["false_alarms"])


# --- the page ----------------------------------------------------------------------------------------------------------------

HEADS = {
    "moving": "## A command that moves, behind a servo slower than the law knows\n\nMean of the estimate, true value 1, of altitude "
    f"references that go up and down at w = {W:g} rad/s. Prediction: `offset_reading_within(F / F_m)`, with the share of the "
    "reference that moves as it was flown.",
    "lag": f"## A loss behind a slow servo, plain\n\nLowest estimate after a loss to {REMAINS:g}. Prediction: `extreme`, which "
    "takes the reference for constant.",
    "late": f"## A loss seen late\n\nLowest estimate after a loss to {REMAINS:g}, compensated law. Prediction: `late_extreme`, which "
    "takes the reference for constant.",
}


def page(rows: Mapping[str, Sequence[Row]], limits: Mapping[str, tuple[float, float]]) -> str:
    lines = [
        "# Bandwidth and saturation: predictions beside flights",
        "",
        "<!-- Written by python benchmarks/section4_bandwidth.py: change that, not this. -->",
        "",
        "This page compares what [theory predicts](../explanation/bandwidth.md) of slow servos and late sensors with the ideal plant "
        "and with flights in JSBSim.",
        "",
        "Calm air, ideal sensors, `preset: paper` without monitor and jam test. `(13) with the flown r` is the adaptive law alone, one",
        "actuator by itself, for the reference that was flown (`testbed.theory.replay`): what it has in common with the flight is due to",
        "servo and sensor, and what the prediction lacks beside it is a reference that reacts to the error.",
        "",
        "![Predictions as lines, the ideal plant as crosses, flights as dots](../figures/section4_bandwidth.png)",
    ]
    for group, head in HEADS.items():
        lines += ["", head, "", *table(rows[group])]
    lines += [
        "",
        "## How slow may a servo be, how late a sensor",
        "",
        f"Turns at 4 deg/s and a climb, the left tail at 0.3 from {LOSS_S:g} s on. Both tails' servos are slow, or all sensors late, from",
        f"the start; no law knows. Held: within {ALTITUDE_M:g} m and {HEADING_DEG:g} deg all the time, no healthy actuator flagged. The last",
        f"value held of {', '.join(f'{lag:g}' for lag in SLOWER)} rad/s, and of {', '.join(f'{1000 * age:g}' for age in OLDER)} ms.",
        "",
        "| law | slowest servo | oldest sensors |",
        "| --- | --- | --- |",
    ]
    for name, (lag, age) in limits.items():
        slowest = "none" if math.isnan(lag) else f"{lag:g} rad/s"
        oldest = "none" if math.isnan(age) else f"{1000 * age:g} ms"
        lines.append(f"| {name} | {slowest} | {oldest} |")
    return "\n".join(lines) + "\n"


def table(rows: Sequence[Row]) -> list[str]:
    head = (
        "condition",
        "predicted",
        "ideal plant",
        "error",
        "flown",
        "error",
        "(13) with the flown r",
        "flown beside it",
    )
    lines = [f"| {' | '.join(head)} |", f"|{' --- |' * len(head)}"]
    for row in rows:
        cells = (
            row.what, f"{row.predicted:.3f}", f"{row.ideal:.3f}", relative(row.ideal, row.predicted),
            f"{row.flown:.3f}", relative(row.flown, row.predicted), f"{row.same_r:.3f}", relative(row.flown, row.same_r),
        )  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def relative(measured: float, predicted: float) -> str:
    return f"{100.0 * (measured / predicted - 1.0):+.1f} %"


def draw(rows: Mapping[str, Sequence[Row]], file: Path) -> None:
    figure, panels = plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
    x = np.geomspace(0.03, 4.0, 80)
    panels[0].plot(
        x,
        [bandwidth.moving_reading(bandwidth.lag(v, 1.0)) for v in x],
        color="0.6",
        label="about zero, plain",
    )
    panels[1].plot(x, [bandwidth.extreme(1.0, REMAINS, v) for v in x], color="0.3", label="predicted")
    panels[2].plot(
        x, [bandwidth.late_extreme(1.0, REMAINS, v, 100) for v in x], color="0.3", label="predicted"
    )
    for axes, group in zip(panels, HEADS, strict=True):
        scatter(axes, rows[group], group == "moving")
    panels[0].set(xlabel="w tau [-]", ylabel="mean estimate, truth 1 [-]", xlim=(0.0, 1.0), ylim=(0.4, 1.1))
    panels[1].set(
        xlabel="gamma tau [-]",
        ylabel=f"lowest estimate, truth {REMAINS:g} [-]",
        xlim=(0.1, 4.0),
        ylim=(0.0, 0.25),
    )
    panels[2].set(
        xlabel="gamma T [-]",
        ylabel=f"lowest estimate, truth {REMAINS:g} [-]",
        xlim=(0.03, 1.6),
        ylim=(0.0, 0.25),
    )
    panels[1].axvline(bandwidth.OVERSHOOT_LIMIT, color="0.7", lw=0.8)
    panels[2].axvline(1.0 / math.e, color="0.7", lw=0.8)
    for axes, title in zip(
        panels, ("a moving command", "a loss behind a lag", "a loss seen late"), strict=True
    ):
        axes.set_title(title)
        axes.legend(fontsize="small")
    figure.savefig(file, dpi=110)
    plt.close(figure)


def scatter(axes: plt.Axes, rows: Sequence[Row], lines: bool) -> None:
    """Predictions of the rows (where they are no line), the ideal plant, (13) with the flown r, flights."""
    x = [row.x for row in rows]
    if lines:
        axes.plot(
            x, [row.predicted for row in rows], "_", color="0.3", ms=14, label="predicted, with its offset"
        )
    axes.plot(x, [row.ideal for row in rows], "x", color="C0", ms=6, label="ideal plant")
    axes.plot(x, [row.same_r for row in rows], "s", mfc="none", color="C2", ms=6, label="(13), flown r")
    axes.plot(x, [row.flown for row in rows], "o", color="C1", ms=4, label="flown")


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--jobs", type=int, help="processes (default: one a core)")
    parser.add_argument("--docs", type=Path, default=DOCS, help="where results/ and figures/ are")
    options = parser.parse_args(arguments)
    rows = measured(options.jobs)
    text = page(rows, withstood(options.jobs))
    (options.docs / "results" / "section4_bandwidth.md").write_text(text, encoding="utf-8")
    draw(rows, options.docs / "figures" / "section4_bandwidth.png")
    print(text)


if __name__ == "__main__":
    main()
