"""Translate an error of pydantic, such as an unknown key, into a message that users understand, with its path in their file."""

from __future__ import annotations

import re
import types
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, Tag
from pydantic_core import ErrorDetails

from testbed.inputs.problems import Issue, TreePath, did_you_mean, unknown
from testbed.inputs.yaml_source import describe

_WORDS = {
    "valid dictionary": "mapping",
    "valid tuple": "list",
    "a valid boolean": "true or false",
    "a valid integer": "a whole number",
    "a valid number": "a number",
    "a valid string": "text",
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
