"""The judging of ALFA's recordings, on ones that are made here with the same columns; the real data is not in the project."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
import pytest
from alfa_flights import (
    HOLD_S,
    QUIET_S,
    STEP_S,
    STILL_S,
    Recording,
    Score,
    alarm,
    files_of,
    judged,
    left_out,
    read,
    still,
)

from testbed.inputs.problems import BadInput

COUNT, FAILED = 800, 500
COLUMNS = ("%time", "field.linear_acceleration.x", "field.linear_acceleration.y", "field.angular_velocity.x",
           "field.angular_velocity.y", "field.angular_velocity.z", "field.orientation.x", "field.orientation.y",
           "field.alt_error", "field.aspd_error", "field.delta_pitch", "field.delta_roll", "field.twist.linear.x",
           "field.data")  # fmt: skip


def _written(file: Path, seed: int, fails: bool) -> Path:
    """40 s at 20 Hz in which rates follow the autopilot's errors, until a failure from 25 s on: then they do something else."""
    rng = np.random.default_rng(seed)
    values = {name: rng.normal(size=COUNT) for name in COLUMNS}
    broken = (np.arange(COUNT) >= FAILED) & fails
    loose = np.where(broken, 3.0, 0.1) * rng.normal(size=COUNT)
    values["field.angular_velocity.x"] = 0.8 * values["field.delta_roll"] + loose
    values["field.angular_velocity.y"] = 0.8 * values["field.delta_pitch"] + 0.1 * rng.normal(size=COUNT)
    values["field.data"] = broken.astype(float)
    rows = [",".join(f"{values[name][i]:.6f}" for name in COLUMNS) for i in range(COUNT)]
    if not fails:  # as of a recording whose fault topic was never written
        rows = [row.rpartition(",")[0] + "," for row in rows]
    file.write_text("\n".join([",".join(COLUMNS), *rows]) + "\n")
    return file


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> list[Recording]:
    """Six flights, of which three fail; one of them in two parts."""
    folder = tmp_path_factory.mktemp("alfa")
    names = [(f"carbonZ_2018-0{i}_part{part}", i) for i in range(1, 7) for part in range(1 + (i == 1))]
    return [
        read(_written(folder / f"{name}.csv", 10 * i + k, i % 2 == 1)) for k, (name, i) in enumerate(names)
    ]


def test_a_recording_is_read(recordings: list[Recording]) -> None:
    """Its flight, the row of its failure, and no failure where the topic is empty; what is missing stays as it was."""
    assert [each.group for each in recordings][:3] == ["2018-01", "2018-01", "2018-02"]
    assert [each.failed for each in recordings][:3] == [FAILED, FAILED, None]
    assert len(recordings[0].columns["delta_roll"]) == COUNT and "%time" not in recordings[0].columns


def test_what_is_missing_stays_as_it_was(tmp_path: Path) -> None:
    (tmp_path / "carbonZ_x_y.csv").write_text("%time,field.a\n0,\n1,2.5\n2,\n3,4\n")
    assert read(tmp_path / "carbonZ_x_y.csv").columns["a"].tolist() == [0.0, 2.5, 2.5, 4.0]


def test_failures_are_found_in_flights_that_were_left_out(recordings: list[Recording]) -> None:
    """A rate that no longer follows is told within 3 s, without an alarm before or in healthy flight."""
    score = left_out(recordings)
    assert (score.recordings, score.right, score.quiet, score.false, score.missed) == (7, 4, 3, 0, 0)
    assert max(score.delays_s) < 3.0


def test_nothing_is_found_where_nothing_changes(recordings: list[Recording]) -> None:
    """The negative control: a label without a failure behind it is found no better than by chance."""
    labelled = [
        each._replace(failed=FAILED if i % 2 else None)
        for i, each in enumerate(r for r in recordings if r.failed is None)
    ]
    score = left_out([each._replace(group=str(i)) for i, each in enumerate([*labelled, *labelled])])
    assert (score.right + score.quiet) / score.recordings < 0.7


def test_an_alarm_needs_time() -> None:
    """Above the threshold for HOLD_S, and never in the first QUIET_S."""
    quiet, held = round(QUIET_S / STEP_S), round(HOLD_S / STEP_S)
    score = np.zeros(COUNT)
    score[: quiet + held] = 1.0
    assert alarm(score, 0.5) == quiet + held - 1
    score[quiet:] = 0.0
    score[400 : 400 + held - 1] = 1.0
    assert alarm(score, 0.5) is None


def test_alarms_are_judged_as_the_authors_do() -> None:
    """Right after the failure, false before it or in healthy flight; a failure with a false alarm is missed as well."""
    broken, healthy = Recording("a", {}, FAILED), Recording("b", {}, None)
    alarms = [FAILED + 20, FAILED - 1, None, 300, None]
    found = judged([broken, broken, broken, healthy, healthy], alarms, STEP_S)
    assert found == Score(5, 1, 1, 2, 2, (pytest.approx(1.0),))
    assert found.words == "0.40 | 0.33 | 0.33 | 1.00"


def test_the_leak_is_a_throttle_that_stands_still(tmp_path: Path) -> None:
    """At 10 Hz: STILL_S after its last change, and the failure where the stream says so."""
    count, held = 300, 120
    throttle = np.where(np.arange(count) < held, np.arange(count) % 7, 0.5)
    rows = [f"{t:.3f},{int(i == 100)}" for i, t in enumerate(throttle)]
    (tmp_path / "a.csv").write_text("throttle,is_boundary\n" + "\n".join(rows) + "\n")
    recording, at = still(tmp_path / "a.csv")
    assert recording.failed == 100 and at == held + round(10 * STILL_S)


def test_other_recordings_are_refused(tmp_path: Path) -> None:
    file = _written(tmp_path / "carbonZ_2018-01_a.csv", 1, True)
    own = hashlib.sha256(file.read_bytes()).hexdigest()
    both = hashlib.sha256(own.encode()).hexdigest()
    assert files_of(tmp_path, "carbonZ*.csv", both) == [file]
    file.write_text(file.read_text() + "\n")
    with pytest.raises(BadInput, match="has other recordings: 1"):
        files_of(tmp_path, "carbonZ*.csv", both)
