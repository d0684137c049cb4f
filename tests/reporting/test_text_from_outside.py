"""Text from other people's files stays text: the markup of every page is the same with hostile names as with harmless ones."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from chromium import drawn
from handmade import flight_of, injection, level_log
from html_page import write_report
from search_files import searched
from search_files import written as search_written
from sweep_files import SWEEP, fly_here, table, written

import testbed
from testbed.api.sweep import finish
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.reporting.comparison.compare import Comparison, compare
from testbed.reporting.export import export
from testbed.studies.load import load_sweep
from testbed.study_reports.search.report import write_search_page
from testbed.study_reports.sweep.report import write_sweep_report

PAYLOADS = (
    "</SCRIPT><img src=x onerror=\"document.title='own'\">", "\"'><svg onload=document.title='own'>", "<!--<script>", "-->",
    "</style><script>document.title='own'</script>", "</title><meta http-equiv=refresh content='0;url=https://example.org'>",
    "<base href=https://example.org><form action=https://example.org>", "javascript:document.title='own'", "{{7*7}}${7*7}",
    "]]><!ENTITY x SYSTEM 'file:///etc/passwd'>&#60;b&#62;", "\x1b]0;own\x07\x1b[31m\x9b2J", "\u202eeman\u2066",
    "\u2028document.title='own'\u2029", "=cmd|'/C calc'!A0", "\\u003cscript>", "../../../etc/passwd",
)  # fmt: skip
HOSTILE, HARMLESS = " ".join(PAYLOADS), "harmless"
NAME = "=</SCRIPT><svg onload=\"document.title='own'\"><!--<script>\x1b]0;own\x07\u202e\u2028 ../../x"
"""What fits where a name may have 120 characters."""
Leaf = tuple[str | int, ...]


class Skeleton(HTMLParser):
    """The elements of a page with the names of their attributes, and what is in its blocks of data."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.elements: list[tuple[str, ...]] = []
        self.links: list[str] = []
        self.data: list[str] = []
        self._kind: str | None = None
        self.feed(file.read_text(encoding="utf-8"))
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, *(name for name, _ in attrs)))
        self.links += [value or "" for name, value in attrs if name == "href"]
        self._kind = dict(attrs).get("type")

    def handle_data(self, data: str) -> None:
        if self._kind == "application/json" and data.strip():
            self.data.append(data)

    def handle_endtag(self, tag: str) -> None:
        self._kind = None


def leaves(tree: Any, path: Leaf = ()) -> Iterator[Leaf]:
    """The place of every text in JSON."""
    if isinstance(tree, str):
        yield path
    for key, value in (
        tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    ):
        yield from leaves(value, (*path, key))


def changed(tree: Any, place: Leaf, text: str) -> Any:
    """JSON with another text at a place."""
    tree = json.loads(json.dumps(tree))
    node = tree
    for key in place[:-1]:
        node = node[key]
    node[place[-1]] = text
    return tree


def safe(made: Path, like: Path) -> None:
    """Assert that a page has the same elements and attributes as another one, and leads to no other place."""
    page, other = Skeleton(made), Skeleton(like)
    assert page.elements == other.elements
    assert not any(re.match(r"[a-z]+:|//", link, re.IGNORECASE) for link in page.links)
    for data in page.data:
        assert "<" not in data and "\u2028" not in data
        json.loads(data)


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    events = [
        injection(3.0),
        {"time_s": 4.0, "kind": "detection", "actuator": "elevon", "delay_s": 1.0},
        {"time_s": 5.0, "kind": "diagnosis", "text": HARMLESS},
        {"time_s": 6.0, "kind": "release", "axis": "p_dot"},
    ]
    verdict = {
        "name": HARMLESS,
        "passed": False,
        "value": 1.0,
        "limit": "",
        "margin": -0.5,
        "reason": HARMLESS,
    }
    log = level_log() | {name: np.zeros(1000) for name in ("north_m", "east_m", "own_column")}
    flight = flight_of(
        log, events, requirements=[verdict], metrics={"altitude_error_max_m": 1.0}, name=HARMLESS
    )
    return write_run_folder(flight, tmp_path_factory.mktemp("outside") / "run")


