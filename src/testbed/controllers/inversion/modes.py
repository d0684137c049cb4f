"""Control modes: for each combination of failed actuators, what is released and how the rest is inverted (29).

Enumerated at start from the aircraft's settings; a combination whose remaining input matrix is too badly conditioned is
refused, with words. A mode with released axes also carries a regulator: a linear-quadratic state feedback designed on
the design model about the mode's own trim, because the actuators that are left no longer decouple the axes. It asks for
no cancellation of what is stable (the weathercock, the damping), and it is designed when the mode is first entered.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.linalg import solve_continuous_are
from scipy.optimize import root

from testbed.aircraft.control_design import ControlDesign
from testbed.aircraft.design_model import DesignModel
from testbed.common.cache import Kept
from testbed.common.signals import RATES
from testbed.controllers.records import INTEGRALS, OUTER

_STEP = 1e-6
# A model that is 20 % wrong misplaces a trim by as much: better one just beyond the stops than none.
_BEYOND_STOPS = 1.3


@dataclass(frozen=True)
class Mode:
    """Which actuators failed, which axes are released, and the modified input matrix.

    Attributes:
        failed: names of the failed actuators.
        released: rates that are given up.
        matrix: [4, n] B_hat of (29), scaled: zeros where the paper puts them. It is square and regular when as many
            axes are released as actuators failed; `inverse` is what flies, and is defined for the other cases too.
        inverse: [n, 4] from wanted rates to scaled actuator positions; zero rows and columns for failed and released.
        held: [n, n, 4] the inverse to use while an actuator (first index) is held at a stop; None without a spare one.
        condition: condition number of what remains, scaled.
        refused: why the mode is not controllable, or empty.
    """

    failed: tuple[str, ...]
    released: tuple[str, ...]
    matrix: np.ndarray
    inverse: np.ndarray
    condition: float
    refused: str = ""
    held: np.ndarray | None = None


def enumerate_modes(
    model: DesignModel, scale: np.ndarray, control: ControlDesign, released: Sequence[str] = ()
) -> Mapping[tuple[int, ...], Mode]:
    """Every combination of failed actuators, keyed by their indices; `released` axes are given up from the start.

    Kept: most flights of a sweep share them. Nobody changes what is kept.
    """
    key = (model, scale.tobytes(), control.model_dump_json(), tuple(released))
    return _modes.get(key, lambda: _enumerated(model, scale, control, released))


def _enumerated(
    model: DesignModel, scale: np.ndarray, control: ControlDesign, released: Sequence[str]
) -> Mapping[tuple[int, ...], Mode]:
    b = np.array(model.input_matrix)[:4] * scale
    return {
        failed: _mode(model, b, failed, control, released)
        for count in range(len(model.actuators))
        for failed in combinations(range(len(model.actuators)), count)
    }


def _mode(
    model: DesignModel,
    b: np.ndarray,
    failed: tuple[int, ...],
    control: ControlDesign,
    released: Sequence[str],
) -> Mode:
    names = tuple(model.actuators[i] for i in failed)
    axes = _released_axes(names, b.shape[1], control, released)
    kept = [i for i, axis in enumerate(RATES) if axis not in axes]
    alive = [i for i in range(b.shape[1]) if i not in failed]
    remaining = b[np.ix_(kept, alive)]
    condition = float(np.linalg.cond(remaining)) if kept else math.inf
    inverse = np.zeros((b.shape[1], 4))
    what = f"{', '.join(names) or 'nothing'} failed, {', '.join(axes) or 'nothing'} released"
    refused = ""
    if not kept or len(kept) > len(alive):
        refused = f"{what}: {len(kept)} axes to keep with {len(alive)} actuators"
    elif condition > control.condition_max:
        refused = (
            f"{what}: condition number {condition:.3g} of the remaining input matrix is above "
            f"{control.condition_max:g}"
        )
    else:
        inverse[np.ix_(alive, kept)] = np.linalg.pinv(remaining)
    held = _held_inverses(b, kept, alive) if len(alive) > len(kept) and not refused else None
    return Mode(names, axes, modified_matrix(b, failed, axes), inverse, condition, refused, held)


def _held_inverses(b: np.ndarray, kept: list[int], alive: list[int]) -> np.ndarray:
    inverses = np.zeros((b.shape[1], b.shape[1], 4))
    for i in alive:
        others = [j for j in alive if j != i]
        inverses[np.ix_([i], others, kept)] = np.linalg.pinv(b[np.ix_(kept, others)])
    return inverses


def _released_axes(
    failed: tuple[str, ...], n: int, control: ControlDesign, always: Sequence[str]
) -> tuple[str, ...]:
    """Axes to give up: those asked for while nothing has failed; else the aircraft's choice for the combination, or by
    its choices for each and its priorities, until no more axes are kept than actuators are left."""
    if not failed:
        return tuple(axis for axis in RATES if axis in always)
    listed = control.release.get("+".join(failed))
    if listed is None:
        listed = tuple(axis for name in failed for axis in control.release.get(name, ()))
    axes = set(listed)
    for axis in reversed(control.priorities):
        if len(RATES) - len(axes) <= n - len(failed):
            break
        axes.add(axis)
    return tuple(axis for axis in RATES if axis in axes)


def modified_matrix(b: np.ndarray, failed: Sequence[int], released: Sequence[str]) -> np.ndarray:
    """B_hat of section 2.3: a failed actuator contributes nothing to the kept axes, an effective one nothing to the
    released axes. Where a failed actuator hardly moves the released axis its entry is set to one, so that the matrix
    stays invertible: that row decides nothing that flies."""
    b_hat = b.copy()
    rows = [i for i, axis in enumerate(RATES) if axis in released]
    kept = [i for i in range(4) if i not in rows]
    alive = [j for j in range(b.shape[1]) if j not in failed]
    if failed:
        b_hat[np.ix_(kept, list(failed))] = 0.0
        b_hat[np.ix_(rows, alive)] = 0.0
        for i, j in zip(rows, failed, strict=False):
            b_hat[rows, j] = 0.0
            b_hat[i, j] = b[i, j] if abs(b[i, j]) > 1e-2 else 1.0
    return b_hat


@dataclass(frozen=True)
class Regulator:
    """Trim and gains of a mode: v = -K dx - K_actuator da - K_integral integral, rates in x_c order.

    Attributes:
        x_trim: [10] by `records.OUTER`.
        r_trim: [n] scaled actuator positions at that trim, as if fully effective.
        K, K_actuator, K_integral: gains on state, modelled actuators and integrals.
        eigenvalues: of the designed loop, rad/s.
        held: outputs that are held: airspeed, altitude, heading or fewer.
    """

    x_trim: np.ndarray
    r_trim: np.ndarray
    K: np.ndarray
    K_actuator: np.ndarray
    K_integral: np.ndarray
    eigenvalues: np.ndarray
    held: tuple[str, ...]


class NoLevelTrim(ValueError):
    """With these actuators the design model has no steady flight, or none that can be held."""


_modes: Kept[Mapping[tuple[int, ...], Mode]] = Kept(32)
_regulators: Kept[Regulator | str] = Kept(256)


def regulator_for(
    model: DesignModel,
    scale: np.ndarray,
    mode: Mode,
    control: ControlDesign,
    limits: np.ndarray,
    lags: np.ndarray,
) -> Regulator:
    """As `design_regulator`, kept: it takes longer than a second of flight, and is the same in flight after flight."""
    arrays = (scale, mode.inverse, limits, lags)
    key = (model, mode.failed, mode.released, control.model_dump_json(), *(a.tobytes() for a in arrays))

    def designed() -> Regulator | str:
        try:
            return design_regulator(model, scale, mode, control, limits, lags)
        except NoLevelTrim as reason:
            return str(reason)

    found = _regulators.get(key, designed)
    if isinstance(found, str):
        raise NoLevelTrim(found)
    return found


def _titles(mode: Mode) -> str:
    return f"{', '.join(mode.failed) or 'nothing'} failed, {', '.join(mode.released) or 'nothing'} released"


def design_regulator(
    model: DesignModel,
    scale: np.ndarray,
    mode: Mode,
    control: ControlDesign,
    limits: np.ndarray,
    lags: np.ndarray,
    jammed: Mapping[int, float] | None = None,
) -> Regulator:
    """Linear-quadratic regulator for a mode, by Bryson's rule (Bryson and Ho, Applied Optimal Control, sec. 5.2).

    Args:
        limits: [n, 2] scaled stops; lags: [n] rad/s of servos and rotors.
        jammed: scaled positions of failed actuators that stand somewhere and act from there.

    Raises:
        NoLevelTrim: nothing steady within the stops, at the reference airspeed or any other.
    """
    n = len(model.actuators)
    alive = np.array([float(name not in mode.failed) for name in model.actuators])
    acting, hold = alive.copy(), np.array(model.trim) / scale
    for i, position in (jammed or {}).items():
        acting[i], hold[i] = 1.0, position
    motors = [bool(alive[i]) for i, kind in enumerate(model.kinds) if kind == "motor"]
    alone = len(motors) > 1 and sum(motors) == 1  # an aircraft that has only one motor has lost none
    faster = control.loops.lost_thrust_faster_m_s if alone else 0.0
    x0, a0, regulated = _level_trim(model, scale, alive, acting, hold, mode, limits, faster)
    nx, ni = len(OUTER), len(regulated)

    def plant(z: np.ndarray, r: np.ndarray) -> np.ndarray:
        x, a = z[:nx], z[nx : nx + n]
        outputs = [x[OUTER.index(name)] - x0[OUTER.index(name)] for name in regulated]
        return np.concatenate([_motion(model, x, a * scale, acting), lags * (r - a), outputs])

    z0 = np.concatenate([x0, a0, np.zeros(ni)])
    A = _jacobian(lambda z: plant(z, a0), z0)
    B = _jacobian(lambda r: plant(z0, r), a0) @ mode.inverse
    kept = [i for i, axis in enumerate(RATES) if axis not in mode.released]
    gliding = "altitude" not in regulated  # then altitude is spent as energy: nothing can hold it
    states = [*range(nx - gliding), *(nx + i for i in range(n) if alive[i]), *range(nx + n, nx + n + ni)]
    q = [getattr(control.regulator.states, name) for name in OUTER] + [control.regulator.actuator] * n
    q += [getattr(control.regulator.integrals, name) for name in regulated]
    Q = np.diag(1.0 / np.square(np.array(q)[states]))
    into = mode.inverse[:, kept]
    R = into.T @ np.diag(alive / control.regulator.actuator**2) @ into
    A, B = A[np.ix_(states, states)], B[np.ix_(states, kept)]
    try:
        P = solve_continuous_are(A, B, Q, R)
    except np.linalg.LinAlgError:
        raise NoLevelTrim(
            f"{_titles(mode)}: what is left cannot stabilise the aircraft about its trim"
        ) from None
    gains = np.zeros((4, nx + n + ni))
    gains[np.ix_(kept, states)] = np.linalg.solve(R, B.T @ P)
    integral = np.zeros((4, len(INTEGRALS)))
    for k, name in enumerate(regulated):
        integral[:, INTEGRALS.index(name)] = gains[:, nx + n + k]
    closed = np.linalg.eigvals(A - B @ gains[np.ix_(kept, states)])
    return Regulator(x0, a0, gains[:, :nx], gains[:, nx : nx + n], integral, closed, regulated)


def _level_trim(
    model: DesignModel,
    scale: np.ndarray,
    alive: np.ndarray,
    acting: np.ndarray,
    hold: np.ndarray,
    mode: Mode,
    limits: np.ndarray,
    faster: float,
) -> tuple[np.ndarray, np.ndarray, tuple[str, ...]]:
    """Steady flight with what is left: level, `faster` than the reference or faster still, if three actuators are left;
    else level at any airspeed, else descending. Returns state [10], scaled positions [n] and the outputs that can be
    held."""
    free = np.flatnonzero(alive)
    if len(free) < 2:
        raise NoLevelTrim(f"{_titles(mode)}: one actuator cannot hold altitude and heading")
    anywhere = (0.0, -2.0, 2.0, -4.0, 4.0, 8.0)
    ways: list[tuple[str, tuple[str, ...], float, tuple[float, ...]]] = []
    if len(free) >= 3:
        speeds = (faster, faster + 1.0, faster + 2.0, faster + 4.0, faster + 8.0)
        ways += [("", ("airspeed", "altitude", "heading"), beyond, speeds) for beyond in (1.0, _BEYOND_STOPS)]
    else:
        if any(alive[i] and model.kinds[i] == "motor" for i in range(len(alive))):
            ways += [("airspeed", ("altitude", "heading"), 1.0, anywhere)]
        ways += [("path_angle", ("airspeed", "heading"), 1.0, anywhere)]  # down, as energy is what is left
    for slack, held, beyond, changes in ways:
        found = _steady(model, scale, alive, acting, hold, beyond * limits, slack, changes)
        if found is not None:
            return *found, held
    raise NoLevelTrim(f"{_titles(mode)}: no steady flight within the stops, level or descending")


def _steady(
    model: DesignModel,
    scale: np.ndarray,
    alive: np.ndarray,
    acting: np.ndarray,
    hold: np.ndarray,
    limits: np.ndarray,
    slack: str,
    changes: Sequence[float],
) -> tuple[np.ndarray, np.ndarray] | None:
    """Steady flight on the design model, with airspeed or path angle unknown too if `slack` says so: state [10] and
    scaled positions [n] of the first trim found with these changes of airspeed (to start from, if it is unknown)."""
    free = np.flatnonzero(alive)
    used = free[-3:]

    def unpack(x: np.ndarray, speed: float) -> tuple[np.ndarray, np.ndarray]:
        alpha, beta, roll = x[:3]
        values = {"airspeed": speed, "path_angle": 0.0}
        if slack:
            values[slack] = x[3]
        a = hold.copy()
        a[used] = x[3 + bool(slack) :]
        if len(free) > 3:
            a[free[0]] = a[free[1]]  # nothing has failed: fly symmetrically
        pitch = _pitch_for(alpha, beta, roll, values["path_angle"])
        return np.array([values["airspeed"], alpha, beta, 0.0, 0.0, 0.0, roll, pitch, 0.0, 0.0]), a

    def attempt(change: float, beta: float) -> tuple[np.ndarray, np.ndarray] | None:
        speed = model.airspeed_m_s + change
        start = [model.alpha_rad, beta, 0.0] + ([speed if slack == "airspeed" else -0.08] if slack else [])

        def residual(x: np.ndarray) -> np.ndarray:
            state, a = unpack(x, speed)
            return _model_rates(model, state, a * scale, acting)

        found = root(residual, np.array([*start, *hold[used]]), method="hybr")
        state, a = unpack(found.x, speed)
        inside = np.all((a >= limits[:, 0] - 1e-9) & (a <= limits[:, 1] + 1e-9))
        plausible = abs(state[1]) < 0.25 and abs(state[2]) < 0.4 and state[0] > 0.5 * model.airspeed_m_s
        return (state, a) if found.success and inside and plausible else None

    for change in changes:
        for beta in (0.0, 0.08, -0.08):
            found = attempt(change, beta)
            if found is not None:
                return found
    return None


def _pitch_for(alpha: float, beta: float, roll: float, path_angle: float) -> float:
    a = math.cos(alpha) * math.cos(beta)
    b = math.sin(roll) * math.sin(beta) + math.cos(roll) * math.sin(alpha) * math.cos(beta)
    s = math.sin(path_angle)
    return math.atan((a * b + s * math.sqrt(max(a * a - s * s + b * b, 0.0))) / (a * a - s * s))


def _model_rates(model: DesignModel, x: np.ndarray, a: np.ndarray, alive: np.ndarray) -> np.ndarray:
    names = ("airspeed", "alpha", "beta", "p", "q", "r", "roll", "pitch")
    return model.rates(dict(zip(names, map(float, x[:8]), strict=True)), a, alive)


def _motion(model: DesignModel, x: np.ndarray, a: np.ndarray, alive: np.ndarray) -> np.ndarray:
    """[10] derivatives of `records.OUTER` on the design model (flat earth, body axes)."""
    speed, alpha, beta, p, q, r, roll, pitch, _, _ = x
    p_dot, q_dot, r_dot, u_dot, v_dot, w_dot = _model_rates(model, x, a, alive)
    ca, sa, cb, sb = math.cos(alpha), math.sin(alpha), math.cos(beta), math.sin(beta)
    u, v, w = speed * ca * cb, speed * sb, speed * sa * cb
    speed_dot = (u * u_dot + v * v_dot + w * w_dot) / speed
    alpha_dot = (u * w_dot - w * u_dot) / (u * u + w * w)
    beta_dot = (v_dot - sb * speed_dot) / (speed * cb)
    turn = q * math.sin(roll) + r * math.cos(roll)
    climb = u * math.sin(pitch) - (v * math.sin(roll) + w * math.cos(roll)) * math.cos(pitch)
    return np.array(
        [
            speed_dot,
            alpha_dot,
            beta_dot,
            p_dot,
            q_dot,
            r_dot,
            p + math.tan(pitch) * turn,
            q * math.cos(roll) - r * math.sin(roll),
            turn / math.cos(pitch),
            climb,
        ]
    )


def _jacobian(function, x: np.ndarray) -> np.ndarray:  # type: ignore[no-untyped-def]
    columns = []
    for i in range(len(x)):
        step = np.zeros(len(x))
        step[i] = _STEP
        columns.append((function(x + step) - function(x - step)) / (2.0 * _STEP))
    return np.array(columns).T


def motion_matrix(model: DesignModel, state: Mapping[str, float]) -> np.ndarray:
    """[10, 10] Jacobian of the airframe's motion with actuators fixed, about a steady state; for its modes."""
    x = np.array([state.get(name, 0.0) for name in OUTER])
    alive = np.ones(len(model.actuators))
    return _jacobian(lambda z: _motion(model, z, np.array(model.trim), alive), x)
