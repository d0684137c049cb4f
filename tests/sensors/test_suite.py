"""What the controller is told: models, faults and streams, against closed forms and statistics."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import yaml

from testbed import fly
from testbed.common.random_streams import engine_seed, generator
from testbed.common.signals import STATE
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario, dump, load_scenario
from testbed.sensors.channels import CHANNELS, PER_SECOND, SI, channels_of
from testbed.sensors.faults import TABLE
from testbed.sensors.measurement import READING
from testbed.sensors.settings import SENSORS, Sensors, SensorSettings
from testbed.sensors.suite import RealSensors

RATE = 200
NAMES = [channel.name for channel in CHANNELS]
SENSED = {channel.reads for channel in CHANNELS}


class Still:
    """A plant whose accelerometer feels 0.3 m/s2."""

    def specific_force_reader(self, axis: str):
        return lambda: 0.3


def truth_rows(steps: int) -> np.ndarray:
    """A made-up, smooth flight; every entry is another."""
    time = np.arange(steps)[:, None] / RATE
    rows = 0.2 + 0.1 * np.sin(time * (1.0 + 0.1 * np.arange(len(STATE)))) + 0.01 * np.arange(len(STATE))
    rows[:, STATE.index("airspeed")] += 18.0
    rows[:, STATE.index("altitude")] += 300.0
    return np.hstack([rows, np.ones((steps, 8))])


def measured(settings: object, truth: np.ndarray, seed: int = 1) -> tuple[RealSensors, np.ndarray]:
    """The sensors after a flight, and [steps, state] what the controller was told."""
    sensors = RealSensors(Sensors.model_validate(settings), Still(), RATE, len(truth), seed)
    told = np.full((len(truth), len(STATE)), np.nan)  # so that what is not written shows
    sensors.bind(truth, told)
    for k in range(len(truth)):
        sensors.measure(k)
    return sensors, told


def readings(settings: object, channel: str, steps: int = 400, seed: int = 1) -> np.ndarray:
    """Errors of one channel that looks at a constant [the channel's unit]."""
    truth = np.repeat(truth_rows(1), steps, axis=0)
    index = NAMES.index(channel)
    sensors, _ = measured(settings, truth, seed)
    reads = CHANNELS[index].reads
    true = truth[:, STATE.index(reads)] if reads in STATE else 0.3
    return (sensors.table[READING, :, index] - true) / SI[CHANNELS[index].unit]


# No truth leaks ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("column", range(len(STATE) + 8))
def test_what_has_no_sensor_is_not_known(column: int) -> None:
    """NaN in one entry of the truth reaches what is computed from its sensor, and nothing else."""
    truth = truth_rows(20)
    _, sound = measured("mems", truth)
    truth[:, column] = np.nan
    _, poisoned = measured("mems", truth)
    name = STATE[column] if column < len(STATE) else "an actuator"
    reached = {STATE[i] for i in np.flatnonzero(np.isnan(poisoned).any(axis=0))}
    if name not in SENSED:
        assert not reached
    else:
        derived = {"pitch", "q", "r", "airspeed", "alpha", "beta"}
        expected = {name} | ({"u_dot"} if name in derived else set())
        expected |= {f"{name}_dot"} if name in ("p", "q", "r") else set()
        assert reached == expected
    others = [i for i, s in enumerate(STATE) if s not in reached]
    assert np.array_equal(poisoned[:, others], sound[:, others])


def test_rates_come_from_gyros_and_accelerometer() -> None:
    truth = truth_rows(50)
    fault = {"type": "bias", "sensor": "gyro_p", "at_s": 0.1, "value_deg_s": 1}
    _, told = measured({"faults": [fault]}, truth)
    p, q, r = (told[:, STATE.index(name)] for name in "pqr")
    for name, rate in zip("pqr", (p, q, r), strict=True):
        np.testing.assert_allclose(told[1:, STATE.index(f"{name}_dot")], np.diff(rate) * RATE, atol=1e-9)
    speed, alpha, beta, pitch = (told[:, STATE.index(n)] for n in ("airspeed", "alpha", "beta", "pitch"))
    v, w = speed * np.sin(beta), speed * np.sin(alpha) * np.cos(beta)
    u_dot = 0.3 - 9.80665 * np.sin(pitch) - q * w + r * v
    np.testing.assert_allclose(told[:, STATE.index("u_dot")], u_dot, rtol=1e-12)


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=4", "failures=[]", "requirements=[]", *settings]
    )


