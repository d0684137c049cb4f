"""The report of a sweep and the page of a comparison in a real browser: quiet, and what can be clicked works."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from chromium import Window, drawn, unreadable
from figure_flights import broken
from sweep_files import fly_here, written

from testbed import fly
from testbed.api.sweep import finish
from testbed.cli.commands import main
from testbed.flight.flight import Outcome
from testbed.reporting.comparison.compare import compare
from testbed.scenario.load import load_scenario
from testbed.studies.folder import logs
from testbed.studies.load import load_sweep

pytestmark = pytest.mark.nightly
KEPT = "run-000007-fixed_inversion"


@pytest.fixture(scope="module")
def sweep(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a sweep of made-up flights; the log of one was kept, and its page made."""
    folder = tmp_path_factory.mktemp("browser")
    plan = load_sweep(written(folder), ["runs=60"])
    fly_here(plan, folder / "out")
    (folder / "out/logs").mkdir()
    (folder / f"out/logs/{KEPT}.parquet").write_bytes(logs.encode(broken()))
    finish(plan, folder / "out")
    assert main(["report", str(folder / "out" / KEPT)]) == 0
    return folder / "out/report.html"


@pytest.fixture(scope="module")
def comparison(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("compared") / "comparison.html"
    compare([broken(), broken(6.0, Outcome.envelope_exceeded)], file)
    return file


@pytest.fixture
def window(browser: Any, sweep: Path) -> Iterator[Window]:
    with drawn(browser, sweep) as made:
        yield made


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400, 1600])
@pytest.mark.parametrize("what", ["sweep", "comparison"])
def test_quiet_and_no_wider_than_the_window(
    browser: Any, sweep: Path, comparison: Path, what: str, width: int, scheme: str
) -> None:
    with drawn(browser, {"sweep": sweep, "comparison": comparison}[what], width, scheme) as made:
        made.picture(f"{what}-{width}-{scheme}", full_page=True)
        shown = {"sweep": "#map svg .flight", "comparison": "#panels-errors canvas"}[what]
        assert made.page.locator(shown).count() > 0


def rows(window: Window) -> list[list[str]]:
    """The cells of the table's rows."""
    cells = "[...document.querySelectorAll('#flights tbody tr')].map(r => [...r.cells].map(c => c.innerText.trim()))"
    return list(window.page.evaluate(cells))


def test_the_table_sorts_both_ways(window: Window) -> None:
    head = window.page.locator("#flights th", has_text="failure 1: value")
    column = window.page.evaluate(
        "[...document.querySelectorAll('#flights th')].findIndex(h => h.innerText.includes('value'))"
    )
    for ending, direction in (("ascending", 1), ("descending", -1)):
        head.locator("button").click()
        values = [direction * float(row[column]) for row in rows(window)]
        assert len(values) == 15 and values == sorted(values)
        assert head.get_attribute("aria-sort") == ending


def test_the_table_filters_and_shows_more(window: Window) -> None:
    window.page.locator("[data-filter=state]").select_option("0")
    window.page.locator("[data-filter=variant]").select_option("1")
    assert all(row[1] == "fixed_inversion" and row[2] == "passed" for row in rows(window))
    before = len(rows(window))
    window.page.get_by_role("button", name="More").click()
    assert len(rows(window)) > before
    window.page.locator("#flights input").fill("right_ruddervator")
    assert rows(window) and all("right_ruddervator" in row for row in rows(window))
    window.page.locator("#flights input").fill("no such words")
    assert rows(window) == []


def test_each_row_has_what_it_missed_and_its_command(window: Window) -> None:
    window.page.locator("[data-filter=state]").select_option("1")
    for row in rows(window):
        assert row[4] == "altitude_error_max_m at most 0.02" and math.isfinite(float(row[5]))
        assert "--only" in row[3] or row[3] == "report"


def test_the_command_of_each_row_is_seen_without_scrolling_sideways(browser: Any, sweep: Path) -> None:
    ends = "[...document.querySelectorAll('#flights tr')].map(r => r.cells[3].getBoundingClientRect().right)"
    with drawn(browser, sweep, 1400) as made:
        assert "the command" in made.page.locator("#flights th").nth(3).inner_text()
        assert max(made.page.evaluate(ends)) < made.page.evaluate(
            "document.querySelector('#flights .table').clientWidth"
        )


