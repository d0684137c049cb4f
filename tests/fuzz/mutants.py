"""Files that a user could give by mistake or in malice: mutations of the shipped ones, as hypothesis strategies.

A mutant is {name: text} of the files to write into an empty folder, in which `examine` then looks at them. Half of the
mutants are changed as trees of values, so that they get past the parser; the others as text.
"""

from __future__ import annotations

import copy
import json
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import outside
import received
import yaml
from hypothesis import strategies as st

ROOT = Path(__file__).parents[2]
Mutant = dict[str, str]

_TIMED = ("commands", "failures", "requirements")
_SECONDS = 2
"""Duration of the mutants' flights: that of the shipped scenarios is squeezed into it."""
HOSTILE = [
    None, True, False, "", " ", "x" * 1000, -1, 0, 1, 2, 1.5, 1e300, -1e300, 10**400, 1e-300, 2**63, float("nan"),
    float("inf"), "1e-3", [], {}, [1], [[]], {"a": 1}, [None], "\x1b[31m", "=1+1", "../..", "/dev/zero", "$\\frac{1}{$",
    "\x00", "nan", "0", "é\u202e", "uniform", "v" * 300, "a/b", "a.b", "-", "0x10", 1_000_000_000_000, "left_ruddervator",
]  # fmt: skip
_SCRAPS = [
    "\t", ":", "- ", "{", "}", "[", "]", "&a ", "*a", "<<: *a", "\x00", "\x85", "%", "!!python/object:os.system ", "!!binary x",
    '"', "'", "#", "\n", "---\n", "? ", "|", ">", "\\", "1e9", "-", ".", "nan", "\ufeff", "\ud7ff", "<", "/>", "</", "&amp;", "]]>",
]  # fmt: skip


def scenario_bases() -> list[dict[str, Any]]:
    """The shipped scenarios, squeezed into _SECONDS."""
    files = sorted((ROOT / "scenarios").glob("*.yaml"))
    return [_squeezed(yaml.safe_load(file.read_text(encoding="utf-8"))) for file in files]


def _squeezed(tree: dict[str, Any]) -> dict[str, Any]:
    factor = _SECONDS / tree["duration_s"]
    tree["duration_s"] = _SECONDS
    air = tree.get("atmosphere", {})
    timed = [*air.get("gusts", []), *([air["noise"]] if "noise" in air else [])]
    for entry in [*timed, *(entry for kind in _TIMED for entry in tree.get(kind, []))]:
        for key in ("at_s", "until_s", "from_s", "duration_s", "hold_s"):
            if key in entry:
                entry[key] = round(entry[key] * factor, 2)
    return tree


def search_bases() -> list[dict[str, Any]]:
    """The shipped searches, and one with all further keys, all with their flights squeezed into _SECONDS."""
    files = sorted((ROOT / "scenarios" / "searches").glob("*.yaml"))
    bases = [yaml.safe_load(file.read_text(encoding="utf-8")) for file in files]
    for tree in bases:
        factor = _SECONDS / tree["scenario"]["duration_s"]
        _squeezed(tree["scenario"])
        for path, distribution in tree["vary"].items():
            if path.endswith(".at_s"):
                ends = distribution["uniform"]
                distribution["uniform"] = [round(end * factor, 2) for end in ends]
    further = copy.deepcopy(next(tree for tree in bases if "failures.0.actuator" in tree["vary"]))
    further |= {
        "goal": "probability", "method": "importance", "cov": 0.5, "starts": 1, "time_limit_s": 9,
        "requirement": "altitude", "nominal": {"failures.0.value": 1},
        "set": {"requirements": [{"name": "altitude", "metric": "altitude_error_max_m", "at_most": 3}]},
        "compare": {"controller.type": ["pid"]},
    }  # fmt: skip
    further["vary"]["failures.0.actuator"]["weights"] = [1, 2]
    return [*bases, further]


