"""A design model from logs of healthy flight: factors on the coefficients of an aircraft's own model, and the functions of its XML
that make a coefficient.

By equation error, the rates that the model leaves are regressed on what each coefficient adds to them, with white errors (Klein
and Morelli, Aircraft System Identification, 2006, chapter 5). By `output_error`, the turning rates are simulated. A factor of 1 is
the aircraft's own model. Coefficients that are zero stay so.

`smoothed_vanes` takes the noise away that would make factors of both too small. What no filter gives back are commands that the
log has not: a law answers the noise of its gyros in each of its steps, and of a log with every second one equation error makes half
of a factor.

Functions are read in JSBSim while the airframe is held at its trim and one state or actuator is a step to either side, as in
`plant.identification`: what a function adds to the axis then is its part of the coefficient.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from scipy.signal import lfilter

from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.model_files.used import ModelFiles
from testbed.common.signals import RATES
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.setup import Setup
from testbed.logs import output_error
from testbed.logs.flight_log import FlightLog, bad
from testbed.logs.regression import BIN_S, Row, Rows, noise_of, rows_of, settled, smoothed_vanes
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import settle_at
from testbed.plant.thrust_stand import changed, stand_physics_hz
from testbed.plant.trim import Trim, command_steps, trim

LEAST_SHARE = 0.1
"""Of a coefficient, below which a function is not named."""
REST = "thrust and lever arms"
"""What no function of the axis makes: engines, external reactions, and forces that act beside the centre of gravity."""
_STATES = {"alpha": 0.005, "beta": 0.005, "p": 0.01, "q": 0.01, "r": 0.01}  # rad, rad/s
_STEPS = {"servo": 0.005, "motor": 0.01, "engine": 0.05}  # rad or throttle
_TOTALS = {"Cl": "moments/l-total-lbsft", "Cm": "moments/m-total-lbsft", "Cn": "moments/n-total-lbsft",
           "CX": "forces/fbx-total-lbs"}  # fmt: skip
_AXES = {"Cl": ("ROLL",), "Cm": ("PITCH",), "Cn": ("YAW",), "CX": ("LIFT", "DRAG", "AXIAL", "X")}


class Maker(NamedTuple):
    """A function of the XML, its axis, and its share of a coefficient's size, 0 to 1."""

    function: str
    axis: str
    share: float

    def __str__(self) -> str:
        where = f"{self.function} ({self.axis})" if self.axis else self.function
        return f"{where} {100 * self.share:.0f} %"


def makers(aircraft: Aircraft, names: Iterable[str]) -> dict[str, tuple[Maker, ...]]:
    """Of each coefficient, such as `Cm_alpha` or `Cn_rudder`, the functions that make it, those with the largest part first.

    Raises BadInput where the aircraft cannot be trimmed at its reference.
    """
    wanted = list(names)
    if not wanted:
        return {}
    plant, at = Plant(aircraft, stand_physics_hz(aircraft)), aircraft.reference
    level = trim(plant, at.airspeed_m_s, at.altitude_m)
    functions = {axis: _functions(aircraft, axis) for axes in _AXES.values() for axis in axes}
    return {name: _of(plant, level, functions, *name.split("_", 1)) for name in wanted}


def _functions(aircraft: Aircraft, axis: str) -> list[str]:
    """Names of the functions of an axis; one without a name is no property, and counts as REST."""
    files = ModelFiles(aircraft.folder, aircraft.model)
    section = files.section("aerodynamics")
    axes = [] if section is None else files.children(section, "axis")
    found = [f for each in axes if each.attributes.get("name") == axis for f in each.all("function")]
    return [f.attributes["name"] for f in found if "name" in f.attributes]


def _of(
    plant: Plant, level: Trim, functions: Mapping[str, list[str]], symbol: str, moved: str
) -> tuple[Maker, ...]:
    sides, actuators = list[dict[tuple[str, str], float]](), list(plant.aircraft.actuators)
    state, commands = {"p": 0.0, "q": 0.0, "r": 0.0, **level.state}, level.commands
    if moved in _STATES:
        cases = [({**state, moved: state[moved] + sign * _STATES[moved]}, commands) for sign in (1.0, -1.0)]
    else:
        i, actuator = actuators.index(moved), plant.aircraft.actuators[moved]
        steps = command_steps(actuator, commands[i], _STEPS[actuator.kind])
        cases = [(state, tuple(changed(commands, i, step))) for step in steps]
    for held, given in cases:
        settle_at(plant, held, given)
        sides.append(_read(plant, functions, symbol, held["alpha"]))
    parts = {key: abs(sides[0][key] - sides[1][key]) for key in sides[0]}
    size = sum(parts.values()) or math.inf
    made = [Maker(*key, part / size) for key, part in parts.items() if part >= LEAST_SHARE * size]
    return tuple(sorted(made, key=lambda each: -each.share))


