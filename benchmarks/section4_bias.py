"""Bias of the estimates by constant disturbances, and the remarks of the paper after (32), for `section4_noise`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pandas as pd
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.trimmed_law import TrimmedLaw, law_of
from section4_flights import DT_S, at_speed, error, head, measured, over, row, with_values

from paper import noise
from testbed import fly

BIASES = (-0.45, -0.3, 0.3, 0.6)  # of the accelerometer [m/s2]
MODEL_ERRORS = [
    (airspeed, name, factor)
    for airspeed in (16.0, 20.0)
    for name, factors in (("", (1.0,)), ("Cm_alpha", (0.8, 1.2)), ("CX_alpha", (0.7, 1.3)))
    for factor in factors
]


def bias_rows(quick: bool, jobs: int | None) -> Iterator[str]:
    cases: list[tuple[str, dict[str, Any]]] = [
        (f"accelerometer {bias:+g} m/s2", {"sensors.accelerometer.bias_m_s2": bias}) for bias in BIASES
    ]
    for airspeed, name, factor in MODEL_ERRORS:
        error_of_model = {"controller.model_error": {name: factor}} if name else {}
        words = f"{airspeed:g} m/s, {f'{name} times {factor:g}' if name else 'the model as it is'}"
        cases.append((words, {**at_speed(airspeed), **error_of_model}))
    cases = cases[::4] if quick else cases
    flights = [{**values, "duration_s": 60} for _, values in cases]
    yield from head(
        "constant disturbance",
        "actuator",
        "n/a",
        "1 + n/a",
        "flown",
        "error",
        "1/(1 - n/r) at the trim's r",
        "error",
    )
    for (words, _), values, records in zip(cases, flights, measured(flights, 1, jobs), strict=True):
        scenario = with_values(values)
        bias = law_of(scenario).bias(scenario)
        flown = over(records, "mean")
        for kind, i in (("tail", 0), ("propeller", 2)):
            n = float(bias[i])
            end = flown[0, i] if len(flown) else math.nan
            literal = noise.biased_by_reference(1.0, n, 1.0)
            yield row(
                words, kind, f"{n:+.3f}", f"{1.0 + n:.4f}", f"{end:.4f}", error(end, 1.0 + n), f"{literal:.4f}", error(end, literal)
            )  # fmt: skip


MANOEUVRES = [(airspeed, factor) for airspeed in (20.0, 16.0) for factor in (0.8, 1.2)]
"""Airspeed to which a flight changes from 18 m/s [m/s], and factor on Cm_alpha of the design model."""
EPSILON, GAMMA = 0.05, 2.0


def transients(quick: bool) -> Iterator[str]:
    """(37) through a change of airspeed: what an error of Cm_alpha adds to a tail's estimate, integrated along the flight."""
    yield from head(
        "Cm_alpha times", "airspeed [m/s]", "largest: predicted", "flown", "error", "at the end: predicted", "flown", "error",
        "rms difference over largest",
    )  # fmt: skip
    for airspeed, factor in MANOEUVRES[:1] if quick else MANOEUVRES:
        correct, _ = _flown(airspeed, 1.0)
        wrong, law = _flown(airspeed, factor)
        flown = (wrong - correct)["left_ruddervator_effectiveness_estimate"].to_numpy()
        predicted = _integrated(wrong, law, factor)
        largest = [float(np.abs(change).max()) for change in (predicted, flown)]
        rms = float(np.sqrt(np.square(predicted - flown).mean()))
        yield row(
            factor, f"18 to {airspeed:g}", *largest, error(largest[1], largest[0]), float(predicted[-1]), float(flown[-1]),
            error(flown[-1], predicted[-1]), f"{100.0 * rms / largest[0]:.1f} %",
        )  # fmt: skip


def _flown(airspeed: float, factor: float) -> tuple[pd.DataFrame, TrimmedLaw]:
    level = at_speed(18.0)["commands"][0]
    values: dict[str, Any] = {
        "commands": [level, {"at_s": 10, "airspeed_m_s": airspeed}],
        "duration_s": 40,
        "controller.model_error": {"Cm_alpha": factor},
    }
    scenario = with_values(values)
    return fly(scenario).log, law_of(scenario)


def _integrated(log: pd.DataFrame, law: TrimmedLaw, factor: float) -> np.ndarray:
    """(37) for the difference that the erroneous coefficient makes, with the positions and angles of attack of the flight."""
    m = law.model
    slope = float(m.A[1, 0]) / factor * (1.0 - factor)  # of delta_f in q_dot over alpha
    n = float(m.B_inv[0, 1]) * slope * (np.radians(log.alpha_deg.to_numpy()) - m.alpha)
    a = np.radians(log.left_ruddervator_position.to_numpy()) / m.scale[0]
    change = np.zeros(len(n))
    for k in range(len(n) - 1):
        g = 1.0 / a[k] if abs(a[k]) > EPSILON else a[k] / EPSILON**2
        change[k + 1] = change[k] + DT_S * GAMMA * g * (n[k] - a[k] * change[k])
    return change


def remarks() -> Iterator[str]:
    """The paper's four remarks after (32), each on the ideal plant with the flying law."""
    r, gamma = 0.5, 2.0
    one = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 0.05, DT_S))
    n = np.array([0.02, -0.02, 0.1, 0.0])
    step = np.log(one.fly(np.full((1, 4), r), 1.0, n).lambda_hat[1]) / DT_S
    yield from head("remark", "predicted", "on the ideal plant")
    signs = f"{np.sign(step[0]):+.0f}, {np.sign(step[1]):+.0f}"
    yield row("1. n g > 0 moves the estimate up, n g < 0 down", f"n = {n[0]:+g}, {n[1]:+g}", signs)
    yield row("2. with the gain gamma g", f"gamma g n = {gamma / r * n[2]:.4f} 1/s", f"{step[2]:.4f} 1/s")
    for start, ratio in ((0.02, 0.5), (50.0, 2.0)):
        loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 1e-60, DT_S), start)
        estimate = loop.fly(np.full((4000, 4), r), 1.0, np.full(4, ratio * r)).lambda_hat[:, 0]
        literal = "diverges" if ratio > start else "does not"
        ours = "diverges" if ratio > 1.0 else f"ends at {noise.biased_by_reference(1.0, ratio, 1.0):g}"
        growth = math.log(estimate[-1] / estimate[-201]) / (200 * DT_S)
        yield row(
            f"3. from {start:g} with n/r = {ratio:g}: by the paper's n g > lambda-hat kappa it {literal}",
            f"by n/r > 1 it {ours}",
            f"grows at {growth:.3f} 1/s" if growth > 0.1 else f"ends at {estimate[-1]:.4f}",
        )
    yield _fourth_remark(r, gamma, threshold=0.2)


def _fourth_remark(r: float, gamma: float, threshold: float) -> str:
    limit = 1.0 - 1.0 / threshold
    ratios = np.array([1.02 * limit, 0.98 * limit, 0.0, 0.0])
    loop = IdealLoop(IdealPlant(np.eye(4)), Tuning(gamma, 0.05, DT_S, threshold=threshold))
    failed = loop.fly(np.full((4000, 4), r), 1.0, r * ratios).failed[-1]
    return row(
        f"4. a large excursion towards zero flags a healthy actuator: threshold {threshold:g}",
        f"n/r = {ratios[0]:.2f}: flagged; {ratios[1]:.2f}: not",
        "; ".join("flagged" if flag else "not" for flag in failed[:2]),
    )