def sweep_bases() -> list[dict[str, Any]]:
    """A sweep with every kind of distribution, and one of each further sampling, all with their scenario inside."""
    scenarios = scenario_bases()
    inside = {
        "name": "all kinds", "scenario": scenarios[0], "runs": 4, "seed": 3,
        "set": {"atmosphere": {"wind_m_s": [0, 0, 0]}},
        "vary": {
            "initial.altitude_m": {"uniform": [300, 310]},
            "initial.heading_deg": {"choice": [0, 90, 180], "weights": [1, 2, 1]},
            "initial.airspeed_m_s": {"normal": [18, 0.1]},
            "atmosphere.wind_m_s.0": {"triang": {"c": 0.5, "loc": -1, "scale": 2}},
            "command_rates.heading_deg_s": {"integers": [1, 3]},
        },
        "compare": {"controller.type": ["pid", "indi"]},
        "stop_when": {"half_width": 0.2},
    }  # fmt: skip
    values = {"failures.0.value": {"uniform": [0, 1]}}
    grid = {"scenario": scenarios[1], "sampling": "grid", "levels": 3, "vary": values}
    altitude = {"initial.altitude_m": {"log_uniform": [290, 310]}}
    latin = {"scenario": scenarios[2], "sampling": "latin_hypercube", "runs": 3, "vary": altitude}
    return [inside, grid, latin]


@st.composite
def mutated_trees(draw: st.DrawFn, bases: list[Any]) -> Any:
    """One of the trees with one to four changes."""
    tree = copy.deepcopy(draw(st.sampled_from(bases)))
    for _ in range(draw(st.integers(1, 4))):
        _change(draw, tree)
    return tree


def _change(draw: st.DrawFn, tree: Any) -> None:
    """One change of a place in a tree: another value, gone, twice, misspelt, or a value from elsewhere."""
    places = list(_places(tree))
    if not places:
        return
    node, key = draw(st.sampled_from(places))
    change = draw(st.sampled_from(["value", "value", "number", "delete", "twice", "key", "swap"]))
    if change == "value":
        node[key] = copy.deepcopy(draw(st.sampled_from(HOSTILE)))  # a later change may be of its inside
    elif change == "number":
        node[key] = draw(st.floats(width=32, allow_nan=False) | st.integers(-10, 1000))
    elif change == "delete":
        del node[key]
    elif change == "swap":
        other, where = draw(st.sampled_from(places))
        node[key] = copy.deepcopy(other[where])
    elif isinstance(node, list):
        node.insert(key, copy.deepcopy(node[key]))
    elif change == "key":
        node[draw(st.sampled_from(["x", f"{key}s", str(key)[1:], "", "a.b", "\x1b[2J"]))] = node.pop(key)


def _places(node: Any) -> Any:
    """(container, key) of every value."""
    if isinstance(node, dict | list):
        for key in list(node) if isinstance(node, dict) else range(len(node)):
            yield node, key
            yield from _places(node[key])


@st.composite
def mutated_text(draw: st.DrawFn, texts: list[str]) -> str:
    """One of the texts with one to four pieces inserted, deleted or doubled."""
    text = draw(st.sampled_from(texts))
    for _ in range(draw(st.integers(1, 4))):
        i = draw(st.integers(0, len(text)))
        j = min(len(text), i + draw(st.sampled_from([0, 1, 2, 10, 100, 1000])))
        kind = draw(st.sampled_from(["insert", "delete", "double", "cut"]))
        if kind == "insert":
            text = text[:i] + draw(st.sampled_from(_SCRAPS)) + text[i:]
        elif kind == "delete":
            text = text[:i] + text[j:]
        elif kind == "double":
            text = text[:j] + text[i:]
        elif draw(st.integers(0, 9)) == 0:
            text = text[:i]
    return text


def _yaml_files(name: str, bases: list[Any]) -> st.SearchStrategy[Mutant]:
    texts = mutated_trees(bases).map(_dumped) | mutated_text([_dumped(tree) for tree in bases])
    return texts.map(lambda text: {name: text})


def _dumped(tree: Any) -> str:
    return yaml.safe_dump(tree, sort_keys=False, allow_unicode=True)


def _aircraft_yaml() -> st.SearchStrategy[Mutant]:
    text = (ROOT / "aircraft" / "vtail" / "vtail.yaml").read_text(encoding="utf-8")
    return _yaml_files("vtail/vtail.yaml", [yaml.safe_load(text)])


