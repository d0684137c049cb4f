"""Shards of a sweep, merged, are the sweep; what does not belong together is refused, and what is missing is said."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
import search_flights
from search_files import REAL, SEARCH
from search_files import written as search_written
from sweep_files import fly_here, here, same_rows, sorted_files, stored, written
from sweep_flights import quick

import testbed
from testbed.api import matrix, search, sweep
from testbed.cli.commands import main
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario
from testbed.studies.load import load_sweep
from testbed.studies.matrix import load_matrix
from testbed.studies.run import Options, fly_sweep

N = 3


def other(scenario: Scenario) -> Flight:
    """As `quick`, of another version of a function of the same name."""
    return replace(quick(scenario), metrics={"altitude_error_max_m": 0.0})


@pytest.fixture(scope="module")
def shards(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folders 1 to 3, each a shard; and `whole`."""
    folder = tmp_path_factory.mktemp("shards")
    plan = load_sweep(written(folder))
    for k in range(1, N + 1):
        fly_sweep(plan, folder / str(k), replace(here(save_logs="all"), shard=f"{k}/{N}"))
    whole = fly_here(plan, folder / "whole", save_logs="all")
    sweep.finish(plan, whole)
    return folder


def folders(shards: Path, *numbers: int) -> list[Path]:
    return [shards / str(k) for k in numbers or range(1, N + 1)]


def test_merged_shards_have_the_bytes_of_the_whole(shards: Path, tmp_path: Path) -> None:
    assert [len(stored(folder)) for folder in folders(shards)] == [8, 8, 8]
    summary, missing = testbed.merge(
        folders(shards, 3, 1, 2, 1), tmp_path / "out"
    )  # in any order, and one twice
    whole = shards / "whole"
    assert missing == [] and summary is not None
    same_rows(whole, tmp_path / "out")
    assert sorted_files(whole) == sorted_files(tmp_path / "out") and len(sorted_files(whole)) == 24
    for name in ("sweep.yaml", "summary.json", *(f"figures/{f.name}" for f in (whole / "figures").iterdir())):
        assert (whole / name).read_bytes() == (tmp_path / "out" / name).read_bytes(), name


