"""The design model: what the controller believes of the aircraft, f_m and B_m of equation (2).

It is identified before flight (`testbed.plant.identification`) and stored beside the aircraft as JSON that anybody can read.
It never reads the truth in flight. A scenario may set an error of its coefficients: section 4 of the paper is about that error.

The state function is made of the usual stability derivatives about one level trim (alpha_0, V_0):

    x_dot = s (bias + A_alpha (alpha - alpha_0) + A_beta beta + c |beta|) + (V/V_0) (A_p p + A_q q + A_r r) + G (p^2, .., q r)
            + k(x) + B u

with s = (V/V_0)^2, the ratio of dynamic pressures, and k(x) the terms of gravity and of the rotation of the body axes. The
rows are p_dot, q_dot, r_dot, u_dot (x_c, controlled), then v_dot, w_dot (x_u, not controlled). In B u, the columns of surfaces
are multiplied by s. c is zero, but for models whose drag or moments go with the size of sideslip. G has the gyroscopic moments:
Euler's -J^-1 (w x J w), which do not go with airspeed.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np

from testbed.aircraft.propulsors import EngineMap, Propulsor
from testbed.common.units import GRAVITY_M_S2
from testbed.common.writing import write
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import read_json

ROWS = ("p_dot", "q_dot", "r_dot", "u_dot", "v_dot", "w_dot")
DESIGN_MODEL = "design_model.json"
"""Where the model is stored, in the aircraft's folder."""
_EXPECTED = "what `testbed identify` writes"
COLUMNS = ("alpha", "beta", "p", "q", "r")
PRODUCTS = (("p", "p"), ("q", "q"), ("r", "r"), ("p", "q"), ("p", "r"), ("q", "r"))
"""Columns of the gyroscopic moments: two rates of rotation each."""
NOT_GYROSCOPIC = ((0.0,) * len(PRODUCTS),) * 3
_SYMBOLS = {"p_dot": "Cl", "q_dot": "Cm", "r_dot": "Cn", "u_dot": "CX", "v_dot": "CY", "w_dot": "CZ"}

_KINDS = ("servo", "motor", "engine")
_POSITIVE = ("airspeed_m_s", "density_kg_m3", "span_m")
_LARGEST = 1e12
"""No number of an identified aircraft comes near it; beyond, products overflow."""

Vector = Sequence[float] | np.ndarray


def coefficient_names(actuators: Iterable[str]) -> list[str]:
    """Names of the coefficients of the design model of an aircraft with these actuators."""
    return [f"{_SYMBOLS[row]}_{name}" for row in ROWS for name in (*COLUMNS, *actuators)]


