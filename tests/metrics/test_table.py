"""Every metric has a definition and a unit, is computed from any log, and from a run folder as from a flight."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from handmade import injection, level_log, readings_of

import testbed
from testbed.flight.folder import write_run_folder
from testbed.metrics import TABLE, measure, readings
from testbed.scenario.load import load_scenario


def test_every_metric_says_what_it_is_and_its_unit() -> None:
    ends = ("_m", "_deg", "_m_s", "_s", "_per_s")
    for name, metric in TABLE.items():
        first = (metric.__doc__ or "").partition("\n")[0]
        unit = re.search(r"\[([^]]+)\]", metric.__doc__ or "")
        assert first and unit, name
        assert name.endswith(ends) == (unit[1] in ("m", "deg", "m/s", "s", "1/s")), name


def test_perfect_healthy_flight() -> None:
    measured = measure(readings_of(level_log()))
    for name, value in measured.items():
        if name == "survived":
            assert value == 1.0
        elif name == "recovery_s" or name.endswith(
            ("_failed_m", "_failed_deg", "_failed_m_s", "_recovery_s")
        ):
            assert math.isnan(value), name  # nothing failed
        elif name in ("detection_delay_s", "isolation_fraction") or "settling" in name:
            assert math.isnan(value), name
        else:
            assert value == 0.0, name


def test_one_row_and_nan_do_not_raise() -> None:
    log = {name: column[:1].copy() for name, column in level_log().items()}
    measure(readings_of(log, injection(0.0)))
    log["altitude_m"][:] = math.nan
    assert math.isnan(TABLE["altitude_error_max_m"](readings_of(log)))


def test_metrics_of_a_run_folder_agree_with_its_summary(tmp_path: Path) -> None:
    short = ["duration_s=8", "failures.1.at_s=6.5", "requirements=[]"]
    flown = testbed.fly(load_scenario("scenarios/left_tail_fail.yaml", short))
    loaded = testbed.load(write_run_folder(flown, tmp_path / "run"))
    assert list(loaded.actuators) == list(flown.actuators)
    np.testing.assert_equal(measure(readings(loaded)), dict(flown.metrics))
    np.testing.assert_equal(dict(loaded.metrics), dict(flown.metrics))
    assert flown.metrics["estimate_settling_ratio"] == pytest.approx(1.0, abs=0.15)
