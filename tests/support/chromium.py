"""Debian's chromium, driven by Playwright: pages are looked at as a reader sees them.

With BROWSER_REQUIRED set, as `.ci/run` does, what is not there is a failure and not a reason to skip.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

REQUIRED = bool(os.environ.get("BROWSER_REQUIRED"))
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def without(what: str) -> None:
    """Skip the test for lack of something; fail where it is required."""
    if REQUIRED:
        pytest.fail(f"there is no {what}")
    pytest.skip(f"there is no {what}")


@contextmanager
def drawn(
    browser: Any, report: Path, width: int = 1400, scheme: str = "light", query: str = ""
) -> Iterator[Window]:
    """A report once its script has drawn it; nothing may have gone wrong by the end."""
    window = Window(browser, width, scheme)
    window.open(report, query)
    window.page.wait_for_selector("body[data-drawn=yes]", timeout=30_000)
    yield window
    window.context.close()
    assert not window.wrong


@contextmanager
def chromium() -> Iterator[Any]:
    """A running browser."""
    if CHROMIUM is None:
        without("chromium: apt-get install chromium")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        without("playwright: pip install '.[browser]'")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield browser
        browser.close()


class Window:
    """A page in a window of some width that remembers what went wrong in it."""

    def __init__(self, browser: Any, width: int, scheme: str) -> None:
        self.context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
        self.page, self.wrong = self.context.new_page(), []
        self.page.on("console", self._said)
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("request", self._asked)

    def _said(self, message: Any) -> None:
        software_drawing = (
            "GL Driver Message" in message.text
        )  # how fast this machine draws is not the page's fault
        if message.type in ("error", "warning") and not software_drawing:
            self.wrong.append(message.text)

    def _asked(self, request: Any) -> None:
        if not request.url.startswith(("file:", "data:", "blob:", "about:")):
            self.wrong.append(f"asked for {request.url}")

    def open(self, file: Path, query: str = "") -> None:
        self.page.goto(file.as_uri() + query)
        self.page.wait_for_load_state("networkidle")
        wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        if self.page.evaluate(wide) > 0:
            self.wrong.append("wider than the window")
