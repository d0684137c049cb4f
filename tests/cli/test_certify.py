"""`testbed certify`: its tables, its files, and bad input before anything flies."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from command_line import Called
from short_flights import scenario

from testbed.margins import certificate


@pytest.fixture
def file(here: Path) -> str:
    """A flight of two seconds with the default law."""
    scenario(here, "adaptive_inversion", 2)
    return "healthy.yaml"


def test_certify_prints_tables_and_writes_all_numbers(here: Path, called: Called, file: str) -> None:
    """The CSV and the JSON hold what the tables show: the uniform limit, and the limit of each entry."""
    for name in ("all.json", "all.csv"):
        status, out, err = called("certify", file, "--out", name)
        assert (status, err) == (0, "")
        assert out.endswith(f"\nwrote {name}\n")
        assert "certified at any airspeed up to an error of  estimates  inversion" in out
        assert "The scenario's estimation is not (13)." in out
        for actuator in ("left_ruddervator", "right_propeller"):
            assert out.count(actuator) >= 3
    numbers = json.loads((here / "all.json").read_text())
    with (here / "all.csv").open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    limit = numbers["modes"][0]["estimates"]
    assert f"{100 * limit:.3g} %" in out
    first = next(row for row in rows if row["quantity"] == "certified_error_of_estimates")
    assert float(first["value"]) == limit
    entries = [float(row["value"]) for row in rows if row["quantity"] == "certified_error_of_entry"]
    assert entries == [x for row in numbers["entries"] for x in row]
    assert {row["of"] for row in rows if row["quantity"] == "trim_beta"} == set(numbers["actuators"])


def test_without_cvxpy_all_but_the_margin_is_said(
    here: Path, called: Called, file: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As on a machine without the extra `certify`: the table says what is missing, and the file leaves it out."""
    monkeypatch.setattr(certificate, "find_spec", lambda name: None)
    status, out, err = called("certify", file, "--out", "all.csv")
    assert (status, err) == (0, "")
    assert "needs cvxpy" in out and "H+ radius at most" in out
    quantities = {row[2] for row in csv.reader((here / "all.csv").read_text().splitlines())}
    assert "radius" in quantities and "margin" not in quantities


def test_certify_refuses_bad_input_all_at_once(here: Path, called: Called, file: str) -> None:
    text = Path(file).read_text().replace("vtail", "vtial")
    (here / "bad.yaml").write_text(text)
    status, out, err = called("certify", "bad.yaml", "--error", "1.5", "--out", "numbers.txt")
    assert (status, out) == (2, "")
    assert err.splitlines()[0] == "--error: is 1.5, expected a fraction between 0 and 1, such as 0.1"
    assert err.splitlines()[1] == "numbers.txt: has no known ending, expected .csv or .json"
    assert "did you mean vtail?" in err.splitlines()[2]
    assert sorted(p.name for p in here.iterdir()) == ["bad.yaml", "healthy.yaml"]
    (here / "mine.csv").write_text("mine")
    status, _, err = called("certify", file, "--out", "mine.csv")
    assert status == 2 and err.startswith("mine.csv: exists already, expected a file that does not exist yet")
    assert (here / "mine.csv").read_text() == "mine"
