"""The process in which a functional mock-up unit flies: it speaks the protocol of `process`, and calls the unit by FMPy."""

from __future__ import annotations

import ctypes
import json
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import IO, Any

from fmpy import extract, instantiate_fmu

from testbed.common.signals import SENSED, SETPOINT
from testbed.controllers.external import fmu
from testbed.inputs.problems import BadInput, Problem, did_you_mean, one_of

_FOLDER = "unpacked"


class Unit:
    """One instance of a unit; raises BadInput when it does not fit what is flown."""

    def __init__(self, setup: Mapping[str, Any], file: str, mapping: str | None = None) -> None:
        actuators = [each["name"] for each in setup["actuators"]]
        description = fmu.described(file)
        fit = fmu.fitted(description, actuators, mapping)
        outputs, inputs = fmu.complete(fit, actuators, file), [(v, i) for v, i in fit.inputs if i is not None]
        self._constants = [setup["dt_s"], setup["trim_pitch"], *(each["trim"] for each in setup["actuators"])]
        self._dt = setup["dt_s"]
        self._inputs, self._outputs = _Values([v for v, _ in inputs]), _Values(outputs)
        self._signals = [i for _, i in inputs]
        parameters = _parameters(description, setup["parameters"], file)
        folder = extract(file, Path(setup["folder"]) / _FOLDER)
        self._fmu = instantiate_fmu(folder, description, "CoSimulation")
        for kind, reference, value in parameters:
            getattr(self._fmu, f"set{kind}")([reference], [value])
        version = description.fmiVersion[0]
        names = ("fmi2SetReal", "fmi2GetReal") if version == "2" else ("fmi3SetFloat64", "fmi3GetFloat64")
        self._set, self._get = (getattr(self._fmu, name) for name in names)
        self._counted = version != "2"

    def step(self, step: int, told: Mapping[str, Mapping[str, float]]) -> list[float]:
        """The commands of a control step."""
        sensed, reference = told["sensed"], told["reference"]
        signals = [*map(sensed.get, SENSED), *map(reference.get, SETPOINT), *self._constants]
        if step == 0:
            if not self._counted:  # FMI 2
                self._fmu.setupExperiment(startTime=0.0)
            self._fmu.enterInitializationMode()
        self._inputs.take([signals[i] for i in self._signals])
        self._call(self._set, self._inputs)
        if step == 0:
            self._fmu.exitInitializationMode()
        ended = self._fmu.doStep(step * self._dt, self._dt)
        if ended and (ended[1] or ended[2]):
            raise RuntimeError(
                "doStep asks for the end of the simulation" if ended[1] else "doStep returned early"
            )
        self._call(self._get, self._outputs)
        return self._outputs.given()

    def close(self) -> None:
        """End the unit's simulation."""
        self._fmu.terminate()
        self._fmu.freeInstance()

    def _call(self, function: Any, values: _Values) -> None:
        n = len(values.numbers)
        if n:
            function(self._fmu.component, values.references, n, values.numbers, *[n] * self._counted)


class _Values:
    """Variables of a unit with memory for their values, and their units."""

    def __init__(self, variables: Sequence[fmu.Variable]) -> None:
        n = len(variables)
        self.references = (ctypes.c_uint * n)(*(each.reference for each in variables))
        self.numbers = (ctypes.c_double * n)()
        self._units = [(each.factor, each.offset) for each in variables]

    def take(self, values: Sequence[Any]) -> None:
        """Values in SI units."""
        for i, (value, (factor, offset)) in enumerate(zip(values, self._units, strict=True)):
            self.numbers[i] = (value - offset) / factor

    def given(self) -> list[float]:
        """The values in SI units."""
        return [n * factor + offset for n, (factor, offset) in zip(self.numbers, self._units, strict=True)]


def _parameters(description: Any, given: Mapping[str, Any], file: str) -> list[tuple[str, int, Any]]:
    """Kind, reference and value of each parameter that the scenario gives; raises BadInput for those that there are not."""
    known = {each.name: each for each in description.modelVariables if each.causality == "parameter"}
    problems = [
        Problem(
            f"has no parameter {name}", file, expected=one_of(known), suggestion=did_you_mean(name, known)
        )
        for name in given
        if name not in known
    ]
    if problems:
        raise BadInput(problems)
    return [(known[name].type, known[name].valueReference, value) for name, value in given.items()]


def main(file: str, mapping: str | None = None) -> None:
    """Fly one flight over standard input and output."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what the unit prints is no answer
    try:
        unit = Unit(json.loads(sys.stdin.readline()), file, mapping)
        _say(answers, {})
        for step, line in enumerate(sys.stdin):
            _say(answers, {"step": step, "commands": unit.step(step, json.loads(line))})
        unit.close()
    except BadInput as error:
        _say(answers, {"problem": "; ".join(map(str, error.problems))})
    except Exception as error:  # of FMPy's: a call that failed
        _say(answers, {"problem": str(error) or type(error).__name__})


def _say(answers: IO[str], said: Mapping[str, Any]) -> None:
    answers.write(json.dumps(said) + "\n")
    answers.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
