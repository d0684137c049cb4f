"""Every format: written whole or not at all, the same bytes twice, refused in words; a new one is tested as it is listed."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from handmade import flight_of, level_log

from testbed.flight import damage
from testbed.flight.flight import Flight, Outcome
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.reporting.export import TABLE, export
from testbed.reporting.export.place import DEFAULT_ORIGIN, Origin, geodetic, parse_origin, poses


@pytest.mark.parametrize("to", TABLE)
def test_the_same_flight_gives_the_same_bytes(to: str, flown: Flight, tmp_path: Path) -> None:
    one, two = (export(flown, to, tmp_path / f"{i}{TABLE[to].ending}") for i in range(2))
    assert one.read_bytes() == two.read_bytes()
    assert sorted(file.name for file in tmp_path.iterdir()) == [one.name, two.name]


@pytest.mark.parametrize("to", TABLE)
def test_a_flight_that_diverged_is_written(to: str, flown: Flight, tmp_path: Path) -> None:
    data = flown.data.copy()
    data[-3:, 1:] = np.nan
    assert (
        export(replace(flown, data=data, outcome=Outcome.diverged), to, tmp_path / "file").stat().st_size
        > 500
    )


@pytest.mark.parametrize("to", [name for name, format in TABLE.items() if len(format.needs) > 1])
def test_a_log_without_a_place_is_refused(to: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="the log has no column north_m"):
        export(flight_of(level_log()), to, tmp_path / "file")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("to", TABLE)
def test_what_a_format_shows_is_asked_for_before_it_is_written(
    to: str, flown: Flight, tmp_path: Path
) -> None:
    """A log of somebody else may lack any column but those without which no flight is loaded."""
    for j, name in enumerate(flown.columns):
        if name in damage._NEEDED or name.endswith(damage._OF_AN_ACTUATOR):
            continue
        rest = [i for i in range(len(flown.columns)) if i != j]
        less = replace(flown, columns=tuple(flown.columns[i] for i in rest), data=flown.data[:, rest])
        try:
            export(less, to, tmp_path / name)
        except BadInput as error:
            assert f"has no column {name}" in str(error)


def test_an_existing_file_is_kept(flown: Flight, tmp_path: Path) -> None:
    (tmp_path / "mine.mat").write_text("mine")
    with pytest.raises(BadInput, match="exists already"):
        export(flown, "mat", tmp_path / "mine.mat")
    assert (tmp_path / "mine.mat").read_text() == "mine"


def test_an_unknown_format_is_refused(flown: Flight, tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="did you mean parquet"):
        export(flown, "parket", tmp_path / "file")


def test_without_its_package_mcap_says_what_to_install(
    flown: Flight, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mcap.writer", None)
    with pytest.raises(BadInput, match=r"pip install 'testbed\[export\]'"):
        export(flown, "mcap", tmp_path / "file")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "origin"),
    [("47.5,8", Origin(47.5, 8.0)), ("-33.9,151.2,20", Origin(-33.9, 151.2, 20.0))],
)
def test_an_origin_is_read(text: str, origin: Origin) -> None:
    assert parse_origin(text) == origin


@pytest.mark.parametrize("text", ["", "47", "a,b", "90,0", "0,181", "nan,0", "1,2,3,4"])
def test_what_is_no_origin_is_refused(text: str) -> None:
    with pytest.raises(BadInput, match="expected LAT,LON"):
        parse_origin(text)


def test_a_minute_of_arc_is_a_nautical_mile() -> None:
    """At 45 deg a minute of latitude is 1852.2 m on WGS 84; one of longitude 1314.2 m (any table of the ellipsoid)."""
    latitude, longitude = geodetic(Origin(45.0, 10.0), np.array([1852.22]), np.array([1314.17]), 0.0)
    assert (latitude[0] - 45.0) * 60.0 == pytest.approx(1.0, abs=2e-4)
    assert (longitude[0] - 10.0) * 60.0 == pytest.approx(1.0, abs=2e-4)


def test_altitude_is_the_logs_or_begins_at_the_origins(flown: Flight) -> None:
    logged = flown.log["altitude_m"].to_numpy()
    np.testing.assert_array_equal(poses(flown, DEFAULT_ORIGIN).altitude_m, logged)
    np.testing.assert_allclose(
        poses(flown, Origin(0.0, 0.0, 50.0)).altitude_m, logged - logged[0] + 50.0, atol=1e-9
    )


def test_it_is_written_from_a_run_folder(
    flown: Flight, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from testbed.cli.commands import main

    folder = write_run_folder(flown, tmp_path / "run")
    assert main(["export", str(folder), "--to", "kml", "--origin", "47,8"]) == 0
    assert (folder / "healthy.kml").is_file() and "wrote" in capsys.readouterr().out
    assert main(["export", str(folder), "--to", "cml"]) == 2
    assert "did you mean kml" in capsys.readouterr().err
