"""Logs of other programs: a mapping file leads to the same answer, and what cannot be read is refused in one sentence."""

from __future__ import annotations

import gzip
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
import yaml
from command_line import in_this_process

import testbed
from testbed.aircraft.description import load_aircraft
from testbed.logs.mapped import read_table

from .conftest import AT_S, Run

ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
MAPPING: dict[str, Any] = {
    "time": {"column": "t_us", "unit": "us"},
    "signals": {
        "p": {"column": "gx", "unit": "deg_s"},
        "q": {"column": "gy", "unit": "deg_s", "scale": -1},
        "r": {"column": "gz", "unit": "deg_s"},
        "roll": {"column": "roll", "unit": "rad"},
        "pitch": {"column": "pitch", "unit": "deg"},
        "airspeed": {"column": "tas", "unit": "kt"},
        "alpha": {"column": "aoa", "unit": "deg"},
        "beta": {"column": "aos", "unit": "deg"},
        "u_dot": {"column": "ax", "unit": "g"},
    },
    "actuators": {
        "left_ruddervator": {"column": "pwm1", "unit": "deg", "zero": 1500, "scale": 0.1},
        "right_ruddervator": {"column": "pwm2", "unit": "deg", "zero": 1500, "scale": -0.1},
        "left_propeller": {"column": "thrust1", "unit": "N"},
        "right_propeller": {"column": "thrust2", "unit": "N"},
    },
}


def _table(folder: Path) -> pd.DataFrame:
    """The log of a run as another program might have written it."""
    log = pd.read_csv(folder / "log.csv")
    return pd.DataFrame(
        {
            "t_us": (log["time_s"] + 100.0) * 1e6, "gx": log["p_measured_deg_s"], "gy": -log["q_measured_deg_s"],
            "gz": log["r_measured_deg_s"], "roll": np.radians(log["roll_measured_deg"]), "pitch": log["pitch_measured_deg"],
            "tas": log["airspeed_measured_m_s"] * 3600 / 1852, "aoa": log["alpha_measured_deg"], "aos": log["beta_measured_deg"],
            "ax": log["u_dot_m_s2"] / 9.80665,
            "pwm1": 1500 + 10 * log["left_ruddervator_command"], "pwm2": 1500 - 10 * log["right_ruddervator_command"],
            "thrust1": log["left_propeller_command"], "thrust2": log["right_propeller_command"],
        }
    )  # fmt: skip


@pytest.fixture(scope="session")
def table(run: Run) -> pd.DataFrame:
    return _table(run({"type": "effectiveness", "actuator": "left_ruddervator", "value": 0.3}, True))


def _written(folder: Path, table: pd.DataFrame, mapping: Any = MAPPING, name: str = "log.csv") -> list[str]:
    """The arguments of a command for this log."""
    (folder / "map.yaml").write_text(yaml.safe_dump(mapping))
    table.to_csv(folder / name, index=False) if name.endswith("csv") else table.to_parquet(folder / name)
    return ["diagnose", name, "--model", "vtail", "--columns", "map.yaml", "--out", "out"]


@pytest.mark.parametrize("name", ["log.csv", "log.parquet"])
def test_units_signs_and_zeros(tmp_path: Path, table: pd.DataFrame, name: str) -> None:
    arguments = _written(tmp_path, table, name=name)
    ended = in_this_process(tmp_path, *arguments)
    assert ended.returncode == 1, ended.stderr
    (found,) = testbed.diagnose(tmp_path / name, "vtail", tmp_path / "map.yaml").findings
    assert (found.actuator, found.state) == ("left_ruddervator", "weak")
    assert found.from_s == pytest.approx(100.0 + AT_S, abs=1.0)
    assert found.effectiveness == pytest.approx(0.3, abs=0.1)


def test_gaps_clock_steps_and_missing_values_are_mended_and_said(tmp_path: Path, table: pd.DataFrame) -> None:
    """Two seconds without rows, a clock that goes back for ten rows, and single values that are missing: the same finding."""
    table = table.drop(index=range(900, 1100)).reset_index(drop=True)
    table.loc[400:409, "t_us"] -= 5e6
    table.loc[::50, "gx"] = np.nan
    _written(tmp_path, table)
    found = testbed.diagnose(tmp_path / "log.csv", "vtail", tmp_path / "map.yaml")
    assert [(f.actuator, f.state) for f in found.findings] == [("left_ruddervator", "weak")]
    assert any("missing" in line for line in found.log.remarks)
    assert any("10 rows" in line for line in found.log.remarks)


