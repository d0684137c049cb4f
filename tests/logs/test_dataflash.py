"""ArduPilot's DataFlash logs: one that is written here, message by message, from the description of the format."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import yaml
from command_line import in_this_process
from pymavlink.DFReader import DFReader_binary

from testbed.inputs.problems import BadInput
from testbed.logs import autopilot_logs
from testbed.logs.autopilot_logs import dataflash_columns as columns

from .conftest import AT_S, Run

MESSAGES = {
    "IMU": (129, "QBffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX", 100),
    "ATT": (130, "Qff", "TimeUS,Roll,Pitch", 25),
    "ARSP": (131, "QBf", "TimeUS,I,Airspeed", 25),
    "AOA": (132, "Qff", "TimeUS,AOA,SSA", 25),
    "RCOU": (133, "QHHff", "TimeUS,C1,C2,T1,T2", 50),
}
"""Number, format, fields, rate [Hz]. The thrusts T1, T2 stand for motors whose log has no throttle."""
MAPPING: dict[str, Any] = {
    "time": {"column": "IMU.TimeUS", "unit": "us"},
    "signals": {
        "p": {"column": "IMU.GyrX", "unit": "rad_s"}, "q": {"column": "IMU.GyrY", "unit": "rad_s"},
        "r": {"column": "IMU[0].GyrZ", "unit": "rad_s"}, "u_dot": {"column": "IMU.AccX", "unit": "m_s2"},
        "roll": {"column": "ATT.Roll", "unit": "deg"}, "pitch": {"column": "ATT.Pitch", "unit": "deg"},
        "airspeed": {"column": "ARSP.Airspeed", "unit": "m_s"},
        "alpha": {"column": "AOA.AOA", "unit": "deg"}, "beta": {"column": "AOA.SSA", "unit": "deg"},
    },
    "actuators": {
        "left_ruddervator": {"column": "RCOU.C1", "unit": "deg", "zero": 1500, "scale": 0.06},
        "right_ruddervator": {"column": "RCOU.C2", "unit": "deg", "zero": 1500, "scale": 0.06},
        "left_propeller": {"column": "RCOU.T1", "unit": "N"}, "right_propeller": {"column": "RCOU.T2", "unit": "N"},
    },
}  # fmt: skip


def _declared(name: str) -> bytes:
    number, kinds, fields, _ = MESSAGES[name]
    size = 3 + struct.calcsize("<" + kinds)
    text = [name.encode(), kinds.encode(), fields.encode()]
    return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", number, size, *text)


def _written(log: pd.DataFrame) -> bytes:
    """The bytes of a DataFlash log of a run's sensors and commands."""
    rad = np.pi / 180
    pulses = [1500 + log[f"{side}_ruddervator_command"] / 0.06 for side in ("left", "right")]
    zeros = np.zeros(len(log))
    values = {
        "IMU": [zeros, *(log[f"{axis}_measured_deg_s"] * rad for axis in "pqr"), log["u_dot_m_s2"]],
        "ATT": [log["roll_measured_deg"], log["pitch_measured_deg"]],
        "ARSP": [zeros, log["airspeed_measured_m_s"]],
        "AOA": [log["alpha_measured_deg"], log["beta_measured_deg"]],
        "RCOU": [*pulses, log["left_propeller_command"], log["right_propeller_command"]],
    }
    own = (128, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
    format_of_formats = b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", *own)
    parts = [format_of_formats, *map(_declared, MESSAGES)]
    for row, time_s in enumerate(log["time_s"]):
        for name, (number, kinds, _, rate) in MESSAGES.items():
            if row % (100 // rate) == 0:
                numbers = [each.iloc[row] if hasattr(each, "iloc") else each[row] for each in values[name]]
                told = [round(x) if k in "BHQ" else float(x) for x, k in zip(numbers, kinds[1:], strict=True)]
                parts.append(struct.pack("<2sB" + kinds, b"\xa3\x95", number, round(time_s * 1e6), *told))
    return b"".join(parts)


@pytest.fixture(scope="session")
def content(run: Run) -> bytes:
    folder = run({"type": "effectiveness", "actuator": "left_ruddervator", "value": 0.3}, True)
    return _written(pd.read_csv(folder / "log.csv"))


def _diagnosed(folder: Path, content: bytes, mapping: Any = MAPPING) -> Any:
    (folder / "map.yaml").write_text(yaml.safe_dump(mapping))
    (folder / "log.bin").write_bytes(content)
    return in_this_process(
        folder, "diagnose", "log.bin", "--model", "vtail", "--columns", "map.yaml", "--out", "out"
    )


def test_messages_of_several_rates_lead_to_the_failure(tmp_path: Path, content: bytes) -> None:
    ended = _diagnosed(tmp_path, content)
    assert ended.returncode == 1, ended.stderr
    summary = yaml.safe_load((tmp_path / "out" / "summary.json").read_text())
    (finding,) = summary["findings"]
    assert (finding["actuator"], finding["state"]) == ("left_ruddervator", "weak")
    assert abs(finding["from_s"] - AT_S) < 1.0 and abs(finding["effectiveness"] - 0.3) < 0.1


def test_a_log_that_was_cut_is_read_as_far_as_it_goes(tmp_path: Path, content: bytes) -> None:
    """As after a crash: the last message may be torn."""
    ended = _diagnosed(tmp_path, content[: int(0.8 * len(content)) + 7])
    assert ended.returncode == 1, ended.stderr


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"column": "RCIN.C1", "unit": "deg"}, "has no message RCIN"),
        ({"column": "RCOU.C11", "unit": "deg"}, "has no field C11 of RCOU"),
        ({"column": "pwm", "unit": "deg"}, "expected MESSAGE.Field"),
        ({"column": "RCOU[3].C1", "unit": "deg"}, "of this sensor"),
    ],
)
def test_what_the_log_has_not_is_said(tmp_path: Path, content: bytes, change: Any, words: str) -> None:
    actuators = {**MAPPING["actuators"], "left_ruddervator": change}
    ended = _diagnosed(tmp_path, content, {**MAPPING, "actuators": actuators})
    assert ended.returncode == 2 and words in ended.stderr
    assert "Traceback" not in ended.stderr and not (tmp_path / "out").exists()


