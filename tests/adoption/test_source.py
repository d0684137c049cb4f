"""A model is read whole: what its other files hold is in its place, and what would open files or ports is gone."""

import xml.etree.ElementTree as ET

import pytest

from testbed.adoption.source import FOREIGN, find_source, package_root, read_whole
from testbed.inputs.problems import BadInput


def test_sections_of_other_files_are_in_their_place():
    source = find_source("c172x", package_root())
    assert any(each.get("file") for each in ET.parse(source.file).getroot() if each.tag == "system")
    tree = read_whole(source)
    assert not [each for each in tree if each.tag != "propulsion" and each.get("file")]
    assert tree.find("autopilot/channel") is not None


@pytest.mark.parametrize("model", ["c172x", "f16", "Short_S23"])
def test_no_output_or_input_of_the_simulation_is_left(model):
    tree = read_whole(find_source(model, package_root()))
    assert not tree.findall("output") and not tree.findall("input")
    assert tree.findall(".//channel/*/output"), "those of components stay"


def test_names_that_only_flightgear_provides_are_declared_here():
    tree = read_whole(find_source("p51d", package_root()))
    texts = [word.lstrip("-") for each in tree.iter() for word in (each.text or "").split()]
    assert not [word for word in texts if word.startswith("/") and len(word) > 1 and "." not in word]
    declared = {each.text for each in tree.iter("property") if each.get("value") == "0"}
    assert f"{FOREIGN}controls/engines/engine/throttle" in declared


def test_an_unknown_model_is_refused_with_a_suggestion():
    with pytest.raises(BadInput, match=r"no model 'c173p', expected .*, did you mean c172p\?"):
        find_source("c173p", package_root())


def test_a_name_like_none_is_refused_with_all_that_there_are():
    with pytest.raises(BadInput, match=r"no model 'Rascal', expected .*: 737, .*, c172p, c172r, "):
        find_source("Rascal", package_root())


def test_a_link_in_a_circle_is_no_model(tmp_path):
    (tmp_path / "mine").symlink_to("mine")
    with pytest.raises(BadInput, match=r"no model '.*mine'"):
        find_source(str(tmp_path / "mine"), package_root())


def test_a_missing_file_is_named(tmp_path):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "mine.xml").write_text('<fdm_config><system file="gone"/></fdm_config>')
    with pytest.raises(BadInput, match=r"mine\.xml: names the file gone, which is in none of"):
        read_whole(find_source(str(folder), package_root()))


def test_files_that_name_themselves_or_each_other_end(tmp_path):
    """One in a circle; and 40, each of which names the next one twice, which would be read 2^40 times."""
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "mine.xml").write_text('<fdm_config><system file="circle"/><system file="s0"/></fdm_config>')
    (folder / "circle.xml").write_text('<system name="c"><system file="circle"/></system>')
    for k in range(40):
        (folder / f"s{k}.xml").write_text(
            f'<system><system file="s{k + 1}"/><system file="s{k + 1}"/></system>'
        )
    tree = read_whole(find_source(str(folder), package_root()))
    assert {each.get("file") for each in tree.iter("system")} == {None, "circle", "s2"}


def test_what_is_no_model_is_refused(tmp_path):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "mine.xml").write_text("<propeller/>")
    with pytest.raises(BadInput, match=r"is <propeller>, expected a JSBSim model"):
        read_whole(find_source(str(folder), package_root()))
    (folder / "mine.xml").write_text("<fdm_config>")
    with pytest.raises(BadInput, match=r"mine\.xml:1: is not XML: the file ends too early"):
        read_whole(find_source(str(folder), package_root()))


def test_a_value_that_is_no_number_is_0_as_for_jsbsim():
    tree = read_whole(
        find_source("Short_S23", package_root())
    )  # its hydrodynamics leave three for the aircraft to set
    for each in tree.iter("property"):
        float(each.get("value", "0"))
