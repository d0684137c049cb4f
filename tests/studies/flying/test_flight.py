"""What one flight leaves: a record, whatever goes wrong in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import SWEEP, fly_here, table, written
from sweep_flights import quick

import testbed
from testbed.inputs.problems import BadInput
from testbed.studies.flying.flight import Job, flight_of, fly_reference, fly_task
from testbed.studies.load import load_sweep


def test_a_rare_invalid_draw_is_a_row_with_its_reason(tmp_path: Path) -> None:
    """The normal's tail leaves the range in a few runs; the others fly."""
    text = SWEEP.replace("{uniform: [0, 1]}", "{normal: [1.2, 0.13]}")
    frame = table(fly_here(load_sweep(written(tmp_path, text), ["runs=120"]), tmp_path / "out"))
    invalid = frame[frame["outcome"] == "invalid"]
    assert set(invalid["run"]) == set(frame[frame["failures.0.value"] > 1.5]["run"]) and len(invalid) > 0
    assert invalid["reason"].str.contains("failures.0.value: is .* expected less than or equal to 1.5").all()


def test_a_function_that_workers_cannot_import_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="cannot be imported by a worker"):
        testbed.sweep(written(tmp_path), tmp_path / "out", fly=lambda scenario: quick(scenario))


def test_an_exception_is_a_record_with_its_reason_in_bounds(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    task = plan.task(3)
    for fly, outcome, reason in (
        ("sweep_flights:bad", "completed", ""),
        (
            "sweep_flights:hungry",
            "error",
            "MemoryError: Unable to allocate 8.00 PiB for an array with shape "
            "(1125899906842624,) and data type float64",
        ),
        ("sweep_flights:lost", "error", "ValueError: at 0x... " + "x" * 300),
    ):
        record = fly_task(Job(plan.builder, fly), task).record
        assert (record.run, record.variant, record.seed) == (1, 1, task.seed)
        assert (record.outcome, record.reason) == (outcome, reason[:300])
        assert record.passed in ((True, False) if outcome == "completed" else (False,))


def test_the_record_is_that_of_the_flight_itself(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    job = Job(plan.builder, "sweep_flights:quick")
    flight, record = flight_of(job, plan.task(0)), fly_task(job, plan.task(0)).record
    assert flight.passed == record.passed and flight.scenario.seed == record.seed


def test_functions_are_named_so_that_a_worker_can_import_them() -> None:
    assert fly_reference(None) == "testbed.simulation:fly"
    assert fly_reference(quick) == "sweep_flights:quick"
