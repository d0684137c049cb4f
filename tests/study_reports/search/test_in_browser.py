"""The report of a search in a real browser: quiet, no wider than the window, and complete, whatever the search found."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from chromium import Window
from search_files import REAL, SEARCH, searched, written

pytestmark = pytest.mark.nightly
SHOWN = {
    "found": ("What it takes", "Both flights side by side", "Distance of the nearest failure found"),
    "not_found": ("not found in 60 flights", "independent draws", "The searches"),
    "probability": ("How likely a requirement is broken", "plain sampling needs", "by level"),
}


@pytest.fixture(scope="module")
def reports(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Reports of a failure found in the simulator and, of made-up flights, of none found and of a probability."""
    folder = tmp_path_factory.mktemp("searches")
    real, made_up = (
        written(folder, REAL.replace("at_most: 1", "at_most: 0.38"), "real.yaml"),
        written(folder, SEARCH),
    )
    compared = "compare={controller.type: [adaptive_inversion, pid]}"
    asked: dict[str, tuple[Path, list[str], str]] = {
        "found": (real, [], "simulated"),
        "not_found": (made_up, ["budget=60", compared], "unbreakable"),
        "probability": (made_up, ["goal=probability", "budget=1000", "cov=0.6", compared], "gusty"),
    }
    for name, (file, settings, fly) in asked.items():
        searched(file, folder / name, *settings, fly=fly, figures=True)
    return {name: folder / name / "report.html" for name in asked}


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
@pytest.mark.parametrize("what", list(SHOWN))
def test_quiet_and_no_wider_than_the_window(
    browser: Any, reports: dict[str, Path], tmp_path: Path, what: str, width: int, scheme: str
) -> None:
    window = Window(browser, width, scheme)
    window.open(reports[what])
    window.page.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)")
    pictures = Path(os.environ.get("SITE_PICTURES", tmp_path))
    window.page.screenshot(path=pictures / f"search-{what}-{width}-{scheme}.png", full_page=True)
    wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    assert window.page.evaluate(wide) == 0 and window.wrong == []
    text = window.page.inner_text("body")
    assert all(words in text for words in SHOWN[what])
    broken = "[...document.images].filter(image => !image.naturalWidth).length"
    assert window.page.evaluate(broken) == 0
    window.context.close()


def test_the_flight_found_and_the_comparison_open(browser: Any, reports: dict[str, Path]) -> None:
    for link in ("Both flights side by side", "the flight found"):
        window = Window(browser, 1400, "light")
        window.open(reports["found"])
        window.page.get_by_text(link, exact=True).click()
        window.page.wait_for_selector("body[data-drawn=yes]", timeout=30_000)
        assert window.wrong == []
        window.context.close()
