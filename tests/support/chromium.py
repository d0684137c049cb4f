"""Debian's chromium, driven by Playwright: pages are looked at as a reader sees them.

With BROWSER_REQUIRED set, as `.ci/run` does, what is not there is a failure and not a reason to skip. With SITE_PICTURES set, the
pages that tests look at are left in that folder as pictures.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

REQUIRED = bool(os.environ.get("BROWSER_REQUIRED"))
PICTURES = os.environ.get("SITE_PICTURES")
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
_AXE = Path(__file__).parents[2] / "web/node_modules/axe-core/axe.min.js"
MOST_LOOKS = 100
"""How often, 0.1 s apart, a page is looked at until it fits into its window."""
_AT_ONCE = 6
"""Windows in which pages are loaded at the same time: each is watched for half a second after its last request."""
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
    """A page in a window of some width that remembers what went wrong in it. It asks for no transitions: none is waited for."""

    def __init__(self, browser: Any, width: int, scheme: str) -> None:
        self.context = browser.new_context(
            viewport={"width": width, "height": 900}, color_scheme=scheme, reduced_motion="reduce"
        )
        self.page, self.wrong = self.context.new_page(), []
        self.scheme = scheme
        self.page.on("console", self._said)
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("request", self._asked)

    def _said(self, message: Any) -> None:
        # How fast this machine draws is not the page's fault.
        software_drawing = "GL Driver Message" in message.text
        if message.type in ("error", "warning") and not software_drawing:
            self.wrong.append(message.text)

    def _asked(self, request: Any) -> None:
        if not request.url.startswith(("file:", "data:", "blob:", "about:")):
            self.wrong.append(f"asked for {request.url}")

    def open(self, file: Path, query: str = "") -> None:
        """Load a page, and look at it once it has been quiet."""
        self.load(file, query)
        self.look()

    def load(self, file: Path, query: str = "") -> None:
        self.wrong.clear()
        self.page.goto(file.as_uri() + query)

    def look(self) -> None:
        """Wait until the page has asked for nothing for half a second, and see whether it fits into the window.

        Plots follow a change of the window in one of the next frames, which a busy machine draws late.
        """
        self.page.wait_for_load_state("networkidle")
        wide = "document.documentElement.scrollWidth > document.documentElement.clientWidth"
        for _ in range(MOST_LOOKS):
            if not self.page.evaluate(wide):
                return
            self.page.wait_for_timeout(100)
        self.wrong.append(f"wider than the window of {self.page.viewport_size['width']}")

    def resize(self, width: int) -> None:
        """Make the window this wide, and wait until nothing on the page moves any more."""
        self.page.set_viewport_size({"width": width, "height": 900})
        self.page.wait_for_function("document.getAnimations().length === 0")

    def recolour(self) -> None:
        """From light to dark, or back."""
        self.scheme = "dark" if self.scheme == "light" else "light"
        self.page.emulate_media(color_scheme=self.scheme)

    def picture(self, name: str, full_page: bool = False) -> None:
        """Leave a picture, where pictures are asked for."""
        if PICTURES:
            self.page.screenshot(path=Path(PICTURES) / f"{name}.png", full_page=full_page)


def unreadable(browser: Any, address: str, scheme: str) -> list[str]:
    """What axe-core, from web/'s packages, finds in a page that a screen reader or a weak eye cannot use."""
    if not _AXE.is_file():
        without("axe-core: cd web && npm ci")
    context = browser.new_context(color_scheme=scheme, bypass_csp=True)
    page = context.new_page()
    page.goto(address)
    page.wait_for_selector("body[data-drawn=yes]", timeout=30_000)
    page.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)")
    page.add_script_tag(path=_AXE)
    found = page.evaluate("axe.run()")["violations"]
    context.close()
    return [f"{each['id']}: {each['nodes'][0]['html'][:200]}" for each in found]


def opened(browser: Any, files: Sequence[Path], width: int, scheme: str) -> Iterator[tuple[Path, Window]]:
    """Each page in turn, in one of a few windows, while the next ones are loaded in the others."""
    windows = [Window(browser, width, scheme) for _ in files[:_AT_ONCE]]
    for file, window in zip(files, windows, strict=False):
        window.load(file)
    for i, file in enumerate(files):
        window = windows[i % _AT_ONCE]
        window.look()
        yield file, window
        if i + _AT_ONCE < len(files):
            window.resize(width)
            window.load(files[i + _AT_ONCE])
    for window in windows:
        window.context.close()
