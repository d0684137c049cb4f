"""The `sensors` block of a scenario: presets, what differs from them, and what is refused."""

from __future__ import annotations

import math

import pytest
import yaml
from measuring import scenario

from testbed.inputs.problems import BadInput
from testbed.scenario.load import dump
from testbed.sensors.settings import Sensors, SensorSettings


def test_words_and_what_differs_from_them() -> None:
    assert yaml.safe_load(dump(scenario()))["sensors"] == "ideal"
    mems = Sensors.model_validate({"model": "mems", "gyro": {"noise_deg_s_rthz": 0.1}})
    assert mems.of("gyro").si("noise") == pytest.approx(math.radians(0.1))
    assert mems.of("gyro").si("bias_sigma") == pytest.approx(math.radians(0.05))
    assert mems.of("altitude") == SensorSettings.of(Sensors.model_validate("mems"), "altitude")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("meems", "sensors: 'meems' is not known (one of your own needs --with FILE.py), did you mean mems?"),
        ("3", "sensors: is 3, expected ideal, mems or a mapping"),
        (
            "{model: memes}",
            "sensors.model: 'memes' is not known (one of your own needs --with FILE.py), did you mean mems?",
        ),
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
