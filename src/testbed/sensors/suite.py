"""The sensors of one flight, of a controller and of an autopilot outside of the program: made before it, measuring in each control
step, and logged after it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, ClassVar

import numpy as np

from testbed.common import signals
from testbed.common.angles import wrap
from testbed.common.jit import bound
from testbed.common.random_streams import generator
from testbed.common.signals import STATE, as_records, begins_within, longer, room_for
from testbed.common.units import GRAVITY_M_S2
from testbed.sensors.channels import CHANNELS, SENSED_ONLY, Channel, channels_of, logged
from testbed.sensors.faults import Dropout, SensorFault, Span, Stuck
from testbed.sensors.measurement import (
    ERROR,
    FAULT,
    LAYERS,
    OFFSET,
    PARAMETERS,
    READING,
    SENSED,
    correlate,
    measure,
    sense,
)
from testbed.sensors.settings import SensorModel, SensorSettings

_NAMES = tuple(channel.name for channel in CHANNELS)
_BLOCK = 10_000
"""Control steps that are compared at a time: most faults change a reading in the first of them."""
_FROM_STATE = [(signals.SENSED.index(name), STATE.index(name)) for name in signals.SENSED if name in STATE]
_ALTITUDE, _CLIMB_RATE = STATE.index("altitude"), STATE.index("climb_rate")
_FORCES = slice(signals.SENSED.index("force_x"), signals.SENSED.index("velocity_down") + 1)
_AIR = slice(signals.SENSED.index("pressure"), signals.SENSED.index("temperature") + 1)
_FORCE_X = next(i for i, channel in enumerate(CHANNELS) if channel.reads == "specific_force_x")
_GAS_CONSTANT = 287.05  # of dry air [J/(kg K)]


class Bank:
    """Channels of sensors with errors and faults. All random numbers of the flight are drawn when it is made or lengthened.

    Attributes:
        channels: what is measured.
        sources: columns of the truth that the channels read; a channel that reads none of them reads the specific force.
        table: [5, steps or more, channels] errors, offsets, faults, what was sensed, and what was read (see `measurement`) [SI].
    """

    channels: ClassVar[Sequence[Channel]]
    sources: ClassVar[Sequence[str]]

    def __init__(self, settings: SensorSettings, rate_hz: int, steps: int, seed: int) -> None:
        self.settings, self.rate_hz, self.seed = settings, rate_hz, seed
        n = len(self.channels)
        self.constants, self.lagged = np.zeros(n, PARAMETERS), np.zeros(n)
        self.table = np.zeros((LAYERS, steps, n))
        self._steps = 0
        self.lengthen(steps)

    def lengthen(self, steps: int) -> None:
        """Take more control steps: the errors of a longer flight begin with those so far.

        What is there, but for faults, is not written again, and is shared by copies of this process. So the table has room, as
        `longer` gives it.
        """
        so_far, new = self.table, slice(self._steps, steps)
        if so_far.shape[1] < steps:
            self.table = np.zeros((LAYERS, room_for(steps), len(self.channels)))
            self.table[:, : self._steps] = so_far[:, : self._steps]
        self._steps = steps
        for i, channel in enumerate(self.channels):
            model, reads = self.settings.of(channel.sensor), channel.reads
            scale, error = self._drawn(channel, model, steps)
            self.table[ERROR, new, i] = error[new]
            source = self.sources.index(reads) if reads in self.sources else -1
            lag = 1.0 - math.exp(-model.low_pass_rad_s / self.rate_hz) if model.low_pass_rad_s else 1.0
            delay = round(model.delay_s * self.rate_hz)
            self.constants[i] = source, lag, scale, delay, model.si("resolution"), reads == "heading"
        self._enter_faults(0)

    def _drawn(self, channel: Channel, model: SensorModel, steps: int) -> tuple[float, np.ndarray]:
        """Scale factor of one channel [1], and the sum of its bias, drift, wander and noise in each step ([steps], in SI).

        Each part has its own random stream, so a change of one leaves the numbers of the others as they were.
        """

        def normal(part: str, size: int) -> np.ndarray:
            return generator(self.seed, f"sensors.{channel.name}.{part}").standard_normal(size)

        scale, error = 1.0 + model.scale_error, np.full(steps, model.si("bias"))
        if model.scale_error_sigma:
            scale += model.scale_error_sigma * float(normal("scale", 1)[0])
        if sigma := model.si("bias_sigma"):
            error += sigma * normal("bias", 1)
        if density := model.si("drift"):
            walk = np.cumsum(normal("drift", steps)) * density / math.sqrt(self.rate_hz)
            error[1:] += walk[:-1]
        if sigma := model.si("wander"):
            wander = normal("wander", steps)
            correlate(wander, math.exp(-1.0 / (self.rate_hz * model.wander_time_s)))
            error += sigma * wander
        if density := model.si("noise"):
            error += density * math.sqrt(self.rate_hz / 2.0) * normal("noise", steps)
        return scale, error

    def fault(self, settings: SensorSettings, step: int) -> None:
        """Take settings with other faults, which have done the same before this control step."""
        self.settings = settings
        self._enter_faults(step)

    def _enter_faults(self, first: int) -> None:
        """Enter the faults from this control step on. Earlier rows stay as they are: they may be in a file
        (`live.flight.LongSession`)."""
        if not self.settings.faults:
            return
        layers = np.zeros((2, self._steps, len(self.channels)))
        for index, fault in enumerate(self.settings.faults):
            start, end = fault.window(self.rate_hz)
            window = slice(int(start), int(min(end, self._steps)))
            steps = np.arange(max(window.stop - window.start, 0)) + start - fault.at_s * self.rate_hz
            for i, channel in enumerate(self.channels):
                if self._has(channel, fault):
                    stream = generator(self.seed, f"sensors.fault.{index}.{channel.name}")
                    fault.enter(Span(steps.copy(), self.rate_hz, stream, *layers[:, window, i]))
        self.table[OFFSET, first : self._steps], self.table[FAULT, first : self._steps] = layers[:, first:]

    def _has(self, channel: Channel, fault: SensorFault) -> bool:
        """Whether this channel has the fault."""
        return fault.sensor in (channel.name, channel.sensor)


class RealSensors(Bank):
    """The sensors of which the measured state is made.

    Ideal sensors need none of it: `plant.envelope.observe` copies the truth to the measured state.

    Args:
        force: reads the specific force along body x from the plant [m/s2].
    """

    channels, sources = CHANNELS, STATE

    def __init__(
        self, settings: SensorSettings, force: Callable[[], float], rate_hz: int, steps: int, seed: int
    ) -> None:
        super().__init__(settings, rate_hz, steps, seed)
        self._force = force

    def bind(self, truth: np.ndarray, measured: np.ndarray) -> None:
        """Take the rows of a flight, one a step: the truth (as `Plant.read`) and the measured state to be filled.

        Call it again after `lengthen`.
        """
        readings = as_records(self.table[READING], _NAMES)
        state = as_records(measured, STATE)
        self._parts = (truth, self.constants, self.lagged, self.table, readings, state)
        self._rate = float(self.rate_hz)
        self._measure = bound(measure, 0, 0.0, self._rate, self._parts)

    def measure(self, step: int) -> None:
        """Fill all of this step's row of the measured state from its row of truth."""
        self._measure(step, self._force(), self._rate, self._parts)

    def columns(self, truth: np.ndarray) -> dict[str, np.ndarray]:
        """Columns of the log beyond those of ideal sensors, in the rows of `truth`."""
        return dict(logged(truth, self.table[READING, : len(truth)]))

    def receipts(self, steps: int, planned: float = math.inf) -> list[dict[str, Any]]:
        """Beginning and end of each fault as events. `verified` says whether the fault changed any reading.

        Args:
            steps: control steps flown.
            planned: those of the whole flight. Faults that begin after them are left out, and not counted.
        """
        events: list[dict[str, Any]] = []
        faults = [f for f in self.settings.faults if begins_within(f.at_s, self.rate_hz, planned)]
        for i, fault in enumerate(faults):
            start, end = fault.window(self.rate_hz)
            told = {"kind": "sensor_fault", "fault": i, "type": fault.type, "sensor": fault.sensor}
            if start < steps:
                verified = self._changed(fault, int(start), int(min(end, steps)))
                events.append({"time_s": start / self.rate_hz, **told, "active": True, "verified": verified})
            if end < steps:
                events.append({"time_s": end / self.rate_hz, **told, "active": False})
        return events

    def _changed(self, fault: SensorFault, start: int, end: int) -> bool:
        """Whether any reading in the window differs by more than half a digit from that of a sensor without faults."""
        for c in channels_of(fault.sensor):
            channel = self.constants[c]
            for first in range(start, end, _BLOCK):
                steps = np.arange(first, min(first + _BLOCK, end))
                difference = (
                    self.table[READING, steps, c]
                    - self.table[SENSED, np.maximum(steps - channel["delay"], 0), c]
                )
                if channel["circular"]:
                    difference = wrap(difference)
                if not np.all(np.abs(difference) <= max(0.5 * channel["digit"], 1e-12) * (1.0 + 1e-9)):
                    return True
        return False


