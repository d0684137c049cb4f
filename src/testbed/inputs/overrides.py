"""`--set KEY=VALUE`: set the value at a dotted path of a tree that was read from a YAML file."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from testbed.inputs.problems import BadInput, Problem, TreePath
from testbed.inputs.yaml_source import Source, describe, dotted, parse

SHORT_FORMS: dict[TreePath, str] = {("aircraft",): "name"}
"""Where a text is short for a mapping, and the key of the mapping that has the text."""

_LONGEST, _SHOWN = 20, 200
"""Keys of a path: ours have up to seven. A path of thousands takes minutes to follow and to say what is wrong with."""

Made = Callable[[TreePath], dict[str, Any] | list[Any]]
"""Gives what is put at a path where the tree has nothing, so that a setting can lead on into it."""


class Option(str):
    """A KEY=VALUE that was given as an option of its own, as `--budget 100`, and is called so in problems."""


def place_of(setting: str) -> str:
    """Where a KEY=VALUE comes from, as problems with it say."""
    key, _, value = setting.partition("=")
    return f"--{key} {value}" if isinstance(setting, Option) else f"--set {setting}"


def apply(source: Source, overrides: Iterable[str] | Mapping[str, Any], missing: Made = lambda _: {}) -> None:
    """Apply each KEY=VALUE, or each value by its KEY, to the tree in turn; problems are added to `source.problems`."""
    if isinstance(overrides, Mapping):
        for key, value in overrides.items():
            set_value(source, str(key).split("."), copy.deepcopy(value), f"set {key}", missing)
        return
    for override in overrides:
        place = place_of(override)
        key, equals, text = override.partition("=")
        parts = key.strip().split(".")
        if not equals or not all(parts):
            source.problems.append(
                Problem("is not a setting", place, expected="KEY=VALUE, KEY a dotted path")
            )
            continue
        try:
            value = parse(text)
        except BadInput as error:
            source.problems += [Problem(p.what, place, path=key) for p in error.problems]
            continue
        source.problems += [
            Problem(p.what, place, None, f"{key}.{p.path}".rstrip("."), p.expected) for p in value.problems
        ]
        set_value(source, parts, value.tree, place, missing)


def set_value(source: Source, parts: list[str], value: Any, place: str, missing: Made = lambda _: {}) -> None:
    """Set the value at a path; what is missing on the way is made. Problems are added to `source.problems`.

    Args:
        parts: the path's keys and indices, as text.
        place: where the value comes from, as problems with it will say, such as `--set a.b=1`.
        missing: gives what is made at a path on the way; by default an empty mapping.
    """
    if len(parts) > _LONGEST:
        what = f"is a path of {len(parts)} keys"
        source.problems.append(Problem(what, place[:_SHOWN], expected=f"at most {_LONGEST}"))
        return
    node, path = source.tree, ()  # type: tuple[Any, TreePath]
    for i, part in enumerate(parts):
        last = i == len(parts) - 1
        if isinstance(node, list):
            index = int(part) if part.isascii() and part.isdigit() else len(node)
            if index >= len(node):
                what, expected = f"has no entry {part}", _indices(node)
                source.problems.append(Problem(what, place, path=dotted(path), expected=expected))
                return
            key: str | int = index
        elif isinstance(node, dict):
            key = part
            if not last and isinstance(node.get(part), str) and (*path, part) in SHORT_FORMS:
                node[part] = {SHORT_FORMS[(*path, part)]: node[part]}
            if not last and node.get(part) is None:
                node[part] = missing((*path, part))
                _forget(source, (*path, part), place)
        else:
            what = f"is {describe(node)}"
            source.problems.append(Problem(what, place, path=dotted(path), expected="a mapping or a list"))
            return
        path = (*path, key)
        if last:
            node[key] = value
            _forget(source, path, place)
        else:
            node = node[key]


def is_override(source: Source, path: TreePath) -> bool:
    """Whether the value at a path came from --set, not from the file."""
    return path in source.places and source.places[path][0] != source.file


def _indices(items: list[Any]) -> str:
    """What an index of a list may be, in words."""
    if len(items) < 2:
        return "0, its only entry" if items else "no index, the list is empty"
    return f"an index from 0 to {len(items) - 1}"


def _forget(source: Source, path: TreePath, place: str) -> None:
    """Forget places and problems of the file's value at a path and below it, because a value from `place` replaces it."""
    text = dotted(path)
    source.problems[:] = [
        p for p in source.problems if p.file != source.file or not f"{p.path}.".startswith(f"{text}.")
    ]
    for known in [known for known in source.places if known[: len(path)] == path]:
        del source.places[known]
    source.places[path] = (place, None)
