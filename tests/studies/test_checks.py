"""Bad sweeps are refused like bad scenarios: every problem, its place, what was expected and meant; nothing flies."""

from __future__ import annotations

import subprocess
import sys
from contextlib import nullcontext
from pathlib import Path

import pytest
from sweep_files import SWEEP, written

from testbed.inputs.problems import BadInput
from testbed.studies import checks
from testbed.studies.checks import check
from testbed.studies.load import load_sweep

VALUE = "failures.0.value: {uniform: [0, 1]}"


REFUSED: list[tuple[str, str, list[str]]] = [
    (VALUE, "failures.0.vaule: {uniform: [0, 1]}", [":11: failures.0.vaule: unknown key, did you mean value?"]),
    (VALUE, "failures.3.value: {uniform: [0, 1]}",
     [":11: failures: has no entry 3, expected 0, its only entry"]),
    (VALUE, "failures.0.value: {unifrom: [0, 1]}",
     [":11: vary.failures.0.value: unknown distribution 'unifrom', did you mean uniform?"]),
    (VALUE, "failures.0.value: {uniform: [1, 0]}",
     [":11: vary.failures.0.value: uniform is from 1 to 0, expected [low, high]"]),
    (VALUE, "failures.0.value: {uniform: [0]}",
     [":11: vary.failures.0.value: uniform has a list, expected [low, high]"]),
    (VALUE, "failures.0.value: {weibull_min: {c: 2, scal: 1}}",
     [":11: vary.failures.0.value: weibull_min has no parameter 'scal', "
      "expected c, loc, scale, by name or in this order, did you mean scale?"]),
    (VALUE, "failures.0.value: {beta: [2]}",
     [":11: vary.failures.0.value: beta has 1 parameters, expected a, b, loc, scale, by name or in this order"]),
    (VALUE, "failures.0.value: {beta: [-2, 1]}",
     [":11: vary.failures.0.value: beta does not take [-2, 1], expected parameters in their range: "
      "a, b, loc, scale, by name or in this order"]),
    (VALUE, "failures.0.value: {choice: []}",
     [":11: vary.failures.0.value: choice is empty, expected a list of values"]),
    (VALUE, "failures.0.value: {uniform: [-0.5, 1]}",
     [":11: failures.0.value: is -0.5, expected greater than or equal to 0"]),
    (VALUE, "failures.0.value: {choice: [0.5, much]}", [":11: failures.0.value: is 'much', expected a number"]),
    (VALUE, "failures.0.value: 3", [":11: vary.failures.0.value: is 3, expected a distribution, as {uniform: [0, 1]}"]),
    ("weights: [1, 3]", "weights: [1]",
     [":12: vary.failures.0.actuator: has 1 weights for 2 choices, expected one weight each"]),
    ("weights: [1, 3]", "weights: [1, -3]",
     [":12: vary.failures.0.actuator: weights are [1.0, -3.0], expected none below 0, and one above"]),
    ("right_ruddervator]", "right_rudervator]",
     [":12: failures.0.actuator: vtail has no actuator 'right_rudervator', did you mean right_ruddervator?"]),
    ("Cm_alpha", "Cm_alhpa", [":13: controller.model_error.Cm_alhpa: unknown coefficient 'Cm_alhpa', did you mean Cm_alpha?"]),
    ("[adaptive_inversion,", "[adaptive_inversoin,",
     [":14: controller.type: unknown type 'adaptive_inversoin', did you mean adaptive_inversion?"]),
    (VALUE, "failures.0.type: {uniform: [0, 1]}",
     ["vary.failures.0.type: is a word, and uniform draws numbers, expected {choice: [...]}"]),
    ("controller.type:", "controler.type:", [":14: controler: unknown key, did you mean controller?"]),
    ("runs: 12", "runs: 0\nsampling: sobl\nstopwhen: 3",
     [":3: runs: is 0, expected greater than 0", ":4: sampling: 'sobl' is not known, did you mean sobol?",
      ":5: stopwhen: unknown key, did you mean stop_when?"]),
    ("runs: 12", "stop_when: {half_width: 0.7}", [":3: stop_when.half_width: is 0.7, expected less than 0.5"]),
    ("runs: 12", "sampling: grid\nruns: 5000",
     [":4: runs: is 5000, there are 250, expected at most 250, or no runs for all"]),
    ("left_tail_fail", "left_tial_fail",
     [":2: scenario: there is no file 'scenarios/left_tial_fail.yaml', did you mean scenarios/left_tail_fail.yaml?"]),
    (VALUE, "seed: {integers: [2, 9]}",
     [":9: vary: names seed, expected other values: every run has a seed of its own already"]),
    ("compare: {", "compare: {failures.0.value: [0, 1], ",
     [":1: gives failures.0.value two meanings, expected not also failures.0.value"]),
    ("metric: altitude_error_max_m", "metric: altitude_eror_max_m",
     [":8: requirements.0.metric: unknown metric 'altitude_eror_max_m'"
      " (one of your own needs --with FILE.py), did you mean altitude_error_max_m?"]),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "expected"), REFUSED, ids=[new[:40] for _, new, _ in REFUSED])
