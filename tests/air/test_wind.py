"""Wind, gusts and turbulence in flight: against Galilei, closed forms, and MIL-F-8785C."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.signal import welch

from testbed import fly
from testbed.air.config import severity
from testbed.air.wind import profile
from testbed.aircraft.description import load_aircraft
from testbed.common.random_streams import engine_seed
from testbed.plant.jsbsim import Plant
from testbed.scenario.load import Scenario, load_scenario

W20 = 7.62  # 25 ft/s


FT = 0.3048


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=2", "failures=[]", "requirements=[]", *settings]
    )


@pytest.mark.parametrize("wind", [(5.0, -7.0, 0.0), (0.0, 12.0, 0.0), (-9.0, 0.0, 0.0)])
def test_steady_wind_only_carries_the_aircraft_along(wind: tuple[float, float, float]) -> None:
    """Galilei: relative to the air nothing differs but what the rotating Earth does to a body moving over it
    (2 x 7.3e-5 rad/s x 12 m/s = 0.002 m/s2)."""
    calm, windy = fly(scenario()).log, fly(scenario(f"atmosphere.wind_m_s={list(wind)}")).log
    assert windy["airspeed_m_s"].iloc[0] == pytest.approx(18.0, abs=1e-9)
    assert windy[["wind_north_m_s", "wind_east_m_s", "wind_down_m_s"]].to_numpy() == pytest.approx(
        np.tile(wind, (400, 1)), abs=1e-9
    )
    limits = dict.fromkeys(("airspeed_m_s", "alpha_deg", "beta_deg", "roll_deg", "heading_deg"), 2e-3)
    limits |= {"p_deg_s": 2e-3, "q_deg_s": 1e-2, "r_deg_s": 2e-3, "pitch_deg": 1e-2, "u_dot_m_s2": 5e-3}
    for name, limit in limits.items():
        assert (windy[name] - calm[name]).abs().max() < limit, name
    time = calm["time_s"]
    for name, speed in zip(("north_m", "east_m", "altitude_m"), wind, strict=True):
        assert (windy[name] - calm[name] - speed * time).abs().max() < 0.02, name


def test_a_flight_begins_trimmed_in_sinking_air_too() -> None:
    """Only later, as the altitude is lost, does the controller answer."""
    calm, windy = fly(scenario()).log[:20], fly(scenario("atmosphere.wind_m_s=[3, 4, 1.5]")).log[:20]
    assert windy["climb_rate_m_s"].iloc[0] == pytest.approx(-1.5, abs=1e-6)
    for name in ("airspeed_m_s", "alpha_deg", "beta_deg", "p_deg_s", "q_deg_s", "r_deg_s", "u_dot_m_s2"):
        assert (windy[name] - calm[name]).abs()[:3].max() < 2e-3, name


def test_calm_adds_nothing() -> None:
    flight = fly(scenario("atmosphere.turbulence_w20_m_s=0", "atmosphere.gusts=[]"))
    assert not [column for column in flight.columns if column.startswith("wind")]
    assert flight.data.tobytes() == fly(scenario()).data.tobytes()


def test_the_profile_is_one_minus_cosine() -> None:
    time = np.linspace(0.0, 5.0, 501)
    values = np.array([profile(t, 1.0, 2.0) for t in time])
    np.testing.assert_allclose(values[:101], (1 - np.cos(np.pi * time[:101])) / 2, atol=1e-12)
    assert np.all(values[100:301] == 1.0)
    np.testing.assert_allclose(values[300:401], values[100::-1], atol=1e-12)
    assert np.all(values[401:] == 0.0)


def test_a_gust_blows_when_and_as_long_as_said() -> None:
    """Upwards 2 m/s over 9 m at 18 m/s: rises in 0.5 s from 0.5 s on, and is over at 1.5 s."""
    gust = "atmosphere.gusts=[{at_s: 0.5, length_m: 9, magnitude_m_s: [0, 0, -2], frame: ned}]"
    flight, calm = fly(scenario(gust)), fly(scenario())
    log, n = flight.log, len(calm.columns)
    assert flight.data[:101, :n].tobytes() == calm.data[:101].tobytes()
    assert not np.array_equal(flight.data[101:, :n], calm.data[101:])
    down = log["wind_down_m_s"].to_numpy()
    elapsed = log["time_s"].to_numpy() - 0.5
    expected = np.where((elapsed > 0) & (elapsed < 1.0), -(1 - np.cos(2 * np.pi * elapsed)), 0.0)
    np.testing.assert_allclose(down, expected, atol=1e-4)  # airspeed at 0.5 s is 18 within 1e-4
    assert down.min() == pytest.approx(-2.0, abs=1e-4)
    rise = math.radians(log["alpha_deg"].iloc[110] - log["alpha_deg"].iloc[100])
    assert 0.7 < rise / (0.0489 / 18.0) <= 1.0  # the gust after 0.05 s, less what the wing yields


def test_gusts_add_up_to_the_wind_and_turn_with_their_frame() -> None:
    """Flying east: forward is east, right is south. The frame is that of the gust's beginning."""
    gusts = (
        "[{at_s: 0.2, duration_s: 0.1, hold_s: 9, magnitude_m_s: [0, 2, 0], frame: body},"
        " {at_s: 0.2, duration_s: 0.1, hold_s: 9, magnitude_m_s: [-1, 0, 0], frame: wind}]"
    )
    log = fly(scenario(f"atmosphere.gusts={gusts}", "atmosphere.wind_m_s=[0.5, 0, 0]")).log
    row = log.iloc[100]
    assert row["wind_north_m_s"] == pytest.approx(0.5 - 2.0, abs=1e-3)
    assert row["wind_east_m_s"] == pytest.approx(-1.0, abs=5e-3)
    assert np.ptp(log["wind_north_m_s"].to_numpy()[100:]) < 1e-9  # though the aircraft turns


