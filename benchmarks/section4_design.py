"""Gains of `testbed design`, pasted into scenarios and flown, for `section4_noise`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from flights import Record
from prediction_errors import summary
from section4_flights import head, measured, row, with_values

from testbed import design
from testbed.gains.design import Design

EVERY = {
    "accelerometer": {"noise_m_s2_rthz": 0.1},
    "gyro": {"noise_deg_s_rthz": 0.01},
    "alpha": {"noise_deg_rthz": 0.03},
    "beta": {"noise_deg_rthz": 0.01},
}
DESIGNS: list[tuple[str, str, dict[str, Any], float]] = [
    ("paper", "accelerometer 0.3 m/s2/rtHz", {"sensors.accelerometer.noise_m_s2_rthz": 0.3}, 0.1),
    ("paper", "accelerometer 0.3 m/s2/rtHz", {"sensors.accelerometer.noise_m_s2_rthz": 0.3}, 0.2),
    ("paper", "gyro 0.03 deg/s/rtHz", {"sensors.gyro.noise_deg_s_rthz": 0.03}, 0.02),
    ("paper", "alpha 0.03 deg/rtHz", {"sensors.alpha.noise_deg_rthz": 0.03}, 0.02),
    ("paper", "all of these", {"sensors": EVERY}, 0.05),
    ("paper", "JSBSim's turbulence, W20 1 m/s", {"atmosphere.turbulence_w20_m_s": 1.0}, 0.1),
    ("paper", "Dryden turbulence, W20 1 m/s", {"atmosphere.turbulence_w20_m_s": 1.0, "atmosphere.model": "dryden_8785c"}, 0.1),
    ("default", "accelerometer 0.3 m/s2/rtHz", {"sensors.accelerometer.noise_m_s2_rthz": 0.3}, 0.05),
    ("default", "alpha 0.1 deg/rtHz", {"sensors.alpha.noise_deg_rthz": 0.1}, 0.02),
    ("default", "JSBSim's turbulence, W20 3 m/s", {"atmosphere.turbulence_w20_m_s": 3.0}, 0.05),
    ("default", "Dryden turbulence, W20 3 m/s", {"atmosphere.turbulence_w20_m_s": 3.0, "atmosphere.model": "dryden_8785c"}, 0.05),
]  # fmt: skip
"""Law, errors in words and as settings, tolerated deviation."""
FAILED_S, MEASURED_S = 80.0, 200.0
"""Time of the failures; length of the flights in which deviations are measured, from `LATE_S` on."""
LOSSES = [(actuator, left) for actuator in ("left_ruddervator", "left_propeller") for left in (0.5, 0.0)]


def design_rows(quick: bool, seeds: int, jobs: int | None) -> Iterator[str]:
    """Design, paste, fly healthy, and with each kind of actuator at half and lost; compare with the predictions."""
    yield from head(
        "law", "errors", "tolerated", "gain", "actuator", "deviation: predicted", "flown", "converges: predicted [s]",
        "flown [s]", "flagged: predicted [s]", "range", "flown [s]",
    )  # fmt: skip
    cases, flights = [], []
    for law, words, values, tolerated in DESIGNS[::3] if quick else DESIGNS:
        plain = {"type": "adaptive_inversion", **({"preset": "paper"} if law == "paper" else {})}
        found = design(with_values({"controller": plain, **values}), deviation=tolerated)
        cases.append((law, words, tolerated, found))
        block = dict(found.controller)
        flights += [
            {**values, "controller": block, "failures": [loss(*each, FAILED_S)], "duration_s": FAILED_S + 25}
            for each in LOSSES
        ]
        wide = {"lambda_min": 0.01, "lambda_max": 10.0} if law == "paper" else {}
        until = MEASURED_S + 0.1  # the loss only ends what is measured
        healthy = {"failures": [loss(*LOSSES[0], MEASURED_S)], "duration_s": until}
        flights.append({**values, "controller": {**block, **wide}, **healthy})
    records = measured(flights, seeds, jobs)
    each = len(LOSSES) + 1
    pairs: dict[str, list[tuple[float, float]]] = {}
    for k, case in enumerate(cases):
        yield from _design_rows(*case, records[each * k : each * (k + 1)], pairs)
    yield ""
    yield from summary(pairs)


def loss(actuator: str, left: float, at_s: float) -> dict[str, Any]:
    return {"type": "effectiveness", "actuator": actuator, "at_s": at_s, "value": left}


def _design_rows(
    law: str,
    words: str,
    tolerated: float,
    found: Design,
    flown: Sequence[Sequence[Record]],
    pairs: dict[str, list[tuple[float, float]]],
) -> Iterator[str]:
    """Two rows, with their predictions and measurements added to `pairs`."""
    gains = found.controller.get("gamma", {"every": found.controller.get("process_noise_per_root_s")})
    every = [record["metrics"] for record in flown[-1]]
    for kind, i, of in (("tail", 0, flown[:2]), ("propeller", 2, flown[2:4])):
        one = found.actuators[i]
        std = math.sqrt(float(np.mean([m[f"std_{j}"] ** 2 for m in every for j in (i, i + 1)])))
        converged = float(np.median([record["metrics"]["converged_s"] for record in of[0]]))
        delays = [math.inf if math.isnan(x := record["metrics"]["flagged_s"]) else x for record in of[1]]
        delay = float(np.median(delays))
        gain = gains.get("servo" if kind == "tail" else "motor", gains.get("every"))
        share = f"{seconds(delay)} ({np.isfinite(delays).sum()}/{len(delays)})"
        spread = f"{seconds(one.soonest_s)} to {seconds(one.latest_s)}"
        for name, pair in (
            ("deviation", (one.noise, std)),
            ("convergence", (one.convergence_s, converged)),
            ("time to the flag", (one.detection_s, delay)),
        ):
            pairs.setdefault(f"{name}, {law}", []).append(pair)
        yield row(
            law, words, tolerated, gain, kind, one.noise, std, one.convergence_s, converged,
            seconds(one.detection_s), spread, share,
        )  # fmt: skip


def seconds(time: float) -> str:
    return f"{time:.3g}" if math.isfinite(time) else "never"
