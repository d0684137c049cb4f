"""Deviation of the estimates by noise, and false alarms: predicted, on the ideal plant, and flown, for `section4_noise`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from paper.ideal import IdealLoop, IdealPlant, Tuning
from paper.trimmed_law import TrimmedLaw, law_of
from prediction_errors import summary as worst_and_median
from scipy.signal import lfilter
from section4_flights import ALARMS, DT_S, SETTLED_S, at_speed, error, head, measured, over, row, with_values

from paper import noise
from testbed.gains.choice import LEAST_SHAPE
from testbed.gains.errors import ErrorSource, sources
from testbed.gains.false_alarms import POSITION, REFERENCE, false_alarm_rate

KINDS = {"tail": slice(0, 2), "propeller": slice(2, 4)}
WHITE = [(2.0, density, 18.0) for density in (0.02, 0.05, 0.1, 0.2, 0.3, 0.37, 0.45, 0.5, 0.55, 0.6, 0.8)] + [
    (8.0, 0.05, 18.0), (8.0, 0.15, 18.0), (2.0, 0.1, 20.0), (2.0, 0.3, 20.0),
]  # fmt: skip
"""gamma [1/s], density of the accelerometer [m/s2 per root hertz], airspeed [m/s]."""
GYRO = [(2.0, density, 18.0) for density in (0.003, 0.007, 0.015, 0.03, 0.06)] + [
    (8.0, 0.007, 18.0), (8.0, 0.02, 18.0), (2.0, 0.02, 20.0),
]  # fmt: skip
"""The same of the gyro [deg/s per root hertz]."""


def noise_points(quick: bool, seeds: int, jobs: int | None) -> list[dict[str, Any]]:
    """One point for each setting and kind of actuator: predicted, simulated and flown deviation."""
    settings = [("white", *one) for one in WHITE] + [("gyro", *one) for one in GYRO]
    settings = settings[::5] if quick else settings
    flights = [values_of(*one) for one in settings]
    found = []
    for (colour, gamma, density, airspeed), values, records in zip(
        settings, flights, measured(flights, seeds, jobs), strict=True
    ):
        law = law_of(with_values(values))
        errors = sources(with_values(values), law.state)
        impulses = [padded(law.error_response(source.channel.name)) for source in errors]
        variances = [
            source.deviation(law.newton_response(e, gamma), DT_S) ** 2
            for source, e in zip(errors, impulses, strict=True)
        ]
        predicted = np.sqrt(sum(variances))
        ideal = simulated(law, errors, gamma)
        flown = np.sqrt(np.square(over(records, "std")).mean(axis=0))
        for kind, of in KINDS.items():
            size = predicted[of].mean()
            nu = 1.0 / size**2
            found.append(
                {
                    "colour": colour, "gamma": gamma, "density": density, "airspeed": airspeed, "kind": kind, "nu": nu,
                    "axis": math.sqrt(nu * gamma / 2.0), "predicted": size, "ideal": ideal[of].mean(), "flown": flown[of].mean(),
                    "least_nu": float(1.0 / predicted.max() ** 2),
                    "level": f"{sum(bool(record['metrics']['level']) for record in records)}/{len(records)}",
                }
            )  # fmt: skip
    return found


def padded(response: np.ndarray, steps: int = 6000) -> np.ndarray:
    whole = np.zeros((steps, 4))
    whole[: len(response)] = response
    return whole


def simulated(
    law: TrimmedLaw, errors: Sequence[ErrorSource], gamma: float, steps: int = 200000
) -> np.ndarray:
    """[4] deviation of the flying law on the ideal plant with the aircraft's B and the same noise, at constant references."""
    rng = np.random.default_rng(1)
    disturbance = np.zeros((steps, 4))
    for source in errors:
        w = source.std * rng.normal(size=steps)
        response = law.error_response(source.channel.name)
        for i in range(4):
            disturbance[:, i] += lfilter(response[:, i], [1.0], w)
    plant = IdealPlant(np.array(law.model.B), airspeed=math.sqrt(law.pressure_ratio))
    # The ideal plant scales all columns with pressure; so the references of propellers are divided by it.
    reference = law.positions / np.where(law.model.servo, 1.0, law.pressure_ratio)
    tuning = Tuning(gamma, 0.05, DT_S, lambda_min=0.01, lambda_max=10.0)
    estimate = (
        IdealLoop(plant, tuning).fly(np.tile(reference, (steps, 1)), 1.0, disturbance).lambda_hat[2000:]
    )
    inverse = 1.0 / estimate
    return np.asarray(inverse.std(axis=0) / inverse.mean(axis=0) ** 2)


