"""Engines on the stand: the map is what the engine gives, its response is the modelled one, and flight begins with both."""

from __future__ import annotations

import math
from functools import partial

import numpy as np
import pytest
from stock_aircraft import c172p, glider, jet

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.design_model import DesignModel
from testbed.aircraft.propulsors import EngineMap
from testbed.common.signals import STATE
from testbed.plant.identification import identify
from testbed.plant.jsbsim import Plant
from testbed.plant.settling import settle_at
from testbed.plant.thrust_stand import follow, throttle_grid
from testbed.plant.trim import Trim, begin_at, trimmed_start

HZ = 200


@pytest.fixture(scope="module", params=[c172p, jet], ids=lambda make: make.__name__)
def powered(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Aircraft, DesignModel]:
    aircraft = load_aircraft(str(request.param(tmp_path_factory.mktemp("aircraft") / "made")))
    return aircraft, identify(aircraft)


def engines(model: DesignModel) -> dict[int, EngineMap]:
    return {i: p for i, p in enumerate(model.propulsors) if isinstance(p, EngineMap)}


def level(aircraft: Aircraft) -> tuple[Plant, Trim]:
    """A new plant, and the trim at the aircraft's reference, which is found once."""
    at = aircraft.reference
    return Plant(aircraft, HZ), trimmed_start(aircraft, HZ, at.airspeed_m_s, at.altitude_m, math.pi / 2)


def test_flight_begins_with_engines_running(powered: tuple[Aircraft, DesignModel]) -> None:
    """Open loop for 2 s: no rate above 0.02 deg/s, altitude within 2 cm, and the place is the start's."""
    aircraft, _ = powered
    _, start = level(aircraft)
    plant = Plant(aircraft, HZ)
    begin_at(plant, start)
    first = dict(zip(STATE, plant.read(), strict=False))
    assert abs(first["north"]) + abs(first["east"]) < 1e-6
    for _ in range(2 * HZ):
        plant.step()
    now = dict(zip(STATE, plant.read(), strict=False))
    assert max(abs(now[name]) for name in "pqr") < math.radians(0.02)
    assert now["altitude"] == pytest.approx(aircraft.reference.altitude_m, abs=0.02)
    assert min(plant.position(i) for i in engines(powered[1])) > 100.0


def test_redundant_throttles_are_equal(powered: tuple[Aircraft, DesignModel]) -> None:
    aircraft, model = powered
    _, start = level(aircraft)
    throttles = [start.commands[i] for i in engines(model)]
    assert max(throttles) - min(throttles) < 1e-6


def test_the_map_is_the_thrust_that_the_engine_gives(powered: tuple[Aircraft, DesignModel]) -> None:
    """At the trim, to 0.1 % of full thrust; between its points and at other airspeeds, to 3 %."""
    aircraft, model = powered
    plant, start = level(aircraft)
    for i, engine in engines(model).items():
        full = engine.thrust_at(engine.throttles[-1], model.airspeed_m_s)
        for throttle, share, within in (
            (start.commands[i], 1.0, 1e-3),
            (0.83, 1.07, 0.03),
            (0.55, 0.9, 0.03),
        ):
            commands = [throttle if j == i else c for j, c in enumerate(start.commands)]
            settle_at(plant, {**start.state, "airspeed": share * model.airspeed_m_s}, commands)
            axial = share * model.airspeed_m_s * math.cos(start.state["alpha"])
            assert engine.thrust_at(throttle, axial) == pytest.approx(plant.position(i), abs=within * full)


