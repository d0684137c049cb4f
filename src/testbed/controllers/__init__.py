"""Controllers: what flies the aircraft, from measured state and references to commands.

A new controller is a class or function in a module here, the class of its settings in `config` with its name in `config.TABLE`,
and one line in `make.CONSTRUCTORS`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:  # reading a scenario imports this package for `config` alone
    import numpy as np


class Controller(Protocol):
    """What flies the aircraft: made from a `Setup`, bound to the arrays of a flight, then called once in each control step.

    Attributes:
        reasons: (control step, text) of each failure that the controller cannot hold or cannot explain, in order of time.
    """

    @property
    def reasons(self) -> Iterable[tuple[int, str]]: ...

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the arrays of a flight (its channels), with one row for each control step.

        A flight that is extended gives longer ones, which begin with the rows so far; nothing else has changed then.

        Args:
            states: [steps] measured states, a record array with the fields of `signals.STATE`.
            setpoints: [steps] references, a record array with the fields of `signals.SETPOINT`.
            telemetry: [steps, `signals.telemetry_width`] filled by the controller (`signals.TELEMETRY`). NaN is what it does
                not say, and is not judged.
        """
        ...

    def step(self, step: int) -> Iterable[float]:
        """Commands [n] for row `step` of the channels: servos in radians, motors as throttle from 0 to 1."""
        ...
