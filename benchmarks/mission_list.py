"""The missions of `missions.py`: routes, failures, and the conditions in which they are flown.

A mission is a route flown with failures. Failures begin at FAILURE_S; a second one at SECOND_S. The routes keep references
moving through the first failure.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from flights import Values, coefficient_errors

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.common.units import METRES_PER_FOOT

FAILURE_S, SECOND_S, DURATION_S = 20.0, 35.0, 70.0
ALTITUDE_M, HEADING_DEG = 5.0, 15.0
"""A flight is held if it is flown to the end with both errors within these limits, from the first failure on."""
BASE = f"""\
name: mission
aircraft: vtail
duration_s: {DURATION_S:g}
rate_hz: 200
initial: {{altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}}
controller: {{type: pid}}
sensors: mems
"""


@dataclass(frozen=True)
class Route:
    """References of a flight: airspeed at the start [m/s], rates of the references, and (time, changes) of the commands."""

    words: str
    airspeed_m_s: float
    rates: Mapping[str, float]
    commands: Sequence[tuple[float, Mapping[str, float]]]

    @property
    def values(self) -> Values:
        """Settings of the scenario by dotted paths."""
        return {
            "initial.airspeed_m_s": self.airspeed_m_s,
            "command_rates": dict(self.rates),
            "commands": [{"at_s": at_s, **changes} for at_s, changes in self.commands],
        }


def _turns(*legs: tuple[float, float, float]) -> tuple[tuple[float, Mapping[str, float]], ...]:
    """Commands of (time, heading, altitude) together."""
    return tuple((at_s, {"heading_deg": heading, "altitude_m": altitude}) for at_s, heading, altitude in legs)


_CALM_LEGS = _turns((8, 120, 305), (18, 120, 312), (40, 90, 312), (50, 90, 300))
ROUTES: Mapping[str, Route] = {
    "cruise": Route("turns at 4 deg/s, climbs at 1 m/s", 18, {"heading_deg_s": 4, "altitude_m_s": 1}, _CALM_LEGS),
    "hard": Route(
        "turns at 8 deg/s together with climbs and descents at 2 m/s",
        18,
        {"heading_deg_s": 8, "altitude_m_s": 2},
        _turns((6, 150, 310), (18, 60, 320), (34, 150, 308), (48, 80, 318), (60, 110, 308)),
    ),
    "slow": Route("as cruise, at 15 m/s", 15, {"heading_deg_s": 4, "altitude_m_s": 1}, _CALM_LEGS),
    "fast": Route("as cruise, at 22 m/s", 22, {"heading_deg_s": 4, "altitude_m_s": 1}, _CALM_LEGS),
    "ramp": Route(
        "heading, altitude and airspeed move for 30 s through the failure",
        18,
        {"heading_deg_s": 4, "altitude_m_s": 1, "airspeed_m_s2": 0.1},
        ((10, {"heading_deg": 210, "altitude_m": 330, "airspeed_m_s": 20}), (55, {"heading_deg": 180})),
    ),
}  # fmt: skip


def _loss(actuator: str, value: float, at_s: float = FAILURE_S) -> dict[str, Any]:
    return {"type": "effectiveness", "actuator": actuator, "value": value, "at_s": at_s}


def _failure(kind: str, actuator: str, **fields: Any) -> dict[str, Any]:
    return {"type": kind, "actuator": actuator, "at_s": FAILURE_S, **fields}


TAILS = ("left_ruddervator", "right_ruddervator")
PROPELLERS = ("left_propeller", "right_propeller")
LEFT, RIGHT = TAILS
LEFT_P, RIGHT_P = PROPELLERS


@dataclass(frozen=True)
class Mission:
    """A route flown with failures. The name has the words by which missions are chosen, joined by `_`."""

    name: str
    failures: Sequence[Mapping[str, Any]] = ()

    @property
    def route(self) -> Route:
        """The route is the first word of the name."""
        return ROUTES[self.name.partition("_")[0]]

    def is_meant_by(self, choice: str) -> bool:
        """Whether every word of a choice such as `slow_propeller` is in the name."""
        return set(choice.split("_")) <= set(self.name.split("_"))


def _singles() -> list[Mission]:
    short = dict(
        zip(
            (*TAILS, *PROPELLERS),
            ("left_tail", "right_tail", "left_propeller", "right_propeller"),
            strict=True,
        )
    )
    lost, weak = (
        [Mission(f"hard_{name}_{word}", [_loss(actuator, value)]) for actuator, name in short.items()]
        for word, value in (("lost", 0.0), ("weak", 0.3))
    )  # fmt: skip
    return [*lost, *weak]


MISSIONS: tuple[Mission, ...] = (
    *(Mission(f"{route}_healthy") for route in ("hard", "slow", "fast")),
    *_singles(),
    Mission("slow_left_tail_lost", [_loss(LEFT, 0.0)]),
    Mission("slow_right_tail_lost", [_loss(RIGHT, 0.0)]),
    Mission("slow_left_propeller_lost", [_loss(LEFT_P, 0.0)]),
    Mission("slow_right_propeller_lost", [_loss(RIGHT_P, 0.0)]),
    Mission("slow_tails_weak", [_loss(a, 0.3) for a in TAILS]),
    Mission("slow_right_propeller_weak", [_loss(RIGHT_P, 0.3)]),
    Mission("fast_left_propeller_lost", [_loss(LEFT_P, 0.0)]),
    Mission("fast_right_tail_lost", [_loss(RIGHT, 0.0)]),
    Mission("fast_right_propeller_lost", [_loss(RIGHT_P, 0.0)]),
    Mission("ramp_right_tail_lost", [_loss(RIGHT, 0.0)]),
    Mission("ramp_left_propeller_lost", [_loss(LEFT_P, 0.0)]),
    Mission("hard_tails_weak", [_loss(a, 0.3) for a in TAILS]),
    Mission("hard_propellers_weak", [_loss(a, 0.5) for a in PROPELLERS]),
    Mission("cruise_all_weak", [_loss(a, 0.5) for a in (*TAILS, *PROPELLERS)]),
    Mission("hard_second_tail_after_tail", [_loss(LEFT, 0.0), _loss(RIGHT, 0.5, SECOND_S)]),
    Mission("hard_second_propeller_after_tail", [_loss(LEFT, 0.4), _loss(LEFT_P, 0.0, SECOND_S)]),
    Mission("cruise_second_tail_lost_after_tail", [_loss(LEFT, 0.0), _loss(RIGHT, 0.0, SECOND_S)]),
    Mission("cruise_second_tail_after_propeller", [_loss(LEFT_P, 0.0), _loss(LEFT, 0.5, SECOND_S)]),
    Mission("cruise_second_opposite_after_propeller", [_loss(LEFT_P, 0.0), _loss(RIGHT, 0.5, SECOND_S)]),
    Mission("cruise_second_propeller_stuck_after_tail", [_loss(LEFT, 0.2), _failure("stuck", LEFT_P, at_s=SECOND_S)]),
    Mission(
        "cruise_second_propeller_intermittent_after_tail",
        [_loss(LEFT, 0.0), _failure("intermittent", RIGHT_P, at_s=SECOND_S, off_s=0.5, on_s=1.0)],
    ),
    Mission("cruise_tail_reversed", [_failure("reversal", LEFT)]),
    Mission("hard_tail_reversed", [_failure("reversal", RIGHT)]),
    Mission("slow_tail_reversed", [_failure("reversal", RIGHT)]),
    Mission("cruise_tail_jam_here", [_failure("stuck", LEFT)]),
    *(
        Mission(f"cruise_tail_jam_{word}", [_failure("stuck_at", LEFT, value=value)])
        for word, value in (("minus10", -10.0), ("minus5", -5.0), ("plus5", 5.0), ("plus10", 10.0))
    ),
    Mission("cruise_tail_jam_minus15", [_failure("stuck_at", RIGHT, value=-15.0)]),
    Mission("cruise_propeller_jam_here", [_failure("stuck", RIGHT_P)]),
    Mission("cruise_propeller_jam_high", [_failure("stuck_at", LEFT_P, value=0.8)]),
    Mission("cruise_tail_hardover_max", [_failure("hardover", LEFT, to="max")]),
    Mission("cruise_tail_hardover_min", [_failure("hardover", RIGHT, to="min")]),
    Mission("cruise_propeller_hardover_max", [_failure("hardover", LEFT_P, to="max")]),
    Mission("cruise_propeller_hardover_min", [_failure("hardover", RIGHT_P, to="min")]),
    Mission("cruise_propeller_runaway", [_failure("runaway", RIGHT_P, rate=0.3)]),
    Mission("cruise_propeller_stop", [_failure("motor_stop", LEFT_P)]),
    Mission("hard_tail_intermittent", [_failure("intermittent", LEFT, off_s=0.5, on_s=1.0)]),
    Mission("cruise_propeller_intermittent", [_failure("intermittent", RIGHT_P, off_s=0.5, on_s=1.0)]),
    Mission("hard_tail_delay", [_failure("delay", LEFT, delay_s=0.1)]),
    Mission("hard_propeller_delay", [_failure("delay", LEFT_P, delay_s=0.15)]),
    Mission("cruise_tail_pulses", [_failure("oscillation", LEFT, amplitude=4.0, frequency_hz=1.0)]),
    Mission("cruise_tail_bias", [_failure("bias", RIGHT, value=5.0)]),
    Mission("cruise_tail_float", [_failure("float", LEFT)]),
)  # fmt: skip


def chosen(missions: Sequence[Mission], choices: str | None) -> list[Mission]:
    """The missions that any of the choices, joined by commas, means; all for None. Exits if one means none."""
    if choices is None:
        return list(missions)
    for choice in choices.split(","):
        if not any(mission.is_meant_by(choice) for mission in missions):
            raise SystemExit(f"--missions: no mission has {choice} in its name; missions.py --list shows all")
    return [mission for mission in missions if any(map(mission.is_meant_by, choices.split(",")))]


@dataclass(frozen=True, order=True)
class Condition:
    """In what a mission is flown: aircraft, wind at 20 ft (sets the turbulence) [ft/s], relative model error."""

    aircraft: str = "vtail"
    w20_ft_s: float = 25.0
    model_error: float = 0.0

    def values(self, mission: Mission, seed: int) -> Values:
        """What differs from BASE in the flight of this mission with this seed."""
        values: dict[str, Any] = {"aircraft": self.aircraft, "failures": [dict(f) for f in mission.failures]}
        values |= mission.route.values
        if self.w20_ft_s:
            values["atmosphere.turbulence_w20_m_s"] = self.w20_ft_s * METRES_PER_FOOT
        if self.model_error:
            names = coefficients(self.aircraft)
            values["controller.model_error"] = coefficient_errors(names, self.model_error, seed)
        return values

    @property
    def title(self) -> str:
        air = f"W20 = {self.w20_ft_s:g} ft/s" if self.w20_ft_s else "calm air"
        return f"{self.aircraft}, {air}" + (f", model {self.model_error:.0%} off" if self.model_error else "")


@cache
def coefficients(aircraft: str) -> tuple[str, ...]:
    """Names of the coefficients of an aircraft's design model."""
    return tuple(load_design_model(load_aircraft(aircraft).folder / DESIGN_MODEL).coefficient_names())