def test_the_response_is_the_modelled_one(powered: tuple[Aircraft, DesignModel]) -> None:
    """A step of the throttle that was not among those it was fitted to, for 4 s: within a tenth of the change."""
    aircraft, model = powered
    plant, start = level(aircraft)
    begin_at(plant, start)
    for i, engine in engines(model).items():
        step = [c + 0.2 if j == i else c for j, c in enumerate(start.commands)]
        settle_at(plant, start.state, start.commands)
        plant.command(step)
        thrusts = []
        for _ in range(80):
            thrusts.append(plant.position(i))
            plant.settle(HZ // 20)
        followed = follow(
            np.full(80, step[i]),
            start.commands[i],
            engine.lag_rad_s,
            engine.rise_s,
            engine.fall_s,
            0.05,
        )
        axial = model.airspeed_m_s * math.cos(model.alpha_rad)
        modelled = [engine.thrust_at(float(t), axial) for t in followed]
        change = engine.thrust_at(step[i], axial) - thrusts[0]
        assert np.abs(np.array(modelled) - thrusts).max() < 0.15 * change


def test_an_engines_lost_effectiveness_is_what_the_model_says(powered: tuple[Aircraft, DesignModel]) -> None:
    """Rates without one engine, held in the trim: thrust, and the torque of a propeller."""
    aircraft, model = powered
    plant, start = level(aircraft)
    before = {**start.state, "p": 0.0, "q": 0.0, "r": 0.0}
    positions = [
        math.radians(p) if k == "servo" else p for p, k in zip(start.positions, model.kinds, strict=True)
    ]
    for i in engines(model):
        name = f"{list(aircraft.actuators.values())[i].prefix}/effectiveness"
        plant[name] = 0.0
        settle_at(plant, start.state, start.commands)
        truth = [plant[f"accelerations/{axis}dot-rad_sec2"] for axis in "pqr"]
        plant[name] = 1.0
        lost = [0.0 if j == i else 1.0 for j in range(len(positions))]
        assert model.rates(before, positions, lost)[:3] == pytest.approx(truth, abs=2e-4)


def test_an_engine_without_power_stops(powered: tuple[Aircraft, DesignModel]) -> None:
    """By its own switch: the others run on."""
    aircraft, model = powered
    plant, start = level(aircraft)
    begin_at(plant, start)
    first, *others = engines(model)
    plant[f"{list(aircraft.actuators.values())[first].prefix}/power-lost"] = 1.0
    for _ in range(10 * HZ):
        plant.settle(1)
    assert plant.position(first) <= 0.05 * start.positions[first]
    for i in others:
        assert plant.position(i) == pytest.approx(start.positions[i], rel=1e-3)


def test_a_glider_is_trimmed_in_its_glide(tmp_path_factory: pytest.TempPathFactory) -> None:
    aircraft = load_aircraft(str(glider(tmp_path_factory.mktemp("aircraft") / "made")))
    plant, start = level(aircraft)
    begin_at(plant, start)
    drag, lift = (abs(plant[f"forces/fw{axis}-aero-lbs"]) for axis in "xz")
    assert math.tan(start.state["path_angle"]) == pytest.approx(-drag / lift, rel=1e-2)
    assert start.state["airspeed"] == 30.0


@pytest.mark.parametrize("trimmed", [0.0, 0.03, 0.5, 0.71, 1.0])
def test_the_trims_throttle_is_a_point_of_the_grid(trimmed: float) -> None:
    grid = throttle_grid((0.0, 1.0), trimmed)
    assert np.all(np.diff(grid) > 0.0)
    assert np.abs(grid - trimmed).min() < 1e-12
    assert (grid[0], grid[-1]) == (0.0, 1.0)


def test_a_followed_throttle_has_lag_and_rates() -> None:
    """First-order towards a small step, at limited rates towards large ones, in both directions."""
    fast = partial(follow, start=0.0, lag=2.0, rise=10.0, fall=10.0, dt=0.01)
    after = fast(np.array([0.0, *[0.1] * 50]))
    assert after[-1] == pytest.approx(0.1 * (1.0 - math.exp(-0.98)), rel=1e-6)
    limited = follow(np.array([0.0, *[1.0] * 100, *[0.0] * 100]), 0.0, 1e3, 0.2, 0.5, 0.01)
    assert limited[100] == pytest.approx(0.2 * 0.99)
    assert limited[-1] == pytest.approx(0.0, abs=1e-9)