def _message(name: str, number: int, kinds: str, fields: str, *rows: tuple[Any, ...]) -> bytes:
    """Messages of a kind of their own, with its declaration."""
    letters = kinds.replace("Z", "64s")
    said = (number, 3 + struct.calcsize("<" + letters), name.encode(), kinds.encode(), fields.encode())
    made = [struct.pack("<2sB" + letters, b"\xa3\x95", number, *row) for row in rows]
    return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", *said) + b"".join(made)


@pytest.mark.parametrize(
    ("added", "refused"),
    [
        (_message("MSG", 140, "QZ", "TimeUS,Message", (0, b"ArduCopter V4.5.0 (2f4096)")), True),
        (_message("MSG", 140, "QZ", "TimeUS,Message", (0, b"ArduPlane V4.5.0 (2f4096)")), False),
        (_message("MOTB", 140, "Qf", "TimeUS,LiftMax", (0, 1.0)), True),
        (_message("MOTB", 140, "Qf", "TimeUS,LiftMax"), False),
    ],
)
def test_a_multicopters_log_is_refused(tmp_path: Path, content: bytes, added: bytes, refused: bool) -> None:
    """By its program's name, or by what its mixer writes; a kind that is declared and never written says nothing."""
    ended = _diagnosed(tmp_path, content + added)
    assert ended.returncode == (2 if refused else 1)
    assert ("is the log of a multicopter, expected an aircraft with a wing" in ended.stderr) == refused