def test_the_accelerometer_feels_what_jsbsim_flies() -> None:
    """With sensors that have no errors, u_dot of the accelerometer is JSBSim's own in a manoeuvre, but for
    gravity's change with place (0.3 %) and the Earth's rotation; p_dot is a step late."""
    fault = "sensors={faults: [{type: bias, sensor: position, at_s: 3.9, value_m: 1}]}"
    turn = "commands=[{at_s: 0, heading_deg: 120, airspeed_m_s: 19}]"
    log = fly(scenario(fault, turn)).log
    assert log["u_dot_true_m_s2"].abs().max() > 0.2
    assert (log["u_dot_m_s2"] - log["u_dot_true_m_s2"]).abs().max() < 0.01
    assert (log["q_dot_deg_s2"] - log["q_dot_true_deg_s2"].shift(1)).abs().max() < 1e-6


# Ideal sensors ----------------------------------------------------------------------------------------------


def test_ideal_is_the_truth_and_adds_nothing() -> None:
    flight = fly(scenario("sensors=ideal"))
    assert not [c for c in flight.columns if "measured" in c or "_true_" in c]
    assert fly(scenario()).data.tobytes() == flight.data.tobytes()
    assert Sensors.model_validate("ideal").is_ideal
    assert Sensors.model_validate({"gyro": {"noise_deg_s_rthz": 0.0}}).is_ideal
    assert not Sensors.model_validate("mems").is_ideal


def test_sensors_without_errors_tell_the_truth() -> None:
    truth = truth_rows(100)
    _, told = measured({"model": "ideal"}, truth)
    kept = [i for i, name in enumerate(STATE) if not name.endswith("_dot")]
    assert np.array_equal(told[:, kept], truth[:, : len(STATE)][:, kept])


# Faults: every type on every channel and sensor -------------------------------------------------------------


def fault_of(kind: str, sensor: str) -> dict[str, object]:
    """A fault of this type that this sensor can have, from 0.5 to 1 s."""
    unit = CHANNELS[channels_of(sensor)[0]].unit
    value = {
        "stuck": {f"value_{unit}": 1.0},
        "dropout": {},
        "bias": {f"value_{unit}": 0.5},
        "drift": {f"rate_{PER_SECOND[unit]}": 0.5},
        "noise": {f"noise_{unit}_rthz": 0.1},
    }[kind]
    return {"type": kind, "sensor": sensor, "at_s": 0.5, "until_s": 1.0, **value}


@pytest.mark.parametrize("sensor", dict.fromkeys([*SENSORS, *NAMES]))
@pytest.mark.parametrize("kind", TABLE)
@pytest.mark.parametrize("model", ["ideal", "mems"])
def test_a_fault_acts_in_its_window_only(kind: str, sensor: str, model: str) -> None:
    truth = truth_rows(300)
    sound, told_sound = measured({"model": model}, truth)
    broken, told = measured({"model": model, "faults": [fault_of(kind, sensor)]}, truth)
    before, after = slice(0, 100), slice(200, None)
    for window in (before, after):
        assert np.array_equal(broken.table[READING, window], sound.table[READING, window])
    assert np.array_equal(told[before], told_sound[before])
    assert np.array_equal(told[201:], told_sound[201:])  # row 200 differentiates over the fault's end
    changed = (broken.table[READING] != sound.table[READING]).any(axis=0)
    assert list(np.flatnonzero(changed)) == channels_of(sensor)
    begin, end = broken.receipts(300)
    assert begin["verified"] and (begin["time_s"], end["time_s"]) == (0.5, 1.0)
    assert begin["kind"] == "sensor_fault" and begin["sensor"] == sensor


@pytest.mark.parametrize("channel", NAMES)
@pytest.mark.parametrize("kind", ["bias", "drift", "noise"])
def test_a_fault_of_nothing_changes_nothing_and_says_so(kind: str, channel: str) -> None:
    truth = truth_rows(250)
    fault = fault_of(kind, channel)
    fault = {k: 0.0 if k.startswith(("value", "rate", "noise")) else v for k, v in fault.items()}
    broken, told = measured({"model": "mems", "faults": [fault]}, truth)
    assert np.array_equal(told, measured("mems", truth)[1])
    assert not broken.receipts(250)[0]["verified"]