BAD: dict[str, tuple[Callable[[pd.DataFrame], pd.DataFrame], Callable[[Any], Any], str]] = {
    "no rows": (lambda t: t.iloc[:0], lambda m: m, "log.csv"),
    "a few rows": (lambda t: t.iloc[:50], lambda m: m, "at least 10 s"),
    "a gyro in degrees": (
        lambda t: t,
        lambda m: {**m, "signals": {**m["signals"], "p": {"column": "gx", "unit": "rad_s"}}},
        "gx",
    ),
    "time in milliseconds": (lambda t: t, lambda m: {**m, "time": {"column": "t_us", "unit": "ms"}}, "time"),
    "two time bases": (
        lambda t: t.assign(t_us=np.where(np.arange(len(t)) % 2, t["t_us"], t["t_us"] / 1000)),
        lambda m: m,
        "of one clock",
    ),
    "no column": (lambda t: t.drop(columns="pwm2"), lambda m: m, "'pwm2'"),
    "no output": (lambda t: t.assign(pwm2=np.nan), lambda m: m, "no actuator's output"),
    "text": (lambda t: t.assign(gx="fast"), lambda m: m, "expected numbers"),
    "an actuator too few": (
        lambda t: t,
        lambda m: {**m, "actuators": {k: v for k, v in m["actuators"].items() if k != "left_propeller"}},
        "map.yaml:",
    ),
    "a throttle of newtons": (
        lambda t: t,
        lambda m: {**m, "actuators": {**m["actuators"], "left_propeller": {"column": "thrust1", "unit": "throttle"}}},
        "thrust1",
    ),
    "a scale of nothing": (
        lambda t: t,
        lambda m: {**m, "signals": {**m["signals"], "p": {**m["signals"]["p"], "scale": 0}}},
        "is 0, so that every value would be 0",
    ),
    "a column for two signals": (
        lambda t: t,
        lambda m: {**m, "signals": {**m["signals"], "q": m["signals"]["p"]}},
        "signals.q.column: is gx, as signals.p is, expected a column of its own",
    ),
    "pulses as degrees": (
        lambda t: t,
        lambda m: {**m, "actuators": {**m["actuators"], "left_ruddervator": {"column": "pwm1", "unit": "deg"}}},
        "deg, expected about -25.8 to 25.8; see zero and scale",
    ),
    "one second of airspeed": (
        lambda t: t.assign(tas=t["tas"].where(t.index < 100)),
        lambda m: m,
        "has all that is needed for 1 s, expected at least 10 s of flight",
    ),
    "a unit of something else": (
        lambda t: t,
        lambda m: {**m, "signals": {**m["signals"], "roll": {"column": "roll", "unit": "m_s"}}},
        "signals.roll.unit",
    ),
    "an unknown signal": (
        lambda t: t,
        lambda m: {**m, "signals": {**m["signals"], "rol": {"column": "roll", "unit": "rad"}}},
        "did you mean roll?",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_logs_are_refused_and_nothing_is_written(tmp_path: Path, table: pd.DataFrame, name: str) -> None:
    change, remap, words = BAD[name]
    ended = in_this_process(tmp_path, *_written(tmp_path, change(table.copy()), remap(MAPPING)))
    assert ended.returncode == 2
    assert words in ended.stderr and "Traceback" not in ended.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"PAR1 and no more", "cannot be read"),
        (b"\x00\xff" * 500, "cannot be read"),
        (b"ULog\x01\x12\x35" + bytes(200), ""),
        (gzip.compress(b"time,gx", mtime=0), "is packed by gzip"),  # the same in every process of the tests
        (b"PK\x03\x04 and more", "is a zip archive or a spreadsheet"),
        ("time,gx".encode("utf-16"), "is text in UTF-16"),
    ],
)
def test_other_files_are_refused(tmp_path: Path, table: pd.DataFrame, content: bytes, words: str) -> None:
    arguments = _written(tmp_path, table)
    (tmp_path / "log.csv").write_bytes(content)
    ended = in_this_process(tmp_path, *arguments)
    assert ended.returncode == 2 and ended.stderr.startswith(f"log.csv: {words}")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ("gy,", "gx,", "has 2 columns 'gx', expected one"),
        (",gx,", ", gx,", "expected one of t_us, ' gx', gy"),
    ],
)
def test_heads_that_mislead_are_refused(
    tmp_path: Path, table: pd.DataFrame, before: str, after: str, words: str
) -> None:
    arguments = _written(tmp_path, table)
    head, _, rows = (tmp_path / "log.csv").read_text().partition("\n")
    assert before in head
    (tmp_path / "log.csv").write_text(f"{head.replace(before, after, 1)}\n{rows}")
    ended = in_this_process(tmp_path, *arguments)
    assert ended.returncode == 2 and words in ended.stderr