def test_refused_with_place_and_suggestion(tmp_path: Path, old: str, new: str, expected: list[str]) -> None:
    assert old in SWEEP
    file = written(tmp_path, SWEEP.replace(old, new, 1))
    with pytest.raises(BadInput) as refused:
        check(load_sweep(file))
    lines = [str(problem).removeprefix(str(file)) for problem in refused.value.problems]
    assert lines == expected


def test_what_every_draw_has_wrong_is_said_once(tmp_path: Path) -> None:
    text = SWEEP.replace(VALUE, "rate_hz: {normal: [100.3, 0.01]}", 1)
    with pytest.raises(BadInput) as refused:
        check(load_sweep(written(tmp_path, text)))
    (problem,) = refused.value.problems
    assert problem.path == "rate_hz" and problem.expected == "a whole number"


def test_a_scenario_that_cannot_be_read_is_refused_where_it_is_named(tmp_path: Path) -> None:
    (tmp_path / "other.yaml").write_text(SWEEP)
    for name, words in ((".", ":2: scenario: . is a folder"), ("other.yaml", "other.yaml:1: is a sweep")):
        text = SWEEP.replace("scenarios/left_tail_fail.yaml", name)
        assert text != SWEEP
        with pytest.raises(BadInput, match=words):
            load_sweep(written(tmp_path, text))


def test_bad_cases_are_refused_by_line(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("failures.0.value,seed\n0.5,1\n1e-3,-4\n0.5\n[0.5,2\n")
    text = SWEEP[: SWEEP.index("vary:")].replace("runs: 12\n", "") + "cases: table.csv\n"
    with pytest.raises(BadInput) as refused:
        load_sweep(written(tmp_path, text))
    found = [str(problem).rpartition("/")[2] for problem in refused.value.problems]
    assert found[:3] == [
        "table.csv:3: failures.0.value: 1e-3 is read as text by YAML, write 1.0e-3",
        "table.csv:3: seed: is -4, expected a whole number, at least 0",
        "table.csv:4: has 1 cells, expected 2, as the header",
    ]
    assert found[3].startswith("table.csv:5: failures.0.value: is not YAML")
    (tmp_path / "table.csv").write_text("failures.0.value\n0.5\n7\n")
    with pytest.raises(BadInput) as refused:
        check(load_sweep(written(tmp_path, text)))
    assert "failures.0.value: is 7 (run 1), expected less than or equal to 1.5" in str(refused.value)


def test_of_many_options_and_cases_the_first_are_checked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each takes a millisecond or so, and a table may have a million."""
    monkeypatch.setattr(checks, "_MOST_CHECKED", 10)
    head = SWEEP[: SWEEP.index("vary:")]
    never_drawn = ", weights: [" + "1, " * 10 + "0]}}\n"
    options = "vary: {failures.0.value: {choice: [" + "0.5, " * 9 + "%s, %s]" + never_drawn
    check(load_sweep(written(tmp_path, head + options % (0.5, 7))))
    with pytest.raises(BadInput, match=r"failures\.0\.value: is 7"):
        check(load_sweep(written(tmp_path, head + options % (7, 0.5))))
    text = head.replace("runs: 12\n", "") + "cases: table.csv\n"
    for row, refused in ((11, False), (10, True)):
        cases = ["0.5"] * 11
        cases[row - 1] = "7"
        (tmp_path / "table.csv").write_text("\n".join(["failures.0.value", *cases]))
        with pytest.raises(BadInput, match=r"is 7") if refused else nullcontext():
            check(load_sweep(written(tmp_path, text)))


def test_the_parent_of_a_sweep_loads_no_model(tmp_path: Path) -> None:
    """It takes the properties from the record of the first load, which was made in a process of its own."""
    (tmp_path / "s.yaml").write_text(
        "scenario:\n  name: x\n  aircraft: vtail\n  duration_s: 1\n  failures:\n"
        "    - {type: motor_stop, actuator: left_propeller, at_s: 0.5}\n"
        "runs: 4\nvary: {initial.altitude_m: {uniform: [300, 310]}}\n"
    )
    program = "import sys; from testbed.api import sweep; sweep.prepare('s.yaml'); assert 'jsbsim' not in sys.modules"
    subprocess.run([sys.executable, "-c", program], cwd=tmp_path, check=True)


def test_a_worker_draws_nothing() -> None:
    """scipy.stats, from which runs are drawn, would take half of the time in which each of its processes starts."""
    program = "import sys, testbed.studies.flying.worker; assert 'scipy.stats' not in sys.modules"
    subprocess.run([sys.executable, "-c", program], check=True)