def draw_noise(points: Sequence[Mapping[str, Any]], path: Path) -> None:
    """Deviation over |a|/sqrt(s): prediction, ideal plant and JSBSim; one line for each gamma."""
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(1, 2, sharey=True)
    titles = {"white": "white noise (accelerometer)", "gyro": "differentiated gyro, and f of it"}
    for axes, (colour, title) in zip(panels, titles.items(), strict=True):
        chosen = [point for point in points if point["colour"] == colour]
        for gamma, shade in ((2.0, "0.0"), (8.0, "0.55")):
            of = [point for point in chosen if point["gamma"] == gamma]
            x = [point["axis"] for point in of]
            if not of:
                continue
            line = np.geomspace(min(x), max(x), 50)
            axes.loglog(
                line, np.sqrt(gamma / 2.0) / line, color=shade, label=rf"predicted, $\gamma$ = {gamma:g} 1/s"
            )
            axes.loglog(x, [p["ideal"] for p in of], "o", mfc="none", color=shade, label="ideal plant")
            axes.loglog(x, [p["flown"] for p in of], "x", color=shade, label="flown in JSBSim")
        axes.set_title(title)
        axes.set_xlabel(r"$|a| / \sqrt{s}$, position over noise [s$^{-1/2}$]")
        axes.grid(visible=True, which="both", color="0.9")
    panels[0].set_ylabel("standard deviation of the estimate [-]")
    panels[0].legend(fontsize=8)
    figure.savefig(path, dpi=150)


IN_TABLE = {
    "white": {(2.0, 0.02, 18.0), (2.0, 0.1, 18.0), (2.0, 0.3, 18.0), (2.0, 0.5, 18.0), (2.0, 0.55, 18.0), (2.0, 0.8, 18.0),
              (8.0, 0.15, 18.0), (2.0, 0.3, 20.0)},
    "gyro": {(2.0, 0.003, 18.0), (2.0, 0.06, 18.0), (8.0, 0.02, 18.0), (2.0, 0.02, 20.0)},
}  # fmt: skip
"""Gamma, density and airspeed of the rows of the table; the figure and the summary have all points."""


def noise_table(points: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    yield from head(
        "noise", "gamma [1/s]", "density", "airspeed [m/s]", "actuator", "nu", "predicted", "ideal plant", "error", "flown",
        "error", "kept its trim",
    )  # fmt: skip
    for p in points:
        if (p["gamma"], p["density"], p["airspeed"]) not in IN_TABLE[p["colour"]]:
            continue
        size, ideal, flown = p["predicted"], p["ideal"], p["flown"]
        yield row(
            p["colour"], p["gamma"], p["density"], p["airspeed"], p["kind"], p["nu"], size, ideal, error(ideal, size), flown,
            error(flown, size), p["level"],
        )  # fmt: skip


def values_of(colour: str, gamma: float, density: float, airspeed: float) -> dict[str, Any]:
    sensor, key = ("accelerometer", "noise_m_s2_rthz") if colour == "white" else ("gyro", "noise_deg_s_rthz")
    return {**at_speed(airspeed), "controller.gamma": gamma, f"sensors.{sensor}.{key}": density}


ALARM_NOISE = (0.37, 0.45)
"""Densities of the accelerometer [m/s2 per root hertz], gamma 2: nu of the propellers is 20 and 14."""


def alarm_rows(quick: bool, seeds: int, jobs: int | None) -> Iterator[str]:
    flights = [
        {**values_of("white", 2.0, density, 18.0), "duration_s": 400 if quick else 2000}
        for density in ALARM_NOISE
    ]
    yield from head(
        "nu", "threshold, persistence", "at constant r [1/s]", "flown [1/s]", "at constant position [1/s]"
    )
    for values, records in zip(flights, measured(flights, seeds, jobs), strict=True):
        law = law_of(with_values(values))
        s = float(law.model.B_inv[2, 3]) ** 2 * noise.one_sided_intensity(
            values["sensors.accelerometer.noise_m_s2_rthz"]
        )
        nu = float(noise.shape(law.positions[2], 2.0, s))
        seconds = (values["duration_s"] - SETTLED_S) * len(over(records, "std"))
        for which, (threshold, persistence_s) in ALARMS.items():
            rates = [
                false_alarm_rate(nu, 2.0, DT_S, persistence_s, threshold, held)
                for held in (REFERENCE, POSITION)
            ]
            count = over(records, f"alarms_{which}")[:, 2].sum()
            yield row(nu, which, rates[0], f"{count / seconds:.3g} ({count:.0f})", rates[1])


def summary(points: Sequence[Mapping[str, Any]]) -> str:
    """How far the deviations are off where every actuator of a flight has a nu of `LEAST_SHAPE` or more."""
    chosen = [p for p in points if p["least_nu"] >= LEAST_SHAPE]
    lines = [f"In flights whose actuators all have a nu of {LEAST_SHAPE:g} or more:", ""]
    pairs = {
        f"deviation, {'ideal plant' if name == 'ideal' else 'flown'}": [
            (p["predicted"], p[name]) for p in chosen
        ]
        for name in ("ideal", "flown")
    }
    return "\n".join([*lines, *worst_and_median(pairs)])