def test_what_is_missing_is_said_and_can_be_flown(
    shards: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert main(["merge", str(shards / "1"), str(shards / "3"), "--out", str(out), "--no-plots"]) == 3
    assert (
        f"{out}: 4 runs are missing: 1, 4, 7, 10; `testbed sweep {out}/sweep.yaml" in capsys.readouterr().err
    )
    fly_sweep(load_sweep(out / "sweep.yaml"), out, here(), resume=True)
    same_rows(shards / "whole", out)


def test_a_shard_is_resumed_as_a_shard(shards: Path, tmp_path: Path) -> None:
    shutil.copytree(shards / "1", tmp_path / "one")
    plan = load_sweep(tmp_path / "one/sweep.yaml")
    how = replace(here(), shard=f"1/{N}")
    assert fly_sweep(plan, tmp_path / "one", how, resume=True).count == 0
    assert not (tmp_path / "one/results.csv").exists()


def test_what_does_not_belong_together_is_refused_and_makes_nothing(shards: Path, tmp_path: Path) -> None:
    file = written(tmp_path)
    fly_here(load_sweep(file, ["seed=4"]), tmp_path / "seed")
    fly_here(load_sweep(file), tmp_path / "function", "sweep_flights:slow")
    (tmp_path / "scenario.yaml").touch()
    for strangers, words in (
        (tmp_path / "seed", "seed: was 4, is now 3"),
        (tmp_path / "function", "was begun with the function"),
        (tmp_path, "is the folder of a run"),
    ):
        with pytest.raises(BadInput, match=words):
            testbed.merge([shards / "1", strangers], tmp_path / "out")
        assert not (tmp_path / "out").exists()
    with pytest.raises(BadInput, match="exists already"):
        testbed.merge([shards / "1"], shards / "2")


def test_a_flight_with_two_results_is_refused(
    shards: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sweep_flights.quick", other)  # begun with the same inputs, so its name says
    options = replace(Options(workers=here().workers, save_logs="none"), fly=quick)
    fly_sweep(load_sweep(written(tmp_path)), tmp_path / "out", options)
    with pytest.raises(BadInput, match="has another result of run 0"):
        testbed.merge([shards / "1", tmp_path / "out"], tmp_path / "merged")
    assert not (tmp_path / "merged").exists()


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_a_shard_that_is_none_is_refused(shard: str) -> None:
    with pytest.raises(BadInput, match="expected K/N, K from 1 to N"):
        Options(shard=shard)


def test_a_sweep_that_stops_by_itself_has_no_shards(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path), ["stop_when={half_width: 0.1}"])
    with pytest.raises(BadInput, match="a sweep without stop_when"):
        fly_sweep(plan, tmp_path / "out", replace(here(), shard="1/2"))
    assert not (tmp_path / "out").exists()


def test_a_matrix_is_merged_too(tmp_path: Path) -> None:
    plan = load_matrix("vtail", keys={"failures": [{"type": "effectiveness", "value": 0.2}]})
    for k in (1, 2):
        matrix.fly(plan, tmp_path / str(k), replace(here(), shard=f"{k}/2"))
    summary, missing = testbed.merge([tmp_path / "1", tmp_path / "2"], tmp_path / "out", figures=False)
    assert missing == [] and summary is not None and summary["counts"] == {"held": 4, "survived": 4}


def searched_in_shards(file: Path, folder: Path, n: int, how: Options) -> search.SearchPlan:
    """The folders 1 to n, each a shard of a search; and `whole`."""
    plan, whole = search.prepare(file, folder / "whole")
    for k in range(1, n + 1):
        search.fly(plan, folder / str(k), replace(how, shard=f"{k}/{n}"))
    search.finish(plan, whole, search.fly(plan, whole, how), figures=False)
    return plan


@pytest.mark.nightly
def test_a_search_is_merged_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = REAL.replace("budget: 24", "budget: 20") + "compare: {controller.type: [pid, fixed_inversion]}\n"
    searched_in_shards(
        search_written(tmp_path, text), tmp_path, 2, Options(save_logs="none", workers=here().workers)
    )
    assert not (tmp_path / "1/results.csv").exists()
    assert len(stored(tmp_path / "1")) < len(stored(tmp_path / "whole"))
    assert main(["merge", str(tmp_path / "2"), "--out", str(tmp_path / "half")]) == 3
    said = capsys.readouterr().err
    assert "1 searches are missing: pid; `testbed search " in said and "half/search.yaml --out" in said
    assert main(
        ["merge", *map(str, folders(tmp_path, 1, 2)), "--out", str(tmp_path / "out"), "--no-plots"]
    ) in (0, 1)
    for name in ("results.csv", "summary.json", "search.yaml"):
        assert (tmp_path / "whole" / name).read_bytes() == (tmp_path / "out" / name).read_bytes(), name


@pytest.mark.nightly
def test_a_search_with_code_of_the_users_is_joined_and_not_flown_again(tmp_path: Path) -> None:
    text = SEARCH + "compare: {atmosphere.wind_m_s.2: [0, 1]}\n"
    how = Options(save_logs="none", fly=search_flights.gusty, workers=here().workers)
    plan = searched_in_shards(search_written(tmp_path, text), tmp_path, 2, how)
    assert testbed.merge(folders(tmp_path, 1, 2), tmp_path / "out") == (None, [])
    flights = search.fly(plan, tmp_path / "out", how, resume=True)
    search.finish(plan, tmp_path / "out", flights, figures=False)
    assert flights.count == 0
    same = [(tmp_path / name / "summary.json").read_bytes() for name in ("whole", "out")]
    assert same[0] == same[1]


def test_one_search_is_not_divided(tmp_path: Path) -> None:
    plan, _ = search.prepare(search_written(tmp_path), tmp_path / "out")
    with pytest.raises(BadInput, match="is 1/2, and a search of one variant and option is not divided"):
        search.fly(plan, tmp_path / "out", Options(shard="1/2"))
    assert not (tmp_path / "out").exists()