def test_what_each_fault_reads() -> None:
    def read(**fault: object) -> np.ndarray:
        truth = truth_rows(400)
        sensors, _ = measured({"faults": [{"sensor": "altitude", "at_s": 1.0, **fault}]}, truth)
        return sensors.table[READING, :, NAMES.index("altitude")]

    truth = truth_rows(400)[:, STATE.index("altitude")]
    assert np.all(read(type="stuck")[200:] == truth[199])
    assert np.all(read(type="stuck", value_m=7)[200:] == 7.0)
    assert np.all(read(type="dropout")[200:] == 0.0)
    np.testing.assert_allclose(read(type="drift", rate_m_s=2.0)[200:] - truth[200:], np.arange(200) / 100.0)
    lost = read(type="dropout", fraction=0.3, reads="last")[200:]
    held = np.append(lost[0] == truth[199], lost[1:] == lost[:-1])
    assert abs(np.mean(held) - 0.3) < 5 * math.sqrt(0.3 * 0.7 / 200)
    assert np.array_equal(lost[~held], truth[200:][~held])


def test_faults_add_up_but_do_not_fight() -> None:
    bias = {"type": "bias", "sensor": "airspeed", "at_s": 0, "value_m_s": 1}
    assert np.allclose(readings({"faults": [bias, bias]}, "airspeed"), 2.0)
    stuck = {"type": "stuck", "sensor": "airspeed", "at_s": 1}
    with pytest.raises(ValueError, match="both decide what airspeed reads"):
        Sensors.model_validate({"faults": [bias, stuck]})
    Sensors.model_validate({"faults": [bias | {"until_s": 1}, stuck]})


# Models, against closed forms -------------------------------------------------------------------------------


def test_deterministic_errors() -> None:
    truth = truth_rows(100)
    index, column = NAMES.index("airspeed"), STATE.index("airspeed")

    def read(**model: float) -> np.ndarray:
        return measured({"airspeed": model}, truth)[0].table[READING, :, index]

    v = truth[:, column]
    np.testing.assert_allclose(read(bias_m_s=0.4), v + 0.4, rtol=1e-14)
    np.testing.assert_allclose(read(scale_error=0.02), 1.02 * v, rtol=1e-14)
    assert np.array_equal(read(delay_s=0.02)[4:], v[:-4]) and np.all(read(delay_s=0.02)[:4] == v[0])
    digits = read(resolution_m_s=0.5)
    assert np.all(np.abs(digits - v) <= 0.25 + 1e-12) and np.all(digits * 2 == np.round(digits * 2))
    truth[:, column] = 18.0
    truth[1:, column] = 19.0
    lagged = read(low_pass_rad_s=20.0)
    np.testing.assert_allclose(19.0 - lagged, np.exp(-20.0 * np.arange(100) / RATE), rtol=1e-9)


def test_heading_goes_round() -> None:
    """A lag and a bias across north give no jump through the south."""
    truth = truth_rows(200)
    truth[:, STATE.index("heading")] = (6.2 + 0.002 * np.arange(200)) % (2 * np.pi)
    settings = {"heading": {"low_pass_rad_s": 20.0, "bias_deg": -3.0}}
    heading = measured(settings, truth)[1][:, STATE.index("heading")]
    assert np.all((heading >= 0.0) & (heading < 2 * np.pi))
    steps = (np.diff(heading) + np.pi) % (2 * np.pi) - np.pi
    assert np.all(np.abs(steps) < 0.003)


@pytest.mark.parametrize("channel", NAMES)
def test_noise_has_the_density_that_was_asked_for(channel: str) -> None:
    """sigma = N sqrt(rate/2), and means of m samples have 1/m of its variance, as white noise of one-sided
    density N must. A variance of n samples has the relative deviation sqrt(2/n); 5 of them fail once in 2
    million."""
    _, sensor, _, unit = CHANNELS[NAMES.index(channel)]
    density, n, m = 0.01, 40_000, 100
    error = readings({sensor: {f"noise_{unit}_rthz": density}}, channel, n)
    variance = density**2 * RATE / 2
    assert np.var(error) == pytest.approx(variance, rel=5 * math.sqrt(2 / n))
    means = error.reshape(-1, m).mean(axis=1)
    assert np.mean(means**2) == pytest.approx(variance / m, rel=5 * math.sqrt(2 * m / n))


