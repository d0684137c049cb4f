"""What is said of an aircraft's files before JSBSim sees them."""

from __future__ import annotations

from pathlib import Path

import jsbsim
import pytest
from hostile_models import HOSTILE, MODEL, inserted, replaced, vtail_at

from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.aircraft.model_files import check, numbers, used
from testbed.aircraft.model_files.check import model_problems

STOCK = Path(jsbsim.__file__).parent / "aircraft"
_ADOPTED = ("`testbed adopt` removes it", "`testbed adopt` copies from them", "`testbed adopt` does so")


def test_a_shipped_aircraft_has_no_problem(vtail: Aircraft) -> None:
    assert model_problems(vtail) == []


@pytest.mark.parametrize("name", sorted(d.name for d in STOCK.iterdir() if (d / f"{d.name}.xml").is_file()))
def test_of_jsbsims_own_models_only_what_adoption_changes_is_refused(name: str) -> None:
    """Their `output` and `input`, entities, and files in JSBSim's shared folders; `blank` is no model of today's format."""
    files = used.ModelFiles(STOCK / name, name)
    problems = [*files.problems]
    for rule in (
        check.forbidden,
        check.incomplete,
        numbers.not_numbers,
        numbers.unphysical,
        check.dangerous,
    ):
        problems += rule(files)
    others = [str(problem) for problem in problems if not any(words in str(problem) for words in _ADOPTED)]
    assert others == [] or name == "blank", others
    assert files.root is not None


def test_each_file_that_is_used_is_read_once(vtail: Aircraft) -> None:
    files = used.ModelFiles(vtail.folder, vtail.model)
    assert [root.file.name for root in files.roots] == ["vtail.xml", "vtail_motor.xml", "vtail_prop.xml"]
    assert len(files.inside("propulsion", "engine")) == 2
    assert len(files.inside("mass_balance", "pointmass")) == 2


def test_all_problems_are_said_at_once(vtail_copy: Path) -> None:
    for name in (
        "output to a file",
        "declared trim",
        "nan in a propeller table",
        "negative mass",
        "no inertia",
    ):
        HOSTILE[name].spoil(vtail_copy)
    problems = model_problems(load_aircraft(str(vtail_copy)))
    assert len(problems) == 5
    assert all(problem.line for problem in problems)


@pytest.mark.parametrize(
    "name",
    ["simulation/reset", "/simulation/reset", "simulation[0]/reset", "fcs/../simulation/do_simple_trim",
     "simulation/./terminate", "simulation/output[1]/log_rate_hz", "simulation/write-state-file"],
)  # fmt: skip
def test_every_spelling_of_a_steering_property_is_known(name: str) -> None:
    assert check.steers(name)


@pytest.mark.parametrize(
    "name", ["simulation/integrator/rate/rotational", "fcs/reset", "simulation/sim-time-sec"]
)
def test_other_properties_may_be_written_by_a_model(name: str) -> None:
    assert not check.steers(name)


def test_a_system_is_found_where_jsbsim_finds_it(vtail_copy: Path) -> None:
    (vtail_copy / "Systems").mkdir()
    (vtail_copy / "Systems" / "lights.xml").write_text("<system name='lights'/>")
    inserted("fdm_config", '<system file="lights"/>')(vtail_copy)
    assert model_problems(load_aircraft(str(vtail_copy))) == []


def test_an_inertia_a_little_beyond_the_triangle_is_flown(vtail_copy: Path) -> None:
    """As ten of JSBSim's own models have it."""
    replaced(MODEL, r'<izz unit="KG\*M2">[^<]*', '<izz unit="KG*M2">0.9')(vtail_copy)
    assert model_problems(load_aircraft(str(vtail_copy))) == []


def test_a_model_with_a_name_too_long_for_a_file_is_not_there(tmp_path: Path) -> None:
    folder = vtail_at(tmp_path)
    file = folder / "vtail.yaml"
    file.write_text(file.read_text().replace("model: vtail", f"model: {'x' * 1000}"))
    (problem,) = model_problems(load_aircraft(str(folder)))
    assert problem.what == "there is no such file"
