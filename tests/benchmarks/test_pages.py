"""Pages of results: each says with what it was flown, and is known to be old when the program has changed."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import benchmark_page
import digests
import pages
import pytest
import stamps
from blocks import block, with_block
from command_line import ROOT
from digests import CODE, digest, proven, syntax
from result_pages import DOCS, PAGES

STAMP = stamps.Stamp("abc1234", "2026-11-23", "1 to 5", "python x.py", "Python 3", {"law": digest("law")})


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_page_carries_a_stamp_and_can_be_flown_again(page) -> None:  # type: ignore[no-untyped-def]
    for command in page.commands:
        assert (ROOT / command.split()[0]).is_file()
    assert all(digest(part) for part in page.on)
    for file in page.files if page.stamped else ():
        stamp = stamps.read(file.read_text(encoding="utf-8"))
        assert stamp is not None, f"{file}: python benchmarks/pages.py {page.name}"
        assert all((stamp.commit, stamp.date, stamp.seeds, stamp.environment, stamp.digests))
        assert stamp.command == page.command and stamp.digests.keys() <= set(page.on)


def test_every_page_of_results_is_listed() -> None:
    listed = {file.resolve() for page in PAGES for file in page.files}
    assert set((DOCS / "results").glob("*.md")) <= listed


def test_a_stamp_is_read_as_it_was_written_and_replaced() -> None:
    page = stamps.stamped("# Title\n\ntext\n", STAMP)
    assert stamps.read(page) == STAMP
    other = replace(STAMP, commit="def5678")
    assert stamps.read(stamps.stamped(page, other)) == other
    assert stamps.stamped(page, other).count("<!-- stamp") == 1
    assert stamps.read("# Title\n") is None


def test_the_site_says_that_a_page_is_older_than_the_law() -> None:
    fresh = stamps.shown(stamps.stamped("# Title\n\ntext\n", STAMP))
    assert fresh.startswith("# Title\n\n!!! info") and "nothing that it depends on has changed" in fresh
    old = stamps.shown(
        stamps.stamped("# Title\n\ntext\n", replace(STAMP, digests={"law": "0", "plant": digest("plant")}))
    )
    assert '!!! warning "Older than the program: flown on 2026-11-23"' in old
    assert "Changed since abc1234: law." in old
    assert stamps.shown("# Title\n\ntext\n") == "# Title\n\ntext\n"


@pytest.mark.parametrize(
    "other",
    [
        '"""Says it."""\nfrom testbed.b import f\n\n\ndef g(x):  # why\n    """Says it."""\n    return f(x,\n        1)\n',
        "from testbed.a.b import f\ndef g(x): return f(x, 1)\n",
    ],
)
def test_comments_docstrings_formatting_and_moves_do_not_count(other: str) -> None:
    assert syntax(other) == syntax("from testbed.a import f\n\n\ndef g(x):\n    return f(x, 1)\n")


@pytest.mark.parametrize(
    "other", ["return f(x, 2)", "return f(x, 1.0)", "return h(x, 1)", "return f(x, 1, '')"]
)
def test_what_changes_a_result_counts(other: str) -> None:
    """Negative control of the last."""
    assert syntax(f"def g(x):\n    {other}\n") != syntax("def g(x):\n    return f(x, 1)\n")


def test_a_renamed_file_is_the_same_and_a_changed_number_is_not(tmp_path: Path) -> None:
    law = tmp_path / "src" / "testbed" / "controllers"
    law.mkdir(parents=True)
    (law / "a.py").write_text("GAIN = 1.0\n")
    before = digest("law", tmp_path)
    (law / "a.py").rename(law / "b.py")
    assert digest("law", tmp_path) == before
    (law / "b.py").write_text("GAIN = 1.5\n")
    assert digest("law", tmp_path) != before
    assert digest("plant", tmp_path) == ""


def test_a_chain_of_proofs_counts_for_the_part_that_it_is_about(tmp_path: Path) -> None:
    file = tmp_path / "proven.json"
    entry = [{"before": {"law": a}, "after": {"law": b}} for a, b in (("2", "3"), ("1", "2"))]
    file.write_text(json.dumps(entry))
    assert proven("law", "1", "3", file) and proven("law", "7", "7", file)
    assert not proven("law", "1", "4", file) and not proven("plant", "1", "3", file)


def test_the_committed_proofs_are_of_parts_that_flights_show() -> None:
    for proof in digests.proofs():
        assert proof["files"] > 20
        assert proof["before"].keys() <= set(digests.PROVABLE) <= set(CODE)


def test_flights_of_another_program_are_not_gone_on_with(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(pages, "ROOT", tmp_path)
    command = "benchmarks/gallery.py --results runs/gallery runs/adopted/* docs/runs/x"
    one, again, two = (pages.kept_apart(command, {"law": law}) for law in "112")
    assert one == again != two
    folder = one.split()[2].removesuffix("/gallery")
    assert one == f"benchmarks/gallery.py --results {folder}/gallery {folder}/adopted/* docs/runs/x"
    assert (tmp_path / folder).is_dir() and folder != "runs"


def test_a_block_is_replaced_and_nothing_else() -> None:
    page = "before\n<!-- x -->\nold\n<!-- end of x -->\nafter\n"
    assert block(with_block(page, "x", "new\nlines"), "x") == "new\nlines"
    assert with_block(page, "x", "old") == page
    with pytest.raises(KeyError, match="y"):
        block(page, "y")


def test_what_parts_bring_is_kept_with_the_law_that_flew_them() -> None:
    table = "## What the parts of `default` bring\n\n| a | b |\n\nOf the first 400 draws"
    page = f"seed 7, 400 draws. The seed is made from the controllers' digest `0abc` and a word.\n\n{table}.\n\n## More\n"
    assert benchmark_page.kept(page, "0abcdef") == ["", f"{table}."]
    old = f"{table}, seed 7, flown with another law, `0abc`."
    assert benchmark_page.kept(page, "1abcdef") == ["", old]
    assert benchmark_page.kept(page.replace(f"{table}.", old), "2abcdef") == ["", old]
    assert benchmark_page.kept("# Benchmark\n", "0abc") == []