def test_noise_of_a_flight_measured_from_its_log() -> None:
    """From the log of a flight with MEMS gyros: 0.007 deg/s/rtHz. First differences, so that bias and drift
    do not count: their variance is twice the noise's; quantisation adds 1/12 digit squared."""
    log = fly(scenario("sensors=mems", "controller.released=[p_dot]", "controller.filter_rad_s=20")).log
    for name in "pqr":
        error = np.diff(log[f"{name}_measured_deg_s"] - log[f"{name}_deg_s"])[10:]
        expected = 2 * (0.007**2 * RATE / 2 + 0.0153**2 / 12)
        assert np.var(error) == pytest.approx(expected, rel=5 * math.sqrt(3 / len(error)))


def test_drift_and_wander() -> None:
    """A random walk's increments have variance K^2 dt; a wander has its sigma and correlation time: the
    relative deviation of its variance over T is sqrt(2 tau / T)."""
    walk = readings({"altitude": {"drift_m_rts": 0.3}}, "altitude", 20_000)
    assert walk[0] == 0.0
    assert np.var(np.diff(walk)) == pytest.approx(0.3**2 / RATE, rel=5 * math.sqrt(2 / 20_000))
    tau, steps = 0.05, 40_000
    wander = readings({"alpha": {"wander_deg": 0.4, "wander_time_s": tau}}, "alpha", steps)
    bound = 5 * math.sqrt(2 * tau * RATE / steps)
    assert np.mean(wander**2) == pytest.approx(0.16, rel=bound)
    lag = round(tau * RATE)
    assert np.mean(wander[lag:] * wander[:-lag]) == pytest.approx(0.16 * math.exp(-1), rel=2 * bound)


def test_bias_and_scale_are_drawn_for_each_flight() -> None:
    draws = [readings({"beta": {"bias_sigma_deg": 0.3}}, "beta", 2, seed) for seed in range(300)]
    assert all(one[0] == pytest.approx(one[1]) for one in draws)
    assert np.std([one[0] for one in draws]) == pytest.approx(0.3, rel=5 / math.sqrt(600))
    scales = {float(readings({"airspeed": {"scale_error_sigma": 0.1}}, "airspeed", 2, s)[0]) for s in (1, 2)}
    assert len(scales) == 2


# Streams ----------------------------------------------------------------------------------------------------


def test_adding_a_random_part_moves_no_other() -> None:
    truth = truth_rows(200)
    few = {"gyro": {"noise_deg_s_rthz": 0.01}}
    more = {"gyro": {"noise_deg_s_rthz": 0.01, "bias_sigma_deg_s": 1.0}, "altitude": {"noise_m_rthz": 1.0}}
    more["faults"] = [fault_of("noise", "airspeed")]  # type: ignore[assignment]
    one, other = (measured(settings, truth)[0].table[READING] for settings in (few, more))
    q = NAMES.index("gyro_q")
    shift = other[:, q] - one[:, q]
    np.testing.assert_allclose(shift, shift[0], atol=1e-15)  # the bias, and the same noise
    longer = measured(few, truth_rows(300))[0].table[READING]
    assert np.array_equal(longer[:200], one)


def test_streams_are_named_and_differ() -> None:
    names = [f"sensors.{n}.{p}" for n in NAMES for p in ("noise", "bias", "drift", "wander", "scale")]
    names += ["turbulence"]
    firsts = [generator(1, name).standard_normal() for name in names]
    assert len(set(firsts)) == len(names)
    assert generator(1, "a").standard_normal() == generator(1, "a").standard_normal()
    seeds = np.array([engine_seed(seed, "turbulence") for seed in range(2000)], dtype=float)
    assert seeds.min() >= 2 and seeds.max() < 2**31 - 1 and len(set(seeds)) == 2000
    assert abs(np.corrcoef(seeds[1:], seeds[:-1])[0, 1]) < 5 / math.sqrt(2000)
    assert all(abs(b - a) > 1 for a, b in pairwise(sorted(seeds[:5])))