def _read(
    plant: Plant, functions: Mapping[str, list[str]], symbol: str, alpha: float
) -> dict[tuple[str, str], float]:
    """{(function, axis): what it adds to the coefficient's force [lbf] or moment [lbf ft]} in body axes."""
    turned = {"LIFT": math.sin(alpha), "DRAG": -math.cos(alpha), "AXIAL": -1.0}
    made = {
        (name, axis): turned.get(axis, 1.0) * plant[name]
        for axis in _AXES[symbol]
        for name in functions[axis]
    }
    return made | {(REST, ""): plant[_TOTALS[symbol]] - sum(made.values())}


KEPT_BACK = 0.3
"""Share of each log, at its end, that is not used but to validate."""
LARGEST_STD = 0.3
"""Standard deviation of a factor beyond which the coefficient is not identifiable from these logs."""
COLLINEAR = 10.0
"""Inflation of a factor's variance by the others from which on they cannot be told apart."""
WINDOW_S = 10.0
_ROUNDS, _LAGS = 2, 20


@dataclass(frozen=True)
class Factor:
    """What logs say of a coefficient.

    Attributes:
        value, std: factor on the model's value by equation error, and its standard deviation.
        simulated, simulated_std: by output error; NaN of u_dot's coefficients, and where there is no stretch to simulate.
        inflation: of its variance by the other coefficients.
        alike, correlation: the coefficient of the same rate whose factor goes most with it, and how much, by equation error.
        known: whether it is identifiable; else it is kept.
        log, from_s: when the 10 s were that told most.
        rate: of RATES, whose coefficient it is.
    """

    name: str
    value: float
    std: float
    simulated: float
    simulated_std: float
    inflation: float
    alike: str
    correlation: float
    known: bool
    log: int
    from_s: float
    rate: str

    @property
    def taken(self) -> float:
        """The factor that the model gets: that by output error where there is one, and 1 where nothing can be known."""
        if not self.known:
            return 1.0
        return self.simulated if np.isfinite(self.simulated) else self.value

    @property
    def contradicted(self) -> bool:
        """Whether both methods put the aircraft's own value beyond two standard deviations, on the same side.

        How far they are apart counts as a deviation too: noise and gusts bias each in its own way. Where there is one method alone,
        as of u_dot, nothing is contradicted: noise of angle of attack made a right `CX_alpha` 0.9 of what it is.
        """
        apart = self.simulated - self.value
        each = ((self.value, self.std), (self.simulated, self.simulated_std))
        sides = {np.sign(v - 1.0) * (abs(v - 1.0) > 2.0 * np.hypot(std, apart)) for v, std in each}
        return self.known and sides in ({1.0}, {-1.0})


@dataclass(frozen=True)
class Validation:
    """Of a rate, on the part of the logs that was not used.

    Without what is constant: `fit` is 1 - rms error / rms, before and after; `theil` Theil's inequality coefficient, 0 perfect and
    1 worst; `correlations` are the residual's first 20, and `coloured` the share of them that is beyond `white`, which white noise
    exceeds in 5 %. `simulated` and `simulated_before` are the fits of p, q or r itself, simulated for 5 s; NaN of u. `measured` and
    `predicted` [bins] are what is compared, at the times `time_s`, the logs one after another.
    """

    rate: str
    fit_before: float
    fit: float
    theil: float
    coloured: float
    simulated_before: float
    simulated: float
    time_s: np.ndarray
    measured: np.ndarray
    predicted: np.ndarray
    correlations: np.ndarray
    white: float


@dataclass(frozen=True)
class Identified:
    """A design model from logs, and how far it can be believed.

    `covariances` [factors, factors] are those by equation error, of each rate, in the order of `factors`; `output` is output error.
    `makers` are the functions of the XML that make what the logs contradict, by name; `remarks` sentences about the logs.
    """

    model: DesignModel
    factors: tuple[Factor, ...]
    validation: tuple[Validation, ...]
    covariances: Mapping[str, np.ndarray]
    output: output_error.Output
    makers: Mapping[str, tuple[Maker, ...]] = field(default_factory=dict)
    remarks: tuple[str, ...] = ()


