"""Validate a tree that was read from YAML against a pydantic model, and report all problems at once, each with its line.

Some checks need a valid model of the whole, such as whether the aircraft has an actuator of this name. To make these checks
even if the model refuses parts of the tree, those parts are removed from a copy, and the rest is validated again.
Each error of pydantic, such as an unknown key, becomes a message that users understand, with its path in their file (`issue_of`).
"""

from __future__ import annotations

import copy
import re
import types
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, Tag, ValidationError
from pydantic_core import ErrorDetails

from testbed.inputs.problems import BadInput, Issue, Problem, TreePath, did_you_mean, unknown
from testbed.inputs.yaml_source import Source, describe

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


_WORDS = {
    "valid dictionary": "mapping",
    "valid tuple": "list",
    "a valid boolean": "true or false",
    "a valid integer": "a whole number",
    "a valid number": "a number",
    "a valid string": "text",
    "None": "no such key here",
}
"""What pydantic expects, in words that need no Python."""
_OPEN = {"failures", "faults"}
"""Keys below which a type may be a part of the user's own."""


def issue_of(model: type[BaseModel], tree: Any, error: ErrorDetails) -> Issue:
    """The issue that one pydantic error of validating `tree` against `model` stands for."""
    path, annotation = _user_path(model, tree, error)
    kind, context, given = error["type"], error.get("ctx", {}), error["input"]
    if kind == "missing":
        return Issue(path, "is missing")
    if kind == "extra_forbidden":
        known = annotation.model_fields if _is_model(annotation) else ()
        return unknown(path, "unknown key", str(path[-1]), known)
    if kind.startswith("union_tag"):
        here = (*path, str(context["discriminator"]).strip("'"))
        if kind == "union_tag_not_found":
            typo = did_you_mean(here[-1], map(str, given))
            return Issue(here, "is missing", "", f"it by {typo!r}" if typo else "")
        names = [name.strip("' ") for name in context["expected_tags"].split(",")]
        own = not _OPEN.isdisjoint(here)
        return unknown(here, f"unknown {here[-1]} {context['tag']!r}", context["tag"], names, own)
    if kind == "literal_error" and get_origin(annotation) is Literal:
        names = [str(name) for name in get_args(annotation)]
        own = path == ("sensors", "model")
        return unknown(path, f"{describe(given)} is not known", str(given), names, own)
    if kind == "refused":
        return Issue(path, context["what"], context["expected"], context["suggestion"])
    if kind == "too_short":
        return Issue(path, f"has {context['actual_length']} entries", f"at least {context['min_length']}")
    if kind == "too_long":
        return Issue(path, f"has {context['actual_length']} entries", f"at most {context['max_length']}")
    return Issue(path, f"is {describe(given)}", _expected(error["msg"]))


def _expected(message: str) -> str:
    """pydantic's "Input should be a valid dictionary or instance of X" as "a mapping"."""
    message = re.sub(r"^(Input|String|Value) should (be |have )?", "", message)
    message = re.sub(r" or (instance|(an )?object).*", "", message)
    for pydantics, ours in _WORDS.items():
        message = message.replace(pydantics, ours)
    return message


def _user_path(model: type[BaseModel], tree: Any, error: ErrorDetails) -> tuple[TreePath, Any]:
    """Where an error is in the user's tree, and the type that is expected there.

    pydantic's own location also contains the tags of discriminated unions, which are not keys of the tree.
    """
    path: TreePath = ()
    annotation: Any = model
    node = tree
    for i, part in enumerate(error["loc"]):
        annotation = _unwrap(annotation)
        branch = _branch(annotation, part)
        if branch is not None:
            annotation = branch
            continue
        last = i == len(error["loc"]) - 1
        if last and error["type"] == "extra_forbidden":
            return (*path, part), annotation
        if not isinstance(node, dict | list):
            break  # a validator had expanded a scalar into several keys: the scalar itself is wrong
        annotation = _inside(annotation, part)
        path = (*path, part)
        here = part in (node if isinstance(node, dict) else range(len(node)))
        node = node[part] if here else None  # type: ignore[index]
    return path, _unwrap(annotation)


def _unwrap(annotation: Any) -> Any:
    """The type without Annotated and `| None`."""
    while get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    if get_origin(annotation) in (Union, types.UnionType):
        members = [a for a in get_args(annotation) if a is not type(None)]
        if len(members) == 1:
            return _unwrap(members[0])
    return annotation


def _branch(annotation: Any, part: str | int) -> Any:
    """The member of a union whose tag this part of a location is; None if it is no tag.

    Models are told by a value of their own, or, with other types, by a tag of pydantic's.
    """
    if get_origin(annotation) not in (Union, types.UnionType):
        return None
    for member in get_args(annotation):
        if Tag(str(part)) in getattr(member, "__metadata__", ()):
            return _unwrap(member)
    for member in map(_unwrap, get_args(annotation)):
        if _is_model(member):
            tags = [get_args(field.annotation) for field in member.model_fields.values()]
            if any(part in tag for tag in tags):
                return member
    return None


def _inside(annotation: Any, part: str | int) -> Any:
    """Type of the value at a key or index of a value of this type."""
    if _is_model(annotation):
        field = annotation.model_fields.get(str(part))
        return field.annotation if field else None
    arguments = [a for a in get_args(annotation) if a is not Ellipsis]
    return arguments[-1] if arguments else None


def _is_model(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, BaseModel)
