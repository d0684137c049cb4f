"""Controllers: what flies the aircraft, from measured state and references to commands.

A new controller is one file, the class of its settings in `config` with its name in `config.TABLE`, and one line in
`make.CONSTRUCTORS`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:  # reading a scenario needs `config` only
    import numpy as np


class Controller(Protocol):
    """What flies the aircraft: built from a `Setup`, bound to a flight's channels, called once a control step.

    Attributes:
        reasons: (step, text) of each failure that the controller cannot hold or explain, in the order of the flight.
    """

    @property
    def reasons(self) -> Iterable[tuple[int, str]]: ...

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """Take the channels of a flight, one row per control step.

        Args:
            states: [steps] measured states, a record array with the fields of `signals.STATE`.
            setpoints: [steps] references, a record array with the fields of `signals.SETPOINT`.
            telemetry: [steps, `signals.telemetry_width`] filled by the controller (`signals.TELEMETRY`).
        """
        ...

    def step(self, step: int) -> Iterable[float]:
        """Commands [n] for row `step` of the channels: servos in radians, motors as throttle 0 to 1."""
        ...
