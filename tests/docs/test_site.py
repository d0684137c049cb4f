"""The built site, in a browser: nothing comes from a network, nothing complains, nothing is wider than the window."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import chromium
import pytest
from chromium import Window, opened, without
from command_line import ROOT

pytestmark = pytest.mark.nightly

WIDTHS = (1280, 390)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built as .ci/run builds it: a warning is an error. SITE names a folder in which it has been built."""
    if "SITE" in os.environ:
        return Path(os.environ["SITE"])
    try:
        import material  # noqa: F401
        import mkdocstrings  # noqa: F401
    except ImportError:
        without("mkdocs-material or mkdocstrings: pip install '.[docs]'")
    out = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(out)]
    built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr
    return out


@pytest.mark.parametrize("part", range(3))
def test_every_page_opens_from_disk(site: Path, browser: Any, part: int) -> None:
    """Wide in light and narrow in dark, or the other way round: a window's next page begins as the one before ended. A third of the
    pages each, so that no worker waits for one test at the end."""
    # the links of 404.html begin at a server's root
    pages = [file for file in sorted(site.rglob("*.html")) if file.name != "404.html"]
    found = {}
    for file, window in opened(browser, pages[part::3], WIDTHS[0], "light"):
        name = file.relative_to(site).with_suffix("").as_posix()
        for width in WIDTHS:
            window.resize(width)
            window.look()
            window.picture(f"{name.replace('/', '-')}-{width}-{window.scheme}")
            if width != WIDTHS[-1]:
                window.recolour()
        if window.wrong:
            found[name] = list(window.wrong)
    assert len(pages) > 30 and not found


def test_search_works_from_disk(site: Path, browser: Any) -> None:
    window = Window(browser, 1280, "light")
    window.open(site / "index.html")
    field = window.page.locator("input.md-search__input")
    field.click()
    field.press_sequentially("hardover")
    window.page.locator(".md-search-result__item").first.wait_for(timeout=20_000)
    assert not window.wrong
    window.context.close()


def test_the_check_can_fail(browser: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Negative control: a page that is too wide, asks a server and raises."""
    monkeypatch.setattr(chromium, "MOST_LOOKS", 3)
    file = tmp_path / "bad.html"
    file.write_text(
        '<meta name="viewport" content="width=device-width"><div style="width: 5000px">wide</div>'
        '<img src="http://127.0.0.1:9/x.png"><script>throw new Error("raised")</script>'
    )
    window = Window(browser, 390, "light")
    window.open(file)
    window.context.close()
    for part in ("wider than the window", "asked for http://127.0.0.1:9/x.png", "raised"):
        assert any(part in wrong for wrong in window.wrong)
