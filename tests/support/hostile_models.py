"""Aircraft that hurt: copies of the v-tail with one thing wrong, each as a function of a copy's folder.

`HOSTILE` names one of each kind. `mutants` yields any number of random ones from a seed, for fuzzing.
"""

from __future__ import annotations

import os
import random
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

from testbed.aircraft.shipped import data_root

Spoil = Callable[[Path], None]

MODEL, YAML = "vtail.xml", "vtail.yaml"
MOTOR, PROPELLER = "Engines/vtail_motor.xml", "Engines/vtail_prop.xml"
TAIL = "fcs/left-ruddervator"
LATER = "<lt><property>simulation/sim-time-sec</property><value>0.5</value></lt>"
"""1 at first, and 0 half a second later: what a first load does not see."""


class Hostile(NamedTuple):
    """One thing wrong with an aircraft, and what must be said of it: the file, then some words."""

    spoil: Spoil
    file: str
    words: str


def vtail_at(folder: Path) -> Path:
    """A copy of the v-tail at this path, named as the v-tail is."""
    return Path(shutil.copytree(data_root() / "aircraft" / "vtail", folder / "vtail"))


def replaced(file: str, old: str, new: str, count: int = 1) -> Spoil:
    """Replaces text, a regular expression, which must be there."""

    def spoil(folder: Path) -> None:
        text, n = re.subn(old, lambda _: new, (folder / file).read_text(), count=count, flags=re.DOTALL)
        assert n, f"{old} is not in {file}"
        (folder / file).write_text(text)

    return spoil


def inserted(section: str, new: str) -> Spoil:
    """Inserts text at the beginning of a section of the model."""

    def spoil(folder: Path) -> None:
        text = (folder / MODEL).read_text()
        assert f"<{section}" in text
        (folder / MODEL).write_text(re.sub(rf"(<{section}\b[^>]*>)", lambda m: m[1] + new, text, count=1))

    return spoil


def written(file: str, contents: bytes | str) -> Spoil:
    """Replaces a whole file."""

    def spoil(folder: Path) -> None:
        (folder / file).write_bytes(contents.encode() if isinstance(contents, str) else contents)

    return spoil


def removed(file: str) -> Spoil:
    return lambda folder: (folder / file).unlink()


def cut(file: str) -> Spoil:
    return lambda folder: (folder / file).write_bytes((folder / file).read_bytes()[:200])


def linked(file: str, target: str) -> Spoil:
    """Replaces a file by a link."""

    def spoil(folder: Path) -> None:
        (folder / file).unlink()
        (folder / file).symlink_to(target)

    return spoil


def pipe(file: str) -> Spoil:
    """Replaces a file by a named pipe that nobody writes to."""

    def spoil(folder: Path) -> None:
        (folder / file).unlink()
        os.mkfifo(folder / file)

    return spoil


def moved_out(folder: Path) -> None:
    """The engine is beside the aircraft's folder, and `../` leads to it."""
    shutil.copy(folder / MOTOR, folder.parent / "vtail_motor.xml")
    replaced(MODEL, 'file="vtail_motor"', 'file="../../vtail_motor"', 0)(folder)


def channel(component: str) -> Spoil:
    """Adds a channel with one component to the flight control."""
    return inserted("flight_control", f'<channel name="x">{component}</channel>')


def function(operation: str) -> Spoil:
    """Adds a function `aero/x` to the aerodynamics."""
    return inserted("aerodynamics", f"<function name='aero/x'>{operation}</function>")


def without(section: str) -> Spoil:
    return replaced(MODEL, rf"<{section}\b.*</{section}>", "")


_BILLION = (
    "<!DOCTYPE x [<!ENTITY a 'aaaaaaaaaa'>"
    + "".join(f"<!ENTITY {b} '{f'&{a};' * 10}'>" for a, b in zip("abcdefgh", "bcdefghi", strict=True))
    + "]>"
)

