"""What is looked at in each row of truth: SI, measured ideally, and which limit ends a flight."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from testbed.aircraft.description import Envelope
from testbed.common.angles import body_from_ned
from testbed.common.signals import STATE
from testbed.plant.envelope import (
    DIVERGED,
    GOES_ON,
    GROUND_M,
    LIMITS,
    ON_THE_GROUND,
    OUTSIDE_ENVELOPE,
    limits_of,
    observe,
)

ENVELOPE = Envelope(
    airspeed_min_m_s=8,
    airspeed_max_m_s=40,
    altitude_min_m=10,
    alpha_max_deg=20,
    beta_max_deg=25,
    roll_max_deg=80,
)
LEVEL = {"altitude": 100.0, "airspeed": 18.0}
ACTUATORS = 2
CALM = (0.0, 0.0, 0.0)


def look(
    envelope: Envelope = ENVELOPE, wind: Sequence[float] = CALM, **values: float
) -> tuple[int, np.ndarray, np.ndarray]:
    """How the flight ends with these values in this wind [m/s], the row of truth, and the measured one."""
    raw = np.zeros(len(STATE) + 2 * ACTUATORS)
    for name, value in {**LEVEL, **values}.items():
        raw[STATE.index(name)] = value
    factors = np.ones_like(raw)
    truth, measured = np.full((3, len(raw)), np.nan), np.full((3, len(STATE)), np.nan)
    ending = observe(1, (raw, factors, np.array(wind), limits_of(envelope), truth, measured))
    assert np.isnan(truth[[0, 2]]).all() and np.isnan(measured[[0, 2]]).all(), "no other row is touched"
    return ending, truth[1], measured[1]


def test_inside_the_envelope_a_flight_goes_on() -> None:
    ending, truth, measured = look(north=3.0)
    assert ending == GOES_ON
    assert truth[STATE.index("north")] == 3.0
    assert np.array_equal(measured, truth[: len(STATE)])


def test_units_are_turned_into_si() -> None:
    raw, factors = np.arange(1.0, len(STATE) + 1.0), np.linspace(0.1, 2.0, len(STATE))
    truth, measured = np.zeros((1, len(raw))), np.zeros((1, len(STATE)))
    observe(0, (raw, factors, np.array(CALM), limits_of(Envelope()), truth, measured))
    assert np.array_equal(truth[0], raw * factors)


@pytest.mark.parametrize(
    ("name", "limit", "inside", "outside"),
    [
        ("airspeed", 8.0, 8.001, 7.999),
        ("airspeed", 40.0, 39.999, 40.001),
        ("altitude", 10.0, 10.001, 9.999),
        ("alpha", np.radians(20), 0.349, 0.3491),
        ("beta", np.radians(25), 0.4363, 0.4364),
        ("roll", np.radians(80), 1.3962, 1.3963),
    ],
)
def test_each_limit_ends_a_flight(name: str, limit: float, inside: float, outside: float) -> None:
    assert look(**{name: inside})[0] == GOES_ON
    assert look(**{name: limit})[0] == GOES_ON, "a limit itself is inside"
    assert look(**{name: outside})[0] == OUTSIDE_ENVELOPE
    if name in ("alpha", "beta", "roll"):
        assert look(**{name: -inside})[0] == GOES_ON
        assert look(**{name: -outside})[0] == OUTSIDE_ENVELOPE
    assert look(Envelope(), **{name: outside})[0] == GOES_ON, "a limit that is not given does not exist"


def test_the_ground_is_below_every_envelope() -> None:
    assert look(Envelope(), altitude=GROUND_M)[0] == GOES_ON
    assert look(Envelope(), altitude=GROUND_M - 1e-6)[0] == ON_THE_GROUND
    assert look(altitude=-5.0, roll=3.0)[0] == ON_THE_GROUND, "before any other limit"


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", ["altitude", "r_dot"])
def test_what_is_not_finite_has_diverged(name: str, value: float) -> None:
    assert look(**{name: value})[0] == DIVERGED


def test_every_limit_has_its_own_place() -> None:
    limits = limits_of(ENVELOPE)[0]
    assert [float(limits[name]) for name in LIMITS] == pytest.approx(
        [10.0, 8.0, 40.0, np.radians(20), np.radians(25), np.radians(80)]
    )


def test_in_any_attitude_it_is_the_turning_of_the_wind_with_the_body() -> None:
    wind, rates = np.array([4.0, -3.0, 1.5]), {"p": 0.3, "q": -0.2, "r": 0.5}
    attitude = {"roll": 0.4, "pitch": -0.3, "heading": 2.1}
    _, truth, measured = look(wind=wind.tolist(), **attitude, **rates)
    turning = np.cross(list(rates.values()), body_from_ned(**attitude) @ wind)
    place = STATE.index("u_dot")
    assert measured[place] - truth[place] == pytest.approx(turning[0])


def test_in_wind_u_dot_is_measured_through_the_air() -> None:
    """By hand: 10 m/s from the left of a level aircraft that yaws by 0.5 rad/s take 5 m/s2 from what is true over the ground."""
    to_the_east = (0.0, 10.0, 0.0)
    _, truth, measured = look(wind=to_the_east, u_dot=1.0, r=0.5)
    assert measured[STATE.index("u_dot")] == pytest.approx(1.0 - 5.0)
    assert truth[STATE.index("u_dot")] == 1.0
    others = [i for i, name in enumerate(STATE) if name != "u_dot"]
    assert np.array_equal(measured[others], truth[others])
