"""One page, one table, one figure, for every report."""

from __future__ import annotations

import base64
import io
import math
from pathlib import Path

import pytest
from html_page import Page
from PIL import Image

from testbed.reporting import html
from testbed.reporting.html import Html


def test_a_page_is_whole_and_fits_a_phone(tmp_path: Path) -> None:
    file = html.write_page(tmp_path / "report.html", "tail & <fan>", ["<p>one</p>", "", "<p>two</p>"])
    text = file.read_text(encoding="utf-8")
    page = Page(text)
    assert text.startswith("<!DOCTYPE html>") and "<p>one</p>\n<p>two</p>" in text
    assert "<title>tail &amp; &lt;fan&gt;</title>" in text
    viewport = [a["content"] for a in page.attributes if a.get("name") == "viewport"]
    assert viewport == ["width=device-width, initial-scale=1"]
    assert page.fetches_and_runs_nothing()
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


def test_a_page_that_cannot_be_finished_leaves_the_old_one(tmp_path: Path) -> None:
    file = html.write_page(tmp_path / "report.html", "first", ["<p>first</p>"])
    before = file.read_bytes()
    with pytest.raises(UnicodeEncodeError):
        html.write_page(file, "second", ["\ud800"])
    assert file.read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


def test_cells_are_escaped_unless_they_are_html_and_numbers_are_aligned() -> None:
    made = html.row(["a < b", Html("<b>c</b>"), 0.25, None, math.nan], "met")
    assert made == (
        '<tr class="met"><td>a &lt; b</td><td><b>c</b></td><td class="number">0.25</td>'
        '<td class="number">-</td><td class="number">-</td></tr>'
    )


def test_a_table_has_its_head_rows_and_caption() -> None:
    page = Page(html.table(["x [m]", "<y>"], [html.row(["1", "2"]), html.row(["3", "4"])], "worst & best"))
    assert [page.tags.count(tag) for tag in ("table", "th", "tr", "td", "caption")] == [1, 2, 3, 4, 1]
    assert "x [m]<y>" in page.text and "worst & best" in page.text


def test_only_figures_that_are_there_are_shown(tmp_path: Path) -> None:
    Image.new("RGB", (300, 200), "red").save(tmp_path / "one.png")
    (shown,) = html.figures(tmp_path, {"one": "a <caption>", "two": "missing"})
    assert "a &lt;caption&gt;" in shown
    page = Page(shown)
    assert page.fetches_and_runs_nothing()
    data = base64.b64decode(page.references[0].partition(",")[2])
    with Image.open(io.BytesIO(data)) as picture:
        assert picture.size == (300, 200) and picture.convert("RGB").getpixel((75, 50))[0] > 240


def test_data_cannot_end_its_script() -> None:
    page = html.data({"name": "</SCRIPT><img src=x onerror=alert(1)>"}, "flight")
    assert page.count("<") == 2 and "img" not in Page(page).tags
