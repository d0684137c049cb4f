"""A user's own controller: flown without touching the package, and what is wrong with it said with its file and line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import ROOT, in_this_process
from short_flights import scenario, worst_errors
from vtail_setup import vtail_setup

from testbed.common.signals import SETPOINT, STATE
from testbed.controllers.make import CONSTRUCTORS
from testbed.controllers.user import adapter
from testbed.controllers.user.adapter import Reference, State, adapted
from testbed.controllers.user.loader import load_controller
from testbed.flight.folder import load, write_run_folder
from testbed.inputs.problems import BadInput
from testbed.metrics import readings
from testbed.simulation import fly

EXAMPLE = ROOT / "examples" / "my_controller.py"


def test_records_have_the_signals_in_their_order() -> None:
    assert State._fields == STATE
    assert Reference._fields == SETPOINT


def test_the_example_flies_from_the_command_line_and_from_python(tmp_path: Path) -> None:
    wanted = scenario(tmp_path)
    run = in_this_process(
        tmp_path,
        "run",
        "healthy.yaml",
        "--controller",
        f"{EXAMPLE}:MyController",
        "--out",
        "out",
        "--no-plots",
    )
    assert run.returncode == 0, run.stderr
    assert "flown by my_controller:MyController" in run.stdout
    flown = load(tmp_path / "out")
    altitude, heading, airspeed = worst_errors(flown)
    assert (altitude < 2.0, heading < 8.0, airspeed < 1.5) == (True, True, True)
    assert flown.controller == flown.flown_by == "my_controller:MyController"
    again = fly(wanted, controller=load_controller(f"{EXAMPLE}:MyController"))
    assert again.summary == flown.summary


def test_one_with_bind_and_step_flies_as_it_is(tmp_path: Path) -> None:
    flight = fly(scenario(tmp_path, "pid", 2), controller=CONSTRUCTORS["fixed_inversion"])
    again = fly(scenario(tmp_path, "fixed_inversion", 2))
    assert np.array_equal(flight.data, again.data, equal_nan=True)


@pytest.mark.parametrize("own", [{}, {"reasons": [(3, "lost")]}])
def test_one_with_bind_and_step_may_give_reasons(own: dict[str, Any]) -> None:
    made = type("Own", (), {"bind": lambda *_: None, "step": lambda *_: [0.0] * 4, **own})
    controller = adapted(lambda setup: made(), vtail_setup())
    assert list(controller.reasons) == own.get("reasons", [])


def test_what_it_says_of_its_actuators_is_logged(tmp_path: Path) -> None:
    file = tmp_path / "own.py"
    file.write_text(
        "class Own:\n    effectiveness = [1, 0.5, 1, 1]\n    failed = [0, 1, 0, 0]\n"
        "    def __init__(self, setup): self.trim = setup.trim_commands\n"
        "    def update(self, time_s, state, reference): return self.trim\n"
    )
    flight = fly(scenario(tmp_path, "pid", 1), controller=load_controller(f"{file}:Own"))
    log = readings(flight).log
    assert log["right_ruddervator_effectiveness_estimate"][-1] == 0.5
    assert log["right_ruddervator_failed"].all()
    assert log["left_propeller_effectiveness_estimate"][-1] == 1.0


def test_one_that_is_slow_is_said_to_be(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(adapter, "_SLOW_S", 0.02)
    file = tmp_path / "own.py"
    file.write_text(
        "import time\nclass Own:\n    def __init__(self, setup): self.trim = setup.trim_commands\n"
        "    def update(self, time_s, state, reference): time.sleep(0.03 * (0 < time_s < 0.007)); return self.trim\n"
    )
    slow = scenario(tmp_path, "pid", 20)  # 4000 steps
    with pytest.warns(
        UserWarning, match=r"own.py: takes 0\.0\d+ s in each control step, 1\d\d s for the whole flight"
    ):
        fly(slow, controller=load_controller(f"{file}:Own"))


OWN = "class Own:\n    def __init__(self, setup): {init}\n    def {update}(self, time_s, state, reference): {body}\n"
STEP = (
    "class Own:\n    def __init__(self, setup): pass\n    def bind(self, *channels): {bind}\n"
    "    def step(self, k): return {step}\n"
)
NO_TEXT = "class NoText:\n    def __repr__(self): raise ValueError\n    __array__ = __repr__\n"
FAULTY = {
    "import nothing_of_this_name": "own.py:1: raised while being read: ModuleNotFoundError",
    "class Own(:": "own.py:1: is not Python",
    "x = 1": "own.py: has no class Own",
    "Own = 3": "own.py: Own is 3, expected a class",
    OWN.format(init="1/0", update="update", body="0"): "own.py:2: raised while being made: ZeroDivisionError",
    OWN.format(
        init="0", update="updat", body="0"
    ): "own.py: Own has no method update, expected update(time_s",
    OWN.format(
        init="0", update="update", body="return [0, 0]"
    ): "own.py: at 0.000 s commands are [0, 0], expected 4",
    OWN.format(init="0", update="update", body="pass"): "own.py: at 0.000 s commands are None, expected 4",
    OWN.format(
        init="0", update="update", body="return ['0', '0', '1', '1']"
    ): "commands are ['0', '0', '1', '1'], expected 4 finite numbers",
    OWN.format(
        init="0", update="update", body="return [1e308] * 4"
    ): "expected 4 finite numbers of at most 1e+12",
    OWN.format(
        init="0", update="update", body="return [0, 0, float('nan'), 0]"
    ): "commands are [0, 0, nan, 0]",
    OWN.format(
        init="0", update="update", body="return [0, 0, 0.4, 0.4] if time_s < 0.5 else time_s.no"
    ): "own.py:3: raised at 0.500 s: AttributeError: 'float' object has no attribute 'no'",
    "raise SystemExit(0)": "own.py:1: raised while being read: SystemExit: 0",
    OWN.format(init="exit(4)", update="update", body="0"): "own.py:2: raised while being made: SystemExit: 4",
    OWN.format(
        init="0", update="update", body="raise SystemExit(5)"
    ): "own.py:3: raised at 0.000 s: SystemExit: 5",
    "import os\nos._exit(0)": "own.py:2: raised while being read: SystemExit: os._exit(0)",
    "from os import _exit\n"
    + OWN.format(init="0", update="update", body="_exit(5)"): "own.py:4: raised at 0.000 s: SystemExit",
    OWN.format(init="0", update="update", body="return [0, 0, 0.4, 0.4]")
    + "    effectiveness = property(lambda self: 1 / 0)\n": "own.py:4: raised at 0.000 s: ZeroDivisionError",
    OWN.format(
        init="setup.actuators[0] = 0", update="update", body="0"
    ): "own.py: raised while being made: AttributeError",
    f"{NO_TEXT}{OWN.format(init='0', update='update', body='return NoText()')}": "own.py: at 0.000 s commands are of type NoText",
    "class Own:\n    parameters = 3\n": "own.py: the attribute `parameters` is 3, expected a mapping",
    STEP.format(bind="1/0", step="0"): "own.py:3: raised while being bound: ZeroDivisionError",
    STEP.format(bind="0", step="k/0"): "own.py:4: raised at 0.000 s: ZeroDivisionError",
    STEP.format(bind="0", step="[0.0]"): "own.py: at 0.000 s commands are [0.0], expected 4 finite",
    STEP.format(
        bind="0", step="['a'] * 4"
    ): "own.py: at 0.000 s commands are ['a', 'a', 'a', 'a'], expected 4",
    STEP.format(bind="0", step="[float('nan')] * 4"): "commands are [nan, nan, nan, nan], expected 4 finite",
    STEP.format(bind="0", step="[[0.0] * 4] * 4"): "own.py: at 0.000 s commands are",
    STEP.format(bind="channels[0].fill(0)", step="0"): "own.py:3: raised while being bound: ValueError",
    OWN.format(
        init="0", update="update", body="return [1j] * 4"
    ): "commands are [1j, 1j, 1j, 1j], expected 4",
    STEP.format(bind="0", step="[0.0] * 4") + "    reasons = 5\n": "own.py: raised in its reasons: TypeError",
}


@pytest.mark.parametrize("text", FAULTY, ids=list(FAULTY.values()))
def test_its_faults_are_said_with_file_and_line(tmp_path: Path, text: str) -> None:
    (tmp_path / "own.py").write_text(text)
    with pytest.raises(BadInput) as caught:
        fly(scenario(tmp_path, "pid", 1), controller=load_controller(f"{tmp_path / 'own.py'}:Own"))
    assert FAULTY[text] in str(caught.value)


def test_a_fault_in_flight_is_exit_status_2_and_leaves_nothing(tmp_path: Path) -> None:
    scenario(tmp_path)
    (tmp_path / "own.py").write_text(OWN.format(init="0", update="update", body="raise KeyError('gain')"))
    result = in_this_process(tmp_path, "run", "healthy.yaml", "--controller", "own.py:Own", "--out", "out")
    assert result.returncode == 2
    assert result.stderr.splitlines() == ["own.py:3: raised at 0.000 s: KeyError: 'gain'"]
    assert not (tmp_path / "out").exists()


def test_a_process_that_its_code_has_started_ends_as_before(tmp_path: Path) -> None:
    file = tmp_path / "own.py"
    text = "import os\nchild = os.fork()\nif child == 0:\n    os._exit(7)\n_, status = os.waitpid(child, 0)\n"
    file.write_text(f"{text}ended = os.waitstatus_to_exitcode(status)\nclass Own: ended = ended\n")
    assert load_controller(f"{file}:Own").ended == 7  # type: ignore[attr-defined]


def test_one_that_leaves_the_folder_does_not_take_the_flight_with_it(tmp_path: Path) -> None:
    (tmp_path / "away").mkdir()
    scenario(tmp_path, "pid", 1)
    body = "__import__('os').chdir('away') if time_s == 0 else None; return [0, 0, 0.4, 0.4]"
    (tmp_path / "own.py").write_text(OWN.format(init="0", update="update", body=body))
    given = ("run", "healthy.yaml", "--controller", "own.py:Own", "--out", "out", "--no-plots")
    result = in_this_process(tmp_path, *given)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "out" / "log.csv").is_file() and not list((tmp_path / "away").iterdir())


def test_a_scenario_cannot_name_a_file(tmp_path: Path) -> None:
    """YAML runs no code."""
    with pytest.raises(BadInput, match="unknown type"):
        scenario(tmp_path, f"'{EXAMPLE}:MyController'")


def test_a_folder_flown_by_ones_own_says_so(tmp_path: Path) -> None:
    flight = fly(scenario(tmp_path, "pid", 1), controller=load_controller(f"{EXAMPLE}:MyController"))
    folder = write_run_folder(flight, tmp_path / "out")
    assert load(folder).flown_by == "my_controller:MyController"
    assert "flown_by" not in fly(scenario(tmp_path, "pid", 1)).summary
