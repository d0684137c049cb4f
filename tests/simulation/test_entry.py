"""What is done for speed changes nothing: compiled against uncompiled, cached against computed; and the guard on it."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import caches
import pytest
from command_line import ROOT

from testbed.flight.flight import Flight
from testbed.scenario.load import load_scenario
from testbed.simulation import fly

TAIL = str(ROOT / "scenarios" / "left_tail_fail.yaml")
SHORT = [
    "duration_s=3",
    "requirements=[]",
    "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 0.3, value: 0}]",
    "commands=[{at_s: 0, heading_deg: 100, altitude_m: 305, airspeed_m_s: 19}]",
]
"""A failure, a detection, a mode switch, and references that move, in 3 s."""
CASES = {
    "ideal": [],
    "mems": ["sensors=mems", "controller.filter_rad_s=20"],
    "weighted": ["sensors=mems", "controller.estimation=weighted"],
    "fixed": ["controller.type=fixed_inversion"],
    "dryden": ["atmosphere={model: dryden_8785c, turbulence: light, noise: {w: [1, -2]}}"],
}
_SAVE = """
import json, sys
from testbed.scenario.load import load_scenario
from testbed.simulation import fly
file, cases, folder = json.loads(sys.argv[1])
for name, settings in cases.items():
    with open(f"{folder}/{name}", "wb") as stream:
        stream.write(fly(load_scenario(file, settings)).data.tobytes())
"""


def short(case: str) -> Flight:
    return fly(load_scenario(TAIL, [*SHORT, *CASES[case]]))


def uncompiled(folder: Path) -> Path:
    """Logs of the short flights, flown by the pages as plain Python."""
    cases = {name: [*SHORT, *settings] for name, settings in CASES.items()}
    command = [sys.executable, "-c", _SAVE, json.dumps([TAIL, cases, str(folder)])]
    subprocess.run(command, env={**os.environ, "NUMBA_DISABLE_JIT": "1"}, check=True)
    return folder


@pytest.mark.nightly
def test_compiled_flies_as_the_page_reads(tmp_path: Path) -> None:
    """To the last bit, through a failure, its detection and a mode switch. Powers were what differed (numba makes
    products of x**4, Python asks the C library), so the pages write them as products.

    One test for all cases: as a fixture of several, each of pytest's workers would fly the plain Python anew."""
    pages = uncompiled(tmp_path)
    for case in CASES:
        assert short(case).data.tobytes() == (pages / case).read_bytes(), case
    flight = short(
        "ideal"
    )  # the negative control: the modes are switched, and another flight has other bytes
    assert {"injection", "detection", "release"} <= {event["kind"] for event in flight.events}
    assert flight.data.tobytes() != (pages / "fixed").read_bytes()


@pytest.mark.parametrize("case", ["ideal", "mems"])
def test_a_cached_result_changes_nothing(case: str) -> None:
    """The first flight, the second, and one after another aircraft state has been flown, to the same bytes."""
    caches.forget()
    cold = short(case)
    warm = short(case)
    fly(load_scenario(TAIL, [*SHORT, "controller.model_error={Cm_alpha: 1.3}", "initial.airspeed_m_s=20"]))
    later = short(case)
    assert cold.data.tobytes() == warm.data.tobytes() == later.data.tobytes()
    assert cold.summary == warm.summary == later.summary


def edited(file: Path, pattern: str, replacement: str) -> None:
    text, count = re.subn(pattern, replacement, file.read_text(), count=1)
    assert count == 1, f"{pattern} is in {file.name}"
    file.write_text(text)


def heavier(folder: Path) -> None:
    """The empty weight raised by 30 %, as text of the same length."""
    weight = re.search(r"<emptywt unit=\"KG\">([0-9.]+)<", (folder / "vtail.xml").read_text())
    assert weight is not None
    more = f"{1.3 * float(weight[1]):.9f}"[: len(weight[1])]
    edited(folder / "vtail.xml", re.escape(weight[0]), f'<emptywt unit="KG">{more}<')


def other_design(folder: Path) -> None:
    """A coefficient of the stored design model."""
    edited(folder / "design_model.json", r'"bias": \[\s+[-0-9.]+', '"bias": [-3.0')


def other_servo(folder: Path) -> None:
    """The lag of a servo, in the model and in what the controller is told; they have to agree."""
    edited(folder / "vtail.yaml", r"lag_rad_s: [0-9.]+", "lag_rad_s: 10")
    edited(
        folder / "vtail.xml",
        r'value="30">fcs/left-ruddervator/servo-lag',
        'value="10">fcs/left-ruddervator/servo-lag',
    )


@pytest.mark.nightly
@pytest.mark.parametrize("edit", [heavier, other_design, other_servo])
def test_an_edited_aircraft_flies_as_in_a_new_process(
    vtail_copy: Path, tmp_path: Path, edit: Callable[[Path], None]
) -> None:
    """Flown, edited, and flown again in this process: trim, design model and aircraft are those of the edited files."""
    settings = [*SHORT, f"aircraft={vtail_copy}"]
    before = fly(load_scenario(TAIL, settings)).data.tobytes()
    edit(vtail_copy)
    here = fly(load_scenario(TAIL, settings)).data.tobytes()
    command = [sys.executable, "-c", _SAVE, json.dumps([TAIL, {"elsewhere": settings}, str(tmp_path)])]
    subprocess.run(command, check=True)
    assert here == (tmp_path / "elsewhere").read_bytes()
    assert here != before, "the edit makes a difference"


def test_a_loss_is_the_worse_the_earlier_it_is() -> None:
    """Both ruddervators at their stops: robustness is below 0 by what was not flown, though no requirement was missed before."""

    def flown(at_s: float) -> Flight:
        gone = [
            f"{{type: hardover, actuator: {side}_ruddervator, at_s: {at_s}}}" for side in ("left", "right")
        ]
        settings = [
            f"failures=[{', '.join(gone)}]",
            "requirements=[{signal: airspeed_m_s, at_least: 0}]",
            "duration_s=30",
        ]
        return fly(load_scenario(TAIL, [*settings, "commands=[]", "controller={type: adaptive_inversion}"]))

    early, late = flown(1.0), flown(6.0)
    assert not (early.passed or late.passed) and late.requirements[0]["passed"]
    assert early.robustness < late.robustness < 0.0
    assert late.robustness == pytest.approx(late.end_time_s / 30.0 - 1.0, abs=1e-3)
    assert late.summary["robustness"] == late.robustness
