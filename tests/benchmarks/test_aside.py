"""Long tables beside their page."""

from __future__ import annotations

from pathlib import Path

from aside import aside_in

PAGE = "# A\n\n## B\n\nwords\n\n| a | b, c |\n| --- | --- |\n| 1 | x, y |\n| 2 |  |\n\nafter\n\n## C\n\n| d |\n| --- |\n"


def test_a_table_of_one_section_is_moved(tmp_path: Path) -> None:
    text = aside_in(PAGE, "## B", tmp_path / "long.csv")
    table = PAGE[PAGE.index("| a") : PAGE.index("\n\nafter")]
    assert text == PAGE.replace(table, "[The table](long.csv) has 2 rows: a; b, c.")
    assert (tmp_path / "long.csv").read_text() == 'a,"b, c"\n1,"x, y"\n2,\n'
