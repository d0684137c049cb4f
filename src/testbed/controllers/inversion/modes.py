"""Control modes: for each combination of failed actuators, the axes to release and the inverse for the others (29).

They follow from the aircraft's settings, before the flight. A combination is refused, with the reason, if its remaining input
matrix is ill-conditioned. `regulator` designs the outer loop of a mode with released axes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, combinations

import numpy as np

from testbed.aircraft.control_design import AllocationWeights, ControlDesign
from testbed.aircraft.design_model import DesignModel
from testbed.common.cache import Cache
from testbed.common.signals import RATES

_CLEARLY = 0.5
"""Less important axes are given up in place of others if at least this share remains of the authority that the best choice
leaves."""


@dataclass(frozen=True)
class Mode:
    """Which actuators failed, which axes are released, and the inverse of the modified input matrix.

    Attributes:
        failed: names of the failed actuators.
        released: rates that are given up.
        inverse: [n, 4] from the virtual control to scaled actuator positions: B_hat^-1 of (29), or the pseudo-inverse where
            there are more actuators than kept axes. Rows of failed actuators and columns of released axes are zero.
        condition: condition number of the remaining scaled input matrix, kept axes by available actuators.
        refused: why the mode cannot be flown, or empty.
    """

    failed: tuple[str, ...]
    released: tuple[str, ...]
    inverse: np.ndarray  # (29)
    condition: float
    refused: str = ""

    @property
    def title(self) -> str:
        """What failed and what is released, in words."""
        return (
            f"{', '.join(self.failed) or 'nothing'} failed, {', '.join(self.released) or 'nothing'} released"
        )


class Modes(Mapping[tuple[int, ...], Mode]):
    """The mode of every combination of failed actuators except all of them, by the ascending indices of the failed ones.

    A mode is made when it is first asked for: twelve actuators have 4095 combinations, of which a flight needs a few.
    """

    def __init__(
        self, model: DesignModel, scale: np.ndarray, control: ControlDesign, released: Sequence[str]
    ) -> None:
        self._model, self._control, self._released = model, control, tuple(released)
        self._b = np.array(model.input_matrix)[:4] * scale
        self._made: dict[tuple[int, ...], Mode] = {}

    def __getitem__(self, failed: tuple[int, ...]) -> Mode:
        n = len(self._model.actuators)
        if failed not in self._made:
            if len(failed) >= n or list(failed) != sorted(set(failed) & set(range(n))):
                raise KeyError(failed)
            self._made[failed] = _mode(self._model, self._b, failed, self._control, self._released)
        return self._made[failed]

    def __iter__(self) -> Iterator[tuple[int, ...]]:
        n = len(self._model.actuators)
        return chain.from_iterable(combinations(range(n), count) for count in range(n))

    def __len__(self) -> int:
        return int(2 ** len(self._model.actuators)) - 1


_modes: Cache[Modes] = Cache(32)


def enumerate_modes(
    model: DesignModel, scale: np.ndarray, control: ControlDesign, released: Sequence[str] = ()
) -> Modes:
    """The modes of an aircraft, cached, because most flights of a sweep share them.

    Args:
        scale: [n] rad or N of one scaled unit.
        released: axes that are given up while nothing has failed.
    """
    key = (model, scale.tobytes(), control.model_dump_json(), tuple(released))
    return _modes.get(key, lambda: Modes(model, scale, control, released))


def _mode(
    model: DesignModel,
    b: np.ndarray,
    failed: tuple[int, ...],
    control: ControlDesign,
    released: Sequence[str],
) -> Mode:
    names = tuple(model.actuators[i] for i in failed)
    axes = _released_axes(model, b, failed, control, released)
    available = [i for i in range(b.shape[1]) if i not in failed]
    kept = [i for i, axis in enumerate(RATES) if axis not in axes]
    condition = float(np.linalg.cond(b[np.ix_(kept, available)])) if kept else math.inf
    mode = Mode(names, axes, np.zeros((b.shape[1], 4)), condition)
    refused = _refusal(len(kept), len(available), condition, control.condition_max)
    if refused:
        return replace(mode, refused=f"{mode.title}: {refused}")
    return replace(mode, inverse=_inverse(b, kept, available))


def _released_axes(
    model: DesignModel,
    b: np.ndarray,
    failed: tuple[int, ...],
    control: ControlDesign,
    always: Sequence[str],
) -> tuple[str, ...]:
    """Axes to give up. While nothing has failed, these are `always`.

    After a failure of actuators that the aircraft's `release` does not name, they are those that `_controllable` finds. For all
    others, and where it finds none, they are those that the aircraft lists.
    """
    if not failed:
        return tuple(axis for axis in RATES if axis in always)
    names = [model.actuators[i] for i in failed]
    listed = _listed_axes(names, b.shape[1], control)
    if any(name in key.split("+") for key in control.release for name in names):
        return listed
    available = [i for i in range(b.shape[1]) if i not in failed]
    fast = b * np.where([[axis != "u_dot"] for axis in RATES], _fast(model), 1.0)
    given_up = [axis for axis in RATES if axis in always or axis not in control.priorities]
    derived = _controllable(fast[:, available], fast, given_up, control)
    return listed if derived is None else derived


def _listed_axes(failed: Sequence[str], n: int, control: ControlDesign) -> tuple[str, ...]:
    """The axes that the aircraft's `release` lists for this combination, or else those that it lists for each failed actuator.

    More axes are given up, lowest priority first, until no more are kept than the actuators that remain of n.
    """
    listed = control.release.get("+".join(failed))
    if listed is None:
        listed = tuple(axis for name in failed for axis in control.release.get(name, ()))
    axes = set(listed) | (set(RATES) - set(control.priorities))  # those that the aircraft does not have
    for axis in reversed(control.priorities):
        if len(RATES) - len(axes) <= n - len(failed):
            break
        axes.add(axis)
    return tuple(axis for axis in RATES if axis in axes)


def _inverse(b: np.ndarray, kept: Sequence[int], available: Sequence[int]) -> np.ndarray:
    """[n, 4] `Mode.inverse`: the pseudo-inverse of the kept rows of b [4, n]."""
    inverse = np.zeros((b.shape[1], 4))
    # (29): B_hat^-1, rows of failed actuators and columns of released axes zero
    inverse[np.ix_(available, kept)] = np.linalg.pinv(b[np.ix_(kept, available)])
    return inverse


def _fast(model: DesignModel) -> np.ndarray:
    """[n] 1 for actuators that are fast enough to control rates of rotation; 0 for engines, whose thrust takes seconds."""
    return np.array([float(kind != "engine") for kind in model.kinds])


def _controllable(
    b: np.ndarray, healthy: np.ndarray, first: Sequence[str], control: ControlDesign
) -> tuple[str, ...] | None:
    """Axes to give up so that the others can be controlled, or None where none suffice.

    They are the fewest, and of those the least important, unless others leave clearly more of the aircraft's authority. An aileron
    yaws a little, so without a rudder roll could be given up in place of yaw, but the aileron is the better control of roll.

    Args:
        b: [4, available] scaled input matrix, of those effects that are fast enough.
        healthy: [4, n] the same of all actuators.
        first: axes that are given up in any case.
    """
    size = np.maximum(np.linalg.norm(healthy, axis=1, keepdims=True), 1e-9)
    least = [axis for axis in reversed(control.priorities) if axis not in first]
    for count in range(len(least)):
        sets = [(*first, *more) for more in combinations(least, count)]
        authority = [_remaining_authority(b, size, axes, control.condition_max) for axes in sets]
        enough = _CLEARLY * max(authority)
        if enough > 0.0:
            chosen = next(axes for axes, each in zip(sets, authority, strict=True) if each >= enough)
            return tuple(axis for axis in RATES if axis in chosen)
    return None


def _remaining_authority(
    b: np.ndarray, size: np.ndarray, released: Sequence[str], condition_max: float
) -> float:
    """Authority that remains over the kept axes in the direction in which it is least: the least singular value of their rows,
    each in units of its `size` [4, 1]; 0 where the condition number or the loss is larger than `condition_max`."""
    kept = [i for i, axis in enumerate(RATES) if axis not in released]
    if len(kept) > b.shape[1] or float(np.linalg.cond(b[kept])) > condition_max:
        return 0.0
    least = float(np.linalg.svd(b[kept] / size[kept], compute_uv=False)[-1])
    return least if least * condition_max >= 1.0 else 0.0


def _refusal(axes: int, actuators: int, condition: float, condition_max: float) -> str:
    """Why so many axes cannot be kept with so many actuators, or empty."""
    if not axes or axes > actuators:
        return f"{axes} axes to keep with {actuators} actuators"
    if condition > condition_max:
        return f"condition number {condition:.3g} of the remaining input matrix is above {condition_max:g}"
    return ""


def allocation_of(
    b: np.ndarray, released: Sequence[str], weights: AllocationWeights
) -> tuple[np.ndarray, np.ndarray]:
    """[4] squared weight of each rate in the allocation within the stops, and [n, n] the Hessian of half its sum of squares.

    Args:
        b: [4, n] scaled input matrix.
        released: axes that are given up, and have no weight.
    """
    row_weight = np.array([0.0 if axis in released else getattr(weights, axis) ** 2 for axis in RATES])
    return row_weight, b.T @ np.diag(row_weight) @ b + weights.deviation**2 * np.eye(b.shape[1])
