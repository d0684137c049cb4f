"""Text that other programs would obey rather than show: control characters in a terminal, formulas in a spreadsheet.

Names come from files of others. An escape sequence in one could recolour the screen, retitle the window, or write over
what was printed before; characters that reverse the direction of text could hide a part of a line. A spreadsheet takes a
cell that begins with `=` for a formula, which may send the table's contents to somebody.
"""

from __future__ import annotations

_CONTROL = [*range(0x20), *range(0x7F, 0xA0)]
_DIRECTION = [0x061C, 0x200E, 0x200F, *range(0x202A, 0x202F), *range(0x2066, 0x206A)]
_SHOWN = {code: ascii(chr(code))[1:-1] for code in [*_CONTROL, *_DIRECTION] if chr(code) not in "\n\t"}
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")  # noqa: RUF001  (spreadsheets take wide ones too)
_QUOTE = "'"


def printable(text: str) -> str:
    r"""The text with control characters as escapes, such as `\x1b`; ends of lines and tabs stay."""
    return text.translate(_SHOWN)


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
