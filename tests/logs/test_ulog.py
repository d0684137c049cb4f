"""ULog: what we export is read by PX4's own reader, and leads back to what was broken; and what is no log is refused."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from command_line import ROOT, in_this_process
from pyulog import ULog

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.failures import TABLE
from testbed.flight.folder import load
from testbed.logs.diagnosis import diagnosed
from testbed.logs.entry import _setup
from testbed.logs.mapped import read_table
from testbed.logs.page import of_log
from testbed.plant.identification import stored
from testbed.reporting.export import export

from .conftest import AT_S, Run

MAPPING = ROOT / "examples" / "px4_columns.yaml"
WEAK = {"type": "effectiveness", "actuator": "left_ruddervator", "value": 0.3}


@pytest.fixture(scope="session")
def log(run: Run, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The ULog of a flight in weather with a weak tail."""
    return export(load(run(WEAK, True)), "ulog", tmp_path_factory.mktemp("ulog") / "log.ulg")


def test_px4s_reader_reads_it(run: Run, log: Path) -> None:
    """Every topic with every row; the sensors' values within single precision, and the truth beside them."""
    flight, read = load(run(WEAK, True)), ULog(str(log))
    topics = {each.name: each.data for each in read.data_list}
    assert set(flight.actuators) < set(topics) and not read.file_corruption
    rates = topics["vehicle_angular_velocity"]
    np.testing.assert_allclose(rates["timestamp"] * 1e-6, flight.log["time_s"], atol=1e-6)
    np.testing.assert_allclose(
        np.degrees(rates["xyz[1]"]), flight.log["q_measured_deg_s"], rtol=1e-6, atol=1e-5
    )
    truth = topics["vehicle_angular_velocity_groundtruth"]
    np.testing.assert_allclose(np.degrees(truth["xyz[1]"]), flight.log["q_deg_s"], rtol=1e-6, atol=1e-5)
    said = [message.message for message in read.logged_messages]
    assert len(said) == len(flight.events) and any("left ruddervator" in each for each in said)


def test_the_attitude_of_a_turn(run: Run, log: Path) -> None:
    """Roll, pitch and heading of the log, from the quaternion, by scipy."""
    from scipy.spatial.transform import Rotation

    flight = load(run(WEAK, True))
    data = ULog(str(log), ["vehicle_attitude_groundtruth"]).data_list[0].data
    q = np.stack([data[f"q[{i}]"] for i in (1, 2, 3, 0)], axis=1)
    yaw, pitch, roll = Rotation.from_quat(q).as_euler("ZYX", degrees=True).T
    np.testing.assert_allclose(roll, flight.log["roll_deg"], atol=1e-3)
    np.testing.assert_allclose(pitch, flight.log["pitch_deg"], atol=1e-3)
    np.testing.assert_allclose((yaw - flight.log["heading_deg"] + 180.0) % 360.0 - 180.0, 0.0, atol=1e-3)


def _diagnosed(folder: Path, log: Path, mapping: Path = MAPPING) -> Any:
    return in_this_process(
        folder, "diagnose", str(log), "--model", "vtail", "--columns", str(mapping), "--out", "out"
    )


def test_the_way_back_leads_to_the_failure(tmp_path: Path, run: Run, log: Path) -> None:
    """What is said of the ULog is what is said of the run folder."""
    ended = _diagnosed(tmp_path, log)
    assert ended.returncode == 1, ended.stderr
    (own,) = testbed.diagnose(run(WEAK, True)).findings
    (found,) = yaml.safe_load((tmp_path / "out" / "summary.json").read_text())["findings"]
    assert (found["actuator"], found["state"]) == (own.actuator, own.state) == ("left_ruddervator", "weak")
    assert abs(found["from_s"] - own.from_s) < 0.21 and abs(found["effectiveness"] - own.effectiveness) < 0.02


def test_a_files_page_replays_where_it_flew(tmp_path: Path, run: Run, log: Path) -> None:
    """From a log's position, attitude and commands: the run's own place and heading, within single precision."""
    flown = load(run(WEAK, True)).log
    aircraft = load_aircraft("vtail")
    read = read_table(log, MAPPING, aircraft)
    found = diagnosed(read, _setup(aircraft))
    scene = of_log(found, aircraft, stored(aircraft))
    for name in ("north_m", "east_m", "altitude_m", "left_ruddervator_command", "right_propeller_position"):
        there = flown[name.replace("_position", "_command")]
        np.testing.assert_allclose(scene.log[name], there[: len(scene.log[name])], rtol=1e-4, atol=1e-2)
    turned = scene.log["heading_deg"] - flown["heading_measured_deg"][: len(scene.log["heading_deg"])]
    np.testing.assert_allclose((turned + 180.0) % 360.0 - 180.0, 0.0, atol=1e-2)
    assert _diagnosed(tmp_path, log).returncode == 1
    page = (tmp_path / "out" / "report.html").read_text()
    assert 'id="replay"' in page and "The log has no truth" in page


@pytest.mark.nightly
@pytest.mark.parametrize("weather", [False, True], ids=["calm", "mems"])
@pytest.mark.parametrize("name", sorted(TABLE))
def test_every_failure_comes_back_as_it_was(run: Run, tmp_path: Path, name: str, weather: bool) -> None:
    """The ULog says of each type of failure what the run folder says: the same actuators in the same states."""
    failure: dict[str, Any] = {"type": name, "set": {"fcs/left-ruddervator/effectiveness": 0.4}}
    if name != "property":
        kind, values = next((k, v) for k, v in TABLE[name].examples.items() if k in ("servo", "motor"))
        failure = {
            "type": name,
            "actuator": {"servo": "left_ruddervator", "motor": "right_propeller"}[kind],
            **values,
        }
    folder = run(failure, weather)
    file = export(load(folder), "ulog", tmp_path / "log.ulg")
    own, back = testbed.diagnose(folder), testbed.diagnose(file, "vtail", MAPPING)
    assert [(f.actuator, f.state) for f in back.findings] == [(f.actuator, f.state) for f in own.findings]
    for one, other in zip(own.findings, back.findings, strict=True):
        assert abs(one.from_s - other.from_s) < 0.41
    assert all(f.from_s > AT_S - 10.0 for f in back.findings)