HOSTILE: dict[str, Hostile] = {
    # What JSBSim obeys
    "output to a file": Hostile(
        inserted("fdm_config", '<output name="owned.csv" type="CSV" rate="10"/>'), MODEL, "write a file"
    ),
    "output to a port": Hostile(
        inserted("fdm_config", '<output name="localhost" type="SOCKET" port="1138" protocol="UDP"/>'),
        MODEL,
        "port",
    ),
    "input port": Hostile(inserted("fdm_config", '<input port="1137"/>'), MODEL, "listen on a port"),
    "child": Hostile(inserted("fdm_config", '<child name="vtail"/>'), MODEL, "load another aircraft"),
    "entities": Hostile(replaced(MODEL, "<fdm_config", f"{_BILLION}<fdm_config"), MODEL, "DOCTYPE"),
    "external entity": Hostile(
        replaced(MODEL, "<fdm_config", "<!DOCTYPE x [<!ENTITY p SYSTEM 'file:///etc/passwd'>]><fdm_config"),
        MODEL,
        "DOCTYPE",
    ),
    "declared trim": Hostile(
        inserted("flight_control", '<property value="1">simulation/do_simple_trim</property>'),
        MODEL,
        "steers the simulation",
    ),
    "written stop": Hostile(
        channel(
            "<pure_gain name='x'><input>fcs/x</input><gain>1</gain><output>fcs/../simulation/terminate</output></pure_gain>"
        ),
        MODEL,
        "steers the simulation",
    ),
    "written state file": Hostile(
        inserted("flight_control", '<property value="1">simulation/write-state-file</property>'),
        MODEL,
        "steers the simulation",
    ),
    "written by a function": Hostile(
        inserted(
            "aerodynamics",
            "<function name='aero/x' copyto='simulation/write-state-file'><value>1</value></function>",
        ),
        MODEL,
        "steers the simulation",
    ),
    "engines started in flight": Hostile(
        inserted(
            "aerodynamics",
            "<function name='aero/x' copyto='propulsion/set-running'><value>1</value></function>",
        ),
        MODEL,
        "steers the simulation",
    ),
    # What would end the process or change the flight later than a first load looks
    "remainder": Hostile(
        function(f"<mod><value>1</value>{LATER}</mod>"),
        MODEL,
        "divide by zero.*a divisor <value> of 1 or more",
    ),
    "remainder of a whole number": Hostile(
        function("<mod><value>1</value><value>0.5</value></mod>"), MODEL, "divide by zero"
    ),
    "switch in a function": Hostile(
        function(f"<switch>{LATER}<value>1</value></switch>"), MODEL, "ends the process.*<ifthen>"
    ),
    "seed of the clock": Hostile(function("<random seed='time_now'/>"), MODEL, "seed='time_now'"),
    "function that reads itself": Hostile(
        function(f"<ifthen>{LATER}<value>1</value><property>aero/x[0]</property></ifthen>"),
        MODEL,
        "reads its own value, aero/x",
    ),
    "missing property in a later branch": Hostile(
        function(f"<ifthen>{LATER}<value>1</value><property>aero/alhpa-rad</property></ifthen>"),
        MODEL,
        "aero/alhpa-rad.*did you mean aero/alpha-rad",
    ),
    "endless delay": Hostile(
        channel(
            "<actuator name='fcs/x'><input>fcs/left-ruddervator/command-rad</input>"
            "<delay type='frames'>1000000000</delay></actuator>"
        ),
        MODEL,
        "JSBSim says",
    ),
    "functions that read each other": Hostile(
        inserted(
            "aerodynamics",
            "<function name='aero/x'><property>aero/y</property></function>"
            "<function name='aero/y'><property>-aero/x</property></function>",
        ),
        MODEL,
        "reads its own value, aero/x through aero/y",
    ),
    # Files
    "no model": Hostile(removed(MODEL), MODEL, "there is no such file"),
    "empty model": Hostile(written(MODEL, ""), MODEL, "is not XML: no element found"),
    "cut model": Hostile(cut(MODEL), MODEL, "is not XML"),
    "not a model": Hostile(written(MODEL, "<runscript/>"), MODEL, "a JSBSim model"),
    "NUL": Hostile(written(MODEL, b"<fdm_config>\0</fdm_config>"), MODEL, "is not XML"),
    "deep": Hostile(
        inserted("aerodynamics", "<function name='x'>" + "<sum>" * 5000 + "</sum>" * 5000 + "</function>"),
        MODEL,
        "nested deeper",
    ),
    "9 MB": Hostile(inserted("fdm_config", "<!-- " + "x" * 9_000_000 + " -->"), MODEL, "at most 8 MB"),
    "attributes": Hostile(
        inserted("fdm_config", "<documentation " + " ".join(f"a{i}='1'" for i in range(2000)) + "/>"),
        MODEL,
        "has 2000 attributes, expected at most 1000",
    ),
    "long table": Hostile(
        replaced(PROPELLER, "<tableData>", f"<tableData>{'1 2 ' * 300_000}"),
        PROPELLER,
        "expected at most 1000000",
    ),
    "model elsewhere": Hostile(replaced(YAML, "model: vtail ", "model: ../vtail/vtail "), YAML, "model"),
    "no engine file": Hostile(removed(MOTOR), MODEL, "vtail_motor.*there is no such file"),
    "empty engine file": Hostile(written(MOTOR, ""), MOTOR, "is not XML"),
    "cut engine file": Hostile(cut(MOTOR), MOTOR, "is not XML"),
    "engine file of another kind": Hostile(written(MOTOR, "<pump/>"), MODEL, "has no engine"),
    "no propeller file": Hostile(removed(PROPELLER), MODEL, "vtail_prop.*there is no such file"),
    "empty propeller file": Hostile(written(PROPELLER, ""), PROPELLER, "is not XML"),
    "mistyped engine file": Hostile(
        replaced(MODEL, 'file="vtail_motor"', 'file="vtail_moter"'), MODEL, "did you mean vtail_motor"
    ),
    "engine outside": Hostile(moved_out, MODEL, "leaves the aircraft's folder"),
    "absolute engine": Hostile(
        replaced(MODEL, 'file="vtail_motor"', 'file="/etc/passwd"'), MODEL, "leaves the aircraft's folder"
    ),
    "link outside": Hostile(linked(MOTOR, "/etc/hostname"), MODEL, "leaves the aircraft's folder"),
    "pipe": Hostile(pipe(MOTOR), MOTOR, "no regular file"),
    "missing system": Hostile(
        inserted("fdm_config", '<system file="nowhere"/>'), MODEL, "there is no such file"
    ),
    "file of a channel": Hostile(
        inserted("flight_control", '<channel file="/etc/passwd"/>'), MODEL, "reads for other elements only"
    ),
    # Sections and parts
    "no aerodynamics": Hostile(without("aerodynamics"), MODEL, "has no <aerodynamics>"),
    "no mass": Hostile(without("mass_balance"), MODEL, "has no <mass_balance>"),
    "no metrics": Hostile(without("metrics"), MODEL, "has no <metrics>"),
    "no propulsion": Hostile(without("propulsion"), YAML, "not the number of an engine"),
    "no flight control": Hostile(
        without("flight_control"), MODEL + "|" + YAML, "no (part of the model has a )?property"
    ),
    "no thruster": Hostile(replaced(MODEL, "<thruster.*?</thruster>", ""), MODEL, "has no <thruster>"),
    "short row": Hostile(
        replaced(PROPELLER, "0.500 0.073257", "0.500"), PROPELLER, "has 1 numbers in row 11, expected as many"
    ),
    "unit of a propeller": Hostile(
        replaced(PROPELLER, 'diameter unit="M"', 'diameter unit=".."'),
        PROPELLER,
        "expected one of FT, IN, M, CM",
    ),
    "no thrust table": Hostile(
        replaced(PROPELLER, 'name="C_THRUST"', 'name="C_THRUSTS"'), PROPELLER, "has 0 tables C_THRUST"
    ),
    "no volts": Hostile(replaced(MOTOR, "<maxvolts.*?</maxvolts>", ""), MOTOR, "has no <maxvolts>"),
    "unknown component": Hostile(
        channel("<integrator name='x'><input>fcs/y</input></integrator>"),
        MODEL,
        "JSBSim says",
    ),
    # Numbers
    "nan in a propeller table": Hostile(
        replaced(PROPELLER, r"<tableData>\s*\S+\s+\S+", "<tableData> 0 nan"), PROPELLER, "'nan'.*finite"
    ),
    "word in a propeller table": Hostile(
        replaced(PROPELLER, r"<tableData>\s*\S+\s+\S+", "<tableData> 0 x"), PROPELLER, "'x'.*finite"
    ),
    "falling table": Hostile(
        replaced(PROPELLER, r"<tableData>\s*\S+", "<tableData> 99"),
        PROPELLER,
        "ascending keys",
    ),
    "empty table": Hostile(
        replaced(PROPELLER, r"<tableData>.*?</tableData>", "<tableData></tableData>"),
        PROPELLER + "|" + MODEL,
        "table|JSBSim says",
    ),
    "infinite wing": Hostile(
        replaced(MODEL, r'<wingarea unit="M2">0.55', '<wingarea unit="M2">inf'), MODEL, "finite"
    ),
    "text for a number": Hostile(
        replaced(MODEL, '<emptywt unit="KG">4.95', '<emptywt unit="KG">heavy'), MODEL, "finite"
    ),
    "unknown unit": Hostile(
        replaced(MODEL, '<emptywt unit="KG">', '<emptywt unit="STONE">'), MODEL, "JSBSim says"
    ),
    "no mass of its own": Hostile(
        replaced(MODEL, '<emptywt unit="KG">4.95', '<emptywt unit="KG">0'), MODEL, "more than 0"
    ),
    "negative mass": Hostile(
        replaced(MODEL, '<emptywt unit="KG">4.95', '<emptywt unit="KG">-5'), MODEL, "more than 0"
    ),
    "no inertia": Hostile(
        replaced(MODEL, '<ixx unit="KG\\*M2">[^<]*', '<ixx unit="KG*M2">0'), MODEL, "more than 0"
    ),
    "inertia of no body": Hostile(
        replaced(MODEL, '<izz unit="KG\\*M2">[^<]*', '<izz unit="KG*M2">5'), MODEL, "sum of the other two"
    ),
    "product of inertia": Hostile(
        replaced(MODEL, '<ixz unit="KG\\*M2">[^<]*', '<ixz unit="KG*M2">5'), MODEL, "products of inertia"
    ),
    # Names
    "missing property in aerodynamics": Hostile(
        inserted(
            "aerodynamics",
            "<axis name='LIFT'><function name='aero/extra'><property>aero/alhpa-rad</property></function></axis>",
        ),
        MODEL,
        "aero/alhpa-rad.*did you mean aero/alpha-rad",
    ),
    "missing property in control": Hostile(
        channel(
            "<fcs_function name='fcs/x'><function><property>fcs/no-such</property></function></fcs_function>"
        ),
        MODEL,
        "fcs/no-such",
    ),
    "wrong prefix": Hostile(
        replaced(YAML, f"prefix: {TAIL}", "prefix: fcs/left-rudervator"),
        YAML,
        "did you mean fcs/left-ruddervator",
    ),
    "no effectiveness": Hostile(
        replaced(MODEL, f"{TAIL}/effectiveness", f"{TAIL}/effect", 0),
        YAML,
        "no property fcs/left-ruddervator/effectiveness",
    ),
    "wrong engine": Hostile(
        replaced(YAML, "engine: 1", "engine: 7"), YAML, "7 is not the number of an engine"
    ),
    "wrong point mass": Hostile(
        replaced(YAML, "pointmass: 1", "pointmass: 9"), YAML, "9 is not the number of a point mass"
    ),
    # The YAML says otherwise
    "another limit": Hostile(
        replaced(YAML, r"limits: \[-25.8, 25.8\]", "limits: [-30, 25.8]"),
        YAML,
        r"servo-min-rad in vtail.xml:\d+ is -0.450295",
    ),
    "another rate": Hostile(
        replaced(YAML, "rate_limit: 401.07", "rate_limit: 300"),
        YAML,
        r"servo-rate-rad_sec in vtail.xml:\d+ is 7",
    ),
    "another lag": Hostile(
        replaced(YAML, "lag_rad_s: 30", "lag_rad_s: 20"), YAML, r"servo-lag-rad_sec in vtail.xml:\d+ is 30"
    ),
    "another motor": Hostile(
        replaced(YAML, "resistance_ohm: 0.2", "resistance_ohm: 0.3"), YAML, "coilresistance"
    ),
    "unknown key of control": Hostile(
        replaced(YAML, "  priorities:", "  priorites: [p_dot]\n  priorities:"),
        YAML,
        "did you mean priorities",
    ),
    "unknown actuator to release": Hostile(
        replaced(YAML, "    left_ruddervator: ", "    left_rudervator: "),
        YAML,
        "did you mean left_ruddervator",
    ),
    "NaN in the design model": Hostile(
        replaced("design_model.json", r'"alpha_rad": [^,]*', '"alpha_rad": NaN'),
        "design_model.json",
        "finite",
    ),
    "overflow in the design model": Hostile(
        replaced("design_model.json", r'"alpha_rad": [^,]*', '"alpha_rad": 1e999'),
        "design_model.json",
        "finite",
    ),
    "short design model": Hostile(
        replaced("design_model.json", r'"bias": \[[^,]*,', '"bias": ['), "design_model.json", "bias"
    ),
}


