"""`testbed adopt`: a folder that loads, an aircraft that flies, refusals in a sentence."""

import math

import pytest
from command_line import in_this_process, testbed

from testbed.adoption.entry import adopted_card
from testbed.adoption.source import Source, find_source, package_root
from testbed.aircraft.description import load_aircraft
from testbed.inputs.problems import BadInput
from testbed.plant.identification import stored
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import trim


@pytest.mark.nightly
def test_a_glider_is_adopted_by_the_command_line(tmp_path):
    done = testbed(tmp_path, "adopt", "SGS")
    assert done.returncode == 0, done.stderr
    for heading in ("trim at", "modes", "condition number", "given up", "without aileron: "):
        assert heading in done.stdout
    aircraft = load_aircraft(str(tmp_path / "SGS"))
    assert list(aircraft.actuators) == ["elevator", "aileron", "rudder"]
    assert aircraft.axes == ("p_dot", "q_dot", "r_dot")
    assert stored(aircraft).identified_from == aircraft.fingerprint(), "its design model is the stored one"
    at = aircraft.reference
    found = trim(Plant(aircraft, 200), at.airspeed_m_s, at.altitude_m)
    assert -math.radians(5) < found.state["path_angle"] < 0.0
    flown = in_this_process(
        tmp_path, "run", "SGS/first_flight.yaml", "--set", "duration_s=22", "--set", "requirements=[]"
    )
    assert "testbed run SGS/first_flight.yaml" in done.stdout and flown.returncode == 0, flown.stderr
    again = in_this_process(tmp_path, "adopt", "SGS")
    assert (again.returncode, again.stderr) == (2, "SGS: exists already, expected --out with a new folder\n")


@pytest.mark.parametrize(
    ("model", "why"),
    [
        ("C130", "no known way to start its engines gives thrust to fly with: "),
        ("B17", "N at full throttle do not hold it in level flight"),
        ("ball", "its wing gives no lift"),
    ],
)
def test_what_cannot_be_adopted_is_refused_in_a_sentence(model, why, tmp_path):
    with pytest.raises(BadInput, match=f"{model} cannot be adopted: .*{why}") as refused:
        adopted_card(find_source(model, package_root()), tmp_path / "out")
    assert len(refused.value.problems) == 1
    assert not (tmp_path / "out").exists()


def hostile(folder, content) -> Source:
    folder.mkdir()
    (folder / f"{folder.name}.xml").write_text(content)
    return find_source(str(folder), package_root())


def test_a_model_that_ends_the_process_is_refused(tmp_path):
    # without mass or wing, JSBSim says so or dies; either way it is a sentence
    sections = "<metrics/><mass_balance/><aerodynamics/>"
    source = hostile(tmp_path / "empty", f'<fdm_config name="empty" version="2.0">{sections}</fdm_config>')
    with pytest.raises(BadInput, match=r"empty cannot be adopted: .*JSBSim"):
        adopted_card(source, tmp_path / "out")


def test_a_model_without_a_section_is_refused(tmp_path):
    source = hostile(tmp_path / "empty", '<fdm_config name="empty" version="2.0"/>')
    with pytest.raises(BadInput, match="empty cannot be adopted: it has no <metrics>"):
        adopted_card(source, tmp_path / "out")


def test_an_adoption_that_takes_too_long_is_given_up(tmp_path):
    with pytest.raises(
        BadInput, match=r"c172p cannot be adopted: it was not adopted within 1 s of processor time"
    ):
        adopted_card(find_source("c172p", package_root()), tmp_path / "out", longest_s=1)
