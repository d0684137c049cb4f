"""The first load of a model is made elsewhere, recorded, and survived."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import caches
import pytest
from hostile_models import MODEL, channel, inserted, replaced

from testbed.aircraft.description import load_aircraft
from testbed.common import child
from testbed.inputs.problems import BadInput
from testbed.plant import first_load
from testbed.plant.first_load import assure, property_catalog
from testbed.plant.jsbsim import Plant


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache folder, and a process that has seen no aircraft."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    caches.forget()
    return tmp_path / "cache" / "testbed" / "models"


@pytest.fixture
def elsewhere(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """The first loads that are begun in other processes."""
    begun: list[object] = []
    real = first_load._answer
    monkeypatch.setattr(first_load, "_answer", lambda aircraft: begun.append(aircraft) or real(aircraft))
    return begun


def test_a_known_aircraft_is_not_loaded_elsewhere_again(
    vtail_copy: Path, cache: Path, elsewhere: list[object]
) -> None:
    aircraft = load_aircraft(str(vtail_copy))
    for _ in range(2):
        assure(aircraft)
    assert (len(elsewhere), len(list(cache.iterdir()))) == (1, 1)
    caches.forget()  # as a new process
    assert property_catalog(aircraft) == Plant(aircraft, 200).catalog()
    assert len(elsewhere) == 1
    replaced(MODEL, "4.95", "4.96")(vtail_copy)
    assure(load_aircraft(str(vtail_copy)))
    assert len(elsewhere) == 2


def test_a_record_that_is_not_whole_is_made_again(
    vtail_copy: Path, cache: Path, elsewhere: list[object]
) -> None:
    aircraft = load_aircraft(str(vtail_copy))
    known = property_catalog(aircraft)
    (file,) = cache.iterdir()
    for contents in (b"", file.read_bytes()[:100], b"[]", b"\xff"):
        file.write_bytes(contents)
        caches.forget()
        assert property_catalog(aircraft) == known
    assert len(elsewhere) == 5


@pytest.mark.skipif(os.name != "posix", reason="/dev/null as a folder")
def test_without_a_cache_folder_each_process_loads_anew(
    vtail_copy: Path, cache: Path, elsewhere: list[object], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", "/dev/null/none")
    aircraft = load_aircraft(str(vtail_copy))
    assure(aircraft)
    assure(aircraft)
    caches.forget()
    assure(aircraft)
    assert len(elsewhere) == 2
    assert not cache.exists()


def test_jsbsims_own_words_are_repeated(vtail_copy: Path, cache: Path) -> None:
    channel("<integrator name='x'><input>fcs/y</input></integrator>")(vtail_copy)
    with pytest.raises(BadInput, match=r"vtail\.xml: JSBSim says INTEGRATOR component x does not provide"):
        assure(load_aircraft(str(vtail_copy)))
    assert not cache.exists()  # nothing is known of it


def load_by(folder: Path, code: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the process of the first load run this code in place of the probe's."""
    (folder / "other_probe.py").write_text(f"from testbed.common import child\n{code}\n")
    monkeypatch.setenv("PYTHONPATH", str(folder))
    monkeypatch.setattr(first_load, "_PROBE", "other_probe")


def test_a_load_that_computes_for_ever_ends_with_words(
    vtail_copy: Path, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    load_by(tmp_path, "def endless(_):\n    while True: pass\nchild.answer(endless)", monkeypatch)
    monkeypatch.setattr(first_load, "_LIMITS", replace(first_load._LIMITS, processor_s=1))
    monkeypatch.setattr(
        child, "_PATIENCE", 500
    )  # on a busy machine the clock would run out first, and says so
    words = r"vtail\.xml: JSBSim does not finish loading and starting it within 1 s of processor time"
    with pytest.raises(BadInput, match=words):
        assure(load_aircraft(str(vtail_copy)))


def test_the_signal_that_ended_a_process_is_named(
    vtail_copy: Path, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    killed = "import os, sys; print('last words', file=sys.stderr, flush=True); os.kill(os.getpid(), 11)"
    load_by(tmp_path, killed, monkeypatch)
    with pytest.raises(BadInput, match=r"JSBSim says last words; it ended the process \(SIGSEGV\)"):
        assure(load_aircraft(str(vtail_copy)))


def test_the_process_of_a_first_load_writes_no_file(vtail_copy: Path, cache: Path) -> None:
    before = sorted(vtail_copy.parent.rglob("*"))
    assure(load_aircraft(str(vtail_copy)))
    assert sorted(vtail_copy.parent.rglob("*")) == before


def test_the_process_of_a_first_load_is_light() -> None:
    program = (
        "import sys, testbed.plant.probe\n"
        "assert not {'numba', 'matplotlib', 'scipy', 'pandas', 'pyarrow'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def test_a_state_that_is_not_finite_is_refused(vtail_copy: Path, cache: Path) -> None:
    nan = "<function name='aero/nan'><pow><value>-8</value><value>0.5</value></pow></function>"
    inserted("axis", nan)(vtail_copy)
    with pytest.raises(BadInput, match=r"vtail\.xml: its state is not finite after 20 steps"):
        assure(load_aircraft(str(vtail_copy)))
