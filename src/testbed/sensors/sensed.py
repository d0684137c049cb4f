"""All that an autopilot outside of the program is given (`signals.SENSED`): what the sensors read, with their errors and faults.

Most of it is the measured state. Specific force along y and z and the velocity over the ground are read for such an autopilot only:
they have errors and faults of their own, which change nothing of what other controllers are given.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from testbed.common.signals import SENSED, STATE, as_records, longer
from testbed.common.units import GRAVITY_M_S2
from testbed.sensors.channels import CHANNELS, SENSED_ONLY, Channel
from testbed.sensors.faults import Dropout, SensorFault, Stuck
from testbed.sensors.measurement import READING, sense
from testbed.sensors.settings import SensorSettings
from testbed.sensors.suite import Bank, RealSensors

_FROM_STATE = [(SENSED.index(name), STATE.index(name)) for name in SENSED if name in STATE]
_ALTITUDE, _CLIMB_RATE = STATE.index("altitude"), STATE.index("climb_rate")
_FORCES = slice(SENSED.index("force_x"), SENSED.index("velocity_down") + 1)
_AIR = slice(SENSED.index("pressure"), SENSED.index("temperature") + 1)
_FORCE_X = next(i for i, channel in enumerate(CHANNELS) if channel.reads == "specific_force_x")
_GAS_CONSTANT = 287.05  # of dry air [J/(kg K)]


class _Others(Bank):
    """The channels of `SENSED_ONLY`, which have faults of the sensors that they belong to."""

    channels, sources = SENSED_ONLY, tuple(channel.reads for channel in SENSED_ONLY)

    def _has(self, channel: Channel, fault: SensorFault) -> bool:
        holds = isinstance(fault, Dropout) or (isinstance(fault, Stuck) and fault.value is None)
        of_receiver = channel.unit == "m_s" and fault.sensor == "position" and holds
        return of_receiver or (channel.unit == "m_s2" and fault.sensor == channel.sensor)


class Sensed:
    """The rows of `signals.SENSED` of one flight.

    Args:
        suite: sensors with errors, of which the measured state is made; None for ideal ones.
        read: reads what is not in the truth's rows from the plant (see `Plant.air_and_ground_reader`).

    Attributes:
        rows: [steps] records with the fields of `SENSED`, in SI and radians; the rows of the control steps flown are filled.
    """

    def __init__(
        self, suite: RealSensors | None, read: Callable[[], tuple[float, ...]], rate_hz: int
    ) -> None:
        self._suite, self._read, self._rate_hz = suite, read, rate_hz
        self._others = None if suite is None else _Others(suite.settings, rate_hz, 0, suite.seed)
        self._truth, self._rows = np.zeros((0, len(SENSED_ONLY))), np.zeros((0, len(SENSED)))

    def bind(self, truth: np.ndarray, measured: np.ndarray) -> None:
        """Take the rows of a flight, as `RealSensors.bind` does; again when it is extended."""
        self._state, self._measured = truth, measured
        self._rows, self._truth = longer(self._rows, len(truth)), longer(self._truth, len(truth))
        self.rows = as_records(self._rows, SENSED)
        if self._others is not None:
            self._others.lengthen(len(truth))

    def fault(self, settings: SensorSettings, step: int) -> None:
        """As `Bank.fault`; the sensors are not ideal ones."""
        assert self._others is not None
        self._others.fault(settings, step)

    def read(self, step: int) -> None:
        """Fill the row of this control step; the row of the measured state must be filled already."""
        row, measured = self._rows[step], self._measured[step]
        force_x, force_y, force_z, north, east, pressure, temperature = self._read()
        if (others := self._others) is not None and self._suite is not None:
            self._truth[step] = force_y, force_z, north, east
            sense(step, self._truth, 0.0, others.constants, others.lagged, others.table)
            force_x = self._suite.table[READING, step, _FORCE_X]
            force_y, force_z, north, east = others.table[READING, step]
        for to, source in _FROM_STATE:
            row[to] = measured[source]
        row[_FORCES] = force_x, force_y, force_z, north, east, -measured[_CLIMB_RATE]
        too_high_m = measured[_ALTITUDE] - self._state[step, _ALTITUDE]
        too_low = math.exp(-GRAVITY_M_S2 * too_high_m / (_GAS_CONSTANT * temperature))
        row[_AIR] = pressure * too_low, temperature
        row[0] = step / self._rate_hz
