"""Dryden turbulence in flight: its spectra and moments in still air-frame, its noise as an input, and flights beside JSBSim's."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.signal import welch
from scipy.stats import ks_2samp

from testbed import fly
from testbed.air.config import Atmosphere
from testbed.air.turbulence import Turbulence, rolling_intensity
from testbed.aircraft.description import load_aircraft
from testbed.plant.jsbsim import Plant
from testbed.scenario.load import Scenario, load_scenario
from testbed.simulation import assemble

W20 = 7.62  # 25 ft/s
FT = 0.3048
AIRSPEED, ALTITUDE, RATE = 18.0, 100.0, 10
WIND = ["wind_north_m_s", "wind_east_m_s", "wind_down_m_s"]


def scenario(*settings: str) -> Scenario:
    base = ["duration_s=2", "failures=[]", "requirements=[]", "controller={type: adaptive_inversion}"]
    air = [f"atmosphere.turbulence_w20_m_s={W20}", "atmosphere.model=dryden_8785c"]
    return load_scenario("scenarios/left_tail_fail.yaml", [*base, *air, *settings])


@pytest.fixture(scope="module")
def air() -> np.ndarray:
    """[200000, 6] what the plant is told at 100 m and 18 m/s, heading north: velocity [m/s] and rotation [rad/s]."""
    plant = Plant(load_aircraft("vtail"), RATE, 1, rotating_air=True)
    plant.place({"airspeed": AIRSPEED, "altitude": ALTITUDE, "alpha": 0.03, "pitch": 0.03, "heading": 0.0})
    settings = Atmosphere(turbulence_w20_m_s=W20, model="dryden_1797b")
    turbulence = Turbulence(settings, plant, RATE, 200_000, 5)
    turbulence.begin(np.zeros(3))
    rows = np.zeros((200_000, 6))
    for k in range(len(rows)):
        turbulence.step(k)
        rows[k] = turbulence._air / plant.air_factors
    return rows


def expected() -> tuple[float, float, float, float]:
    """sigma_u, sigma_w, length_u, length_w at this altitude, by MIL-F-8785C 3.7.3.4."""
    f = 0.177 + 0.000823 * ALTITUDE / FT
    return 0.1 * W20 / f**0.4, 0.1 * W20, ALTITUDE / f**1.2, ALTITUDE


def test_variances(air: np.ndarray) -> None:
    """The variance of T seconds deviates by sqrt(2 tau / T), tau at most L / V: 4 of these deviations."""
    sigma_u, sigma_w, length_u, length_w = expected()
    total = len(air) / RATE
    for i, sigma, length in ((0, sigma_u, length_u), (1, sigma_u, length_u), (2, sigma_w, length_w)):
        relative = np.mean(air[:, i] ** 2) / sigma**2
        assert relative == pytest.approx(1.0, abs=4.0 * math.sqrt(2.0 * length / AIRSPEED / total)), i
    span = load_span()
    rolling = np.mean(air[:, 3] ** 2) / rolling_intensity(sigma_w, length_w, span) ** 2
    assert rolling == pytest.approx(
        1.0, abs=0.08
    )  # a lag of 1.5 steps loses 4 % by holding, and 4 deviations are 2 %


def load_span() -> float:
    return Plant(load_aircraft("vtail"), RATE).span_m


def test_spectra(air: np.ndarray) -> None:
    """Welch's estimate in bands of at least 40 frequencies of 390 independent periodograms, against the formulas: 5 deviations of
    less than 1 %, and 2 % of bend by the noise that is held."""
    sigma_u, sigma_w, length_u, length_w = expected()
    frequency, density = welch(air[:, :3], fs=RATE, nperseg=1024, axis=0)
    omega = 2.0 * np.pi * frequency / AIRSPEED
    u, v, w = (
        sigma_u**2 * 2.0 * length_u / np.pi / (1.0 + (length_u * omega) ** 2),
        *(
            sigma**2
            * length
            / np.pi
            * (1.0 + 3.0 * (length * omega) ** 2)
            / (1.0 + (length * omega) ** 2) ** 2
            for sigma, length in ((sigma_u, length_u), (sigma_w, length_w))
        ),
    )
    for i, formula in enumerate((u, v, w)):
        for low, high in ((0.05, 0.45), (0.45, 0.9)):
            band = (frequency > low) & (frequency < high)
            found = density[band, i].mean() / (formula[band].mean() * 2.0 * np.pi / AIRSPEED)
            assert found == pytest.approx(1.0, abs=0.07), (i, low)


def test_parts_are_independent_but_for_slopes(air: np.ndarray) -> None:
    """u, v, w, p are; q is the slope of w and r that of v: -dw/dx, dv/dx."""
    fast = np.diff(
        air, axis=0
    )  # nearly white, so that the correlation of so many samples is known to 1 / sqrt(N)
    found = np.corrcoef(fast[:, :4].T) - np.eye(4)
    assert np.max(np.abs(found)) < 5.0 / math.sqrt(len(fast))
    assert np.corrcoef(fast[:, 2], air[1:, 4])[0, 1] < -0.2
    assert np.corrcoef(fast[:, 1], air[1:, 5])[0, 1] > 0.2


def test_noise_is_an_input_that_moves_the_flight_a_little() -> None:
    def wind(*coefficients: float, seed: int = 1) -> np.ndarray:
        given = f"atmosphere.noise={{from_s: 0.5, until_s: 1.5, w: {list(coefficients)}}}"
        return fly(scenario(given, f"seed={seed}")).log[WIND].to_numpy()

    start, near, far = wind(1.0, 0.5), wind(1.0, 0.5 + 1e-3), wind(1.0, 2.5)
    assert np.array_equal(start[:101], far[:101])  # before the window
    assert not np.array_equal(start[102:], far[102:])
    down = (far - start)[:, 2]
    np.testing.assert_allclose((near - start)[:, 2] * 2e3, down, atol=0.02 * np.abs(down).max())
    assert np.max(np.abs((near - start)[:, :2])) < 1e-4  # u and v feel it only by airspeed and heading
    assert np.array_equal(start, wind(1.0, 0.5)) and not np.array_equal(start, wind(1.0, 0.5, seed=2))


def test_turbulence_blows_over_wind_and_gusts() -> None:
    gust = "{at_s: 0.2, duration_s: 0.1, hold_s: 0.5, magnitude_m_s: [0, 0, -2], frame: ned}"
    alone = fly(scenario()).log[WIND].to_numpy()
    both = fly(scenario("atmosphere.wind_m_s=[3, -1, 0]", f"atmosphere.gusts=[{gust}]")).log[WIND].to_numpy()
    added = both - alone
    np.testing.assert_allclose(added[:40], np.tile([3.0, -1.0, 0.0], (40, 1)), atol=0.01)
    np.testing.assert_allclose(added[70:150, 2], -2.0, atol=0.05)
    np.testing.assert_allclose(added[300:, 2], 0.0, atol=0.05)
    assert np.all(np.abs(alone[0]) < 1e-9) and np.all(alone[1] != 0.0)


def test_both_specifications_make_the_same_flight() -> None:
    one, other = fly(scenario()), fly(scenario("atmosphere.model=dryden_1797b"))
    assert one.data.tobytes() == other.data.tobytes()
    jsbsim = fly(scenario("atmosphere.model=jsbsim"))
    assert jsbsim.columns == one.columns and jsbsim.data.tobytes() != one.data.tobytes()


def test_sensors_leave_the_turbulence_as_it_was() -> None:
    """Their noise is from other streams; later the filters know that the flight is another."""
    ideal, real = (
        fly(scenario(f"sensors={s}", "duration_s=1")).log[WIND].to_numpy() for s in ("ideal", "mems")
    )
    assert np.array_equal(ideal[:2], real[:2])
    np.testing.assert_allclose(ideal, real, atol=0.02)


@pytest.mark.nightly
def test_flights_are_distributed_as_with_jsbsims_turbulence() -> None:
    """Two-sample tests of 24 flights each. The gusts along the path have the same filter, and so has what they move, the airspeed.
    JSBSim's filters across it are of first order, with 4/3 of Dryden's density at high frequencies: its gusts change sqrt(4/3)
    times as fast, and move the aircraft by more."""

    def facts(model: str) -> np.ndarray:
        settings = ("duration_s=30", "commands=[]", "initial.heading_deg=0", f"atmosphere.model={model}")
        rows = []
        for seed in range(1, 25):
            log = fly(scenario(*settings, f"seed={seed}")).log[2000:]
            fast = log[WIND].diff(20).std().to_numpy()
            rows.append([log["airspeed_m_s"].std(), *fast, log["climb_rate_m_s"].std()])
        return np.array(rows)

    ours, theirs = facts("dryden_8785c"), facts("jsbsim")
    faster = math.sqrt(4.0 / 3.0)
    for i, name, ratio in ((0, "airspeed", 1.0), (1, "u", 1.0), (2, "v", faster), (3, "w", faster)):
        assert ks_2samp(ours[:, i] * ratio, theirs[:, i]).pvalue > 0.01, name
    for i in (2, 3):
        assert ks_2samp(ours[:, i], theirs[:, i]).pvalue < 1e-3  # the test can tell the two apart
    assert 1.0 < np.mean(theirs[:, 4]) / np.mean(ours[:, 4]) < 1.25


@pytest.mark.parametrize("gusts", ["[]", "[{at_s: 0.4, duration_s: 0.2, magnitude_m_s: [2, 1, -1]}]"])
def test_the_wind_that_is_logged_is_that_which_jsbsim_flies_in(gusts: str) -> None:
    """It is not read back from JSBSim, which turns it about the Earth and back: equal but for rounding."""
    parts = assemble(
        scenario(f"atmosphere.gusts={gusts}", "atmosphere.wind_m_s=[3, -2, 0.5]", "duration_s=1")
    )
    for k in range(100):
        flown_in = parts.plant.total_wind()
        parts.weather.apply(k)
        assert parts.weather.wind[k] == pytest.approx(flown_in, abs=1e-12)
        parts.plant.step()
    assert np.ptp(parts.weather.wind[:100], axis=0).min() > 0.1
