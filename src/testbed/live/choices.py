"""What a page can choose to fly: scenarios that come with the testbed, level flight of any aircraft, and own controllers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from testbed.aircraft.shipped import aircraft_names, files_in
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput, Problem, guess
from testbed.inputs.yaml_source import Source
from testbed.live.flight import LiveFlight
from testbed.live.messages import AS_GIVEN
from testbed.scenario.load import changed, load_scenario, scenario_from
from testbed.scenario.model import Scenario
from testbed.sensors.settings import PRESETS


class Choices:
    """What can be flown.

    Attributes:
        names: {scenarios, aircraft, controllers, sensors}: what can be chosen of each.
    """

    def __init__(
        self,
        file: str,
        scenario: Scenario,
        controller: Callable[[Setup], Any] | None = None,
        own: str | None = None,
    ) -> None:
        """The scenario that the command gave, from this file, and the class of the user's own, if there is one."""
        self._file, self._scenario, self._controller, self._own = file, scenario, controller, own
        shipped = [path.name for path in files_in("scenarios")]
        # Aircraft of the user's own in the working folder, as scenarios name them.
        folders = [p.parent.name for p in sorted(Path().glob("*/*.yaml")) if p.stem == p.parent.name]
        self.names = {
            "scenarios": list(dict.fromkeys([file, *shipped])),
            "aircraft": [*aircraft_names(), *(f"./{name}" for name in folders)],
            "controllers": [AS_GIVEN, *CONTROLLERS],
            "sensors": [AS_GIVEN, *PRESETS],
        }

    @property
    def given(self) -> dict[str, str]:
        """What the command gave, as `flight` takes it."""
        return {"flight": self._file, "controller": AS_GIVEN, "sensors": AS_GIVEN}

    def flight(self, flight: str, controller: str, sensors: str = AS_GIVEN) -> LiveFlight:
        """A new flight of a scenario or an aircraft by a controller with sensors, each one of `names`; raises BadInput."""
        names = self.names
        for kind, given, known in (
            ("flight", flight, names["scenarios"] + names["aircraft"]),
            ("controller", controller, names["controllers"]),
            ("sensors", sensors, names["sensors"]),
        ):
            if given not in known:
                what = f"there is no {kind} {given!r}"
                raise BadInput([Problem(what, "choose", None, "", *guess(given, known))])
        scenario = self._chosen(flight)
        if sensors != AS_GIVEN:
            scenario = changed(scenario, {"sensors": sensors})
        if controller == AS_GIVEN:
            return LiveFlight(scenario, self._controller, self._own)
        return LiveFlight(changed(scenario, {"controller": {"type": controller}}))

    def _chosen(self, flight: str) -> Scenario:
        if flight == self._file:
            return self._scenario
        return load_scenario(flight) if flight in self.names["scenarios"] else _level(flight)


def _level(aircraft: str) -> Scenario:
    """Level flight of an aircraft where it is designed."""
    settings = {"name": f"{Path(aircraft).name} by hand", "aircraft": aircraft, "duration_s": 60}
    return scenario_from(Source("choose", settings))