def test_the_link_opens_the_flight(window: Window) -> None:
    window.page.locator("#flights input").fill("7 fixed_inversion")
    link = window.page.locator("#flights tbody a", has_text="report")
    link.first.click()
    window.page.wait_for_url("**/flights/*")
    assert window.page.url.endswith(f"/flights/{KEPT}.html")
    assert "Worst since" in window.page.inner_text("body")


def test_a_brush_chooses_flights(window: Window) -> None:
    """The left half of the first map: flights with the smaller values across."""
    everything = window.page.locator("#flights output").inner_text()
    plot = window.page.locator("#map svg.plot").first
    plot.scroll_into_view_if_needed()
    box = plot.bounding_box()
    window.page.mouse.move(box["x"] + 52, box["y"] + 12)
    window.page.mouse.down()
    window.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] - 38, steps=5)
    window.page.mouse.up()
    assert "flights chosen; passed:" in window.page.locator("#map .told").inner_text()
    assert window.page.locator("#flights output").inner_text() != everything
    chosen = window.page.evaluate("sweepReport.sweep.flights.map((_, i) => sweepReport.chosen.has(i))")
    values = window.page.evaluate("sweepReport.chosen.brush.x.values")
    inside = [value for value, has in zip(values, chosen, strict=True) if has]
    outside = [value for value, has in zip(values, chosen, strict=True) if not has]
    assert inside and outside and max(inside) < max(outside)
    dim = window.page.locator("#map .flight.dim").count()
    assert dim == chosen.count(False)
    window.page.get_by_role("button", name="Choose all").click()
    assert window.page.locator("#map .flight.dim").count() == 0


def test_a_click_picks_a_flight(window: Window) -> None:
    mark = window.page.locator("#map svg .flight").first
    mark.scroll_into_view_if_needed()
    box = mark.bounding_box()
    window.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    told = window.page.locator("#map .told").inner_text()
    picked = window.page.evaluate("sweepReport.sweep.flights[sweepReport.chosen.picked].run")
    assert told.startswith(f"Run {picked}, ") and ("--only" in told or "Open its report" in told)
    assert rows(window)[0][0] == str(picked)


def test_axes_of_the_map_are_chosen(window: Window) -> None:
    window.page.locator("#map select").first.select_option(label="failure 1: actuator")
    titles = window.page.locator("#map svg text.title").all_text_contents()
    assert "failure 1: actuator" in titles
    assert window.page.locator("#map svg .flight").count() == 120


def test_panels_of_a_comparison_share_cursor_and_range(browser: Any, comparison: Path) -> None:
    with drawn(browser, comparison) as made:
        assert made.page.locator("#timelines .bar").count() == 2
        made.page.locator("#timelines .phase").nth(1).click(position={"x": 2, "y": 5})
        low, high = made.page.evaluate("comparison.clock.range")
        shown = made.page.evaluate(
            "comparison.panels.made.filter(m => m.plot).map(m => [m.plot.scales.x.min, m.plot.scales.x.max])"
        )
        assert shown and all(pair == pytest.approx([low, high]) for pair in shown)


def test_a_flight_without_estimates_leaves_the_panels_of_the_others(browser: Any, tmp_path: Path) -> None:
    """Each panel of effectiveness has a vertical scale, on which the curves of the flight that has estimates are drawn."""
    changes, file = ["duration_s=6", "requirements=[]"], tmp_path / "comparison.html"
    weak = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 3, value: 0.3}]"
    scenario = Path(__file__).parents[3] / "scenarios" / "left_tail_fail.yaml"
    compare(
        [
            fly(load_scenario(scenario, [*changes, weak, f"controller={{type: {name}}}"]))
            for name in ("adaptive_inversion", "fixed_inversion")
        ],
        file,
    )
    with drawn(browser, file) as made:
        made.page.evaluate(
            "comparison.panels.made.filter(m => !m.plot).forEach(m => comparison.panels.draw(m))"
        )
        scales = made.page.evaluate(
            "comparison.panels.made.filter(m => m.panel.title.endsWith('[-]'))"
            ".map(m => m.plot.scales.y).map(({ min, max }) => [min, max])"
        )
        assert len(scales) == 4 and all(low < high for low, high in scales)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(browser: Any, sweep: Path, scheme: str) -> None:
    assert unreadable(browser, sweep.as_uri(), scheme) == []