@pytest.fixture(scope="module")
def turbulence() -> np.ndarray:
    """[200000, 3] turbulence at 300 m and 18 m/s, 20 Hz, with the airframe held still (heading north)."""
    plant = Plant(load_aircraft("vtail"), 20)
    plant.place({"airspeed": 18.0, "altitude": 300.0, "alpha": 0.03, "pitch": 0.03, "heading": 0.0})
    plant.set_turbulence(W20, severity(W20), engine_seed(1, "turbulence"))
    rows = np.zeros((200_000, 3))
    for k in range(len(rows)):
        plant.settle(1)
        rows[k] = plant.total_wind()
    return rows


def test_turbulence_has_the_intensity_of_mil_f_8785c(turbulence: np.ndarray) -> None:
    """MIL-F-8785C 3.7.3.4, low altitude, h in feet: sigma_w = 0.1 W20, sigma_u = sigma_v = sigma_w / (0.177 +
    0.000823 h)^0.4, L_w = h, L_u = h / (0.177 + 0.000823 h)^1.2.

    Correlation times tau are L/V along and L/2V across (JSBSim: first-order filters), and the sample variance
    of T seconds has the relative deviation sqrt(2 tau / T): 4 to 6 % here, the bound is 4 of them.
    """
    h = 300.0 / FT
    f = 0.177 + 0.000823 * h
    sigma_w, length_u = 0.1 * W20, 300.0 / f**1.2
    sigma_u, total = sigma_w / f**0.4, len(turbulence) / 20.0
    taus = np.array([length_u / 18.0, length_u / 36.0, 300.0 / 36.0])
    variances = np.mean(turbulence**2, axis=0)
    for variance, sigma, tau in zip(variances, (sigma_u, sigma_u, sigma_w), taus, strict=True):
        assert variance / sigma**2 == pytest.approx(1.0, abs=4 * math.sqrt(2 * tau / total))


def test_turbulence_has_the_spectrum_of_its_filters(turbulence: np.ndarray) -> None:
    """Above its corner (V/(pi L) = 0.02 Hz) the vertical gust's spectrum falls as f^-2, like Dryden's: f^2 S
    is level. Means of 20 and 40 frequencies of 195 independent periodograms: 2 % together; the sampled filter's
    bend towards Nyquist is 2 % at 1.6 Hz. The bound is 3 deviations and the bend."""
    f, s = welch(turbulence[:, 2], fs=20.0, nperseg=1024)
    low, high = (np.mean((f * f * s)[(f > a) & (f < b)]) for a, b in ((0.2, 0.6), (0.8, 1.6)))
    assert high / low == pytest.approx(1.0, abs=0.08)
    slow = s[(f > 0) & (f < 0.03)].mean() / s[(f > 0.2) & (f < 0.3)].mean()
    assert slow > 20.0  # the negative control: white noise has 1


def test_turbulence_comes_from_the_flights_own_stream() -> None:
    def log(*settings: str) -> np.ndarray:
        flight = fly(scenario(f"atmosphere.turbulence_w20_m_s={W20}", "duration_s=1", *settings))
        return flight.log[["wind_north_m_s", "wind_east_m_s", "wind_down_m_s"]].to_numpy()

    first = log()
    assert np.all(np.abs(first[0]) < 1e-9) and np.all(first[1] != 0.0)  # placed in calm air, trimmed
    assert np.array_equal(first, log())
    assert not np.array_equal(first, log("seed=2"))
    # Sensors draw from other streams; from the second step on, the filters know that the flight is another.
    assert np.array_equal(first[:2], log("sensors=mems")[:2])
    np.testing.assert_allclose(first, log("sensors=mems"), atol=0.02)