def identified(logs: Sequence[FlightLog], setup: Setup) -> Identified:
    """The design model that logs of healthy flight give, from that of `setup`, whose trim and condition it keeps."""
    logs = [smoothed_vanes(log) for log in logs]
    rows = rows_of(logs, setup, BIN_S)
    used = rows.known & np.concatenate([np.arange(n) < (1.0 - KEPT_BACK) * n for n in np.bincount(rows.log)])
    c = settings_record(setup, AdaptiveInversionSettings())[0]
    fits = {
        i: _fitted(row, used, float(c.model_error_std[i]), 1.0 / c.model_error_rate)
        for i, row in enumerate(rows.rates) if np.any(row.measured)
    }  # fmt: skip
    if still := [RATES[number] for number in (0, 1, 2) if number not in fits]:
        what = f"nothing moves in {', '.join(still)}, so nothing can be identified"
        raise bad(what, logs[0].name, expected="a log of manoeuvres")
    free = {
        name: bool(x) for i in (0, 1, 2) for name, x in zip(rows.rates[i].names, fits[i].known, strict=True)
    }
    output = output_error.identified(logs, setup, free, KEPT_BACK)
    factors: list[Factor] = []
    validation: list[Validation] = []
    bias = np.array(setup.model.bias)
    for number, fit in fits.items():
        row = rows.rates[number]
        own = [_factor(row, i, fit, output, rows) for i in range(len(row.names))]
        constant = output.constants.get(number, fit.constant)
        bias[number] += constant
        change = np.append([each.taken - 1.0 for each in own], constant)
        simulated = output.fits.get(number, (np.nan, np.nan))
        validation.append(_validated(row, change, rows.known & ~used, simulated))
        factors += own
    model = setup.model.with_error({each.name: each.taken for each in factors})
    model = replace(model, bias=tuple(map(float, bias)))
    covariances = {RATES[i]: fit.covariance for i, fit in fits.items()}
    return Identified(model, tuple(factors), tuple(validation), covariances, output)


@dataclass(frozen=True)
class _Fit:
    """Of a rate, by equation error: factors, their covariance and inflations, which are identifiable, the constant, and [bins,
    names + 1] white columns where they are used."""

    value: np.ndarray
    covariance: np.ndarray
    inflation: np.ndarray
    known: np.ndarray
    constant: float
    white: np.ndarray


def _fitted(row: Row, used: np.ndarray, model_std: float, model_time_s: float) -> _Fit:
    count = len(row.names)
    free, change = np.ones(count + 1, dtype=bool), np.zeros(count + 1)
    for _ in range(_ROUNDS):
        errors = (row.left - row.columns @ change)[:, None]
        noise = noise_of(errors, used, np.array([model_std]), model_time_s, BIN_S)
        at = settled(used)
        columns = (lfilter(noise.filters[0], [1.0], row.columns, axis=0) * noise.mixing[0, 0])[at]
        left = (lfilter(noise.filters[0], [1.0], row.left) * noise.mixing[0, 0])[at]
        information = columns.T @ columns + 1e-12 * np.eye(count + 1)
        covariance = np.linalg.inv(information)
        std = np.sqrt(np.diagonal(covariance))
        free[:count] = std[:count] < LARGEST_STD
        change = np.zeros(count + 1)
        change[free] = np.linalg.lstsq(columns[:, free], left, rcond=None)[0]
    inflation = np.diagonal(covariance) * np.diagonal(information)
    white = np.zeros_like(row.columns)
    white[at] = columns
    own = covariance[:count, :count]
    return _Fit(1.0 + change[:count], own, inflation[:count], free[:count], float(change[count]), white)


def _factor(row: Row, i: int, fit: _Fit, output: output_error.Output, rows: Rows) -> Factor:
    told = np.convolve(fit.white[:, i] ** 2, np.ones(round(WINDOW_S / BIN_S)), "valid")
    best = int(np.argmax(told)) if len(told) else 0
    value, inflation = float(fit.value[i]), float(fit.inflation[i])
    stds = np.sqrt(np.diagonal(fit.covariance))
    correlations = fit.covariance[i] / (stds[i] * stds)
    alike = max((j for j in range(len(stds)) if j != i), key=lambda j: abs(correlations[j]), default=i)
    simulated = output.factors.get(row.names[i], (np.nan, np.nan))
    known = bool(fit.known[i]) and not simulated[1] > LARGEST_STD
    return Factor(
        row.names[i], value, float(stds[i]), *simulated, inflation, row.names[alike], float(correlations[alike]), known,
        int(rows.log[best]), float(rows.time_s[best]), row.rate,
    )  # fmt: skip


def _validated(row: Row, change: np.ndarray, kept: np.ndarray, simulated: tuple[float, float]) -> Validation:
    signals = (row.measured[kept], row.left[kept], row.left[kept] - row.columns[kept] @ change)
    measured, before, after = (each - each.mean() for each in signals)
    spread = float(np.sqrt(np.mean(measured**2))) + 1e-12
    sizes = [float(np.sqrt(np.mean(each**2))) for each in (before, after, measured, measured - after)]
    centred = after - after.mean()
    correlations = np.array(
        [centred[lag:] @ centred[:-lag] / (centred @ centred) for lag in range(1, _LAGS + 1)]
    )
    white = 1.96 / float(np.sqrt(len(after)))
    theil = sizes[1] / (sizes[2] + sizes[3] + 1e-12)
    fits = (1.0 - sizes[0] / spread, 1.0 - sizes[1] / spread)
    coloured = float(np.mean(np.abs(correlations) > white))
    return Validation(
        row.rate, *fits, theil, coloured, *simulated,
        BIN_S * np.flatnonzero(kept), measured, measured - after, correlations, white,
    )  # fmt: skip
