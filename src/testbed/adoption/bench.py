"""A model on JSBSim's bench: held in a flight state while its flight control and engines run, before it is an aircraft here."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping
from pathlib import Path

from testbed.common import writing
from testbed.common.units import METRES_PER_FOOT
from testbed.plant.jsbsim import EngineError, engine_errors, opened
from testbed.plant.properties import INTEGRATORS

HZ = 120.0
_MISSING = re.compile(
    r"property ['\"]?(?:fdm/jsbsim/)?([A-Za-z_][^\s'\"]*?)['\"]? (?:does not exist|is not defined|not found)"
)
_MISSING_MAX = 200


class Bench:
    """A loaded model, held where `place` puts it.

    Args:
        folder: of the model's XML, and of its engines' in `Engines`.
        model: name of the model.
        hz: physics steps in a second.

    Raises:
        EngineError: JSBSim does not load it.

    Attributes:
        missing: properties that functions read and nobody provides; known after `start`.
    """

    def __init__(self, folder: Path, model: str, hz: float = HZ) -> None:
        self.hz = hz
        self._fdm, self._words = opened(folder, model, hz)
        self._manager = self._fdm.get_property_manager()
        self.missing: list[str] = []

    def start(self) -> None:
        """The first initial condition; missing properties are made, with the value 0. Raises EngineError."""
        for _ in range(_MISSING_MAX):
            try:
                with engine_errors():
                    self._fdm.run_ic()
                return
            except EngineError as error:
                found = _MISSING.search(one_line(f"{error} {' '.join(self._words[-3:])}"))
                if found is None:
                    raise
                self._fdm[found[1]] = 0.0
                self.missing.append(found[1])
        raise EngineError(f"more than {_MISSING_MAX} properties are missing")

    def place(self, airspeed_m_s: float, altitude_m: float, alpha_rad: float = 0.0) -> None:
        """Level flight at this state; engines and actuators keep theirs."""
        fdm, speed = self._fdm, airspeed_m_s / METRES_PER_FOOT
        for name, value in (
            ("ic/lat-geod-deg", 0.0), ("ic/long-gc-deg", 0.0), ("ic/h-sl-ft", altitude_m / METRES_PER_FOOT),
            ("ic/psi-true-rad", 0.0), ("ic/phi-rad", 0.0), ("ic/theta-rad", alpha_rad),
            ("ic/u-fps", speed * math.cos(alpha_rad)), ("ic/v-fps", 0.0), ("ic/w-fps", speed * math.sin(alpha_rad)),
        ):  # fmt: skip
            fdm[name] = value
        fdm.run_ic()
        for name in INTEGRATORS:  # held from here on
            fdm[name] = 0

    def settle(self, seconds: float) -> None:
        """Let flight control and engines run while the airframe is held."""
        for _ in range(round(seconds * self.hz)):
            self._fdm.run()

    def has(self, name: str) -> bool:
        return bool(self._manager.hasNode(name))

    def reader(self, names: list[str]) -> Callable[[], list[float]]:
        """Function that reads these properties; one that does not exist reads 0."""
        nodes = [self._manager.get_node(name) if self.has(name) else None for name in names]
        return lambda: [node.get_double_value() if node else 0.0 for node in nodes]

    def set(self, values: Mapping[str, float]) -> None:
        for name, value in values.items():
            self._fdm[name] = value

    def __getitem__(self, name: str) -> float:
        return float(self._fdm.get_property_value(name))

    def __setitem__(self, name: str, value: float) -> None:
        self._fdm[name] = value


def one_line(text: str) -> str:
    """JSBSim's words without colours and line breaks."""
    return " ".join(re.sub(r"\x1b\[[0-9;]*m", "", text).split())


def write(folder: Path, model: str, tree: ET.Element) -> None:
    """Write a model where `Bench` finds it."""
    writing.write(folder / f"{model}.xml", ET.tostring(tree, encoding="unicode"))
