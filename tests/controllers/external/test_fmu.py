"""Functional mock-up units (FMI 2.0 and 3.0), compiled here from the example in C, and archives that no unit should be."""

import os
import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
import pytest

import testbed
from testbed.__main__ import main
from testbed.controllers.external.fmu import SIGNALS, described
from testbed.controllers.external.reference import load
from testbed.controllers.user.loader import load_controller
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput

fmpy = pytest.importorskip("fmpy")
pytestmark = pytest.mark.skipif(not shutil.which("cc"), reason="there is no C compiler")

ROOT = Path(__file__).parents[3]
SHORT = {"duration_s": 1.0, "failures": [], "requirements": []}
ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
OTHERS = ("u1", "u2", "u3", "u4")
PLATFORM = {2: fmpy.platform, 3: fmpy.platform_tuple}


def variables(fmi, names):
    """The variables of `pilot_fmu.c` in the description's words."""
    inputs = (*SIGNALS, *(f"trim.{name}" for name in names))
    rows = [(name, "input", "continuous", "") for name in inputs]
    rows += [(name, "output", "discrete" if name == "count" else "continuous", "") for name in names]
    rows += [("gain", "parameter", "fixed", "1"), ("fault", "parameter", "fixed", "0")]
    for reference, (name, causality, variability, start) in enumerate(rows):
        start = start or ("0" if causality == "input" else "")
        said = (
            f'name="{name}" valueReference="{reference}" causality="{causality}" variability="{variability}"'
        )
        kind = {2: ("Real", "Integer"), 3: ("Float64", "Int32")}[fmi][name in ("fault", "count")]
        unit = 'unit="deg"' if name == "pitch" else ""
        value = f'start="{start}"' if start else ""
        yield (
            f"<ScalarVariable {said}><{kind} {unit} {value}/></ScalarVariable>"
            if fmi == 2
            else f"<{kind} {said} {unit} {value}/>"
        )


CLOCK = {
    2: "",
    3: '<Float64 name="t" valueReference="1000" causality="independent" variability="continuous"/>',
}


def description(fmi, names, first):
    attributes = {2: 'fmiVersion="2.0" guid="pilot"', 3: 'fmiVersion="3.0" instantiationToken="pilot"'}[fmi]
    structure = {
        2: "<Outputs>" + "".join(f'<Unknown index="{first + i + 1}"/>' for i in range(4)) + "</Outputs>",
        3: "".join(f'<Output valueReference="{first + i}"/>' for i in range(4)),
    }[fmi]
    return (
        f'<?xml version="1.0"?><fmiModelDescription {attributes} modelName="pilot">'
        '<CoSimulation modelIdentifier="pilot"/>'
        '<UnitDefinitions><Unit name="deg"><BaseUnit rad="1" factor="0.017453292519943295"/></Unit></UnitDefinitions>'
        f"<ModelVariables>{''.join(variables(fmi, names))}{CLOCK[fmi]}</ModelVariables>"
        f"<ModelStructure>{structure}</ModelStructure></fmiModelDescription>"
    )


@pytest.fixture(scope="module")
def libraries(tmp_path_factory):
    """The compiled unit for FMI 2 and 3, with the functions that it has no use for."""
    folder, made = tmp_path_factory.mktemp("units"), {}
    source = ROOT / "tests/support/pilot_fmu.c"
    for fmi, kind in [(2, fmpy.fmi2.FMU2Slave), (3, fmpy.fmi3.FMU3Slave)]:
        names = [name for name in dir(kind) if name.startswith(f"fmi{fmi}")]
        stubs = [
            f"int {name}(void) {{ return 3; }}\n" for name in names if f"{name}(" not in source.read_text()
        ]
        (folder / "rest.c").write_text("".join(stubs))
        made[fmi] = folder / f"pilot{fmi}.so"
        flags = ["-O2", "-shared", "-fPIC", f"-DFMI={fmi}", f"-I{ROOT}/examples", "-o", made[fmi]]
        subprocess.run(["cc", *flags, source, folder / "rest.c", "-lm"], check=True)
    return made


@pytest.fixture
def unit(libraries, tmp_path):
    """Makes pilot.fmu for a version of FMI, whose outputs have these names."""

    def made(fmi=2, names=ACTUATORS, more=()):
        file = tmp_path / "pilot.fmu"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("modelDescription.xml", description(fmi, names, len(SIGNALS) + 4))
            archive.write(libraries[fmi], f"binaries/{PLATFORM[fmi]}/pilot.so")
            for name, content in more:
                archive.writestr(name, content)
        return file

    return made


def flown(reference, **changes):
    return testbed.fly("left_tail_fail.yaml", load_controller(str(reference)), set={**SHORT, **changes})


def refused(reference, **changes):
    with pytest.raises(BadInput) as caught:
        flown(reference, **changes)
    return str(caught.value)


@pytest.mark.parametrize("fmi", [2, 3])
def test_it_flies_as_its_python_twin_and_the_same_again(unit, fmi):
    file = unit(fmi)
    flights = [flown(file, sensors="mems") for _ in range(2)]
    twin = flown(f"{ROOT}/examples/my_controller.py:MyController", sensors="mems")
    assert flights[0].flown_by == "pilot.fmu"
    assert flights[0].data.tobytes() == flights[1].data.tobytes()
    np.testing.assert_allclose(flights[0].data, twin.data, rtol=1e-6, atol=1e-9)