def test_a_log_that_was_cut_is_read_as_far_as_it_goes(tmp_path: Path, log: Path) -> None:
    """As after a crash: the last message may be torn."""
    content = log.read_bytes()
    (tmp_path / "cut.ulg").write_bytes(content[: int(0.8 * len(content)) + 7])
    ended = _diagnosed(tmp_path, tmp_path / "cut.ulg")
    assert ended.returncode == 1, ended.stderr


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"column": "actuator_outputs.output[0]", "unit": "deg"}, "has no topic actuator_outputs"),
        ({"column": "left_rudervator.command", "unit": "deg"}, "did you mean left_ruddervator?"),
        ({"column": "left_ruddervator.comand", "unit": "deg"}, "did you mean command"),
        ({"column": "pwm", "unit": "deg"}, "expected TOPIC.field"),
        ({"column": "left_ruddervator[2].command", "unit": "deg"}, "has no topic left_ruddervator"),
    ],
)
def test_what_the_log_has_not_is_said(tmp_path: Path, log: Path, change: Any, words: str) -> None:
    mapping = yaml.safe_load(MAPPING.read_text())
    mapping["actuators"]["left_ruddervator"] = change
    (tmp_path / "map.yaml").write_text(yaml.safe_dump(mapping))
    ended = _diagnosed(tmp_path, log, tmp_path / "map.yaml")
    assert ended.returncode == 2 and words in ended.stderr
    assert "Traceback" not in ended.stderr and not (tmp_path / "out").exists()


@pytest.mark.parametrize("topic", ["right_propeller", "left_ruddervator"])
def test_a_topic_without_a_time_is_said(tmp_path: Path, log: Path, topic: str) -> None:
    content, format_of = log.read_bytes(), f"F{topic}:uint64_t timestamp;".encode()
    assert content.count(format_of) == 1
    (tmp_path / "log.ulg").write_bytes(
        content.replace(format_of, format_of.replace(b"timestamp", b"timestamq"))
    )
    ended = _diagnosed(tmp_path, tmp_path / "log.ulg")
    assert ended.returncode == 2 and "did you mean right_propeller?" not in ended.stderr
    assert "has no timestamp" in ended.stderr or "that can be read" in ended.stderr, ended.stderr


NO_LOGS = {
    "empty": b"",
    "cut": b"ULog\x01\x12\x35",
    "noise": b"ULog\x01\x12\x35\x01" + bytes(range(256)) * 40,
}


@pytest.mark.parametrize("content", NO_LOGS.values(), ids=NO_LOGS)
def test_what_is_no_log_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "log.ulg").write_bytes(content)
    ended = _diagnosed(tmp_path, tmp_path / "log.ulg")
    assert ended.returncode == 2 and ended.stderr.startswith(str(tmp_path / "log.ulg")), ended.stderr
    assert not (tmp_path / "out").exists()


def test_a_gyro_in_degrees_is_refused(tmp_path: Path, log: Path) -> None:
    mapping = yaml.safe_load(MAPPING.read_text())
    for axis in "pqr":
        mapping["signals"][axis]["scale"] = 57.3
    (tmp_path / "map.yaml").write_text(yaml.safe_dump(mapping))
    ended = _diagnosed(tmp_path, log, tmp_path / "map.yaml")
    assert ended.returncode == 2 and "unit" in ended.stderr and "vehicle_angular_velocity" in ended.stderr


def _message(kind: bytes, body: bytes) -> bytes:
    return struct.pack("<H", len(body)) + kind + body


@pytest.mark.parametrize(("kind", "words"), [(2, "is the log of a quadcopter, by its MAV_TYPE"), (1, "")])
def test_a_quadcopters_log_is_refused(tmp_path: Path, log: Path, kind: int, words: str) -> None:
    content, key = log.read_bytes(), b"int32_t MAV_TYPE"
    said = _message(b"P", bytes([len(key)]) + key + struct.pack("<i", kind))
    (tmp_path / "log.ulg").write_bytes(content[:16] + said + content[16:])
    ended = _diagnosed(tmp_path, tmp_path / "log.ulg")
    assert ended.returncode == (2 if words else 1) and words in ended.stderr


FORMATS = {
    "of itself": [b"n0:uint8_t a;n0 b;"],
    "of one another": [b"n0:n1 a;", b"n1:n0 a;"],
    "that multiply": [*(f"n{i}:n{i + 1}[60000] a;".encode() for i in range(6)), b"n6:uint8_t a;"],
    "of many fields": [b"n0:uint8_t[65000] a;"],
    "of a field without end": [b"n0:uint8_t[" + b"9" * 5000 + b"] a;"],
}


@pytest.mark.parametrize("what", FORMATS)
def test_formats_made_to_fill_the_memory_are_refused(tmp_path: Path, log: Path, what: str) -> None:
    """PX4's reader makes a list of all fields, in formats within formats too."""
    content = log.read_bytes()
    declared = b"".join(_message(b"F", each) for each in FORMATS[what])
    (tmp_path / "log.ulg").write_bytes(content[:16] + declared + content[16:])
    ended = _diagnosed(tmp_path, tmp_path / "log.ulg")
    assert ended.returncode == 2 and "has a format of more than 10000 fields, or of itself" in ended.stderr
