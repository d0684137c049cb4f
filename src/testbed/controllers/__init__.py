"""Controllers, by the names that scenarios use. A new one is one file, and one line here and in `settings.SETTINGS`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:  # reading a scenario needs the settings beside this file, not numba
    import numpy as np

    from testbed.controllers.setup import Setup


class Controller(Protocol):
    """What flies the aircraft: built from a `Setup`, bound to a flight's channels, called once a control step."""

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight, a row a step: measured states and references (record arrays with the fields of
        `signals.STATE` and `signals.SETPOINT`), and the telemetry to be filled (`signals.TELEMETRY`)."""
        ...

    def step(self, step: int) -> Iterable[float]:
        """Commands [n], servos in radians and motors as throttle, for row `step` of the channels."""
        ...


def _adaptive_inversion(setup: Setup) -> Controller:
    from testbed.controllers.inversion.controller import InversionController

    return InversionController(setup)


def _fixed_inversion(setup: Setup) -> Controller:
    from testbed.controllers.inversion.controller import InversionController

    return InversionController(setup, adapts=False, monitors=False)


def _pid(setup: Setup) -> Controller:
    from testbed.controllers.pid import PidController

    return PidController(setup)


def _indi(setup: Setup) -> Controller:
    from testbed.controllers.indi import IndiController

    return IndiController(setup)


TABLE: dict[str, Callable[[Setup], Any]] = {
    "adaptive_inversion": _adaptive_inversion,
    "fixed_inversion": _fixed_inversion,
    "pid": _pid,
    "indi": _indi,
}