def test_a_mapping_names_what_does_not_fit(unit, tmp_path, capsys):
    file, mapping = unit(names=OTHERS), tmp_path / "names.yaml"
    assert "has no output left_ruddervator, expected one of u1, u2, u3, u4" in refused(file)
    trims = "".join(f"  trim.u{i + 1}: trim.{name}\n" for i, name in enumerate(ACTUATORS))
    outputs = "".join(f"  {name}: u{i + 1}\n" for i, name in enumerate(ACTUATORS))
    mapping.write_text(f"inputs:\n{trims}outputs:\n{outputs}")
    assert flown(f"{file} {mapping}").data.tobytes() == flown(unit()).data.tobytes()


def test_list_shows_what_fits(unit, tmp_path, capsys):
    assert main(["list", "fmu", str(unit(3))]) == 0
    shown = capsys.readouterr().out
    for row in [
        "airspeed takes airspeed",
        "pitch takes pitch in deg",
        "left_propeller commands left_propeller",
        "reference.heading takes reference.heading",
    ]:
        assert row in " ".join(shown.split())
    assert main(["list", "fmu", str(unit(names=OTHERS))]) == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "trim.u1 keeps its start value 0" in shown and "u1 is an output that nothing takes" in shown
    assert "left_propeller has no output: a mapping can name one" in shown
    assert (
        main(["list", "fmu"]) == 2 and "expected testbed list fmu FILE [MAPPING]" in capsys.readouterr().err
    )


def test_parameters_of_a_scenario_set_those_of_the_unit(unit):
    file, weak = unit(), {"controller.parameters": {"gain": 0.5}}
    halved, whole = flown(file, **weak), flown(file)
    name = "left_ruddervator_command"
    assert halved.column(name)[0] == pytest.approx(0.5 * whole.column(name)[0])
    assert "has no parameter gian, expected one of gain, fault, did you mean gain?" in refused(
        file, **{"controller.parameters": {"gian": 1.0}}
    )


@pytest.mark.parametrize(
    ("fault", "fmi", "said"),
    [
        (1, 2, "pilot.fmu: at 0.100 s it said: fmi2DoStep failed with status 3 (error)"),
        (1, 3, "fmi3DoStep failed with status 3 (error)"),
        (2, 2, "at 0.100 s it answered"),
        (3, 2, "at 0.100 s it was ended by SIGSEGV"),
        (4, 3, "at 0.100 s it has not answered within 0.5 s"),
        (6, 3, "doStep asks for the end of the simulation"),
    ],
)
def test_what_goes_wrong_is_said_with_its_time(unit, monkeypatch, fault, fmi, said):
    monkeypatch.setattr("testbed.controllers.external.process.STEP_S", 0.5 if fault == 4 else 10.0)
    assert said in refused(unit(fmi), **{"controller.parameters": {"fault": fault}})


def test_what_it_prints_is_no_answer(unit):
    file = unit()
    assert flown(file, **{"controller.parameters": {"fault": 5}}).data.tobytes() == flown(file).data.tobytes()


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("../evil", "'../evil' would be written elsewhere"),
        ("/evil", "'/evil' would be written elsewhere"),
        ("a\\b", "would be written elsewhere"),
    ],
)
def test_archives_that_write_elsewhere_are_refused(unit, name, said):
    assert said in refused(unit(more=[(name, "x")]))


def test_archives_that_are_too_large_are_refused(unit, monkeypatch):
    monkeypatch.setattr("testbed.controllers.external.fmu._MOST_BYTES", 10_000)
    with pytest.raises(BadInput, match="has more than 10000 files or 10000 bytes"):
        described(str(unit()))


def test_what_is_no_unit_is_refused(unit, tmp_path):
    file = tmp_path / "other.fmu"
    file.write_bytes(os.urandom(1000))
    assert "cannot be read as an FMU: File is not a zip file" in refused(file)
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("modelDescription.xml", "<html/>")
    assert "cannot be read as an FMU" in refused(file)
    with pytest.raises(BadInput, match="there is no such file"):
        load(str(tmp_path / "none.fmu"))
    mapping = tmp_path / "wrong.yaml"
    mapping.write_text("inputs: {pich: pitch, roll: rol}\noutputs: {left_tail: u1}\n")
    said = refused(f"{unit(names=OTHERS)} {mapping}")
    assert "there is no pich, did you mean pitch?" in said and "there is no rol, did you mean roll?" in said
    assert "inputs: " in said and "there is no left_tail" in said
    mapping.write_text("outputs: {left_ruddervator: count}\n")
    assert "outputs: count is no real scalar" in refused(f"{unit(names=('count', *OTHERS[1:]))} {mapping}")


def test_a_sweep_knows_it_by_name_with_its_mapping(unit, tmp_path):
    file, mapping = unit(), tmp_path / "names.yaml"
    mapping.write_text("inputs: {}\n")
    own = own_controllers([f"mine={file} {mapping}"])["mine"]
    assert own.load().words == (str(file), str(mapping))
    assert [name for name, _ in own.code] == ["pilot.fmu", "names.yaml"]
