"""PX4 over its simulator's interface: against a fake written from the protocol, which flies and does what no autopilot should."""

import contextlib
import math
import os
import shutil
import socket
from dataclasses import replace

import numpy as np
import pytest
from pymavlink.dialects.v20 import common
from scripts import runnable

import testbed
from testbed.controllers.external import mavlink_frames, px4
from testbed.controllers.external.ardupilot_parameters import given
from testbed.controllers.external.px4 import written
from testbed.controllers.external.reference import load
from testbed.inputs.problems import BadInput
from testbed.scenario.load import load_scenario
from testbed.simulation import start_and_setup

FAKE = runnable("fake_px4.py")
SHORT = {"duration_s": 1.0, "failures": [], "requirements": []}


def flown(path=FAKE, parameters="", **changes):
    return testbed.fly("left_tail_fail.yaml", load(f"px4:{path} {parameters}"), set={**SHORT, **changes})


def refused(**changes):
    with pytest.raises(BadInput) as caught:
        flown(**changes)
    return str(caught.value)


@pytest.fixture
def brief(monkeypatch):
    """A warm-up of 4 s instead of 30: nothing of the fake settles. What it does wrong comes 0.25 s into the flight, as ever."""
    monkeypatch.setattr(px4, "WARM_UP_S", 4.0)
    monkeypatch.setenv("FAKE_AT", "850")


def setup_of(aircraft, airspeed):
    changes = {**SHORT, "aircraft": aircraft, "initial.airspeed_m_s": airspeed}
    return start_and_setup(load_scenario("left_tail_fail.yaml", changes))[1]


@pytest.mark.nightly
def test_it_turns_climbs_and_flies_the_same_again():
    commands = [{"at_s": 0, "heading_deg": 60, "altitude_m": 300}, {"at_s": 1, "altitude_m": 305}]
    flights = [flown(duration_s=20.0, commands=commands) for _ in range(2)]
    assert flights[0].outcome.value == "completed" and flights[0].flown_by == "fake_px4.py"
    assert abs(flights[0].column("heading_deg")[-1] - 60.0) < 10.0
    assert abs(flights[0].column("altitude_m")[-1] - 305.0) < 1.5
    assert flights[0].data.tobytes() == flights[1].data.tobytes()


@pytest.mark.usefixtures("brief")
@pytest.mark.nightly
def test_real_sensors_reach_it():
    assert flown(sensors="mems").data.tobytes() != flown().data.tobytes()


def test_its_log_console_and_parameters_stay_in_its_folder():
    with testbed.Session("left_tail_fail.yaml", load(f"px4:{FAKE}"), set=SHORT) as session:
        plan, controller = session.parts.plan, session.parts.controller
        session.run_to(1.0)
        controller.close()
        kept = plan.files()
    assert kept["0.ulg"] == b"6203 2" and b"CA_SV_CS0_TRQ_P " in kept["parameters.parm"]
    assert kept["console.txt"].split() == [b"fake", b"px4", str(FAKE.parents[1] / "etc").encode(), b"1030"]


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("dies", 's it ended with status 1; its last words: "no fuel"'),
        ("killed", "was ended by SIGSEGV"),
        ("rubbish", "it sent bytes that begin with b'\\xff"),
        ("megabytes", "it sent bytes that begin with b'\\x00"),
        ("checksum", "it sent message 93 with a wrong checksum"),
        ("nan", "expected finite numbers"),
        ("unarmed", "at 0.000 s it is not armed, expected the reason in console.txt"),
    ],
)
def test_what_goes_wrong_is_said(monkeypatch, fault, said):
    monkeypatch.setenv("FAKE_FAULT", fault)
    assert said in refused()


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize("fault", ["stalls", "late"])
def test_one_that_does_not_answer_in_time_is_not_waited_for(monkeypatch, fault):
    monkeypatch.setenv("FAKE_FAULT", fault)
    monkeypatch.setattr(px4, "STEP_S", 0.5)
    assert "it has not answered within 0.5 s" in refused()


def test_one_that_never_connects(monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "absent")
    monkeypatch.setattr(px4, "START_S", 0.5)
    assert "before the flight it has not connected within 0.5 s" in refused()


def test_one_that_never_sends_controls(monkeypatch):
    monkeypatch.setenv("FAKE_AT", "0")
    monkeypatch.setenv("FAKE_FAULT", "stalls")
    monkeypatch.setattr(px4, "START_S", 5.0)  # in which a busy machine starts a Python
    assert "before the flight it has sent no controls within 5 s" in refused()


@pytest.mark.usefixtures("brief")
@pytest.mark.nightly
def test_repeated_answers_change_nothing(monkeypatch):
    usual = flown().data.tobytes()
    monkeypatch.setenv("FAKE_FAULT", "repeats")
    assert flown().data.tobytes() == usual


