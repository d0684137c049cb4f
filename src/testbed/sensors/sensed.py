"""All that an autopilot outside of the program is given (`signals.SENSED`): what the sensors read, with their errors and faults.

Most of it is the measured state. Specific force along y and z and the velocity over the ground are read for such an autopilot only:
they have errors and faults of their own, which change nothing of what other controllers are given.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Protocol

import numpy as np

from testbed.common.random_streams import generator
from testbed.common.signals import SENSED, STATE, as_records, longer
from testbed.common.units import GRAVITY_M_S2
from testbed.sensors.channels import CHANNELS, SENSED_ONLY
from testbed.sensors.errors import drawn, enter_one
from testbed.sensors.faults import Dropout, Stuck
from testbed.sensors.measurement import ERROR, FAULT, LAYERS, OFFSET, PARAMETERS, READING, sense
from testbed.sensors.settings import SensorSettings
from testbed.sensors.suite import RealSensors, parameters

_FROM_STATE = [(SENSED.index(name), STATE.index(name)) for name in SENSED if name in STATE]
_ALTITUDE, _CLIMB_RATE = STATE.index("altitude"), STATE.index("climb_rate")
_FORCES = slice(SENSED.index("force_x"), SENSED.index("velocity_down") + 1)
_AIR = slice(SENSED.index("pressure"), SENSED.index("temperature") + 1)
_FORCE_X = next(i for i, channel in enumerate(CHANNELS) if channel.reads == "specific_force_x")
_GAS_CONSTANT = 287.05  # of dry air [J/(kg K)]


class Read(Protocol):
    """What is read of the plant beyond its truth row."""

    def air_and_ground_reader(self) -> Callable[[], tuple[float, ...]]: ...


class Sensed:
    """The rows of `signals.SENSED` of one flight.

    Attributes:
        rows: [steps] records with the fields of `SENSED`, in SI and radians; the rows of the control steps flown are filled.
    """

    def __init__(
        self, suite: RealSensors | None, settings: SensorSettings, plant: Read, rate_hz: int, seed: int
    ) -> None:
        self._suite, self._settings, self._rate_hz, self._seed = suite, settings, rate_hz, seed
        self._read = plant.air_and_ground_reader()
        n = len(SENSED_ONLY)
        self._channels, self._lagged = np.zeros(n, PARAMETERS), np.zeros(n)
        self._table, self._truth = np.zeros((LAYERS, 0, n)), np.zeros((0, n))
        self._rows = np.zeros((0, len(SENSED)))

    def bind(self, truth: np.ndarray, measured: np.ndarray) -> None:
        """Take the rows of a flight, as `RealSensors.bind` does; again when it is extended."""
        steps, so_far = len(truth), self._table
        self._state, self._measured = truth, measured
        self._rows, self._truth = longer(self._rows, steps), longer(self._truth, steps)
        self.rows = as_records(self._rows, SENSED)
        if self._suite is not None:
            self._table = np.zeros((LAYERS, steps, len(SENSED_ONLY)))
            self._draw(steps)
            for layer in (READING - 1, READING):
                self._table[layer, : so_far.shape[1]] = so_far[layer]

    def _draw(self, steps: int) -> None:
        """Draw the errors of `SENSED_ONLY`, and enter the faults of the sensors that they belong to."""
        for i, channel in enumerate(SENSED_ONLY):
            model = self._settings.of(channel.sensor)
            scale, self._table[ERROR, :, i] = drawn(channel.name, model, steps, self._rate_hz, self._seed)
            self._channels[i] = parameters(i, model, scale, self._rate_hz)
            for index, fault in enumerate(self._settings.faults):
                holds = isinstance(fault, Dropout) or (isinstance(fault, Stuck) and fault.value is None)
                of_receiver = channel.unit == "m_s" and fault.sensor == "position" and holds
                if of_receiver or (channel.unit == "m_s2" and fault.sensor == channel.sensor):
                    stream = generator(self._seed, f"sensors.fault.{index}.{channel.name}")
                    enter_one(fault, i, self._rate_hz, stream, self._table[OFFSET], self._table[FAULT])

    def fault(self, settings: SensorSettings) -> None:
        """Take settings with other faults, as `RealSensors.fault`."""
        self._settings = settings
        self._table[[OFFSET, FAULT]] = 0.0
        self._draw(self._table.shape[1])

    def read(self, step: int) -> None:
        """Fill the row of this control step; the row of the measured state must be filled already."""
        row, measured = self._rows[step], self._measured[step]
        force_x, force_y, force_z, north, east, pressure, temperature = self._read()
        if self._suite is not None:
            self._truth[step] = force_y, force_z, north, east
            sense(step, self._truth, 0.0, self._channels, self._lagged, self._table)
            force_x = self._suite.table[READING, step, _FORCE_X]
            force_y, force_z, north, east = self._table[READING, step]
        for to, source in _FROM_STATE:
            row[to] = measured[source]
        row[_FORCES] = force_x, force_y, force_z, north, east, -measured[_CLIMB_RATE]
        too_high_m = measured[_ALTITUDE] - self._state[step, _ALTITUDE]
        too_low = math.exp(-GRAVITY_M_S2 * too_high_m / (_GAS_CONSTANT * temperature))
        row[_AIR] = pressure * too_low, temperature
        row[0] = step / self._rate_hz
