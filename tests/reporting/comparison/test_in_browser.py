"""The page of a comparison in a real browser: all flights in one picture, on one axis of time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from chromium import Window, drawn, unreadable

import testbed

pytestmark = pytest.mark.nightly
STUCK = {"type": "stuck", "actuator": "left_ruddervator", "at_s": 5.0}
LOST = {"type": "hardover", "actuator": "left_ruddervator", "at_s": 5.0, "to": "max"}


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of two flights of 60 s, the second of which is lost before its end."""
    settings = [{"failures": [STUCK]}, {"failures": [LOST], "controller": {"type": "pid"}}]
    flights = [testbed.fly("left_tail_fail.yaml", set=each) for each in settings]
    assert flights[1].outcome.is_lost
    file = tmp_path_factory.mktemp("compare") / "comparison.html"
    testbed.compare(flights, file)
    return file


@pytest.fixture
def window(browser: Any, page: Path) -> Iterator[Window]:
    with drawn(browser, page) as made:
        yield made


def value(window: Window, expression: str) -> Any:
    return window.page.evaluate(f"(() => {{ const r = window.comparison; return {expression}; }})()")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
def test_quiet_and_no_wider_than_the_window(browser: Any, page: Path, width: int, scheme: str) -> None:
    with drawn(browser, page, width, scheme) as made:
        made.picture(f"compare-{width}-{scheme}", full_page=True)
        assert made.page.locator("#replay canvas").count() == 1


def test_both_are_in_one_picture_each_where_it_is(window: Window) -> None:
    value(window, "r.clock.go(4)")
    places = "r.scene.seen.map(one => one.craft.group.position.toArray())"
    together = value(window, places)
    assert together[0] == pytest.approx(together[1], abs=0.1)
    value(window, "r.clock.go(12)")
    apart = value(window, places)
    assert max(abs(a - b) for a, b in zip(*apart, strict=True)) > 5.0
    names = window.page.locator(".picture .craft").all_inner_texts()
    assert names == value(window, "r.comparison.flights.map(flight => flight.key)")


def test_another_is_followed_and_one_that_is_lost_stays_where_it_ended(window: Window) -> None:
    window.page.locator("[data-do=follow]").select_option("1")
    value(window, "r.clock.go(50)")
    assert value(window, "r.scene.one === r.scene.seen[1]")
    ended = value(window, "r.scene.one.craft.columns.time_s[r.scene.one.last]")
    assert ended < 50.0 and value(window, "r.scene.one.craft.time") == pytest.approx(ended)
    assert "NaN" not in window.page.locator(".picture output").inner_text()


def test_all_bars_have_the_same_axis_of_time(window: Window) -> None:
    ends = window.page.locator("#timelines .times span:last-child").all_inner_texts()
    assert ends == ["60 s", "60 s"]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing(browser: Any, page: Path, scheme: str) -> None:
    assert unreadable(browser, page.as_uri(), scheme) == []