_NUMBERS = (
    "nan",
    "inf",
    "-inf",
    "0",
    "-1",
    "1e308",
    "1e-308",
    "99999999999999999999",
    "",
    "x",
    "1,5",
    "0x10",
    "1_0",
)
_WORDS = ("..", "/", "simulation/reset", "fcs/none", "#", "%s%n", "\x1b[31m", "a" * 5000, "&amp;", "<!--")


def mutants(seed: int, count: int) -> Iterator[tuple[str, Spoil]]:
    """Random changes of the v-tail's XML, each with a description: a number, a name or a whole line spoiled, or bytes lost."""
    for i in range(count):
        draw = random.Random(f"{seed}/{i}")
        file = draw.choice((MODEL, MODEL, MODEL, MOTOR, PROPELLER))
        kind = draw.choice((_number, _word, _line, _bytes, _element))
        yield f"{seed}/{i} {kind.__name__[1:]} of {file}", _mutation(kind, file, draw)


def _mutation(kind: Callable[[str, random.Random], str], file: str, draw: random.Random) -> Spoil:
    def spoil(folder: Path) -> None:
        (folder / file).write_text(kind((folder / file).read_text(), draw))

    return spoil


def _somewhere(pattern: str, text: str, draw: random.Random) -> re.Match[str]:
    return draw.choice(list(re.finditer(pattern, text)))


