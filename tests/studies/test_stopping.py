"""A sweep that stops by its own rule stops at the same run on any number of workers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sweep_files import SWEEP, written
from sweep_flights import quick

import testbed
from testbed.common.statistics import proportion
from testbed.studies.model import StopWhen
from testbed.studies.run import Stopping


@pytest.mark.nightly
def test_stopping_does_not_depend_on_workers(tmp_path: Path) -> None:
    text = SWEEP + "stop_when: {half_width: 0.15, confidence: 0.9}\n"
    tables = []
    for jobs in (1, 4):
        testbed.sweep(
            written(tmp_path, text), tmp_path / f"{jobs}", runs=200, jobs=jobs, fly=quick, figures=False
        )
        tables.append((tmp_path / f"{jobs}/results.csv").read_bytes())
    assert tables[0] == tables[1]
    summary = json.loads((tmp_path / "1/summary.json").read_text())
    assert 10 < summary["runs"] < 100
    runs, passed = summary["runs"], summary["variants"][0]["all_requirements"]["successes"]
    known = proportion(passed, runs, 0.9, method="exact")
    assert (known.high - known.low) / 2 <= 0.15
    rows = (tmp_path / "1/results.csv").read_text().splitlines()[1 : 1 + 2 * (runs - 1)]
    earlier = proportion(sum(",completed,True," in row for row in rows[::2]), runs - 1, 0.9, method="exact")
    assert (earlier.high - earlier.low) / 2 > 0.15  # and not a run later than it could


def test_what_was_not_judged_is_not_counted() -> None:
    rule = StopWhen(half_width=0.2, confidence=0.95)
    silent, judged = Stopping(rule, 1), Stopping(rule, 1)
    for _ in range(50):
        assert not silent.add([None])
        judged.add([True])
        judged.add([None])
    assert silent.stopped_at is None and judged.stopped_at is not None


def test_the_rule_looks_after_every_run_and_later_after_every_percent() -> None:
    """With an even chance the exact 95 % interval is narrow enough from about 1600 runs on; never without a rule."""
    stopping = Stopping(StopWhen(half_width=0.025), variants=1)
    added = next(i for i in range(1, 5000) if stopping.add([i % 2 == 0]))
    known = proportion(added // 2, added, method="exact")
    earlier = proportion((added - 1) // 2, int(added / 1.02), method="exact")
    assert (known.high - known.low) / 2 <= 0.025 < (earlier.high - earlier.low) / 2
    assert stopping.stopped_at == added and stopping.add([True])
    never = Stopping(None, variants=1)
    assert not any(never.add([True]) for _ in range(1000))


def test_every_variant_must_be_known_closely_enough() -> None:
    alone, both = (Stopping(StopWhen(half_width=0.1), variants=n) for n in (1, 2))
    alone_at = next(i for i in range(1, 999) if alone.add([True]))
    both_at = next(i for i in range(1, 999) if both.add([True, i % 2 == 0]))
    assert alone_at < both_at