def test_times_of_old_logs_are_milliseconds(content: bytes) -> None:
    old = _message("OLD", 140, "If", "TimeMS,X", *((20 * i, 0.5 * i) for i in range(200)))
    found = columns(Path("log.bin"), content + old, ["IMU.TimeUS", "OLD.X"], "IMU.TimeUS")
    until = found["IMU.TimeUS"] <= 199 * 20e3
    np.testing.assert_allclose(found["OLD.X"][until], found["IMU.TimeUS"][until] / 40e3, atol=1e-6)


def test_everything_that_a_log_has_not_is_said_at_once(tmp_path: Path, content: bytes) -> None:
    changed = {
        **MAPPING["actuators"],
        "left_propeller": {"column": "ESC.T1", "unit": "N"},
        "right_propeller": {"column": "RCOU.T3", "unit": "N"},
    }
    ended = _diagnosed(tmp_path, content, {**MAPPING, "actuators": changed})
    assert "has no message ESC, for ESC.T1" in ended.stderr
    assert "has no field T3 of RCOU, for RCOU.T3, expected one of TimeUS, C1" in ended.stderr


def test_noise_behind_the_first_bytes_is_refused(tmp_path: Path) -> None:
    ended = _diagnosed(tmp_path, b"\xa3\x95" + np.random.default_rng(3).bytes(5000))
    assert ended.returncode == 2 and ended.stderr.startswith("log.bin: ")


def test_the_columns_are_those_of_ardupilots_own_reader(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "log.bin").write_bytes(content)
    log, read = DFReader_binary(str(tmp_path / "log.bin")), []
    while (message := log.recv_match(type="IMU")) is not None:
        read.append([message.TimeUS, message.GyrX, message.AccX])
    found = columns(Path("log.bin"), content, ["IMU.TimeUS", "IMU.GyrX", "IMU.AccX"], "IMU.TimeUS")
    assert np.array_equal(np.column_stack(list(found.values())), np.array(read))


HOSTILE: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "text for a number": (lambda log: log.replace(b"QBffff", b"QBnfff", 1), "IMU.GyrX: has no numbers"),
    "letter that is no type": (lambda log: log.replace(b"QBffff", b"QB?fff", 1), "has no message IMU"),
    "type of another size": (lambda log: log.replace(b"QBffff", b"QBafff", 1), "has no message IMU"),
    "fewer names than types": (lambda log: log.replace(b",AccX", bytes(5), 1), "has no message IMU"),
    "a name twice": (lambda log: log.replace(b",GyrY,", b",GyrX,", 1), "has no message IMU"),
    "no time": (lambda log: log.replace(b"TimeUS,Roll", b"TimeXX,Roll", 1), "has no TimeUS of ATT"),
    "message of no length": (
        lambda log: log.replace(b"\xa3\x95\x80" + bytes([130, 19]), b"\xa3\x95\x80" + bytes([130, 0]), 1), "has no message ATT",
    ),
    "escape sequence for a name": (lambda log: log.replace(b"GyrX", b"\x1b]0;", 1), "has no field GyrX"),
    "megabytes of beginnings": (lambda _: b"\xa3\x95" * 5_000_000, "is no chain of messages"),
    "a declaration alone": (lambda _: _declared("ATT"), "is no chain of messages"),
}  # fmt: skip


@pytest.mark.parametrize("what", HOSTILE)
def test_a_log_made_to_harm_is_refused_in_words(tmp_path: Path, content: bytes, what: str) -> None:
    change, words = HOSTILE[what]
    ended = _diagnosed(tmp_path, change(content))
    assert ended.returncode == 2 and words in ended.stderr, ended.stderr
    assert ended.stdout == "" and "\x1b" not in ended.stderr


def test_a_log_of_too_many_messages_is_refused(content: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(autopilot_logs, "_MOST", 1000)
    with pytest.raises(BadInput, match="has more than 1000 messages"):
        columns(Path("log.bin"), content, ["IMU.TimeUS"], "IMU.TimeUS")
