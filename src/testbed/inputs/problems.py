"""Problems with the user's input: where each is, what is wrong, what was expected, and what was probably meant."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

Result = TypeVar("Result")
TreePath = tuple[str | int, ...]
"""The keys and list indices that lead to a value in a tree read from YAML."""


OWN_PART = "one of your own needs --with FILE.py"
"""Said of an unknown name in a place where a part of the user's own can be named."""


_BEGUN = 4  # letters from which on a word is taken for the beginning of a longer one


@dataclass(frozen=True)
class Problem:
    """One thing wrong with the input; prints `file:line: path: what, expected ..., did you mean ...?`."""

    what: str
    file: str = ""
    line: int | None = None
    path: str = ""
    expected: str = ""
    suggestion: str = ""

    def __str__(self) -> str:
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        text = ": ".join(part for part in (place, self.path, self.what) if part)
        if self.expected:
            text += f", expected {self.expected}"
        if self.suggestion:
            text += f", did you mean {self.suggestion}?"
        return " ".join(text.split())  # one problem is one line


class Issue(NamedTuple):
    """A problem with the value at a path of a tree; `yaml_source.Source.problem` adds its file and line."""

    path: TreePath
    what: str
    expected: str = ""
    suggestion: str = ""


class BadInput(Exception):
    """The input cannot be used. `problems` lists all problems found, not only the first."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self) -> tuple[type[BadInput], tuple[tuple[Problem, ...]]]:
        """Pickle by the problems, because in a sweep the exception is sent between processes."""
        return type(self), (self.problems,)


def collect(problems: list[Problem], function: Callable[[], Result]) -> Result | None:
    """Result of a function. If it raises BadInput, its problems are added to `problems`, and the result is None."""
    try:
        return function()
    except BadInput as error:
        problems += error.problems
        return None


def did_you_mean(word: object, candidates: Iterable[str]) -> str:
    """The candidate closest to a mistyped word, of those that begin with it if any do, or "" when none is close."""
    by_fold, typed = {candidate.casefold(): candidate for candidate in candidates}, str(word).casefold()
    begun = [fold for fold in by_fold if len(typed) >= _BEGUN and fold.startswith(typed)]
    close = difflib.get_close_matches(typed, begun or by_fold, n=1, cutoff=0.0 if begun else 0.6)
    return by_fold[close[0]] if close else ""


def one_of(candidates: Iterable[str]) -> str:
    """'one of a, b, c'; "" when there are none or more than 25."""
    names = list(candidates)
    return "one of " + ", ".join(names) if 0 < len(names) <= 25 else ""


def guess(word: object, known: Iterable[str]) -> tuple[str, str]:
    """(expected, suggestion) for an unknown word: the most similar known word, or a list of all when none is similar."""
    names = list(known)
    close = did_you_mean(word, names)
    return "" if close else one_of(names), close


def unknown(path: TreePath, what: str, word: object, known: Iterable[str], own: bool = False) -> Issue:
    """The issue of an unknown word at `path`, with the known word that was probably meant.

    With `own` it may be the name of a part of the user's own, of which the file was not given.
    """
    return Issue(path, f"{what} ({OWN_PART})" if own else what, *guess(word, known))
