"""Every type of fault on every channel and sensor: acts in its window only, reads what it should, survives YAML."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import numpy as np
import pytest
import yaml
from measuring import NAMES, fault_of, measured, readings, scenario, truth_rows

from testbed.common.signals import STATE
from testbed.scenario.load import dump, load_scenario
from testbed.sensors.channels import channels_of
from testbed.sensors.faults import TABLE
from testbed.sensors.measurement import READING
from testbed.sensors.settings import SENSORS, Sensors


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


@pytest.mark.parametrize("kind", TABLE)
@pytest.mark.parametrize("sensor", dict.fromkeys([*SENSORS, *NAMES]))
def test_faults_survive_yaml_and_pickle(kind: str, sensor: str, tmp_path: Path) -> None:
    text = yaml.safe_dump({"model": "mems", "faults": [fault_of(kind, sensor)]}, default_flow_style=True)
    one = scenario(f"sensors={text}")
    file = tmp_path / "again.yaml"
    file.write_text(dump(one))
    assert load_scenario(file) == one
    assert pickle.loads(pickle.dumps(one)) == one