@pytest.mark.usefixtures("brief")
def test_ports_that_are_taken_are_left_to_others():
    with socket.socket() as first, socket.socket(type=socket.SOCK_DGRAM) as second:
        for taken, port in ((first, 4560), (second, 14541)):
            with contextlib.suppress(OSError):  # somebody else's, which is as good
                taken.bind(("127.0.0.1", port))
        first.listen(1)
        assert flown().outcome.value == "completed"


def test_no_free_port_is_said(monkeypatch):
    monkeypatch.setattr(px4, "_MOST", 0)
    assert "finds no free ports from 4560 and 14540 on" in refused()


@pytest.mark.usefixtures("brief")
def test_one_that_goes_on_is_ended(monkeypatch):
    monkeypatch.setenv("FAKE_FAULT", "goes on")
    with testbed.Session("left_tail_fail.yaml", load(f"px4:{FAKE}"), set=SHORT) as session:
        process = session.parts.controller._flown._process
        session.run_to(0.1)
    assert process.returncode is not None and not os.path.exists(f"/proc/{process.pid}")


def test_a_program_of_another_kind_is_refused(tmp_path, monkeypatch):
    assert "before the flight it ended with status" in refused(path=shutil.which("true"))
    monkeypatch.delenv("TESTBED_PX4", raising=False)
    with pytest.raises(BadInput, match="TESTBED_PX4 is not set"):
        load("px4:")


@pytest.mark.parametrize(("aircraft", "airspeed", "surfaces"), [("vtail", 18.0, 2), ("aerosonde", 25.0, 3)])
def test_parameters_follow_from_the_aircraft(aircraft, airspeed, surfaces, tmp_path):
    setup = setup_of(aircraft, airspeed)
    values = written(setup)
    torques = np.array([[values[f"CA_SV_CS{n}_TRQ_{axis}"] for axis in "RPY"] for n in range(surfaces)])
    np.testing.assert_allclose(np.abs(torques).sum(axis=0), 1.0)
    effect = np.array(setup.model.input_matrix)[:3, :surfaces]
    assert (np.sign(torques.T) == np.sign(effect)).all()
    assert 0.01 < values["FW_PR_P"] < 1.0 and values["FW_AIRSPD_MIN"] < values["FW_AIRSPD_TRIM"]
    middle, half = px4._travel(setup)
    trims = [values[f"CA_SV_CS{n}_TRIM"] for n in range(surfaces)]
    np.testing.assert_allclose(
        (middle[:surfaces] + half[:surfaces] * trims), setup.trim_commands[:surfaces], atol=1e-9
    )
    (tmp_path / "own.parm").write_text("FW_PR_P 0.5\nFW_RR_P 0.4\n")
    later = {**values, **given(replace(setup, parameters={"FW_RR_P": 0.1}), str(tmp_path / "own.parm"))}
    assert (later["FW_PR_P"], later["FW_RR_P"]) == (0.5, 0.1)


def test_frames_are_those_of_mavlink():
    decoder = common.MAVLink(None)
    sensor = decoder.decode(
        bytearray(mavlink_frames.hil_sensor(1, 5000, *range(9), 900.0, 2.0, 300.0, 13.0, fields=0x1FFF))
    )
    assert (sensor.time_usec, sensor.zacc, sensor.zmag, sensor.abs_pressure) == (5000, 2.0, 8.0, 900.0)
    assert (sensor.diff_pressure, sensor.temperature, sensor.fields_updated) == (2.0, 13.0, 0x1FFF)
    fix = decoder.decode(
        bytearray(mavlink_frames.hil_gps(2, 5000, 450000001, -3, 300500, 1800, 1790, -20, 5))
    )
    assert (fix.lat, fix.lon, fix.alt, fix.vel, fix.ve, fix.fix_type) == (450000001, -3, 300500, 1800, -20, 3)
    path = decoder.decode(bytearray(mavlink_frames.path_target(3, 1.0, 2.0, -3.0, 4.0, 5.0, 6.0)))
    assert (path.z, path.vx, path.vz, path.type_mask, path.coordinate_frame) == (-3.0, 4.0, 6.0, 0xDC0, 1)
    assert decoder.decode(bytearray(mavlink_frames.heartbeat(4))).type == common.MAV_TYPE_GCS
    said = common.MAVLink_hil_actuator_controls_message(7000, [0.5] * 16, 128, 1).pack(common.MAVLink(None))
    ((number, payload, end),) = mavlink_frames.frames(said + said[:20])
    assert (number, end) == (93, len(said)) and mavlink_frames.actuator_controls(payload)[:2] == (7000, True)


def test_its_compass_points_north():
    field = np.array(px4._FIELD_GAUSS)
    declination = math.degrees(math.atan2(field[1], field[0]))
    assert declination == pytest.approx(3.3, abs=0.1) and np.linalg.norm(field) == pytest.approx(
        0.474, abs=0.002
    )
