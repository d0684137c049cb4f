"""Flights side by side: what differs is found, to the step; the same flight twice does not differ."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from handmade import at, flight_of, injection, level_log
from html_page import Page

import testbed
from testbed.cli.commands import main
from testbed.flight.flight import Flight
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.metrics import measure, readings
from testbed.reporting.comparison.compare import compare
from testbed.reporting.comparison.differences import common_rows, names_of
from testbed.reporting.comparison.page import columns_of, groups, on_grid
from testbed.reporting.words import setting


def made(name: str, seconds: float = 10.0, off_from_s: float = 99.0, **columns: float) -> Flight:
    """A level flight whose columns are off by so much from some time on."""
    log = level_log(seconds)
    for column, by in columns.items():
        log[column][at(off_from_s) :] += by
    flight = flight_of(log, [injection(3.0)], name=name)
    return flight_of(log, [injection(3.0)], metrics=measure(readings(flight)), name=name)


def test_the_first_step_that_differs_and_what_differs_in_it() -> None:
    other = made("b", off_from_s=4.0, roll_deg=1e-12, altitude_m=1.0)
    other.data[at(2.0) :, other.columns.index("fan_reference")] += 0.5
    (found,) = compare([made("a"), other]).first_differences
    assert (found.time_s, found.columns) == (2.0, ("fan_reference",))
    assert (found.moved_s, found.moved) == (4.0, ("altitude_m", "roll_deg"))


def test_the_same_flight_twice_does_not_differ() -> None:
    comparison = compare([made("a"), made("a")])
    assert comparison.first_differences[0].time_s is None
    assert comparison.settings == [] and comparison.names == ["flight 1", "flight 2"]
    assert "are the same in every step and column" in repr(comparison)


def test_names_and_settings() -> None:
    comparison = compare([made("a"), made("b")])
    assert comparison.names == ["a", "b"]
    assert [(s.path, s.values) for s in comparison.settings] == [("name", ("a", "b"))]
    assert list(comparison.metrics.columns) == ["a", "b"]


def broken(**failure: object) -> Flight:
    settings = {
        "duration_s": 0.5,
        "requirements": [],
        "commands": [],
        "failures": [failure] if failure else [],
    }
    return testbed.fly("left_tail_fail.yaml", set=settings)


def test_names_say_what_broke_else_when_else_the_folder() -> None:
    stuck = {"type": "stuck", "actuator": "left_ruddervator"}
    early, late, whole = broken(**stuck, at_s=0.1), broken(**stuck, at_s=0.3), broken()
    assert names_of([early, whole]) == ["left ruddervator got stuck where it was", "nothing broken"]
    assert names_of([early, late])[1] == "left ruddervator got stuck where it was at 0.3 s"
    assert names_of([early, early], ["runs/a", "runs/b"]) == ["runs/a", "runs/b"]
    assert names_of([early, early]) == ["flight 1", "flight 2"]


def test_a_line_of_a_failure_belongs_to_its_flight() -> None:
    stuck = {"type": "stuck", "actuator": "left_ruddervator"}
    comparison = compare([broken(**stuck, at_s=0.1), broken(**stuck, at_s=0.3)])
    panels = [
        panel for group in groups(comparison, columns_of(comparison.flights)) for panel in group["panels"]
    ]
    own = [{"time_s": 0.1, "style": "v0"}, {"time_s": 0.3, "style": "v1"}]
    assert all(panel["failures"] == own for panel in panels)
    same = compare([broken(**stuck, at_s=0.1)] * 2)
    (panel, *_) = groups(same, columns_of(same.flights))[0]["panels"]
    assert panel["failures"] == [{"time_s": 0.1, "style": "failure"}]


def test_settings_are_said_in_words() -> None:
    assert setting("failures.1.value") == "failure 2: value"
    assert setting("initial.airspeed_m_s") == "initial: airspeed [m/s]"
    assert setting("seed") == "seed"


def test_rows_of_other_rates_meet_at_the_same_times() -> None:
    rows, others = common_rows(np.arange(0.0, 1.0, 0.01), np.arange(0.0, 0.5, 0.05))
    assert list(rows) == list(range(0, 50, 5)) and list(others) == list(range(10))


def test_a_shorter_flight_has_no_values_after_its_end() -> None:
    short = made("b", seconds=6.0)
    values = on_grid(made("a").data[:, 0], short.signals, "altitude_m")
    assert np.isfinite(values[: at(6.0)]).all() and np.isnan(values[at(6.0) :]).all()


def test_headings_differ_the_short_way_and_without_jumps() -> None:
    turning = made("b")
    turning.data[:, turning.columns.index("heading_deg")] = (350.0 + 72.0 * turning.data[:, 0]) % 360.0
    log = columns_of([made("a"), turning])
    assert log["1:heading_error_deg"] == pytest.approx(72.0 * log["time_s"])
    assert log["1:heading_deg-0"] == pytest.approx(72.0 * log["time_s"])


@pytest.mark.parametrize("count", [0, 1, 7])
def test_too_few_and_too_many_are_refused(count: int) -> None:
    with pytest.raises(BadInput, match="expected from 2 to 6"):
        compare([made("a")] * count)


def test_the_page_says_it_and_fetches_nothing(tmp_path: Path) -> None:
    compare([made("a <b>"), made("b", off_from_s=5.0, altitude_m=2.0)], tmp_path / "new/c.html")
    text = (tmp_path / "new/c.html").read_text(encoding="utf-8")
    page = Page(text)
    assert all(reference.startswith("data:image/png;base64,") for reference in page.references)
    assert "a <b>" in page.text and "<b>" not in text.partition("<h1>")[2].partition("</h1>")[0]
    assert "first differ at 5.000 s (altitude_m)" in page.text and "altitude_error_max_m" in page.text


def test_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in "ab":
        write_run_folder(made(name), tmp_path / name)
    assert main(["compare", "a", "b"]) == 0
    assert capsys.readouterr().out.endswith("wrote runs/comparison.html\n")
    for _ in range(2):  # also over its own page
        assert (
            main(["compare", "a", "b", "--out", "here"]) == 0
            and (tmp_path / "here/comparison.html").is_file()
        )
    (tmp_path / "mine.html").write_text("mine")
    assert main(["compare", "a", "b", "--out", "mine.html"]) == 2, "nobody else's"
    assert (tmp_path / "mine.html").read_text() == "mine"
    report = (tmp_path / "here/comparison.html").replace(tmp_path / "a/report.html")
    assert main(["compare", "a", "b", "--out", "a/report.html"]) == 2, "that of a run"
    assert report.is_file()
    assert main(["compare", "a", "none"]) == 2
    assert "none: there is no such folder" in capsys.readouterr().err
    assert main(["compare", "a"]) == 2


def test_it_is_in_the_package() -> None:
    assert testbed.compare is compare


def test_what_is_no_flight_is_refused() -> None:
    with pytest.raises(BadInput, match=r"flights\.1: is 'b', expected a flight"):
        compare([made("a"), "b"])  # type: ignore[list-item]


def test_flights_with_long_names_have_letters_in_heads_and_legends(tmp_path: Path) -> None:
    name = "{} with a name that takes a line by itself"
    flights = [made(name.format(each), roll_deg=i, off_from_s=4.0) for i, each in enumerate("xyz")]
    long = compare(flights, tmp_path / "three.html")
    assert long.keys == ["A", "B", "C"] and long.names[1] == "B: " + name.format("y")
    assert list(long.metrics.columns) == long.keys
    text = Page((tmp_path / "three.html").read_text()).text
    assert "3 flights: A, B and C" in text
    assert "\nA and C first differ at 4.000 s" in repr(long)
    two = compare([made(name.format(each)) for each in "xy"])
    assert two.keys == two.names == [name.format(each) for each in "xy"]
