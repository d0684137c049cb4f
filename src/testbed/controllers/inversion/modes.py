"""Control modes: for each combination of failed actuators, the axes to release and the inverse for the others (29).

All combinations are enumerated before the flight, from the aircraft's settings. A combination is refused, with the reason, if
its remaining input matrix is ill-conditioned. `regulator` designs the outer loop of a mode with released axes.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from testbed.aircraft.control_design import ControlDesign
from testbed.aircraft.design_model import DesignModel
from testbed.common.cache import Cache
from testbed.common.signals import RATES


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
        inverse_at_stop: [n, n, 4] the inverse without the actuator of the first index, for use while that one is at its stop;
            None if there are no more actuators than kept axes.
    """

    failed: tuple[str, ...]
    released: tuple[str, ...]
    inverse: np.ndarray
    condition: float
    refused: str = ""
    inverse_at_stop: np.ndarray | None = None

    @property
    def title(self) -> str:
        """What failed and what is released, in words."""
        return (
            f"{', '.join(self.failed) or 'nothing'} failed, {', '.join(self.released) or 'nothing'} released"
        )


_modes: Cache[Mapping[tuple[int, ...], Mode]] = Cache(32)


def enumerate_modes(
    model: DesignModel, scale: np.ndarray, control: ControlDesign, released: Sequence[str] = ()
) -> Mapping[tuple[int, ...], Mode]:
    """The mode of every combination of failed actuators except all of them, by the indices of the failed ones.

    The result is cached, because most flights of a sweep share it: do not change it.

    Args:
        scale: [n] rad or N of one scaled unit.
        released: axes that are given up while nothing has failed.
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
    available = [i for i in range(b.shape[1]) if i not in failed]
    remaining = b[np.ix_(kept, available)]
    condition = float(np.linalg.cond(remaining)) if kept else math.inf
    refused = _refusal(len(kept), len(available), condition, control.condition_max)
    inverse = np.zeros((b.shape[1], 4))
    mode = Mode(names, axes, inverse, condition)
    if refused:
        return replace(mode, refused=f"{mode.title}: {refused}")
    inverse[np.ix_(available, kept)] = np.linalg.pinv(remaining)
    at_stop = _inverses_at_stop(b, kept, available) if len(available) > len(kept) else None
    return replace(mode, inverse_at_stop=at_stop)


def _refusal(axes: int, actuators: int, condition: float, condition_max: float) -> str:
    """Why so many axes cannot be kept with so many actuators, or empty."""
    if not axes or axes > actuators:
        return f"{axes} axes to keep with {actuators} actuators"
    if condition > condition_max:
        return f"condition number {condition:.3g} of the remaining input matrix is above {condition_max:g}"
    return ""


def _inverses_at_stop(b: np.ndarray, kept: list[int], available: list[int]) -> np.ndarray:
    inverses = np.zeros((b.shape[1], b.shape[1], 4))
    for i in available:
        others = [j for j in available if j != i]
        inverses[np.ix_([i], others, kept)] = np.linalg.pinv(b[np.ix_(kept, others)])
    return inverses


def _released_axes(
    failed: tuple[str, ...], n: int, control: ControlDesign, always: Sequence[str]
) -> tuple[str, ...]:
    """Axes to give up.

    While nothing has failed, these are `always`. After a failure, they are those that the aircraft's `release` lists for this
    combination. If it does not list the combination, they are those that it lists for each failed actuator. In both cases more
    axes are given up, lowest priority first, until no more axes are kept than actuators are left.
    """
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
