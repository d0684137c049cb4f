"""One page, one table, one figure, for every report."""

from __future__ import annotations

import ast
import base64
import hashlib
import io
import json
import math
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from html_page import Page
from PIL import Image

from testbed.reporting import html
from testbed.reporting.html import Html


def test_a_page_is_whole_and_fits_a_phone(tmp_path: Path) -> None:
    file = html.write_page(
        tmp_path / "report.html", "tail & <fan>", [Html("<p>one</p>"), "", Html("<p>two</p>")]
    )
    text = file.read_text(encoding="utf-8")
    page = Page(text)
    assert text.startswith("<!DOCTYPE html>") and "<p>one</p>\n<p>two</p>" in text
    assert "<title>tail &amp; &lt;fan&gt;</title>" in text
    viewport = [a["content"] for a in page.attributes if a.get("name") == "viewport"]
    assert viewport == ["width=device-width, initial-scale=1"]
    assert page.fetches_and_runs_nothing()
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


def test_a_page_that_cannot_be_finished_leaves_the_old_one(tmp_path: Path) -> None:
    file = html.write_page(tmp_path / "report.html", "first", [Html("<p>first</p>")])
    before = file.read_bytes()

    def parts() -> Iterator[str]:
        yield "second"
        raise MemoryError

    with pytest.raises(MemoryError):
        html.write_page(file, "second", parts())
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


def test_data_cannot_end_its_script(tmp_path: Path) -> None:
    told = {"name": "</SCRIPT><img src=x onerror=alert(1)><!--<script>\u2028\u2029", "nan": math.nan}
    text = html.write_page(tmp_path / "a.html", "a", [], data={"flight": told}).read_text(encoding="utf-8")
    inside = text.partition('id="flight">')[2].partition("</script>")[0]
    assert not set(inside) & set("<\u2028\u2029")
    assert json.loads(inside) == {"name": told["name"], "nan": None}
    assert "img" not in Page(text).tags


def test_a_page_runs_its_own_script_and_no_other(tmp_path: Path) -> None:
    """The digest is that of the text between the tags, as a browser computes it (CSP level 3, 6.7.2.2)."""
    text = html.write_page(tmp_path / "a.html", "a", [], "sweep.js").read_text(encoding="utf-8")
    code = text.rpartition("<script>")[2].partition("</script>")[0]
    digest = base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()
    (policy,) = [a["content"] for a in Page(text).attributes if a.get("http-equiv")]
    assert f"script-src 'sha256-{digest}'" in policy and policy.count("unsafe") == 1
    assert "default-src 'none'" in policy and "base-uri 'none'; form-action 'none'" in policy
    still = html.write_page(tmp_path / "b.html", "b", []).read_text(encoding="utf-8")
    assert '<body data-drawn="yes">' in still and "data-drawn" not in text.split("<script>")[0]
    assert any("script-src 'none'" in (a.get("content") or "") for a in Page(still).attributes)


@pytest.mark.parametrize("name", ["libraries.js", "flight.js", "live.js", "sweep.js", "compare.js"])
def test_no_script_of_ours_ends_early(name: str) -> None:
    assert not re.search("</script|<!--", html.asset(name), re.IGNORECASE)


def test_pages_find_in_their_libraries_all_that_they_use() -> None:
    """What a script imports of other people's code is looked up while the page runs: nothing else says that it is missing."""
    files = (Path(__file__).parents[2] / "web" / "src").glob("*.js")
    sources = {file.name: file.read_text(encoding="utf-8") for file in files}
    exported = re.findall(r"export \{(.*?)\}", sources.pop("libraries.js"), re.DOTALL)
    used = re.findall(r'import \{([^}]*)\} from "(?:three|uplot|fflate)"', "".join(sources.values()))
    names = {name.split()[0] for each in used for name in each.split(",") if name.strip()}
    assert len(names) > 20 and names <= set(re.findall(r"[\w$]+", " ".join(exported)))


def test_text_is_text_wherever_it_stands() -> None:
    hostile = '"><script>\x1b]0;x\x07\u202e'
    made = html.tag("p", hostile, [hostile, Html("<b>b</b>")], title=hostile)
    page = Page(made)
    assert page.tags == ["p", "b"] and page.attributes[0]["title"] == '"><script>\\x1b]0;x\\x07\\u202e'
    assert html.link("x", "javascript:alert(1)").startswith('<a href="javascript%3Aalert')


def test_only_the_source_says_what_is_html() -> None:
    """Outside of `html.py`, `Html` is made of what stands in the source: never of a name or a formatted text."""
    source = Path(html.__file__).parents[1]
    allowed = {"_repr_html_"}  # of pandas, which escapes
    for file in {*source.glob("reporting/**/*.py"), *source.glob("study_reports/**/*.py")} - {
        Path(html.__file__)
    }:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if (
                isinstance(node, ast.Call)
                and getattr(node.func, "id", getattr(node.func, "attr", "")) == "Html"
            ):
                literal = all(isinstance(part, ast.Constant) for part in node.args)
                assert literal or any(name in ast.unparse(node) for name in allowed), (
                    f"{file}: {ast.unparse(node)}"
                )
