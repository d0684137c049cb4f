"""Controllers in processes of their own: the shipped example, and processes that do what no controller should."""

import json
import os
import shutil
import stat
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import testbed
from testbed.common.signals import SENSED
from testbed.controllers.external.reference import load
from testbed.controllers.user.loader import load_controller
from testbed.inputs.problems import BadInput

EXAMPLES = Path(__file__).parents[3] / "examples"
SHORT = {"duration_s": 1.0, "failures": [], "requirements": []}
ANSWERS = """
import json, sys
setup = json.loads(sys.stdin.readline())
print("{}", flush=True)
trim = [each["trim"] for each in setup["actuators"]]
for line in sys.stdin:
    told = json.loads(line)
    step = told["step"]
    answer = {"step": step, "commands": trim}
    """


@pytest.fixture
def process(tmp_path):
    """Makes the command of a process that answers with trim commands, but for what a line of Python does to it."""

    def made(line="", code=None):
        file = tmp_path / "pilot.py.txt"
        file.write_text(
            code
            if code is not None
            else ANSWERS + (line or "pass") + "\n    print(json.dumps(answer), flush=True)\n"
        )
        return f"{sys.executable} {file}"

    return made


def flown(command, **changes):
    """A short flight by a command, and the controller's parts are closed after it."""
    return testbed.fly("left_tail_fail.yaml", load_controller(command), set={**SHORT, **changes})


def refused(command):
    with pytest.raises(BadInput) as caught:
        flown(command)
    return str(caught.value)


@pytest.mark.skipif(not shutil.which("perl"), reason="Perl is not installed")
def test_the_example_flies_as_its_python_twin():
    by_process = flown(str(EXAMPLES / "pilot.pl"))
    twin = flown(f"{EXAMPLES / 'my_controller.py'}:MyController")
    assert by_process.flown_by == "pilot.pl"
    np.testing.assert_allclose(by_process.data, twin.data, rtol=1e-6, atol=1e-9)


def test_it_is_told_what_is_flown_but_not_what_will_fail(process, tmp_path):
    told = tmp_path / "told.json"
    flown(process(f"step or open({str(told)!r}, 'w').write(json.dumps([setup, told]))"), seed=7)
    setup, step = json.loads(told.read_text())
    assert setup["testbed"] == 1 and setup["seed"] == 7 and setup["aircraft"] == "vtail"
    assert [each["kind"] for each in setup["actuators"]] == ["servo", "servo", "motor", "motor"]
    assert setup["scenario"]["duration_s"] == 1.0 and "failures" not in setup["scenario"]
    assert tuple(step["sensed"]) == SENSED
    assert step["sensed"]["airspeed"] == pytest.approx(18.0, abs=0.5)
    assert -step["sensed"]["force_z"] == pytest.approx(9.8, abs=0.5)
    assert 95_000 < step["sensed"]["pressure"] < 101_325


def test_its_files_are_kept_in_the_run_folder(process, tmp_path):
    told = tmp_path / "told"
    own = "open(setup['folder'] + '/own.log', 'w').write(str(step)), print('a word', file=sys.stderr)"
    flight = flown(process(f"open({str(told)!r}, 'w').write(setup['folder']), {own}"))
    assert not os.path.exists(told.read_text())
    flight.save(tmp_path / "run")
    kept = tmp_path / "run" / "controller"
    assert (kept / "own.log").read_text() == "199"
    assert (kept / "stderr.txt").read_text() == "a word\n" * 200


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("step == 100 and sys.exit(3)", "at 0.500 s it ended with status 3"),
        ("step == 100 and sys.exit('no fuel')", 'its last words: "no fuel"'),
        ("step == 100 and __import__('os').kill(__import__('os').getpid(), 11)", "was ended by SIGSEGV"),
        ("answer = {'step': step, 'commands': trim[:2]}", "at 0.000 s commands are"),
        ("answer['commands'] = [float('nan')] * 4", "it answered '{"),
        ("answer['commands'] = ['a'] * 4", "commands are ['a', 'a', 'a', 'a']"),
        ("answer = [1, 2]", "expected a JSON object"),
        ("answer = {}", "it answered without commands"),
        ("answer['step'] = step - 1", "answered for step -1 in step 0"),
        ("answer['effectiveness'] = 5", "effectiveness are 5"),
        ("print('rubbish')", "it answered 'rubbish'"),
        ("print('x' * 2_000_000, end='')", "1,000,000 bytes without the end of a line"),
        ("print('[' * 100_000)", "expected one JSON object in a line"),
    ],
)
def test_what_goes_wrong_is_said_with_its_time(process, line, said):
    assert said in refused(process(line))


def test_a_silent_process_is_not_waited_for(process, monkeypatch):
    monkeypatch.setattr("testbed.controllers.external.process.STEP_S", 0.3)
    assert "at 0.050 s it has not answered within 0.3 s" in refused(
        process("step == 10 and __import__('time').sleep(60)")
    )


def test_one_that_ignores_its_end_is_ended(process, tmp_path):
    pid = tmp_path / "pid"
    code = (
        ANSWERS
        + f"open({str(pid)!r}, 'w').write(str(__import__('os').getpid()))\n    print(json.dumps(answer), flush=True)\n"
    )
    begun = time.monotonic()
    flown(process(code=code + "import time\ntime.sleep(600)\n"))
    assert time.monotonic() - begun < 60
    assert not os.path.exists(f"/proc/{pid.read_text()}")


def test_one_that_never_says_it_is_ready():
    assert "before the flight it ended with status 0" in refused("true")


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("no_such_pilot", "no_such_pilot: there is no such file"),
        ("", "is empty"),
        ("'unended", "No closing quotation"),
        ("/", "/ is a folder"),
        ("pilot.py", "expected FILE.py:CLASS"),
    ],
)
def test_what_cannot_be_run_is_refused(name, said):
    with pytest.raises(BadInput) as caught:
        load_controller(name)
    assert said in str(caught.value)


def test_a_file_without_permission_is_refused(tmp_path):
    file = tmp_path / "pilot"
    file.write_text("#!/bin/sh\n")
    with pytest.raises(BadInput, match="its permissions forbid it"):
        load(str(file))
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    assert load(str(file)).controller_name == "pilot"


def test_real_sensors_and_their_faults_reach_it(process, tmp_path):
    rows = tmp_path / "rows"
    keep = f"open({str(rows)!r}, 'a').write(json.dumps(told['sensed']) + chr(10))"
    stuck = {"type": "stuck", "sensor": "accelerometer", "at_s": 0.5}
    flight = flown(process(keep), sensors={"model": "mems", "faults": [stuck]})
    sensed = [json.loads(row) for row in rows.read_text().splitlines()]
    assert len({row["force_y"] for row in sensed[101:]}) == 1 < len({row["force_y"] for row in sensed[:100]})
    assert len({row["velocity_north"] for row in sensed}) > 100
    assert sensed[50]["altitude"] == pytest.approx(flight.column("altitude_measured_m")[50], abs=1e-4)