def test_a_file_of_lines_is_no_table(tmp_path: Path, table: pd.DataFrame) -> None:
    """Such as a DataFlash log that was written as text, or a pointer to a large file."""
    arguments = _written(tmp_path, table)
    (tmp_path / "log.csv").write_text("ArduCopter V3.1\n\nFMT, 128, 89, FMT, BBnNZ, Type,Length,Name\n")
    ended = in_this_process(tmp_path, *arguments)
    assert ended.returncode == 2 and "is no table: its first line has one column" in ended.stderr


def test_what_is_not_flown_is_not_judged(tmp_path: Path, table: pd.DataFrame) -> None:
    """Twenty seconds on the ground, in which nothing answers the commands: the finding is the flight's, and the rest is said."""
    ground = table.iloc[:2000].assign(tas=3.0, gx=0.0, gy=0.0, gz=0.0, roll=0.0, pitch=0.0, ax=0.0)
    later = table.assign(t_us=table["t_us"] + 20e6)
    _written(tmp_path, pd.concat([ground, later], ignore_index=True))
    found = testbed.diagnose(tmp_path / "log.csv", "vtail", tmp_path / "map.yaml")
    assert [(f.actuator, f.state) for f in found.findings] == [("left_ruddervator", "weak")]
    assert any("is below 8 m/s; nothing is said there" in line for line in found.log.remarks)
    _written(tmp_path, pd.concat([ground, later.iloc[:800]], ignore_index=True))
    ended = in_this_process(tmp_path, "diagnose", "log.csv", "--model", "vtail", "--columns", "map.yaml")
    assert ended.returncode == 2 and "the least airspeed of vtail" in ended.stderr


def test_a_throttle_that_is_switched_off_is_none(tmp_path: Path, table: pd.DataFrame) -> None:
    """Outputs of 900 before arming are below the 1000 of an idle motor; ones that are never above it have the wrong sign."""
    pulses = 1000.0 + 60.0 * np.maximum(table["thrust1"].to_numpy(), 0.0)
    mapping = {**MAPPING, "actuators": {
        **MAPPING["actuators"], "left_propeller": {"column": "thrust1", "unit": "throttle", "zero": 1000, "scale": 1e-3}
    }}  # fmt: skip
    _written(tmp_path, table.assign(thrust1=np.where(np.arange(len(table)) < 100, 900.0, pulses)), mapping)
    log = read_table(tmp_path / "log.csv", tmp_path / "map.yaml", load_aircraft("vtail"))
    assert log.commands[:90, 2].max() == 0.0 < np.median(log.commands[200:, 2])
    ended = in_this_process(tmp_path, *_written(tmp_path, table.assign(thrust1=2000.0 - pulses), mapping))
    assert ended.returncode == 2 and "as a throttle" in ended.stderr


def test_a_place_on_the_globe(tmp_path: Path, table: pd.DataFrame) -> None:
    """Degrees become metres from where it was first; without a fix, zero and zero, or nonsense, straight lines lead on."""
    north, east = 20.0 * np.arange(len(table)) / 100.0, -5.0 * np.arange(len(table)) / 100.0
    latitude, longitude = (
        60.0 + np.degrees(north / 6371e3),
        10.0 + np.degrees(east / 6371e3 / np.cos(np.pi / 3)),
    )
    lost = slice(1000, 1500)
    latitude[lost] = longitude[lost] = 0.0
    latitude[2000] = 1e308
    placed = table.assign(
        lat=latitude, lon=longitude, alt=300.0, hdg=(np.arange(len(table)) * 0.1 + 350.0) % 360.0
    )
    degrees = {name: {"column": column, "unit": "deg"} for name, column in (
        ("latitude", "lat"), ("longitude", "lon"), ("heading", "hdg"))}  # fmt: skip
    signals = {**MAPPING["signals"], **degrees, "altitude": {"column": "alt", "unit": "m"}}
    _written(tmp_path, placed, {**MAPPING, "signals": signals})
    log = read_table(tmp_path / "log.csv", tmp_path / "map.yaml", load_aircraft("vtail"))
    rows = len(log.time_s)
    np.testing.assert_allclose(log.place["north"], north[:rows], atol=0.01)
    np.testing.assert_allclose(log.place["east"], east[:rows], atol=0.1)
    assert np.degrees(log.place["heading"][-1]) == pytest.approx(350.0 + 0.1 * (rows - 1), abs=0.2)
    assert log.known.all()
    del signals["longitude"]
    ended = in_this_process(tmp_path, *_written(tmp_path, placed, {**MAPPING, "signals": signals}))
    assert ended.returncode == 2 and "has no longitude, without which there is no replay" in ended.stderr


