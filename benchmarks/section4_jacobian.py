"""The last term of (38) in flight, and the paper's fourth remark after (32), for `section4_noise`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from linear_loop import rotor_inertia
from paper.trimmed_law import law_of
from section4_flights import DT_S, NAMES, error, head, row, with_values

from testbed import fly
from testbed.flight.flight import Flight

WRONG = {
    "Cm_alpha": ("q_dot", "alpha"), "Cl_beta": ("p_dot", "beta"), "Cl_p": ("p_dot", "p"), "Cn_beta": ("r_dot", "beta"),
}  # fmt: skip
"""Coefficients of the model that are wrong, each with its rate and the state that it multiplies."""
FACTORS = (0.5, 1.2)
STEPS = [
    {"at_s": 0, "altitude_m": 300, "airspeed_m_s": 18, "heading_deg": 90},
    {"at_s": 5, "altitude_m": 303, "heading_deg": 95},
]
SLOWLY = {"command_rates": {"heading_deg_s": 2, "altitude_m_s": 1}, "duration_s": 25}
AVERAGED_S = 0.5
ROWS, STATES = ("p_dot", "q_dot", "r_dot"), ("alpha", "beta", "p", "q", "r")


def jacobian() -> Iterator[str]:
    """Flights with a wrong model and estimates that stay at the truth: of (38) the last term alone is left."""
    yield from head(
        "coefficient",
        "times",
        "rate",
        "rms of e: predicted [rad/s2]",
        "flown",
        "error",
        "rms difference over rms",
    )
    for name, (rate, _) in WRONG.items():
        for factor in FACTORS:
            predicted, measured = changes_of_e(flown(name, factor), name, factor)
            sizes = [float(np.sqrt(np.square(x).mean())) for x in (predicted, measured)]
            apart = float(np.sqrt(np.square(measured - predicted).mean())) / sizes[0]
            yield row(name, factor, rate, *sizes, error(sizes[1], sizes[0]), f"{100.0 * apart:.1f} %")


def flown(name: str, factor: float) -> Flight:
    controller = {"type": "fixed_inversion", "released": [], "model_error": {name: factor}}
    return fly(with_values({"controller": controller, "commands": STEPS, **SLOWLY}))


def changes_of_e(flight: Flight, name: str, factor: float) -> tuple[np.ndarray, np.ndarray]:
    """[k] the integral of the last term of (38) along the flight, and the change of e (10) in it; both averaged alike."""
    level = with_values({"controller": {"type": "adaptive_inversion", "preset": "paper"}})
    correct = law_of(level).setup.model
    log = flight.log
    x = {each: np.radians(log[f"{each}_deg{'_s' if each in 'pqr' else ''}"].to_numpy()) for each in STATES}
    x |= {each: np.radians(log[f"{each}_deg"].to_numpy()) for each in ("roll", "pitch")}
    x["airspeed"] = log.airspeed_m_s.to_numpy()
    kinds = zip(NAMES, correct.kinds, strict=True)
    units = [np.radians(log[f"{n}_position"]) if k == "servo" else log[f"{n}_position"] for n, k in kinds]
    rate, state = WRONG[name]
    i, j = ROWS.index(rate), STATES.index(state)
    positions = np.column_stack(units)
    model = correct.with_error({name: factor})
    torque = np.gradient(positions, DT_S, axis=0) * rotor_inertia(correct)  # which accelerates the rotors
    modelled = model.rates(x, positions, np.ones(len(units))) + torque @ np.array(model.torque_matrix).T
    e = np.radians(log[f"{rate}_deg_s2"].to_numpy()) - modelled[:, i]
    speed = x["airspeed"] / correct.airspeed_m_s
    slope = correct.derivatives[i][j] * (1.0 - factor) * (speed if state in "pqr" else speed**2)
    rate_of_change = np.gradient(x[state], DT_S) * slope
    return _averaged(np.cumsum(rate_of_change) * DT_S), _averaged(e - e[0])


def _averaged(x: np.ndarray) -> np.ndarray:
    width = round(AVERAGED_S / DT_S)
    found: np.ndarray = np.convolve(x, np.full(width, 1.0 / width), "valid")[1000:]
    return found


THRESHOLD = 0.7
SHARES = (0.95, 1.05)


def remark_4() -> Iterator[str]:
    """Healthy propellers in JSBSim whose estimates a bias of the accelerometer takes towards zero: flagged where predicted?"""
    yield from head("accelerometer bias [m/s2]", "n/a of the propellers", "predicted", "flown")
    unit = _n_over_a(1.0)
    for share in SHARES:
        limit = THRESHOLD - 1.0  # n/a < lambda_thr - lambda at a held position
        bias = share * limit / unit
        flight = fly(with_values(_biased(bias)))
        flags = [event for event in flight.events if event["kind"] in ("detection", "false_alarm")]
        words = f"flagged at {flags[0]['time_s']:.2f} s" if flags else "not flagged"
        yield row(f"{bias:+.3f}", f"{share * limit:+.3f}", "flagged" if share > 1.0 else "not flagged", words)


def _n_over_a(bias: float) -> float:
    scenario = with_values(_biased(bias))
    return float(law_of(scenario).bias(scenario)[2])


def _biased(bias: float) -> dict[str, Any]:
    return {
        "sensors.accelerometer.bias_m_s2": bias,
        "controller.threshold": THRESHOLD,
        "controller.recovery": 0.5 * (1.0 + THRESHOLD),
        "controller.ablate": ["jam_test", "speed_rule"],
        "duration_s": 60,
    }