@dataclass(frozen=True)
class DesignModel:
    """f_m and B_m about one level trim.

    Attributes:
        airspeed_m_s, altitude_m, alpha_rad, density_kg_m3: the reference condition.
        actuators: names, in the order of the columns of `input_matrix`.
        kinds: [n] `servo`, `motor` or `engine`.
        trim: [n] actuator positions at the reference trim [rad or N].
        bias: [6] rates at the reference condition without actuators and without gravity, by `ROWS`.
        derivatives: [6, 5] by `COLUMNS`.
        input_matrix: [6, n] B_m: rates per rad or N, with rotors at steady speed.
        torque_matrix: [6, n] rates per N m of motor torque (zero for others): the airframe feels the motor's
            torque at once, but the thrust with the rotor's lag.
        offset_matrix: [6, n] rates that a healthy propeller adds to B u, because its torque has a part that does not vary with
            thrust.
        propulsors: [n] motor and propeller, or engine; None for servos.
        identified_from: fingerprint of the aircraft's files.
        stall_alpha_rad: angle of attack at which the slope of the lift has fallen to half of that at the trim.
        span_m: wing span; None if it is not known.
        sideslip: [6] c: rates per rad of |beta|, by `ROWS`.
        gyroscopic: [3, 6] G: p_dot, q_dot and r_dot by products of rates of rotation, by `PRODUCTS` [1].
    """

    airspeed_m_s: float
    altitude_m: float
    alpha_rad: float
    density_kg_m3: float
    actuators: tuple[str, ...]
    kinds: tuple[str, ...]
    trim: tuple[float, ...]
    bias: tuple[float, ...]
    derivatives: tuple[tuple[float, ...], ...]
    input_matrix: tuple[tuple[float, ...], ...]
    torque_matrix: tuple[tuple[float, ...], ...]
    offset_matrix: tuple[tuple[float, ...], ...]
    propulsors: tuple[Propulsor | EngineMap | None, ...]
    identified_from: str = ""
    stall_alpha_rad: float = 0.6
    span_m: float | None = None
    sideslip: tuple[float, ...] = (0.0,) * len(ROWS)
    gyroscopic: tuple[tuple[float, ...], ...] = NOT_GYROSCOPIC

    def coefficient_names(self) -> list[str]:
        """Names that `with_error` scales: `Cm_alpha`, `Cm_q`, and `Cn_NAME` of an actuator NAME."""
        return coefficient_names(self.actuators)

    def with_error(self, factors: Mapping[str, float]) -> DesignModel:
        """The model with some coefficients multiplied by these factors: the controller's model error (sections 4.2, 4.3).

        `bias` is changed so that the reference trim is a trim of the new model too.
        """
        names = (*COLUMNS, *self.actuators)
        factor = np.array([[factors.get(f"{_SYMBOLS[row]}_{name}", 1.0) for name in names] for row in ROWS])
        of_state, of_actuator = np.split(factor, [len(COLUMNS)], axis=1)
        inputs, offsets = (np.array(each) * of_actuator for each in (self.input_matrix, self.offset_matrix))
        bias = np.array(self.bias) + (np.array(self.input_matrix) - inputs) @ np.array(self.trim)
        bias += (np.array(self.offset_matrix) - offsets).sum(axis=1)
        return replace(
            self,
            derivatives=rows_of(self.derivatives * of_state),
            input_matrix=rows_of(inputs),
            torque_matrix=rows_of(self.torque_matrix * of_actuator),
            offset_matrix=rows_of(offsets),
            bias=tuple(map(float, bias)),
            sideslip=tuple(map(float, self.sideslip * of_state[:, COLUMNS.index("beta")])),
        )

    def rates(self, x: Mapping[str, float | np.ndarray], u: Vector, effectiveness: Vector) -> np.ndarray:
        """[..., 6] rates by `ROWS` that the model predicts [rad/s2, m/s2].

        Args:
            x: airspeed, alpha, beta, p, q, r, roll, pitch [m/s, rad, rad/s], each a number or [...] numbers.
            u: [..., n] actuator positions [rad or N].
            effectiveness: [n] of each actuator, 1 healthy, 0 lost.
        """
        bias, a, sideslip, gyroscopic, inputs, offsets, servo = self._arrays
        speed = np.asarray(x["airspeed"])[..., None] / self.airspeed_m_s
        pressure = speed * speed
        angles = np.stack([x["alpha"] - self.alpha_rad, x["beta"]], axis=-1)  # type: ignore[arg-type]
        turning = np.stack([x["p"], x["q"], x["r"]], axis=-1)  # type: ignore[arg-type]
        even = np.abs(x["beta"])[..., None] * sideslip
        rates = pressure * (bias + angles @ a[:, :2].T + even) + speed * (turning @ a[:, 2:].T)
        products = np.stack([x[one] * x[other] for one, other in PRODUCTS], axis=-1)  # type: ignore[call-overload]
        rates[..., :3] += products @ gyroscopic.T
        lam = np.asarray(effectiveness, dtype=float)
        acting = np.where(servo, pressure, 1.0) * lam * np.asarray(u)
        return np.asarray(rates + kinematics(x) + acting @ inputs.T + offsets @ lam)

    @property
    def angle_slopes(self) -> np.ndarray:
        """[6, 3] rates per rad of alpha, of beta and of |beta|, by `ROWS`."""
        slopes = np.array(self.derivatives)[:, [COLUMNS.index("alpha"), COLUMNS.index("beta")]]
        return np.column_stack([slopes, self.sideslip])

    @cached_property
    def _arrays(self) -> tuple[np.ndarray, ...]:
        """What `rates` multiplies, and which actuators are servos, as arrays made once."""
        of_state = (self.bias, self.derivatives, self.sideslip, self.gyroscopic)
        of_actuators = (self.input_matrix, self.offset_matrix)
        return (*map(np.array, of_state + of_actuators), np.array([kind == "servo" for kind in self.kinds]))

    def agrees_with(self, other: DesignModel, tolerance: float = 1e-9) -> bool:
        """Whether the two are the same but for rounding: each number within `tolerance`, relative or absolute."""
        return _close(asdict(self), asdict(other), tolerance)

    def save(self, path: Path) -> None:
        """Write as JSON, completely or not at all."""
        write(path, json.dumps(asdict(self), indent=1) + "\n")


def load_design_model(path: Path) -> DesignModel:
    """Read a file that `DesignModel.save` wrote; raises BadInput when it is anything else."""
    try:
        return _from_tree(read_json(path, _EXPECTED))
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        what = f"is no design model: {_words(error)}"
        raise BadInput([Problem(what, str(path), expected=_EXPECTED)]) from None


def _words(error: Exception) -> str:
    """What an exception says; the names of missing and unknown keys are said with the exception's own."""
    return str(error) if type(error) is ValueError else repr(error)


def _from_tree(data: dict[str, Any]) -> DesignModel:
    fields = _frozen(data)
    made = [p and (EngineMap if "throttles" in p else Propulsor)(**p) for p in fields["propulsors"]]
    model = DesignModel(**{**fields, "propulsors": tuple(made)})
    try:
        wrong = next(_impossible(model), "")
    except OverflowError:  # JSON has whole numbers that no float can be
        wrong = f"has a number beyond {_LARGEST:g}"
    if wrong:
        raise ValueError(wrong)
    return model


