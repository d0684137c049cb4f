"""ArduPilot over its JSON interface: against a fake written from the protocol, which flies and does what no autopilot should."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pymavlink.dialects.v20 import common
from scripts import runnable

import testbed
from testbed.__main__ import main
from testbed.controllers.external import ardupilot, mavlink_frames
from testbed.controllers.external.ardupilot_parameters import Outputs, given, written
from testbed.controllers.external.reference import load
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput
from testbed.scenario.load import load_scenario
from testbed.simulation import start_and_setup

FAKE = runnable("fake_ardupilot.py")
SHORT = {"duration_s": 2.0, "failures": [], "requirements": []}
REAL = os.environ.get("TESTBED_ARDUPILOT", "")


def flown(path=FAKE, parameters="", **changes):
    controller = load(f"ardupilot:{path} {parameters}")
    return testbed.fly("left_tail_fail.yaml", controller, set={**SHORT, **changes})


def refused(**changes):
    with pytest.raises(BadInput) as caught:
        flown(**changes)
    return str(caught.value)


@pytest.fixture
def brief(monkeypatch):
    """A warm-up of 4 s instead of 20: nothing of the fake settles. What it does wrong comes 0.25 s into the flight, as ever."""
    monkeypatch.setattr(ardupilot, "WARM_UP_S", 4.0)
    monkeypatch.setenv("FAKE_AT", "850")


def setup_of(aircraft, airspeed):
    changes = {**SHORT, "aircraft": aircraft, "initial.airspeed_m_s": airspeed}
    return start_and_setup(load_scenario("left_tail_fail.yaml", changes))[1]


def digest(flight):
    return hashlib.sha256(flight.data.tobytes()).hexdigest()


def test_it_flies_and_two_at_once_fly_the_same(tmp_path):
    command = [
        sys.executable,
        "-m",
        "testbed",
        "run",
        "left_tail_fail.yaml",
        "--autopilot",
        FAKE,
        "--no-plots",
    ]
    changes = ["--set", "duration_s=5", "--set", "failures=[]", "--set", "requirements=[]"]
    both = [subprocess.Popen([*command, *changes, "--out", tmp_path / name]) for name in "ab"]
    assert [process.wait(120) for process in both] == [0, 0]
    assert (tmp_path / "a/log.csv").read_bytes() == (tmp_path / "b/log.csv").read_bytes()
    log = json.loads((tmp_path / "a/controller/00000001.BIN").read_text())
    assert log == json.loads((tmp_path / "b/controller/00000001.BIN").read_text())


@pytest.mark.nightly
def test_three_flights_are_the_same():
    flights = [flown(duration_s=5.0) for _ in range(3)]
    assert flights[0].outcome.value == "completed" and flights[0].flown_by == "fake_ardupilot.py"
    assert abs(flights[0].column("altitude_m") - 300.0).max() < 3.0
    assert len({digest(flight) for flight in flights}) == 1


def test_options_that_do_not_go_together_are_refused(capsys):
    for options, said in [
        (["--autopilot-parameters", "x.parm"], "--autopilot-parameters: is for an autopilot"),
        (["--autopilot", str(FAKE), "--controller", str(FAKE)], "--autopilot: flies alone"),
    ]:
        assert main(["run", "left_tail_fail.yaml", *options]) == 2
        assert said in capsys.readouterr().err


@pytest.mark.usefixtures("brief")
def test_real_sensors_reach_it():
    assert digest(flown(sensors="mems")) != digest(flown())


def test_its_log_console_and_parameters_stay_in_its_folder():
    kept = {}
    with testbed.Session("left_tail_fail.yaml", load(f"ardupilot:{FAKE}"), set=SHORT) as session:
        plan, controller = session.parts.plan, session.parts.controller
        session.run_to(2.0)
        controller.close()
        kept = plan.files()
    assert {"00000001.BIN", "console.txt", "parameters.parm"} <= set(kept)
    assert kept["console.txt"] == b"fake autopilot 45,10,0,0\n"
    count, heard = json.loads(kept["00000001.BIN"])
    assert count == 4000 + 400 + 1  # warm-up, flight, and one more to end
    assert heard == [[3800, 400], [3960, 176], [3980, 43001], [3980, 43000], [3980, 43002]]


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("dies", 'at 0.245 s it ended with status 1; its last words: "no fuel"'),
        ("killed", "was ended by SIGSEGV"),
        ("magic", "expected a servo packet: 40 bytes of magic 18458"),
        ("rubbish", "it sent 1000 bytes that begin with"),
        ("short", "it sent 39 bytes"),
        ("jumps", "sent packet 855 after packet 849"),
    ],
)
def test_what_goes_wrong_is_said_with_its_time(monkeypatch, fault, said):
    monkeypatch.setenv("FAKE_FAULT", fault)
    assert said in refused()


@pytest.mark.usefixtures("brief")
def test_one_that_stalls_is_not_waited_for(monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "stalls")
    monkeypatch.setattr(ardupilot, "STEP_S", 0.5)
    assert "at 0.245 s it has not answered within 0.5 s" in refused()


@pytest.mark.usefixtures("brief")
def test_one_that_dies_before_the_flight(monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "dies")
    monkeypatch.setenv("FAKE_AT", "0")
    assert "before the flight it ended with status 1" in refused()
    monkeypatch.setenv("FAKE_AT", "400")
    assert "in its warm-up" in refused()


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize("harmless", ["repeats", "long"])
def test_repeated_and_long_packets_change_nothing(monkeypatch, harmless):
    usual = digest(flown())
    monkeypatch.setenv("FAKE_FAULT", harmless)
    assert digest(flown()) == usual


@pytest.mark.usefixtures("brief")
def test_one_that_goes_on_is_ended(monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "goes on")
    with testbed.Session("left_tail_fail.yaml", load(f"ardupilot:{FAKE}"), set=SHORT) as session:
        process = session.parts.controller._flown._process
        session.run_to(0.1)
    assert process.returncode is not None and not os.path.exists(f"/proc/{process.pid}")


def test_one_that_has_flown_no_step_is_closed():
    with testbed.Session("left_tail_fail.yaml", load(f"ardupilot:{FAKE}"), set=SHORT) as session:
        process = session.parts.controller._flown._process
    assert process.returncode is not None


def test_frames_are_those_of_mavlink():
    decoder = common.MAVLink(None)
    arm = decoder.decode(bytearray(mavlink_frames.command_long(7, mavlink_frames.ARM, 1, 21196)))
    assert (arm.command, arm.param1, arm.param2, arm.target_system) == (400, 1, 21196, 1)
    climb = decoder.decode(
        bytearray(mavlink_frames.command_int(300, mavlink_frames.CHANGE_ALTITUDE, z=310.5))
    )
    assert (climb.command, climb.z, climb.frame) == (43001, 310.5, 0)
    assert climb.get_seq() == 300 % 256
    asked = decoder.decode(bytearray(mavlink_frames.parameter_request(1, "SIXTEEN_LETTERS_")))
    assert (asked.param_id, asked.param_index) == ("SIXTEEN_LETTERS_", -1)
    assert decoder.decode(bytearray(mavlink_frames.parameter_list(2))).get_type() == "PARAM_REQUEST_LIST"


@pytest.mark.parametrize(
    ("aircraft", "airspeed", "functions"),
    [("vtail", 18.0, [79, 80, 73, 74]), ("aerosonde", 25.0, [19, 4, 21, 70])],
)
def test_parameters_follow_from_the_aircraft(aircraft, airspeed, functions):
    setup = setup_of(aircraft, airspeed)
    values = written(setup)
    assert [values[f"SERVO{n}_FUNCTION"] for n in range(1, 5)] == functions
    trims = [values[f"SERVO{n}_TRIM"] for n in range(1, 5)]
    commands = Outputs(setup, values).commands([*trims, *[0] * 12])
    servo = [kind == "servo" for kind in setup.model.kinds]
    np.testing.assert_allclose(commands[servo], np.array(setup.trim_commands)[servo], atol=1e-3)
    assert values["AIRSPEED_MIN"] < values["AIRSPEED_CRUISE"] < values["AIRSPEED_MAX"]
    assert 0.05 < values["PTCH_RATE_P"] < 0.5 and 0.05 < values["RLL_RATE_P"] < 0.5


def test_positive_demands_turn_the_aircraft_their_way():
    setup = setup_of("vtail", 18.0)
    outputs = Outputs(setup, written(setup))
    effect = np.array(setup.model.input_matrix)[:, :2]
    turned = [
        effect @ outputs.commands([*pulses, 0, 0, *[0] * 12])[:2] for pulses in ([1600, 1600], [1600, 1400])
    ]
    assert turned[0][1] > 0.0 and turned[1][2] > 0.0  # nose up; nose right


def test_later_parameters_count(tmp_path):
    file = tmp_path / "tuned.parm"
    file.write_text("PTCH_RATE_P 0.3 # mine\nSERVO1_FUNCTION,4\nSERVO6_FUNCTION 79\nRLL_RATE_P 0.2\n")
    setup = replace(setup_of("vtail", 18.0), parameters={"RLL_RATE_P": 0.1})
    values = {**written(setup), **given(setup, str(file))}
    assert (values["PTCH_RATE_P"], values["RLL_RATE_P"]) == (0.3, 0.1)
    pulses = [1500] * 16
    pulses[5] = 2000
    assert Outputs(setup, values).commands(pulses)[0] == pytest.approx(setup.actuators[0].low)


@pytest.mark.parametrize(
    ("line", "said"),
    [("PTCH_RATE_P", "expected NAME VALUE"), ("A B", "is 'B'"), ("x;y 3", "'x;y' is '3'")],
)
def test_parameters_that_are_none_are_refused(tmp_path, line, said):
    (tmp_path / "wrong.parm").write_text(line if "B" not in line else "PTCH B")
    assert said in refused(parameters=tmp_path / "wrong.parm")


def test_parameters_of_a_scenario_are_names_and_numbers():
    said = refused(**{"controller.parameters": {"PTCH_RATE_P": "high"}})
    assert "controller.parameters: 'PTCH_RATE_P' is 'high'" in said
    assert "no SERVOn_FUNCTION is 79" in refused(**{"controller.parameters": {"SERVO1_FUNCTION": 0}})


def refused_as_unknown(path, tmp_path):
    file = tmp_path / "tuned.parm"
    file.write_text("PTCH_RATE_P 0.1\nRLL_RATE_PX 0.2\n")
    changes = {"controller.parameters": {"PTHC_RATE_P": 1}, "duration_s": 0.1}
    assert refused(path=path, parameters=file, **changes).splitlines() == [
        f"{Path(path).name}: it has no parameter RLL_RATE_PX, did you mean RLL_RATE_P?",
        f"{Path(path).name}: it has no parameter PTHC_RATE_P, did you mean PTCH_RATE_P?",
    ]
    assert flown(path, **{**changes, "controller.parameters": {"PTCH_RATE_P": 0.1}}).outcome == "completed"


def test_a_parameter_that_it_does_not_have_is_refused_before_the_flight(tmp_path):
    refused_as_unknown(FAKE, tmp_path)


@pytest.mark.skipif(not REAL, reason="TESTBED_ARDUPILOT names no executable of ArduPilot")
def test_a_parameter_that_a_real_one_does_not_have_is_refused(tmp_path):
    refused_as_unknown(REAL, tmp_path)


def test_executables_that_cannot_be_run_are_refused(tmp_path, monkeypatch):
    monkeypatch.delenv("TESTBED_ARDUPILOT", raising=False)
    text = tmp_path / "arduplane"
    text.write_text("no program")
    for words, said in [
        ("ardupilot:", "TESTBED_ARDUPILOT is not set"),
        ("ardupilot:/no/such", "there is no such file"),
        (f"ardupilot:{text}", "its permissions forbid it"),
        (f"ardupilot:{FAKE} none.parm", "there is no such file of parameters"),
    ]:
        with pytest.raises(BadInput, match=said):
            load(words)
    monkeypatch.setenv("TESTBED_ARDUPILOT", str(FAKE))
    assert load("ardupilot:").words == ("ardupilot:", str(FAKE))


def test_a_sweep_and_its_workers_know_it_by_name(tmp_path):
    (tmp_path / "tuned.parm").write_text("RLL_RATE_P 0.1\n")
    own = own_controllers([f"ardu=ardupilot:{FAKE} {tmp_path / 'tuned.parm'}"])["ardu"]
    assert own.load().words == ("ardupilot:", str(FAKE), str(tmp_path / "tuned.parm"))
    assert [name for name, _ in own.code] == [FAKE.name, "tuned.parm"]
    there = tmp_path / "worker"
    there.mkdir()
    for name, content in own.code:
        (there / name).write_bytes(content)
    assert own.unpacked(there).load().words == (
        "ardupilot:",
        str(there / FAKE.name),
        str(there / "tuned.parm"),
    )


def test_a_program_of_another_kind_is_refused():
    assert "before the flight it ended with status" in refused(path=shutil.which("true"))


@pytest.mark.skipif(not REAL, reason="TESTBED_ARDUPILOT names no executable of ArduPilot")
def test_a_real_one_flies_the_same_three_times():
    flights = [flown(REAL, duration_s=60.0) for _ in range(3)]
    assert flights[0].outcome.value == "completed"
    assert len({digest(flight) for flight in flights}) == 1