def test_a_parquet_column_that_is_no_number_is_not_read(
    tmp_path: Path, table: pd.DataFrame, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Some bytes of it may stand for gigabytes."""
    lists = table.assign(gx=[[0] * 1000] * len(table))
    arguments = _written(tmp_path, lists, name="log.parquet")
    monkeypatch.setattr(pq.ParquetFile, "read", lambda *_, **__: pytest.fail("was read"))
    ended = in_this_process(tmp_path, *arguments)
    assert ended.returncode == 2 and "gx: has list" in ended.stderr and "expected numbers" in ended.stderr


def test_nothing_is_known_before_a_signal_begins(tmp_path: Path, table: pd.DataFrame) -> None:
    half = len(table) // 2
    late = table.assign(gx=table["gx"].where(table.index >= half))
    _written(tmp_path, late)
    log = testbed.diagnose(tmp_path / "log.csv", "vtail", tmp_path / "map.yaml").log
    assert np.mean(log.known) == pytest.approx(0.5, abs=0.03)
    assert any("missing" in line for line in log.remarks)


def test_what_never_moves_cannot_be_identified(tmp_path: Path, table: pd.DataFrame) -> None:
    _written(tmp_path, table.assign(gx=0.0, roll=table["roll"].iloc[0]))
    ended = in_this_process(
        tmp_path, "identify", "vtail", "--log", "log.csv", "--columns", "map.yaml", "--out", "made.json"
    )
    assert ended.returncode == 2 and "nothing moves in p_dot" in ended.stderr
    assert not (tmp_path / "made.json").exists()


def test_a_truncated_parquet_file_is_refused(tmp_path: Path, table: pd.DataFrame) -> None:
    arguments = _written(tmp_path, table, name="log.parquet")
    content = (tmp_path / "log.parquet").read_bytes()
    (tmp_path / "log.parquet").write_bytes(content[: len(content) // 2])
    assert in_this_process(tmp_path, *arguments).returncode == 2


def test_a_file_needs_a_model_and_a_mapping(tmp_path: Path, table: pd.DataFrame) -> None:
    _written(tmp_path, table)
    ended = in_this_process(tmp_path, "diagnose", "log.csv")
    assert ended.returncode == 2
    assert "--model" in ended.stderr and "--columns" in ended.stderr


BEYOND: dict[str, tuple[dict[str, Any], str]] = {
    "thrust of 1e308 N": ({"thrust1": 1e308}, "left_propeller: is up to 1e[+]308 in SI"),
    "servo of 1e308 deg": ({"pwm1": 1e308}, "pwm1: goes from 1e\\+307 to"),
    "infinite in some rows": ({"gx": lambda t: t["gx"].where(t.index % 3 > 0, np.inf)}, "gx: is up to inf"),
    "no airspeed": ({"tas": 0.0}, "tas: is never above 1 m/s"),
    "airspeed of the other sign": ({"tas": -30.0}, "tas: is never above 1 m/s"),
    "years": (
        {"t_us": lambda t: 1e12 * t.index}, "time: goes from",
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", BEYOND)
def test_numbers_that_no_aircraft_has_are_refused(tmp_path: Path, table: pd.DataFrame, what: str) -> None:
    changes, words = BEYOND[what]
    ended = in_this_process(tmp_path, *_written(tmp_path, table.assign(**changes)))
    assert ended.returncode == 2 and re.search(words, ended.stderr), ended.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.nightly
def test_a_log_of_many_years_is_refused_before_it_fills_the_memory(
    tmp_path: Path, table: pd.DataFrame
) -> None:
    """Half of its steps are short, and the others just below what is taken for a jump."""
    rows = pd.concat([table] * 20, ignore_index=True)
    steps = np.where(np.arange(len(rows)) % 2, 0.4, 59.0)
    rows = rows.assign(t_us=1e6 * np.cumsum(steps), **dict.fromkeys(("gx", "gy", "gz", "roll", "pitch"), 0.0))
    ended = in_this_process(tmp_path, *_written(tmp_path, rows))
    assert ended.returncode == 2 and "expected a shorter log" in ended.stderr, ended.stderr


@pytest.mark.parametrize("column", ["gx", "roll", "tas", "ax", "pwm1", "thrust1"])
def test_one_row_of_nonsense_is_taken_for_missing(tmp_path: Path, table: pd.DataFrame, column: str) -> None:
    spoilt = table.astype({column: float})
    spoilt.loc[2000, column] = 1e308
    ended = in_this_process(tmp_path, *_written(tmp_path, spoilt))
    assert ended.returncode == 1 and "WARNING" not in ended.stderr, ended.stderr