def _design_models() -> st.SearchStrategy[Mutant]:
    text = (ROOT / "aircraft" / "vtail" / "design_model.json").read_text(encoding="utf-8")
    texts = mutated_trees([json.loads(text)]).map(json.dumps) | mutated_text([text])
    return texts.map(lambda text: {"vtail/design_model.json": text})


MODEL_FILES = ("vtail.xml", "Engines/vtail_motor.xml", "Engines/vtail_prop.xml")
_TEXTS = [
    "",
    "nan",
    "-1",
    "0",
    "1e300",
    "abc",
    "1 2 3",
    "../../etc/passwd",
    "fcs/nothing",
    "-fcs/left-ruddervator/effectiveness",
]
_INSERTS = [
    '<output name="out.csv" type="CSV" rate="10"/>', '<input port="1137"/>', '<system file="nothing"/>', "<function/>",
    '<property value="nan">fcs/x</property>', "<table/>", "<location unit='IN'><x>0</x></location>", "<engine file='../..'/>",
]  # fmt: skip


@st.composite
def mutated_model(draw: st.DrawFn) -> Mutant:
    """A file of the v-tail's model with one to three changes of its elements."""
    name = draw(st.sampled_from(MODEL_FILES))
    root = ET.fromstring((ROOT / "aircraft" / "vtail" / name).read_text(encoding="utf-8"))
    for _ in range(draw(st.integers(1, 3))):
        _change_element(draw, root)
    return {f"vtail/{name}": ET.tostring(root, encoding="unicode")}


def _change_element(draw: st.DrawFn, root: ET.Element) -> None:
    places = [(parent, i) for parent in root.iter() for i in range(len(parent))]
    if not places:
        return
    parent, i = draw(st.sampled_from(places))
    element = parent[i]
    change = draw(st.sampled_from(["text", "text", "delete", "twice", "tag", "attribute", "move", "insert"]))
    if change == "text":
        element.text = draw(st.sampled_from(_TEXTS) | st.floats(width=32).map(str))
    elif change == "delete":
        parent.remove(element)
    elif change == "twice":
        parent.insert(i, copy.deepcopy(element))
    elif change == "tag":
        element.tag = draw(st.sampled_from(["x", "table", "property", "function", element.tag + "s"]))
    elif change == "attribute":
        key = draw(st.sampled_from([*element.attrib, "name", "unit", "file"]))
        element.set(key, draw(st.sampled_from([*_TEXTS, "DEG", "M"])))
    elif change == "insert":
        parent.insert(i, ET.fromstring(draw(st.sampled_from(_INSERTS))))
    else:
        other, _ = draw(st.sampled_from(places))
        if other is not element and other not in list(element.iter()):
            parent.remove(element)
            other.append(element)


def _xml_text() -> st.SearchStrategy[Mutant]:
    folder = ROOT / "aircraft" / "vtail"
    return st.sampled_from(MODEL_FILES).flatmap(
        lambda name: mutated_text([(folder / name).read_text(encoding="utf-8")]).map(
            lambda text: {f"vtail/{name}": text}
        )
    )


KINDS: dict[str, st.SearchStrategy[Mutant]] = {
    "scenario": _yaml_files("s.yaml", scenario_bases()),
    "sweep": _yaml_files("sweep.yaml", sweep_bases()),
    "search": _yaml_files("search.yaml", search_bases()),
    "aircraft": _aircraft_yaml(),
    "xml": mutated_model() | _xml_text(),
    "design model": _design_models(),
    "matrix": _yaml_files("matrix.yaml", [received.MATRIX]),
    "suite": _yaml_files("benchmark.yaml", [received.STUDIES["benchmark.yaml"]]),
    "cases": outside.cases(mutated_text),
    "log": outside.logs(mutated_trees, mutated_text),
    "entry": outside.entries(mutated_trees, mutated_text),
    "message": outside.messages(mutated_trees, mutated_text),
    **{
        kind: received.mutants_of(kind, mutated_trees, mutated_text)
        for kind in ("run folder", "sweep folder", "search folder", "matrix folder", "benchmark folder")
    },
}
"""The kinds of mutants, by the file that is mutated."""