class _Others(Bank):
    """The channels of `SENSED_ONLY`, which have faults of the sensors that they belong to."""

    channels, sources = SENSED_ONLY, tuple(channel.reads for channel in SENSED_ONLY)

    def _has(self, channel: Channel, fault: SensorFault) -> bool:
        holds = isinstance(fault, Dropout) or (isinstance(fault, Stuck) and fault.value is None)
        of_receiver = channel.unit == "m_s" and fault.sensor == "position" and holds
        return of_receiver or (channel.unit == "m_s2" and fault.sensor == channel.sensor)


class Sensed:
    """The rows of `signals.SENSED` of one flight: all that an autopilot outside of the program is given.

    Most of it is the measured state. Specific force along y and z and the velocity over the ground are read for such an autopilot
    only: they have errors and faults of their own, which change nothing of what other controllers are given.

    Args:
        suite: sensors with errors, of which the measured state is made; None for ideal ones.
        read: reads what is not in the truth's rows from the plant (see `Plant.air_and_ground_reader`).

    Attributes:
        rows: [steps] records with these fields, in SI and radians; the rows of the control steps flown are filled.
    """

    def __init__(
        self, suite: RealSensors | None, read: Callable[[], tuple[float, ...]], rate_hz: int
    ) -> None:
        self._suite, self._read, self._rate_hz = suite, read, rate_hz
        self._others = None if suite is None else _Others(suite.settings, rate_hz, 0, suite.seed)
        self._truth, self._rows = np.zeros((0, len(SENSED_ONLY))), np.zeros((0, len(signals.SENSED)))

    def bind(self, truth: np.ndarray, measured: np.ndarray) -> None:
        """Take the rows of a flight, as `RealSensors.bind` does; again when it is extended."""
        self._state, self._measured = truth, measured
        self._rows, self._truth = longer(self._rows, len(truth)), longer(self._truth, len(truth))
        self.rows = as_records(self._rows, signals.SENSED)
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
