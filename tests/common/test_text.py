"""Text that a terminal and a spreadsheet show and do not obey."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.common.text import cell, printable, text_of, with_article


def test_control_characters_are_shown() -> None:
    assert printable("\x1b[31mred\x1b[0m\x07 \x9b2J \r é\n\tend") == (
        r"\x1b[31mred\x1b[0m\x07 \x9b2J \r é" + "\n\tend"
    )
    assert printable("abc\u202edef\u2066") == r"abc\u202edef\u2066"


@given(st.text())
def test_nothing_that_a_terminal_obeys_is_left(text: str) -> None:
    assert all(c in "\n\t" or c.isprintable() or ord(c) >= 0xA0 for c in printable(text))


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "＝1+1"])  # noqa: RUF001
def test_what_looks_like_a_formula_is_quoted(text: str) -> None:
    assert cell(text) == "'" + text


@pytest.mark.parametrize("text", ["", "left_tail", "a=b", "1", "Cm_alpha"])
def test_other_text_stays(text: str) -> None:
    assert cell(text) == text


@given(st.text())
def test_the_text_of_a_cell_is_what_was_put_in(text: str) -> None:
    assert text_of(cell(text)) == text


def test_a_word_with_its_article() -> None:
    assert [with_article(word) for word in ("servo", "engine", "motor or engine")] == [
        "a servo", "an engine", "a motor or engine",
    ]  # fmt: skip
