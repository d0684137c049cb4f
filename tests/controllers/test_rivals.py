"""The list of who flies a benchmark: each is a controller, and holds healthy flights of aircraft of every size."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path

import adopted_aircraft
import pytest
import yaml
from short_flights import worst_errors

from testbed.aircraft.description import load_aircraft
from testbed.controllers.config import TABLE
from testbed.controllers.rivals import INFORMED, RIVALS
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

ADOPTED = ("c172p", "A320")
NEW = ("adaptive_indi", "mrac", "pid")


@pytest.fixture(scope="module")
def adopted(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], str]:
    """An aircraft as a scenario names it; those of ADOPTED are adopted when they are first asked for."""

    @cache
    def folder(name: str) -> str:
        return str(adopted_aircraft.adopted(name, tmp_path_factory.mktemp("adopted")))

    return lambda name: folder(name) if name in ADOPTED else name


def errors_over_airspeed(folder: Path, aircraft: str, controller: dict[str, object]) -> tuple[float, float]:
    """Worst altitude error [s of airspeed] and heading error [deg] of 60 s with a turn and a climb in light turbulence."""
    at = load_aircraft(aircraft).reference
    v = at.airspeed_m_s
    text = {
        "name": "healthy", "aircraft": aircraft, "duration_s": 60, "seed": 7, "controller": dict(controller),
        "initial": {"altitude_m": at.altitude_m, "airspeed_m_s": v, "heading_deg": 90},
        "command_rates": {"heading_deg_s": math.degrees(1.26 / v), "altitude_m_s": 0.055 * v},
        "commands": [{"at_s": 5, "heading_deg": 105}, {"at_s": 25, "altitude_m": at.altitude_m + 0.6 * v}],
        "sensors": "mems", "atmosphere": {"turbulence_w20_m_s": 4.57},
    }  # fmt: skip
    file = folder / "healthy.yaml"
    file.write_text(yaml.safe_dump(text))
    flight = fly(load_scenario(file))
    assert flight.outcome == "completed"
    altitude, heading, _ = worst_errors(flight, 5.0)
    return altitude / v, heading


def test_every_rival_is_a_controller_and_every_controller_has_a_place() -> None:
    named = {str(block["type"]) for block in (*RIVALS.values(), *INFORMED.values())}
    assert named == set(TABLE)
    for block in (*RIVALS.values(), *INFORMED.values()):
        TABLE[str(block["type"])].model_validate(block)
    assert next(iter(RIVALS)) == "adaptive_inversion"
    assert not RIVALS.keys() & INFORMED.keys()


@pytest.mark.parametrize("name", NEW)
@pytest.mark.parametrize(
    "aircraft", ["vtail", "aerosonde", *(pytest.param(name, marks=pytest.mark.nightly) for name in ADOPTED)]
)
def test_healthy_flights_are_held(
    tmp_path: Path, adopted: Callable[[str], str], aircraft: str, name: str
) -> None:
    """Within 0.3 s of airspeed (5.4 m for the v-tail, 42 m for the A320) and 15 deg."""
    altitude, heading = errors_over_airspeed(tmp_path, adopted(aircraft), dict(RIVALS[name]))
    assert (altitude < 0.3, heading < 15.0) == (True, True), (altitude, heading)


@pytest.mark.nightly
@pytest.mark.parametrize("name", [name for name in (*RIVALS, *INFORMED) if name not in NEW])
@pytest.mark.parametrize("aircraft", ["vtail", "vtail_aft", "aerosonde", *ADOPTED])
def test_everybody_holds_them(
    tmp_path: Path, adopted: Callable[[str], str], aircraft: str, name: str
) -> None:
    block = {**RIVALS, **INFORMED}[name]
    if aircraft.startswith("vtail") and (block.get("keeps_axes") or block.get("released") == []):
        pytest.skip("a v-tail cannot keep roll in gusts: it is why `released` is derived")
    altitude, heading = errors_over_airspeed(tmp_path, adopted(aircraft), dict(block))
    assert (altitude < 0.3, heading < 15.0) == (True, True), (altitude, heading)


@pytest.mark.nightly
def test_gains_of_a_small_v_tail_lose_an_airliner(tmp_path: Path, adopted: Callable[[str], str]) -> None:
    """Negative control: gains found for 5 kg."""
    small = {
        "type": "pid",
        "altitude_kp": 2.2,
        "altitude_ki": 0.035,
        "pitch_kp": 6.6,
        "q_kp": 20.0,
        "heading_kp": 2.2,
    }
    try:
        held = errors_over_airspeed(tmp_path, adopted("A320"), small)
    except AssertionError:
        return
    assert max(held[0] / 0.3, held[1] / 15.0) > 1.0
