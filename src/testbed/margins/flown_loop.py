"""The loop of a controller, broken at one surface: its gain over frequency, flown and by linearisation, and its margins.

With the loop opened at the command u of one surface, and all others closed, L = -u / z, where z is what the surface is told. Flown,
z = u + d with a small sine d that is added behind the controller (the failure `oscillation`): L = -U / (U + D) at the frequency of
the sine. By linearisation, the plant is that of `plant.linear`, held
between control steps, and the controller's response is measured by sines in each value that it is given, one at a time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.signal import cont2discrete

from testbed.aircraft.changes import load_with_changes
from testbed.common.signals import RATES, SETPOINT, STATE, as_records, telemetry_rows
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.make import make_controller
from testbed.controllers.setup import Setup
from testbed.flight.flight import Outcome
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.plant.linear import LinearModel, linearise, python_control
from testbed.scenario.load import Scenario, changed
from testbed.scenario.references import references
from testbed.simulation import fly
from testbed.simulation.assembly import start_and_setup

_SETTLE_S, _PERIODS = 10.0, 4
_DRIFT = 5
"""Number of terms of a polynomial in time: a constant that is integrated up to four times."""
_AMPLITUDE = 0.2
"""Size of the sine [deg]."""
_SIZE = 1e-5
"""Size of a sine in a value that a controller is given [SI]: so small that nothing reaches a limit by it."""
_ASTRAY = 0.01
"""Change of a command [rad or throttle] that no sine of `_SIZE` explains: the controller is unstable alone."""
_CALM = {"failures": [], "commands": [], "requirements": [], "sensors": "ideal", "atmosphere": {}}
"""What of a scenario is left out."""


@dataclass(frozen=True)
class Loop:
    """The gain of a broken loop.

    Attributes:
        frequencies_hz: [m] frequencies.
        gain: [m] complex L; the closed loop has 1 + L.
    """

    frequencies_hz: np.ndarray
    gain: np.ndarray

    @property
    def disk_margin(self) -> float:
        """Least distance of L from -1 at these frequencies: with d, gains from 1/(1+d) to 1/(1-d) and a phase of 2 asin(d/2) are
        borne (Skogestad and Postlethwaite, Multivariable Feedback Control, 2nd ed., eq. 2.40)."""
        return float(np.min(np.abs(1.0 + self.gain)))

    def response(self) -> Any:
        """The same as python-control's FrequencyResponseData, for its `bode_plot`, `nyquist_plot` and `margin`; raises BadInput
        without `pip install 'testbed[linear]'`."""
        return python_control().frd(self.gain, 2.0 * math.pi * self.frequencies_hz)


def loop_by_injection(
    scenario: Scenario,
    actuator: str,
    frequencies_hz: Sequence[float],
    controller: Callable[[Setup], Any] | None = None,
) -> Loop:
    """L at each frequency, from a flight for each. The failures, requirements and weather of the scenario are left out.

    Args:
        actuator: a servo.
        controller: a class of your own in place of the scenario's.

    Raises:
        BadInput: there is no such servo, or the aircraft is lost.
    """
    _refuse_other(scenario, actuator)
    gains = [_flown(scenario, actuator, f, controller) for f in frequencies_hz]
    return Loop(np.array(frequencies_hz, dtype=float), np.array(gains))


def _refuse_other(scenario: Scenario, actuator: str) -> None:
    actuators = load_with_changes(scenario.aircraft).actuators
    servos = [name for name, one in actuators.items() if one.kind == "servo"]
    if actuator not in servos:
        raise BadInput(
            [Problem(f"there is no servo {actuator!r}", "actuator", None, "", *guess(actuator, servos))]
        )


def _flown(
    scenario: Scenario, actuator: str, hz: float, controller: Callable[[Setup], Any] | None
) -> complex:
    duration_s = math.ceil(_SETTLE_S + _PERIODS / hz)
    sine = {
        "type": "oscillation",
        "actuator": actuator,
        "at_s": 0.0,
        "amplitude": _AMPLITUDE,
        "frequency_hz": hz,
    }
    keys = {**_CALM, "failures": [sine], "duration_s": float(duration_s)}
    flight = fly(changed(scenario, keys), controller)
    if flight.outcome is not Outcome.completed:
        raise BadInput(
            [Problem(f"{flight.outcome.sentence} at {hz:g} Hz", actuator, expected="a stable loop")]
        )
    time, command = flight.signals["time_s"], flight.signals[f"{actuator}_command"]
    rows = time >= duration_s - _PERIODS / hz - 1e-9
    u, d = _line(time[rows], command[rows], hz), -1j * _AMPLITUDE
    return -u / (u + d)


def _line(time: np.ndarray, values: np.ndarray, hz: float) -> complex:
    """Complex amplitude c of Re(c exp(j w t)), beside the drift of integrators, by least squares."""
    w = 2.0 * math.pi * hz * time
    t = (time - time.mean()) / time.max()
    basis = np.column_stack([np.cos(w), np.sin(w), *(t**power for power in range(_DRIFT))])
    cosine, sine = np.linalg.lstsq(basis, values, rcond=None)[0][:2]
    return complex(cosine, -sine)


def loop_by_linearisation(
    scenario: Scenario,
    actuator: str,
    frequencies_hz: Sequence[float],
    controller: Callable[[Setup], Any] | None = None,
) -> Loop:
    """L at each frequency without a flight; arguments as of `loop_by_injection`.

    It is that of a controller which is linear alone, without what it adapts. Inversion laws cancel the plant, and so multiply an
    error of its linear model: trust what is flown. Raises BadInput for a controller whose commands run away alone, as incremental
    ones do.
    """
    _refuse_other(scenario, actuator)
    at = {"airspeed_m_s": scenario.initial.airspeed_m_s, "altitude_m": scenario.initial.altitude_m}
    model = linearise(load_with_changes(scenario.aircraft), at)
    if isinstance(law := scenario.controller, AdaptiveInversionSettings):
        # where one value moves at a time, the guard of stuck sensors takes the others for stuck
        scenario = changed(scenario, {"controller.ablate": sorted({*law.ablate, "sensor_guard"})})
    i = list(model.inputs).index(actuator)
    others = [k for k in range(len(model.inputs)) if k != i]
    gains = []
    for hz in frequencies_hz:
        m = _controller_response(scenario, hz, controller) @ _plant_response(
            model, hz, scenario.rate_hz, 1 / scenario.physics_steps
        )
        closed = np.linalg.solve(np.eye(len(others)) - m[np.ix_(others, others)], m[others, i])
        gains.append(-(m[i, i] + m[i, others] @ closed))
    return Loop(np.array(frequencies_hz, dtype=float), np.array(gains))


def _plant_response(model: LinearModel, hz: float, rate_hz: float, lag: float) -> np.ndarray:
    """[len(STATE), n] of what is measured, to commands that are held for a control step.

    `lag` is a physics step, in control steps: JSBSim integrates first, with the accelerations of the step before.
    """
    a, b, c, d, _ = cont2discrete((model.A, model.B, model.C, model.D), 1.0 / rate_hz)
    z = np.exp(2j * math.pi * hz / rate_hz)
    response = c @ np.linalg.solve(z * np.eye(len(a)) - a, b) + d
    names = list(model.outputs)
    response[[k for k, name in enumerate(names) if name not in RATES]] /= z**lag
    found = np.zeros((len(STATE), response.shape[1]), dtype=complex)
    for row, name in enumerate(STATE):
        if name in names:
            found[row] = response[names.index(name)]
    return found


def _controller_response(
    scenario: Scenario, hz: float, controller: Callable[[Setup], Any] | None
) -> np.ndarray:
    """[n, len(STATE)] of the commands to each value that the controller is given, about the steady flight."""
    start, setup = start_and_setup(scenario)
    rate, steps = scenario.rate_hz, math.ceil((_SETTLE_S + _PERIODS / hz) * scenario.rate_hz)
    whole = changed(scenario, {**_CALM, "duration_s": steps / rate})
    setpoints = references(whole, start.state["path_angle"])
    time = np.arange(steps) / rate
    rows = slice(round(_SETTLE_S * rate), None)
    columns = []
    for name in STATE:
        states = np.tile([start.state.get(each, 0.0) for each in STATE], (steps, 1))
        states[:, STATE.index(name)] += _SIZE * np.sin(2.0 * math.pi * hz * time)
        made, telemetry = make_controller(setup, controller), telemetry_rows(steps, len(setup.actuators))
        made.bind(as_records(states, STATE), as_records(setpoints, SETPOINT), telemetry)
        commands = np.array([list(made.step(k)) for k in range(steps)])  # for states that do not follow them
        if np.abs(commands[rows] - commands[0]).max() > _ASTRAY:
            what = f"the commands of {scenario.controller.type} run away where nothing follows them"
            raise BadInput([Problem(what, "controller", expected="loop_by_injection, which flies it")])
        lines = [_line(time[rows], commands[rows, k], hz) for k in range(commands.shape[1])]
        columns.append(np.array(lines) / (-1j * _SIZE))
    return np.column_stack(columns)
