"""Only an unchanged sweep is flown on, with the same aircraft, versions and function."""

from __future__ import annotations

from pathlib import Path

import pytest
from sweep_files import fly_here, table, written
from sweep_flights import quick

import testbed
from testbed.api.sweep import prepare, rebuild
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store
from testbed.studies.folder.begin import begun_with, refuse_changed, refuse_other
from testbed.studies.load import load_sweep
from testbed.studies.record import MIXED

CHANGES: list[tuple[list[str], str]] = [
    (["seed=4"], "sweep.yaml: seed: was 3, is now 4, expected an unchanged sweep"),
    (["sampling=halton"], "sweep.yaml: sampling: was 'sobol', is now 'halton', expected an unchanged sweep"),
    (["duration_s=2"], "sweep.yaml: scenario.duration_s: was 1, is now 2, expected an unchanged sweep"),
]


@pytest.mark.parametrize(("change", "words"), CHANGES)
def test_a_changed_sweep_is_not_resumed(tmp_path: Path, change: list[str], words: str) -> None:
    sweep = written(tmp_path)
    fly_here(load_sweep(sweep, ["runs=4"]), tmp_path / "out")
    before = {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}
    with pytest.raises(BadInput) as refused:
        testbed.sweep(sweep, tmp_path / "out", settings=["runs=4", *change], resume=True, fly=quick)
    assert str(refused.value).endswith(words)
    with pytest.raises(BadInput, match=r"sweep\.yaml: runs: has 4 already, expected at least as many"):
        testbed.sweep(sweep, tmp_path / "out", runs=3, resume=True, fly=quick)
    assert before == {f: f.read_bytes() for f in (tmp_path / "out").rglob("*") if f.is_file()}


def test_what_it_was_begun_with_must_be_the_same(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    fly_here(load_sweep(sweep), tmp_path / "out")
    with pytest.raises(BadInput, match="was begun with the function sweep_flights:quick"):
        testbed.sweep(sweep, tmp_path / "out", resume=True)
    with pytest.raises(BadInput, match="exists already, expected a new folder, or --resume"):
        testbed.sweep(sweep, tmp_path / "out", fly=quick)


def test_a_latin_hypercube_cannot_be_made_longer(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    settings = ["sampling=latin_hypercube"]
    fly_here(load_sweep(sweep, [*settings, "runs=6"]), tmp_path / "out")
    values = table(tmp_path / "out")["failures.0.value"].to_numpy()[::2]
    assert sorted((values * 6).astype(int)) == list(range(6))  # one in each stratum
    with pytest.raises(BadInput, match="a latin hypercube of 6 runs cannot be made longer"):
        testbed.sweep(sweep, tmp_path / "out", runs=8, settings=settings, fly=quick, resume=True)


def test_another_version_or_aircraft_is_said(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    begun = begun_with(plan, "f:g")
    refuse_changed(begun, begun_with(plan, "f:g"), tmp_path)
    other = {**begun, "aircraft_sha256": "0", "versions": {**begun["versions"], "numpy": "0.1"}}
    with pytest.raises(BadInput) as refused:
        refuse_changed(other, begun, tmp_path)
    elsewhere = {**begun, "arithmetic": {**begun["arithmetic"], "matrices": "0", "kernel": "Haswell"}}
    with pytest.raises(
        BadInput, match="other last digits of matrices, which depend on the BLAS kernel: Haswell, this"
    ):
        refuse_changed(elsewhere, begun, tmp_path)
    numpy = begun["versions"]["numpy"]
    assert [str(problem).partition(": ")[2] for problem in refused.value.problems] == [
        "was begun with other files of the aircraft, which have changed since",
        f"was begun with numpy 0.1, this is {numpy}, expected {MIXED}",
    ]


def test_a_folder_of_something_else_is_left_alone(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path))
    (tmp_path / "new").mkdir()
    refuse_other(tmp_path / "new", plan, resume=False)  # an empty folder is as good as none
    with pytest.raises(BadInput, match="is not the folder of a sweep"):
        refuse_other(tmp_path, plan, resume=True)


@pytest.mark.parametrize("runs", ["", "runs: many\n", "runs: 0\n"])
def test_a_folder_that_does_not_say_its_runs_is_refused(tmp_path: Path, runs: str) -> None:
    folder = fly_here(load_sweep(written(tmp_path)), tmp_path / "out")
    file = folder / "sweep.yaml"
    file.write_text(file.read_text().replace("runs: 12\n", runs))
    with pytest.raises(
        BadInput, match=r"sweep\.yaml:\d+: runs: is .*, expected the number of runs, at least 1"
    ):
        prepare(tmp_path / "small.yaml", folder, resume=True)


def test_a_folder_of_an_earlier_version_is_not_resumed_and_still_reported(tmp_path: Path) -> None:
    sweep = written(tmp_path)
    folder = fly_here(load_sweep(sweep), tmp_path / "out")
    before = table(folder)
    (folder / store.NAME).rename(folder / "journal.jsonl")  # in place of a journal
    with pytest.raises(BadInput, match="was begun by an earlier version of testbed, and cannot be resumed"):
        testbed.sweep(sweep, folder, resume=True, fly=quick)
    assert rebuild(folder)["runs"] == 12
    assert table(folder).equals(before)
    (folder / "results.parquet").unlink()
    with pytest.raises(BadInput, match="was flown by an earlier version of testbed"):
        rebuild(folder)