def _frozen(value: Any) -> Any:
    """What JSON holds, with tuples for its lists."""
    if isinstance(value, dict):
        return {key: _frozen(each) for key, each in value.items()}
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


def _impossible(model: DesignModel) -> Iterator[str]:
    """What no identification writes: numbers that are not finite or too large, kinds that there are not, arrays of other shapes."""
    n = len(model.actuators)
    shapes = {
        "trim": (n,), "bias": (len(ROWS),), "sideslip": (len(ROWS),), "derivatives": (len(ROWS), len(COLUMNS)),
        "gyroscopic": (3, len(PRODUCTS)),
        "input_matrix": (len(ROWS), n), "torque_matrix": (len(ROWS), n), "offset_matrix": (len(ROWS), n),
        "airspeed_m_s": (), "altitude_m": (), "alpha_rad": (), "density_kg_m3": (), "stall_alpha_rad": (),
        **({} if model.span_m is None else {"span_m": ()}),
    }  # fmt: skip
    yield from _no_arrays(model, shapes)
    for name in _POSITIVE:
        if (value := getattr(model, name)) is not None and value <= 0.0:
            yield f"{name} is not positive"
    if not isinstance(model.identified_from, str):
        yield "identified_from is no text"
    if unknown := [kind for kind in model.kinds if kind not in _KINDS]:
        yield f"kinds has {unknown[0]!r}, expected {', '.join(_KINDS)}"
    if len(model.kinds) != n or len(model.propulsors) != n:
        yield f"kinds and propulsors must have {n} entries"
    for i, propulsor in enumerate(model.propulsors):
        if propulsor is not None:
            wrong = _no_arrays(propulsor, _shapes_of(propulsor))
            yield from (f"propulsors.{i}.{each}" for each in wrong)


def _shapes_of(propulsor: Propulsor | EngineMap) -> dict[str, tuple[int, ...]]:
    """The shape of each field: a number, or a table of one point or more."""
    numbers = dict.fromkeys(vars(propulsor), ())
    if isinstance(propulsor, EngineMap):
        size = (max(1, len(propulsor.speeds)), max(1, len(propulsor.throttles)))
        return {**numbers, "speeds": size[:1], "throttles": size[1:], "thrust": size}
    points = (max(1, len(propulsor.thrust)),)
    return {**numbers, "advance": (2,), "thrust": points, "torque": points}


def _no_arrays(owner: object, shapes: Mapping[str, tuple[int, ...]]) -> Iterator[str]:
    """Fields that are not arrays of these shapes, of finite numbers of a size that numbers of aircraft have."""
    for name, shape in shapes.items():
        values = np.array(getattr(owner, name), dtype=float)
        if values.shape != shape:
            yield f"{name} has the shape {list(values.shape)}, expected {list(shape)}"
        elif not np.all(np.isfinite(values)):
            yield f"{name} is not finite"
        elif np.any(np.abs(values) > _LARGEST):
            yield f"{name} is beyond {_LARGEST:g}"


def kinematics(x: Mapping[str, float | np.ndarray]) -> np.ndarray:
    """k(x), [..., 6] by `ROWS`: what gravity and the rotation of the body axes add to the rates of u, v and w [m/s2].
    Rates of rotation that are not given are zero."""
    alpha, beta, speed = x["alpha"], x["beta"], x["airspeed"]
    u = speed * np.cos(alpha) * np.cos(beta)
    v = speed * np.sin(beta)
    w = speed * np.sin(alpha) * np.cos(beta)
    p, q, r = (x.get(rate, 0.0) for rate in "pqr")
    g_u = -GRAVITY_M_S2 * np.sin(x["pitch"])
    g_v = GRAVITY_M_S2 * np.cos(x["pitch"]) * np.sin(x["roll"])
    g_w = GRAVITY_M_S2 * np.cos(x["pitch"]) * np.cos(x["roll"])
    zero = np.zeros(np.shape(g_u))
    accelerations = (g_u - q * w + r * v, g_v - r * u + p * w, g_w - p * v + q * u)
    return np.stack([zero, zero, zero, *accelerations], axis=-1)


def _close(one: Any, other: Any, tolerance: float) -> bool:
    if isinstance(one, float) and isinstance(other, int | float):
        return math.isclose(one, other, rel_tol=tolerance, abs_tol=tolerance)
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_close(one[k], other[k], tolerance) for k in one)
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(partial(_close, tolerance=tolerance), one, other))
    return bool(one == other)


def rows_of(matrix: Any) -> tuple[tuple[float, ...], ...]:
    """The rows of a matrix, as a design model keeps them."""
    return tuple(tuple(map(float, row)) for row in matrix)
