"""A function and its parts as one program: what it gives, what it may contain, and what it leaves alone."""

from __future__ import annotations

import gc

import numpy as np
import pytest
from numba.core.errors import NumbaError
from numba.core.types.functions import BaseFunction

from testbed.common.jit_program import Estimate, Function, _parts_of
from testbed.controllers.inversion.step import adaptive_step


@Function
def halved(values, least=0.25):  # type: ignore[no-untyped-def]
    for i in range(len(values)):
        values[i] = max(0.5 * values[i], least)


@Function
def quartered(values, least):  # type: ignore[no-untyped-def]
    halved(values)
    halved(values[::2], least)
    return values[0]


@Function
def copied(values):  # type: ignore[no-untyped-def]
    return values.copy()


def test_a_part_is_compiled_for_each_layout_and_serves_python_too() -> None:
    """With its default value, and with an array of another layout; what Python calls is an entry of its own."""
    values = np.array([8.0, 4.0, 1.0, 2.0])
    assert quartered(values, 0.75) == 2.0
    assert values.tolist() == [2.0, 2.0, 0.75, 1.0]
    assert len(halved._parts) == 2
    assert not halved.overloads
    halved(values)
    assert values.tolist() == [1.0, 1.0, 0.375, 0.5]
    assert len(halved.overloads) == 1


def test_what_allocates_is_refused() -> None:
    with pytest.raises(NumbaError, match="array"):
        copied(np.ones(3))


def test_compiling_leaves_the_collector_and_numba_as_they_were() -> None:
    plain = BaseFunction.get_call_type
    for enabled in (True, False):
        (gc.enable if enabled else gc.disable)()
        try:
            with pytest.raises(NumbaError):
                copied(np.ones(3, np.float32 if enabled else np.int16))
            assert gc.isenabled() is enabled
            assert BaseFunction.get_call_type is plain
        finally:
            gc.enable()


def test_the_time_of_a_long_program_is_told_once() -> None:
    """The law's; a program of two functions takes no time worth telling."""
    estimate, told = Estimate(), []
    estimate.tell = told.append
    for entry in (adaptive_step.py_func, quartered.py_func):
        estimate.begin(entry)
        for part in _parts_of(entry):
            estimate.add(part)
    assert len(told) == 1
    assert told[0] > 0.0


def test_the_parts_of_a_program_are_those_that_are_compiled() -> None:
    assert _parts_of(quartered.py_func) == {halved.py_func}
    assert not _parts_of(halved.py_func)
