"""`testbed matrix`: flown, resumed, reported, and one flight of it alone."""

from __future__ import annotations

import json
from pathlib import Path

from command_line import Called

import testbed
from testbed.aircraft.shipped import files_in


def test_a_matrix_is_flown_resumed_and_reported(here: Path, called: Called) -> None:
    asked = [
        "vtail",
        "--failures",
        "stuck",
        "--out",
        "m",
        "--at",
        "1",
        "--jobs",
        "1",
        "--set",
        "duration_s=2",  # commands after it are dropped, in the folder's file too
    ]
    status, out, err = called("matrix", *asked, "--set", "requirements=[]")
    assert (status, err) == (0, "") and out.startswith("4 cells: 4 held\n4 flights in "), out
    assert len(list((here / "m/flights").glob("*.html"))) == 4
    status, out, _ = called("matrix", "m/matrix.yaml", "--out", "m", "--resume", "--no-plots")
    assert status == 0 and "no flight was missing" in out
    assert called("report", "m")[0] == 0 and called("validate", "m/matrix.yaml")[0] == 0
    status, out, _ = called("matrix", "m/matrix.yaml", "--only", "2", "--no-plots", "--out", "alone")
    alone = json.loads(next((here / "alone").glob("*/summary.json")).read_text())
    assert status == 0 and alone["end_time_s"] == 2.0
    assert testbed.load("m/2").end_time_s == 2.0  # type: ignore[union-attr]


def test_shipped_matrices_are_valid(called: Called) -> None:
    for file in files_in("scenarios/matrices"):
        assert called("validate", str(file)) == (0, f"{file}: ok\n", "")
