"""The built site, in a browser: nothing comes from a network, nothing complains, nothing is wider than the window."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command_line import ROOT

pytestmark = pytest.mark.slow

REQUIRED = bool(os.environ.get("SITE_CHECK_REQUIRED"))
"""Set by .ci/run: what is not there is a failure then, not a reason to skip."""
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
WIDTHS = (1280, 390)


def _without(what: str) -> None:
    if REQUIRED:
        pytest.fail(f"there is no {what}")
    pytest.skip(f"there is no {what}")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built as .ci/run builds it: a warning is an error."""
    try:
        import material  # noqa: F401
        import mkdocstrings  # noqa: F401
    except ImportError:
        _without("mkdocs-material or mkdocstrings: pip install '.[docs]'")
    out = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(out)]
    built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr
    return out


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    if CHROMIUM is None:
        _without("chromium: apt-get install chromium")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _without("playwright: pip install '.[browser]'")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield chromium
        chromium.close()


@pytest.fixture
def pictures(tmp_path: Path) -> Path:
    """Folder for screenshots: SITE_PICTURES, to be looked at, or one that pytest removes."""
    folder = Path(os.environ.get("SITE_PICTURES", tmp_path / "pictures"))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


class Page:
    """A page in a window of some width that remembers what went wrong in it."""

    def __init__(self, browser: Any, width: int, scheme: str) -> None:
        self.context = browser.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme)
        self.page, self.wrong = self.context.new_page(), []
        self.page.on("console", self._said)
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("request", self._asked)

    def _said(self, message: Any) -> None:
        if message.type in ("error", "warning"):
            self.wrong.append(message.text)

    def _asked(self, request: Any) -> None:
        if not request.url.startswith(("file:", "data:", "blob:", "about:")):
            self.wrong.append(f"asked for {request.url}")

    def open(self, file: Path) -> None:
        self.page.goto(file.as_uri())
        self.page.wait_for_load_state("networkidle")
        wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        if self.page.evaluate(wide) > 0:
            self.wrong.append("wider than the window")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", WIDTHS)
def test_every_page_opens_from_disk(
    site: Path, browser: Any, pictures: Path, width: int, scheme: str
) -> None:
    window = Page(browser, width, scheme)
    found = {}
    for file in sorted(site.rglob("*.html")):
        if file.name == "404.html":  # made for a server: its links begin at the root
            continue
        window.wrong.clear()
        window.open(file)
        name = file.relative_to(site).with_suffix("").as_posix()
        if window.wrong:
            found[name] = list(window.wrong)
        window.page.screenshot(path=pictures / f"{name.replace('/', '-')}-{width}-{scheme}.png")
    window.context.close()
    assert not found


def test_search_works_from_disk(site: Path, browser: Any) -> None:
    window = Page(browser, 1280, "light")
    window.open(site / "index.html")
    field = window.page.locator("input.md-search__input")
    field.click()
    field.press_sequentially("hardover")
    window.page.locator(".md-search-result__item").first.wait_for(timeout=20_000)
    assert not window.wrong
    window.context.close()


def test_the_check_can_fail(browser: Any, tmp_path: Path) -> None:
    """Negative control: a page that is too wide, asks a server and raises."""
    file = tmp_path / "bad.html"
    file.write_text(
        '<meta name="viewport" content="width=device-width"><div style="width: 5000px">wide</div>'
        '<img src="http://127.0.0.1:9/x.png"><script>throw new Error("raised")</script>'
    )
    window = Page(browser, 390, "light")
    window.open(file)
    window.context.close()
    for part in ("wider than the window", "asked for http://127.0.0.1:9/x.png", "raised"):
        assert any(part in wrong for wrong in window.wrong)
