"""Text that other programs would obey rather than show: control characters in a terminal, formulas in a spreadsheet.

Names come from files of others. An escape sequence in one could recolour the screen, retitle the window, or write over
what was printed before; characters that reverse the direction of text could hide a part of a line. A spreadsheet takes a
cell that begins with `=` for a formula, which may send the table's contents to somebody.
"""

from __future__ import annotations

import re

_CONTROL, _DIRECTION = r"\x00-\x08\x0b-\x1f\x7f-\x9f", r"\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069"
_NO_TEXT = r"\ud800-\udfff\ufffe\uffff"  # neither UTF-8 nor XML has these
_HIDDEN = re.compile(f"[{_CONTROL}{_DIRECTION}{_NO_TEXT}]")
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")  # noqa: RUF001  (spreadsheets take wide ones too)
_QUOTE = "'"


def printable(text: str) -> str:
    r"""The text with control characters as escapes, such as `\x1b`; ends of lines and tabs stay."""
    return _HIDDEN.sub(lambda found: ascii(found[0])[1:-1], text)


def with_article(word: str) -> str:
    """A word with its indefinite article: `a servo`, `an engine`."""
    return f"{'an' if word[0] in 'aeiou' else 'a'} {word}"


def cell(text: str) -> str:
    """A text as a cell of a CSV file: with a quote `'` before it if a spreadsheet could take it for a formula.

    This is how OWASP recommends it ("CSV injection"), and how spreadsheets mark text themselves. A text that begins with a
    quote gets one more, so that `text_of` can tell them apart. Numbers are not texts: -1.5 stays as it is.
    """
    return _QUOTE + text if text.startswith((*_FORMULA, _QUOTE)) else text


def text_of(cell: str) -> str:
    """The text of a cell that `cell` made."""
    return cell.removeprefix(_QUOTE)
