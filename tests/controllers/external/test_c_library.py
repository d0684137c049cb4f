"""Controllers in C libraries, compiled here: the shipped example, and libraries that do what no controller should."""

import os
import shutil
import subprocess
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

import testbed
from testbed.controllers.user.loader import load_controller
from testbed.inputs.problems import BadInput

EXAMPLES = Path(__file__).parents[3] / "examples"
SHORT = {"duration_s": 1.0, "failures": [], "requirements": []}
HEAD = '#include "testbed_controller.h"\n'
BIND = "void *testbed_bind(const testbed_setup *s) { return (void *)s; }\n"
STEP = """int testbed_step(void *self, const testbed_sensed *y, const testbed_reference *r, double *c) {
    const testbed_setup *s = self;
    for (int i = 0; i < s->actuators; i++) c[i] = s->trim[i];
    %s
}
"""
CLOSE = "void testbed_close(void *self) { (void)self; }\n"
pytestmark = pytest.mark.skipif(not shutil.which("cc"), reason="there is no C compiler")


def compiled(folder: Path, source: str) -> str:
    file = folder / "pilot.c"
    file.write_text(source)
    return built(file, folder)


def built(source: Path, folder: Path) -> str:
    library = folder / "pilot.so"
    warn = ["-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter"]
    command = [
        "cc",
        "-O2",
        *warn,
        "-shared",
        "-fPIC",
        f"-I{EXAMPLES}",
        "-o",
        str(library),
        str(source),
        "-lm",
    ]
    subprocess.run(command, check=True)
    return str(library)


def refused(library: str) -> str:
    with pytest.raises(BadInput) as caught:
        testbed.fly("left_tail_fail.yaml", load_controller(library), set=SHORT)
    return str(caught.value)


def test_the_example_flies_as_its_python_twin(tmp_path: Path) -> None:
    library = built(EXAMPLES / "pilot.c", tmp_path)
    weather = {**SHORT, "sensors": "mems", "duration_s": 3.0}
    by_library = testbed.fly("left_tail_fail.yaml", load_controller(library), set=weather)
    twin = testbed.fly(
        "left_tail_fail.yaml", load_controller(f"{EXAMPLES}/my_controller.py:MyController"), set=weather
    )
    np.testing.assert_allclose(by_library.data, twin.data, rtol=1e-6, atol=1e-9)


def test_nothing_is_kept_in_a_step(tmp_path: Path) -> None:
    library = built(EXAMPLES / "pilot.c", tmp_path)
    with testbed.Session("left_tail_fail.yaml", load_controller(library), set={"failures": []}) as session:
        session.step(100)
        tracemalloc.start()
        session.step(100)
        before = tracemalloc.get_traced_memory()[0]
        session.step(2000)
        grown = tracemalloc.get_traced_memory()[0] - before
        tracemalloc.stop()
    assert grown < 2000 * 16  # bytes: the smallest object that a step could keep has 16


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (BIND + STEP % "return 7;" + CLOSE, "at 0.000 s testbed_step returned 7"),
        (BIND + STEP % "c[1] = 0.0 / (y->time - y->time); return 0;" + CLOSE, "testbed_step commanded ["),
        (BIND + CLOSE, "expected testbed_bind, testbed_step and testbed_close"),
        (
            "void *testbed_bind(const testbed_setup *s) { return 0; }\n" + STEP % "return 0;" + CLOSE,
            "returned NULL",
        ),
    ],
)
def test_what_goes_wrong_is_said(tmp_path: Path, source: str, said: str) -> None:
    assert said in refused(compiled(tmp_path, HEAD + source))


def test_what_is_no_library_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "pilot.so"
    file.write_bytes(os.urandom(1000))
    assert "cannot be loaded" in refused(str(file))


def test_a_library_is_flown_in_a_sweep(tmp_path: Path) -> None:
    library = built(EXAMPLES / "pilot.c", tmp_path)
    sweep = tmp_path / "sweep.yaml"
    sweep.write_text(
        "scenario: left_tail_fail.yaml\nruns: 2\nseed: 1\nset: {duration_s: 1.0, failures: [], requirements: []}\n"
        "vary: {initial.airspeed_m_s: {uniform: [17.5, 18.5]}}\n"
    )
    found = testbed.sweep(sweep, controllers=[f"mine={library}"], out=tmp_path / "out", jobs=1, figures=False)
    assert set(found["controller.type"]) >= {"mine"}
