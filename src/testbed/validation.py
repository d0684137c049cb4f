"""A tree against a pydantic model: every problem at once, each with its line and what was probably meant.

When the model refuses a tree, the refused parts are taken out and the rest is validated again, so that checks
that need a whole, valid model (is there such an actuator?) still run and report on the first attempt.
"""

from __future__ import annotations

import copy
import re
import types
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any, Literal, NamedTuple, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from testbed.problems import BadInput, Problem, did_you_mean, one_of
from testbed.yamlfile import Source, TreePath, describe

Model = TypeVar("Model", bound=BaseModel)


class Issue(NamedTuple):
    """A problem inside a tree, before its file and line are known."""

    path: TreePath
    what: str
    expected: str = ""
    suggestion: str = ""


Check = Callable[[Any], Iterable[Issue]]


def validated(
    model: type[Model],
    source: Source,
    check: Check = lambda _: (),
    stand_ins: Mapping[str, Any] = types.MappingProxyType({}),
) -> Model:
    """The model made of a tree, or BadInput with everything that is wrong with it.

    `check` yields further issues of a valid model. `stand_ins` are harmless values for required top-level
    keys: with one in the place of a refused value, the rest of the tree can still be checked.
    """
    pruned = _Pruned(copy.deepcopy(source.tree), stand_ins)
    issues: list[Issue] = []
    value: Model | None = None
    while pruned.usable:
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
    """All problems in the order of the file, the first found at each path only."""
    found = list(source.problems)
    seen = {p.path for p in found}
    for issue in issues:
        problem = source.problem(*issue)
        if problem.path not in seen or not problem.path:
            found.append(problem)
        seen.add(problem.path)
    return sorted(dict.fromkeys(found), key=lambda p: (p.line is None, p.line or 0))


class _Pruned:
    """A tree from which refused parts are taken, and the way back to the paths of the whole tree."""

    def __init__(self, tree: Any, stand_ins: Mapping[str, Any]) -> None:
        self.tree = tree
        self.usable = True
        self._stand_ins = dict(stand_ins)
        self._removed: set[TreePath] = set()
        self._indices: dict[TreePath, list[int]] = {}

    def original(self, path: TreePath) -> TreePath:
        """Path in the whole tree of a path in what is left of it."""
        result: TreePath = ()
        for part in path:
            kept = self._indices.get(result)
            result = (*result, kept[part] if kept and isinstance(part, int) and part < len(kept) else part)
        return result

    def without(self, model: type[BaseModel], errors: list[ErrorDetails]) -> list[Issue]:
        """Take out what these errors refuse; return as issues those that our own taking-out did not cause."""
        issues = []
        targets: set[TreePath] = set()
        for error in errors:
            issue = _issue(model, self.tree, error)
            whole = self.original(issue.path)
            if not any(gone[: len(whole)] == whole for gone in self._removed):
                issues.append(issue._replace(path=whole))
            targets.add(issue.path)
        for path in sorted(targets, key=_removal_order, reverse=True):
            self._remove(path)
        return issues

    def _remove(self, path: TreePath) -> None:
        """Remove the value at a path; where there is none (a missing key), whatever lacks it."""
        parent = self.tree
        for part in path[:-1]:
            parent = parent[part]
        if not path or (len(path) == 1 and path[0] in self._stand_ins):
            self.usable = bool(path)
            if path:
                parent[path[0]] = self._stand_ins.pop(str(path[0]))
                self._removed.add(path)
        elif isinstance(parent, list) and isinstance(path[-1], int) and path[-1] < len(parent):
            whole = self.original(path[:-1])
            self._removed.add(self.original(path))
            del self._indices.setdefault(whole, list(range(len(parent))))[path[-1]]
            del parent[path[-1]]
        elif isinstance(parent, dict) and path[-1] in parent:
            self._removed.add(self.original(path))
            del parent[path[-1]]
        else:
            self._remove(path[:-1])


def _removal_order(path: TreePath) -> list[tuple[int, str]]:
    """Sorts a list's later entries after its earlier ones, and what is inside a thing after the thing."""
    return [(part, "") if isinstance(part, int) else (-1, part) for part in path]


def _issue(model: type[BaseModel], tree: Any, error: ErrorDetails) -> Issue:
    """One pydantic error in the user's words, at the user's path."""
    path, annotation = _user_path(model, tree, error)
    kind, context = error["type"], error.get("ctx", {})
    word = path[-1] if path else ""
    if kind == "extra_forbidden":
        names = _keys(annotation)
        close = did_you_mean(word, names)
        return Issue(path, "unknown key", "" if close else one_of(names), close)
    if kind == "missing":
        return Issue(path, "is missing")
    if kind.startswith("union_tag"):
        here = (*path, str(context["discriminator"]).strip("'"))
        if kind == "union_tag_not_found":
            return Issue(here, "is missing")
        names = [name.strip("' ") for name in context["expected_tags"].split(",")]
        tag = context["tag"]
        return Issue(here, f"unknown {here[-1]} {tag!r}", one_of(names), did_you_mean(tag, names))
    if kind == "literal_error" and get_origin(annotation) is Literal:
        names = [str(name) for name in get_args(annotation)]
        what = f"{describe(error['input'])} is not known"
        return Issue(path, what, one_of(names), did_you_mean(error["input"], names))
    if kind == "refused":
        return Issue(path, context["what"], context["expected"], context["suggestion"])
    expected = re.sub(r"^(Input|String|Value) should (be )?", "", error["msg"]).replace(
        "dictionary", "mapping"
    )
    if kind in ("too_short", "too_long"):
        limits = (
            f"at least {context['min_length']}" if kind == "too_short" else f"at most {context['max_length']}"
        )
        return Issue(path, f"has {context['actual_length']} entries", limits)
    return Issue(path, f"is {describe(error['input'])}", re.sub(r" or instance of \w+", "", expected))


def _user_path(model: type[BaseModel], tree: Any, error: ErrorDetails) -> tuple[TreePath, Any]:
    """pydantic's location without the union tags it mixes in, and the type expected by what is there."""
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
            break  # a scalar that a validator had spread over several keys: the scalar itself is at fault
        annotation = _inside(annotation, part)
        path = (*path, part)
        here = part in (node if isinstance(node, dict) else range(len(node)))
        node = node[part] if here else None  # type: ignore[index]
    return path, _unwrap(annotation)


def _unwrap(annotation: Any) -> Any:
    """Without Annotated and `| None`."""
    while get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    if get_origin(annotation) in (Union, types.UnionType):
        members = [a for a in get_args(annotation) if a is not type(None)]
        if len(members) == 1:
            return _unwrap(members[0])
    return annotation


def _branch(annotation: Any, part: str | int) -> Any:
    """The member of a union of models that this part of a location names, else None."""
    if get_origin(annotation) not in (Union, types.UnionType):
        return None
    for member in map(_unwrap, get_args(annotation)):
        if isinstance(member, type) and issubclass(member, BaseModel):
            tags = [get_args(field.annotation) for field in member.model_fields.values()]
            if any(part in tag for tag in tags):
                return member
    return None


def _inside(annotation: Any, part: str | int) -> Any:
    """Type of the value at a key or index of a value of this type."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        field = annotation.model_fields.get(str(part))
        return field.annotation if field else None
    arguments = [a for a in get_args(annotation) if a is not Ellipsis]
    return arguments[-1] if arguments else None


def _keys(annotation: Any) -> list[str]:
    is_model = isinstance(annotation, type) and issubclass(annotation, BaseModel)
    return list(annotation.model_fields) if is_model else []