def _swapped(text: str, found: re.Match[str], new: str) -> str:
    return text[: found.start()] + new + text[found.end() :]


def _number(text: str, draw: random.Random) -> str:
    return _swapped(
        text, _somewhere(r"(?<=[\s>])-?\d+\.?\d*(?:e-?\d+)?(?=[\s<])", text, draw), draw.choice(_NUMBERS)
    )


def _word(text: str, draw: random.Random) -> str:
    return _swapped(text, _somewhere(r'(?<=[>"])[a-zA-Z][\w/ *-]*(?=[<"])', text, draw), draw.choice(_WORDS))


def _line(text: str, draw: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    i, j = draw.randrange(len(lines)), draw.randrange(len(lines))
    lines[i : i + 1] = draw.choice(([], [lines[i], lines[j]], [lines[j]]))
    return "".join(lines)


def _bytes(text: str, draw: random.Random) -> str:
    begin = draw.randrange(len(text))
    return text[:begin] + text[begin + draw.choice((1, 10, 1000)) :]


def _element(text: str, draw: random.Random) -> str:
    """Rename an element, both of its tags."""
    found = _somewhere(r"<(\w+)\b([^<>]*)>([^<>]*)</\1>", text, draw)
    new = draw.choice(("x", "output", "input", "property", "table", "value"))
    return _swapped(text, found, f"<{new}{found[2]}>{found[3]}</{new}>")
