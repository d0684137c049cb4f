"""A log that a sweep kept is read back as the flight; what was not kept is said, with the command that flies it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from figure_flights import broken
from sweep_files import fly_here, written

import testbed
from testbed.api.load import load_flight
from testbed.cli.commands import main
from testbed.flight.flight import Flight
from testbed.inputs.problems import BadInput
from testbed.studies.folder import logs
from testbed.studies.load import load_sweep


@pytest.fixture
def sweep(tmp_path: Path) -> Path:
    """A sweep folder with three kept logs: two of run 17, and an odd one of run 18."""
    folder = fly_here(load_sweep(written(tmp_path)), tmp_path / "out")
    (folder / "logs").mkdir()
    for name in ("run-000017-adaptive_inversion", "run-000017-pid", "run-000018-pid"):
        (folder / "logs" / f"{name}.parquet").write_bytes(logs.encode(broken()))
    return folder


def test_a_kept_log_is_the_flight(sweep: Path) -> None:
    flight, original = testbed.load(sweep / "logs/run-000017-pid.parquet"), broken()
    assert isinstance(flight, Flight)
    assert flight.summary == original.summary and flight.columns == original.columns
    assert flight.scenario == original.scenario
    assert flight.log["time_s"].to_numpy() == pytest.approx(original.log["time_s"], abs=0.0)
    assert flight.data == pytest.approx(original.data, rel=1e-6, abs=1e-6, nan_ok=True)
    assert np.array_equal(logs.encode(flight), logs.encode(flight))


@pytest.mark.parametrize("name", ["18", "run-000018-pid", "run-000018", "logs/run-000018-pid.parquet"])
def test_a_run_is_named_shortly(sweep: Path, name: str) -> None:
    assert load_flight(sweep / name).end_time_s == 10.0


def test_several_or_none_are_refused_in_words(sweep: Path) -> None:
    with pytest.raises(
        BadInput, match="several flights, expected one of run-000017-adaptive_inversion, run-000017-pid"
    ):
        testbed.load(sweep / "17")
    with pytest.raises(BadInput, match=r"no log of this run was kept.*--only 5"):
        testbed.load(sweep / "5")
    with pytest.raises(BadInput, match="there is no run 12, expected 0 to 11"):
        testbed.load(sweep / "12")
    with pytest.raises(BadInput, match="is a sweep folder, expected a run folder, or a flight of the sweep"):
        load_flight(sweep)


def test_a_damaged_log_and_one_without_its_flight_are_refused(sweep: Path) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    file = sweep / "logs/run-000018-pid.parquet"
    file.write_bytes(file.read_bytes()[:1000])
    with pytest.raises(BadInput, match="cannot be read"):
        testbed.load(file)
    pq.write_table(pa.table({"time_s": [0.0]}), file)
    with pytest.raises(BadInput, match="does not say of which flight it is"):
        testbed.load(file)


def test_report_makes_its_page_and_links_to_it(sweep: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["report", str(sweep)]) == 1
    assert main(["report", str(sweep / "17")]) == 0
    assert capsys.readouterr().out.count("wrote ") == 2
    pages = sorted(file.name for file in (sweep / "flights").iterdir())
    assert pages == ["run-000017-adaptive_inversion.html", "run-000017-pid.html"]
    page = (sweep / "flights" / pages[0]).read_text(encoding="utf-8")
    assert "--only 17 --variant adaptive_inversion" in page and '<a href="../report.html">' in page
    assert main(["report", str(sweep / "3")]) == 2
    assert "--only 3" in capsys.readouterr().err


def test_flights_of_one_name_are_exported_into_files_of_their_own(sweep: Path) -> None:
    for run in ("run-000017-pid", "18"):
        assert main(["export", str(sweep / run), "--to", "mat"]) == 0
    slug = broken().scenario.slug
    ends = ("run-000017-pid", "run-000018-pid")
    assert sorted(file.name for file in sweep.glob("*.mat")) == [f"{slug}-{end}.mat" for end in ends]