def received(run: Path, folder: Path, summary: Any, scenario: Callable[[str], str] = str) -> Path:
    """A copy of a run folder with another summary and another scenario."""
    folder.mkdir(parents=True)
    (folder / "log.csv").write_bytes((run / "log.csv").read_bytes())
    (folder / "scenario.yaml").write_text(scenario((run / "scenario.yaml").read_text()))
    (folder / "summary.json").write_text(json.dumps(summary))
    return folder


def test_every_text_of_a_summary(run: Path, tmp_path: Path) -> None:
    summary = json.loads((run / "summary.json").read_text())
    shown = 0
    for i, place in enumerate(leaves(summary)):
        folders = [
            received(run, tmp_path / f"{i}-{j}", changed(summary, place, text))
            for j, text in enumerate((HARMLESS, HOSTILE))
        ]
        try:
            like, made = (write_report(folder) for folder in folders)
        except BadInput:
            continue  # refused in words, as an actuator of this name is
        shown += 1
        safe(made, like)
    assert shown >= 8


def named(text: str) -> Callable[[str], str]:
    return lambda scenario: re.sub(
        "^name: .*$", lambda _: f"name: {json.dumps(text)}", scenario, flags=re.MULTILINE
    )


@pytest.fixture(scope="module")
def renamed(run: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Run folders with a harmless and a hostile name of scenario, column, warning, metric, requirement and reason."""
    folder, made = tmp_path_factory.mktemp("renamed"), []
    summary = json.loads((run / "summary.json").read_text())
    for name, text in (("harmless", HARMLESS), ("hostile", HOSTILE)):
        told = json.loads(json.dumps(summary).replace(json.dumps(HARMLESS), json.dumps(text)))
        told |= {"warnings": [text], "metrics": {**summary["metrics"], text: 1.0}, "flown_by": text}
        made.append(received(run, folder / name, told, named(NAME if text is HOSTILE else text)))
        log = (made[-1] / "log.csv").read_text()
        column = re.sub('[,"]', ";", text)
        (made[-1] / "log.csv").write_text(log.replace("own_column", column, 1))
    return made[0], made[1]


def test_a_report(renamed: tuple[Path, Path]) -> None:
    like, made = map(write_report, renamed)
    safe(made, like)
    text = made.read_text(encoding="utf-8")
    assert (
        "own_column" not in text
        and "\x1b" not in text
        and "\u202e" not in text.partition("application/json")[0]
    )


def test_a_comparison_and_what_notebooks_and_terminals_show(
    renamed: tuple[Path, Path], tmp_path: Path
) -> None:
    (one, other), made = map(testbed.load, renamed), []
    for i, flights in enumerate(([one, one], [other, other])):
        names = [f"{flights[0].scenario.name} {k}" for k in range(2)]
        comparison = Comparison(flights, names)
        made.append((comparison.write(tmp_path / f"{i}.html"), comparison))
    safe(made[1][0], made[0][0])
    for shown in (other._repr_html_(), made[1][1]._repr_html_()):
        (tmp_path / "shown.html").write_text(shown, encoding="utf-8")
        assert not {"script", "img", "svg", "meta", "base", "form"} & {
            tag for tag, *_ in Skeleton(tmp_path / "shown.html").elements
        }
    assert not re.search("[\x00-\x08\x0e-\x1f\x7f-\x9f\u202e]", repr(made[1][1]) + repr(other))


def test_a_track_for_google_earth_and_for_tacview(renamed: tuple[Path, Path], tmp_path: Path) -> None:
    flight = testbed.load(renamed[1])
    tree = ElementTree.parse(export(flight, "kml", tmp_path / "flight.kml"))
    (described,) = tree.findall(".//{http://www.opengis.net/kml/2.2}description")
    assert "<" not in (described.text or "<")  # readers take a description for HTML
    lines = export(flight, "acmi", tmp_path / "flight.acmi").read_text(encoding="utf-8-sig").splitlines()
    assert not any(re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f]", line) for line in lines)


def sweep_of(folder: Path, text: str) -> Path:
    """A sweep whose name, varied names and compared names are a text, reported."""
    names = json.dumps([text, f"{text} 2"])
    lines = SWEEP.replace("name: small", f"name: {json.dumps(text)}").replace(
        "\ncompare:", f"\n  name: {{choice: {names}}}\ncompare:"
    )
    folder.mkdir()
    plan = load_sweep(written(folder, lines), ["runs=30"])
    fly_here(plan, folder / "out")
    finish(plan, folder / "out", figures=False)
    return folder / "out"


@pytest.fixture(scope="module")
def sweeps(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("sweeps")
    return sweep_of(folder / "harmless", HARMLESS), sweep_of(folder / "hostile", NAME)


def test_a_sweep(sweeps: tuple[Path, Path]) -> None:
    like, made = map(write_sweep_report, sweeps)
    safe(made, like)
    frame = table(sweeps[1])
    shown = frame._repr_html_()
    assert shown is not None and "<script" not in shown and "<img" not in shown
    cells = (sweeps[1] / "results.csv").read_text(encoding="utf-8")
    assert not re.search(r'(^|,)"?[=@]', cells, re.MULTILINE)


@pytest.mark.parametrize("kind", ["sweep", pytest.param("search", marks=pytest.mark.nightly)])
def test_every_text_of_the_summary_of_a_study(kind: str, sweeps: tuple[Path, Path], tmp_path: Path) -> None:
    """A summary alone, as somebody sends it: folders and pages that it names lead to no other place."""
    if kind == "sweep":
        summary, write = json.loads((sweeps[0] / "summary.json").read_text()), write_sweep_report
        summary["variants"][0]["worst"][0]["page"] = HARMLESS
    else:
        result = searched(search_written(tmp_path), tmp_path / "found", figures=False)
        summary, write = result.summary, write_search_page
    shown, pages = 0, []
    for place in leaves(summary):
        for j, text in enumerate((HARMLESS, HOSTILE)):
            folder = tmp_path / f"at-{'-'.join(map(str, place))}-{j}"[:80]
            folder.mkdir(exist_ok=True)
            (folder / "summary.json").write_text(json.dumps(changed(summary, place, text)))
            try:
                pages.append(write(folder))
            except (KeyError, ValueError, TypeError, StopIteration):
                break  # a variant that no pair names: `testbed report` says so
        else:
            safe(pages[-1], pages[-2])
            shown += 1
    assert shown >= 8
    assert not (tmp_path / "etc").exists()


@pytest.mark.nightly
def test_a_browser_runs_none_of_it(
    browser: Any, renamed: tuple[Path, Path], sweeps: tuple[Path, Path], tmp_path: Path
) -> None:
    flight = testbed.load(renamed[1])
    files = [write_report(renamed[1]), tmp_path / "comparison.html", write_sweep_report(sweeps[1])]
    compare([flight, flight], files[1])
    for file in files:
        with drawn(browser, file) as window:
            title = window.page.title()
            window.page.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)")
            window.page.wait_for_timeout(200)
            assert window.page.url.startswith("file:") and window.page.title() == title != "own"
            found = "document.querySelectorAll('img[src=x], svg[onload], base, form, meta[http-equiv=refresh]').length"
            assert window.page.evaluate(found) == 0


@pytest.mark.nightly
def test_a_browser_would_not_run_it_even_as_markup(browser: Any, run: Path, tmp_path: Path) -> None:
    """A negative control: with the escaping undone, the policy alone still stops scripts, forms and bases."""
    text = write_report(run).read_text(encoding="utf-8")
    inside = "<img src=data: onerror=\"document.title='own'\"><script>document.title='own'</script><base href='https://example.org'>"
    (tmp_path / "undone.html").write_text(text.replace("<h1>", f"{inside}<h1>", 1), encoding="utf-8")
    page = browser.new_page()
    page.goto((tmp_path / "undone.html").as_uri())
    page.wait_for_selector("body[data-drawn=yes]")
    assert page.title() == HARMLESS and page.evaluate("document.baseURI").startswith("file:")
    (tmp_path / "no_policy.html").write_text(
        re.sub("<meta http-equiv[^>]*>", "", text).replace("<h1>", f"{inside}<h1>", 1)
    )
    page.goto((tmp_path / "no_policy.html").as_uri())
    page.wait_for_timeout(300)
    assert page.title() == "own"
    page.close()
