"""Validate a tree that was read from YAML against a pydantic model, and report all problems at once, each with its line.

Some checks need a valid model of the whole, such as whether the aircraft has an actuator of this name. To make these checks
even if the model refuses parts of the tree, those parts are removed from a copy, and the rest is validated again.
"""

from __future__ import annotations

import copy
import types
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from testbed.inputs.problems import BadInput, Issue, Problem, TreePath
from testbed.inputs.pydantic_messages import issue_of
from testbed.inputs.yaml_source import Source

Model = TypeVar("Model", bound=BaseModel)


Check = Callable[[Any], Iterable[Issue]]

MOST_ISSUES = 100
"""Number of problems after which no more are looked for. A file can have tens of thousands, each of which takes time."""


def validated(
    model: type[Model],
    source: Source,
    check: Check = lambda _: (),
    stand_ins: Mapping[str, Any] = types.MappingProxyType({}),
) -> Model:
    """The model made from a tree; raises BadInput with every problem found, or the first MOST_ISSUES or so.

    Args:
        check: yields further issues of a valid model.
        stand_ins: valid values for required top-level keys. A stand-in replaces a value that is missing or refused, so that
            the rest of the tree can still be checked.
    """
    pruned = _Pruned(copy.deepcopy(source.tree), stand_ins)
    issues: list[Issue] = []
    value: Model | None = None
    while pruned.usable and len(issues) < MOST_ISSUES:
        try:
            value = model.model_validate(pruned.tree)
            break
        except ValidationError as error:
            issues += pruned.without(model, error.errors(include_url=False))
    if value is not None:
        issues += [issue._replace(path=pruned.original(issue.path)) for issue in check(value)]
    problems = _with_places(source, issues)
    if problems:
        raise BadInput(problems)
    assert value is not None  # nothing refused, so the first attempt succeeded
    return value


def _with_places(source: Source, issues: Iterable[Issue]) -> list[Problem]:
    """All problems in the order of the file; of several at one path, only the first."""
    found = list(source.problems)
    seen = {p.path for p in found}
    for issue in issues:
        problem = source.problem(*issue)
        if problem.path not in seen or not problem.path:
            found.append(problem)
        seen.add(problem.path)
    return sorted(dict.fromkeys(found), key=lambda p: (p.line is None, p.line or 0))


class _Pruned:
    """A copy of a tree from which refused parts are removed; it can give the path of each value in the whole tree.

    Attributes:
        usable: whether validating again can succeed. False once the tree as a whole, or a stand-in, is refused.
    """

    def __init__(self, tree: Any, stand_ins: Mapping[str, Any]) -> None:
        self.tree = tree
        self.usable = True
        self._stand_ins = dict(stand_ins)
        self._removed: set[TreePath] = set()
        self._indices: dict[TreePath, list[int]] = {}

    def original(self, path: TreePath) -> TreePath:
        """Path in the whole tree of the value at `path` here. They differ after an entry of a list was removed."""
        result: TreePath = ()
        for part in path:
            kept = self._indices.get(result)
            result = (*result, kept[part] if kept and isinstance(part, int) and part < len(kept) else part)
        return result

    def without(self, model: type[BaseModel], errors: list[ErrorDetails]) -> list[Issue]:
        """Remove what these errors refuse, and return them as issues.

        An error of a value from which a part was removed before (such as a list that is now too short) is not the user's
        mistake, and is not returned.
        """
        issues = []
        targets: set[TreePath] = set()
        for error in errors[:MOST_ISSUES]:
            issue = issue_of(model, self.tree, error)
            whole = self.original(issue.path)
            if not any(gone[: len(whole)] == whole for gone in self._removed):
                issues.append(issue._replace(path=whole))
            targets.add(self._existing(issue.path))
        outermost = [p for p in targets if not any(p[:n] in targets for n in range(len(p)))]
        for path in sorted(outermost, key=_removal_order, reverse=True):
            self._remove(path)
        return issues

    def _existing(self, path: TreePath) -> TreePath:
        """The path itself if it has a value or a stand-in; for another missing key, the path of the mapping that lacks it."""
        node = self.tree
        for i, part in enumerate(path):
            if part not in (
                node if isinstance(node, dict) else range(len(node) if isinstance(node, list) else 0)
            ):
                return path if i == 0 and part in self._stand_ins else path[:i]
            node = node[part]
        return path

    def _remove(self, path: TreePath) -> None:
        """Remove the value at a path; a top-level key that has a stand-in gets that."""
        if not path or (len(path) == 1 and path in self._removed):
            self.usable = False  # the whole tree is refused, or a stand-in is refused too
            return
        parent = self.tree
        for part in path[:-1]:
            parent = parent[part]
        self._removed.add(self.original(path))
        if len(path) == 1 and path[0] in self._stand_ins:
            parent[path[0]] = self._stand_ins[str(path[0])]
            return
        if isinstance(parent, list):
            whole = self.original(path[:-1])
            del self._indices.setdefault(whole, list(range(len(parent))))[int(path[-1])]
        del parent[path[-1]]


def _removal_order(path: TreePath) -> list[tuple[int, str]]:
    """Sort key for removal from the end: later entries of a list after earlier ones, inner values after outer ones."""
    return [(part, "") if isinstance(part, int) else (-1, part) for part in path]
