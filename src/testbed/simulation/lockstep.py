"""The loop: in each control step all parts of a flight take their turn, and its rows are recorded."""

from __future__ import annotations

import math

import numpy as np

from testbed.common.jit import bound
from testbed.common.signals import SETPOINT, STATE, as_records, longer, telemetry_rows
from testbed.flight.columns import Recorded
from testbed.flight.flight import Outcome
from testbed.plant.envelope import DIVERGED, GOES_ON, ON_THE_GROUND, OUTSIDE_ENVELOPE, limits_of, observe
from testbed.simulation.assembly import Assembly

_OUTCOMES = {
    GOES_ON: Outcome.completed,  # the last step was reached without any of the others
    DIVERGED: Outcome.diverged,
    ON_THE_GROUND: Outcome.ground_contact,
    OUTSIDE_ENVELOPE: Outcome.envelope_exceeded,
}


class Lockstep:
    """The parts of one flight, and what they have recorded.

    Attributes:
        rows: one row for each control step of the whole flight; those flown are filled.
        done: number of control steps flown.
        outcome: how the flight ended; None while it goes on.
        stopped_by: the error that stopped the flight; None if none did.
    """

    def __init__(self, parts: Assembly) -> None:
        self.parts, self.done = parts, 0
        self.outcome: Outcome | None = None
        self.stopped_by: BaseException | None = None
        n, steps = len(parts.aircraft.actuators), parts.scenario.steps
        truth = np.zeros((steps, len(STATE) + 2 * n))
        measured = np.zeros((steps, len(STATE)))
        self._bind(Recorded(truth, measured, parts.references, telemetry_rows(steps, n)))

    def _bind(self, rows: Recorded) -> None:
        """Give the parts the rows that the flight fills."""
        parts, (truth, measured, setpoints, telemetry) = self.parts, rows
        self.rows = rows
        parts.controller.bind(as_records(measured, STATE), as_records(setpoints, SETPOINT), telemetry)
        if parts.sensors is not None:
            parts.sensors.bind(truth, measured)
        if parts.sensed is not None:
            parts.sensed.bind(truth, measured)
            parts.controller.bind_sensed(parts.sensed.rows)  # type: ignore[attr-defined]
        parts.injector.observe(rows)
        limits = limits_of(parts.aircraft.envelope)
        self._channels = (parts.plant.raw, parts.plant.factors, limits, truth, measured)
        self._log_truth = bound(observe, 0, self._channels)

    @property
    def steps(self) -> int:
        """Control steps of the whole flight."""
        return len(self.rows.truth)

    @property
    def recorded(self) -> Recorded:
        """The rows of the control steps flown."""
        return Recorded(*(rows[: self.done] for rows in self.rows))

    def lengthen(self, references: np.ndarray) -> None:
        """Take more control steps: `references` [steps, 6] begin with those so far, and weather and sensors have theirs."""
        so_far, steps = self.rows, len(references)
        telemetry = longer(so_far.telemetry, steps, math.nan)
        truth, measured = longer(so_far.truth, steps), longer(so_far.measured, steps)
        self.parts.references = references
        self._bind(Recorded(truth, measured, references, telemetry))

    def advance(self, until: int) -> None:
        """Fly up to this control step, or until the flight ends.

        In each control step k, at time k / rate: inject failures, set the wind, read and log the truth, measure, command, stop if
        the flight has ended, advance the plant.

        Raises BadInput when JSBSim cannot go on, or the user's controller.
        """
        plant, controller, injector = self.parts.plant, self.parts.controller, self.parts.injector
        weather, sensors, sensed = self.parts.weather, self.parts.sensors, self.parts.sensed
        log_truth, channels, steps = self._log_truth, self._channels, self.steps
        k, ending = self.done, GOES_ON
        try:
            with plant.in_words():
                for k in range(self.done, min(until, steps)):
                    if k >= injector.next_step:
                        injector.apply(k)
                    if k >= weather.next_step:
                        weather.apply(k)
                    plant.sample()
                    ending = log_truth(k, channels)
                    if sensors is not None:
                        sensors.measure(k)
                    if sensed is not None:
                        sensed.read(k)
                    plant.command(controller.step(k))
                    for delay in injector.filters:
                        delay()
                    if ending:
                        break
                    plant.step()
        except BaseException as error:
            self.done, self.stopped_by = k, error
            raise
        self.done = k + 1
        if ending or self.done == steps:
            self.outcome = _OUTCOMES[ending]