def test_the_same_flight_twice_and_another_seed() -> None:
    settings = ("sensors=mems", "controller.released=[p_dot]", "duration_s=1")
    first, again, other = (fly(scenario(*settings, f"seed={seed}")) for seed in (1, 1, 2))
    assert first.data.tobytes() == again.data.tobytes()
    assert first.data.tobytes() != other.data.tobytes()


# YAML -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", TABLE)
@pytest.mark.parametrize("sensor", dict.fromkeys([*SENSORS, *NAMES]))
def test_faults_survive_yaml_and_pickle(kind: str, sensor: str, tmp_path: Path) -> None:
    text = yaml.safe_dump({"model": "mems", "faults": [fault_of(kind, sensor)]}, default_flow_style=True)
    one = scenario(f"sensors={text}")
    file = tmp_path / "again.yaml"
    file.write_text(dump(one))
    assert load_scenario(file) == one
    assert pickle.loads(pickle.dumps(one)) == one


def test_words_and_what_differs_from_them() -> None:
    assert yaml.safe_load(dump(scenario()))["sensors"] == "ideal"
    mems = Sensors.model_validate({"model": "mems", "gyro": {"noise_deg_s_rthz": 0.1}})
    assert mems.of("gyro").si("noise") == pytest.approx(math.radians(0.1))
    assert mems.of("gyro").si("bias_sigma") == pytest.approx(math.radians(0.05))
    assert mems.of("altitude") == SensorSettings.of(Sensors.model_validate("mems"), "altitude")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("meems", "sensors: 'meems' is not known, did you mean mems?"),
        ("3", "sensors: is 3, expected ideal, mems or a mapping"),
        ("{model: memes}", "sensors.model: 'memes' is not known, did you mean mems?"),
        ("{gyros: {}}", "sensors.gyros: unknown key, did you mean gyro?"),
        ("{gyro: 3}", "sensors.gyro: is 3"),
        ("{model: mems, gyro: {noise_deg_s_rtHz: 1}}", "did you mean noise_deg_s_rthz?"),
        ("{gyro: {noise_deg_s_rthz: -1}}", "sensors.gyro.noise_deg_s_rthz: is -1"),
        ("{heading: {scale_error: 0.1}}", "heading has a scale error"),
        ("{faults: [{sensor: gyro, at_s: 1}]}", "sensors.faults.0.type: is missing"),
        ("{faults: [{type: stuk, sensor: gyro, at_s: 1}]}", "did you mean stuck?"),
        ("{faults: [{type: stuck, sensor: gyroq, at_s: 1}]}", "did you mean gyro_q?"),
        ("{faults: [{type: stuck, at_s: 1}]}", "sensors.faults.0.sensor: is missing"),
        ("{faults: [{type: stuck, sensor: gyro}]}", "sensors.faults.0.at_s: is missing"),
        ("{faults: [{type: stuck, sensor: gyro, at_s: 1, until_s: 1}]}", "until_s: 1 s is not after at_s"),
        ("{faults: [{type: stuck, sensor: gyro, at_s: 9}]}", "sensors.faults.0.at_s: 9 s is not within"),
        ("{faults: [{type: bias, sensor: gyro, at_s: 1}]}", "has no value, expected value_deg_s"),
        ("{faults: [{type: bias, sensor: gyro, at_s: 1, value_m: 1}]}", "expected value_deg_s"),
        ("{faults: [{type: drift, sensor: alpha, at_s: 1}]}", "has no value, expected rate_deg_s"),
        ("{faults: [{type: dropout, sensor: alpha, at_s: 1, fraction: 2}]}", "fraction: is 2"),
        ("{faults: [{type: noise, sensor: alpha, at_s: 1, noise_deg_rthz: -2}]}", "noise_deg_rthz: is -2"),
    ],
)
def test_refusals(text: str, words: str) -> None:
    with pytest.raises(BadInput) as caught:
        scenario(f"sensors={text}")
    assert len(caught.value.problems) == 1
    assert words in str(caught.value)
