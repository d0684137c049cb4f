"""A controller in a C library of one's own, called by ctypes: three functions, which `examples/testbed_controller.h` declares.

Nothing is allocated in a step: state, reference and commands are read and written in memory that is made before the flight.
"""

from __future__ import annotations

import ctypes
import json
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common.signals import SENSED, SETPOINT
from testbed.controllers.external.process import told
from testbed.controllers.user.adapter import CommandLog
from testbed.inputs.problems import BadInput, Problem

if TYPE_CHECKING:
    from testbed.controllers.setup import Setup

VERSION = 1
_Doubles = ctypes.POINTER(ctypes.c_double)


class _Setup(ctypes.Structure):
    """`testbed_setup` of the header."""

    _fields_ = [
        ("version", ctypes.c_int),
        ("actuators", ctypes.c_int),
        ("dt_s", ctypes.c_double),
        ("trim_pitch", ctypes.c_double),
        ("names", ctypes.POINTER(ctypes.c_char_p)),
        ("is_servo", ctypes.POINTER(ctypes.c_int)),
        ("low", _Doubles),
        ("high", _Doubles),
        ("trim", _Doubles),
        ("json", ctypes.c_char_p),
    ]


class CLibrary:
    """Flies one flight with a library; it is loaded into this process, so its faults end this process."""

    reasons: tuple[tuple[int, str], ...] = ()

    def __init__(self, setup: Setup, path: str) -> None:
        self._name, self._dt = os.path.basename(path), setup.dt_s
        self._bind, self._call, self._close = self._functions(path)
        self._log = CommandLog(setup)
        self._sensed, self._setpoint = np.zeros(len(SENSED)), np.zeros(len(SETPOINT))
        self._commands = np.zeros(len(setup.actuators))
        self._addresses = [a.ctypes.data_as(_Doubles) for a in (self._sensed, self._setpoint, self._commands)]
        self._handle = self._bind(ctypes.byref(self._told(setup)))
        if not self._handle:
            raise self._problem("testbed_bind returned NULL: it refuses this aircraft")

    def _functions(self, path: str) -> tuple[Any, Any, Any]:
        """The three functions of the library, with their types."""
        try:
            library = ctypes.CDLL(path)
            functions = [getattr(library, f"testbed_{name}") for name in ("bind", "step", "close")]
        except OSError as error:
            raise self._problem(f"cannot be loaded: {error}") from None
        except AttributeError as error:
            raise self._problem(str(error), "testbed_bind, testbed_step and testbed_close") from None
        bind, step, close = functions
        bind.argtypes, bind.restype = [ctypes.POINTER(_Setup)], ctypes.c_void_p
        step.argtypes, step.restype = [ctypes.c_void_p, _Doubles, _Doubles, _Doubles], ctypes.c_int
        close.argtypes, close.restype = [ctypes.c_void_p], None
        return bind, step, close

    def _told(self, setup: Setup) -> _Setup:
        """The set-up in C; it is kept as long as the controller, so that the library may point into it."""
        n = len(setup.actuators)

        def numbers(values: Any) -> Any:
            return (ctypes.c_double * n)(*values)

        self._kept = _Setup(
            VERSION,
            n,
            setup.dt_s,
            setup.trim_pitch,
            (ctypes.c_char_p * n)(*(name.encode() for name in setup.model.actuators)),
            (ctypes.c_int * n)(*(kind == "servo" for kind in setup.model.kinds)),
            numbers(a.low for a in setup.actuators),
            numbers(a.high for a in setup.actuators),
            numbers(setup.trim_commands),
            json.dumps(told(setup)).encode(),
        )
        return self._kept

    def bind(self, states: np.ndarray, setpoints: np.ndarray, telemetry: np.ndarray) -> None:
        """See `controllers.Controller`."""
        self._states, self._telemetry = states, telemetry
        self._setpoints = setpoints.view(np.float64).reshape(len(setpoints), -1)

    def bind_sensed(self, sensed: np.ndarray) -> None:
        """Take the rows of `signals.SENSED`."""
        self._readings = sensed.view(np.float64).reshape(len(sensed), -1)

    def step(self, step: int) -> np.ndarray:
        """Commands [n] for row `step`; raises BadInput, with the time, when the library fails."""
        self._sensed[:] = self._readings[step]
        self._setpoint[:] = self._setpoints[step]
        status = self._call(self._handle, *self._addresses)
        if status or not np.isfinite(self._commands).all():
            what = f"returned {status}" if status else f"commanded {self._commands.tolist()}"
            raise self._problem(f"at {step * self._dt:.3f} s testbed_step {what}", "0, and finite commands")
        self._log.write(self._telemetry[step], self._commands, self._states[step])
        return self._commands

    def close(self) -> None:
        """Tell the library that the flight is over."""
        handle, self._handle = self._handle, None
        if handle:
            self._close(handle)

    def _problem(self, what: str, expected: str = "") -> BadInput:
        return BadInput([Problem(what, self._name, expected=expected)])


def started(setup: Setup, words: Sequence[str]) -> CLibrary:
    """The controller of one flight; raises BadInput when the library cannot be loaded or refuses the aircraft."""
    return CLibrary(setup, words[0])
