"""Read YAML, remember the line of each value, and refuse values that YAML does not read as a person would (`1e-3`, `0100`).

Problems are collected in `Source.problems` while reading goes on, so that one pass finds all of them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Hashable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from testbed.inputs.input_file import read_text
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.problems import TreePath as TreePath

MAX_NODES = 100_000
"""Most keys and values in one file, and most values with aliases expanded: these can expand a small file to any size."""
_TOO_MANY = f"more than {MAX_NODES} values"

_MOST_BITS = 1023
"""Longest whole number, some 1200 digits."""

_FORBIDDEN = re.compile("[\0\ud800-\udfff]")
_FORBIDDEN_WORDS = "a NUL character or half a surrogate pair, which text cannot have"
_FLOAT = re.compile(r"([-+]?)([0-9_]*)(\.[0-9_]*)?(?:[eE]([-+]?)([0-9]+))?$")


@dataclass
class Source:
    """A tree of plain values, and the place (file, line) of each path in it.

    No field takes part in comparison, so that two scenarios are equal if only their files differ.
    """

    file: str = field(default="", compare=False)
    tree: Any = field(default=None, compare=False)
    places: dict[TreePath, tuple[str, int | None]] = field(default_factory=dict, compare=False)
    problems: list[Problem] = field(default_factory=list, compare=False)

    def place(self, path: TreePath) -> tuple[str, int | None]:
        """File and line of the value at a path, or of the innermost known value around it."""
        while path and path not in self.places:
            path = path[:-1]
        return self.places.get(path, (self.file, None))

    def problem(self, path: TreePath, what: str, expected: str = "", suggestion: str = "") -> Problem:
        """A Problem of the value at this path."""
        file, line = self.place(path)
        return Problem(what, file, line, dotted(path), expected, suggestion)


def dotted(path: TreePath) -> str:
    """The path as it is written in --set: `failures.0.value`."""
    return ".".join(map(str, path))


def read(path: Path | str) -> Source:
    """Read a YAML file whose top level is a mapping; raises BadInput when it cannot be read as one."""
    return parsed(read_text(path), str(path))


def parsed(text: str, file: str) -> Source:
    """As `read`, for text that was read already; `file` is the name that problems give."""
    source = parse(text, file)
    if not isinstance(source.tree, dict):
        what = "is empty" if source.tree is None else f"is {describe(source.tree)}"
        raise BadInput([*source.problems, Problem(what, file, 1, expected="keys and values (a mapping)")])
    return source


def parse(text: str, file: str = "") -> Source:
    """Read YAML text; raises BadInput with the line when it is not YAML."""
    try:
        node = yaml.compose(text, Loader=_Loader)
        return _Reader(file).read(node)
    except _TooMany as error:
        raise BadInput([Problem(f"has {_TOO_MANY}", file, error.line)]) from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        what = f"is not YAML: {error.problem or error.context}"
        if "\\t" in what:
            what = "is not YAML: a tab where spaces are needed"
        raise BadInput([Problem(what, file, mark.line + 1 if mark else None)]) from None
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        raise BadInput([Problem(f"is not YAML: {error.reason}", file, line)]) from None
    except RecursionError:
        raise BadInput([Problem("is nested too deeply", file)]) from None


def dump(tree: Any) -> str:
    """YAML text that `parse` reads back to the same values, in the order given."""
    return yaml.dump(tree, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=110)


def describe(value: object) -> str:
    """A value for a message: its text, cut to 60 characters, or its kind (`a mapping`, `a list`, `empty`)."""
    if value is None:
        return "empty"
    if isinstance(value, dict | list | tuple):
        return "a mapping" if isinstance(value, dict) else "a list"
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


class _TooMany(Exception):
    def __init__(self, line: int) -> None:
        self.line = line


class _Loader(yaml.SafeLoader):
    """Stops at MAX_NODES already while it composes, which takes most of the time."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._nodes = 0

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        self._nodes += 1
        if self._nodes > MAX_NODES:
            raise _TooMany(self.peek_event().start_mark.line + 1)
        return super().compose_node(parent, index)


class _Reader:
    """Turns composed YAML nodes into plain values, and records places and problems."""

    def __init__(self, file: str) -> None:
        self._source = Source(file)
        self._scalars = yaml.constructor.SafeConstructor()
        self._open: set[int] = set()
        self._count = 0

    def read(self, node: yaml.Node | None) -> Source:
        if node is not None:
            self._source.tree = self._value(node, (), node)
        return self._source

    def _complain(self, node: yaml.Node, path: TreePath, what: str, expected: str = "") -> None:
        line = node.start_mark.line + 1
        self._source.problems.append(Problem(what, self._source.file, line, dotted(path), expected))

    def _value(self, node: yaml.Node, path: TreePath, at: yaml.Node) -> Any:
        """Value of a node; `at` is the node whose line is recorded, which is the key for a value in a mapping."""
        self._source.places[path] = (self._source.file, at.start_mark.line + 1)
        self._count += 1
        if id(node) in self._open or self._count > MAX_NODES:
            what = "contains itself" if id(node) in self._open else f"has {_TOO_MANY}"
            raise BadInput([Problem(what, self._source.file, at.start_mark.line + 1, dotted(path))])
        if isinstance(node, yaml.ScalarNode):
            return self._scalar(node, path)
        self._open.add(id(node))
        try:
            if isinstance(node, yaml.SequenceNode):
                return [self._value(item, (*path, i), item) for i, item in enumerate(node.value)]
            return self._mapping(node, path)
        finally:
            self._open.remove(id(node))

    def _mapping(self, node: yaml.Node, path: TreePath) -> dict[str, Any]:
        result: dict[str, Any] = {}
        lines: dict[Hashable, int] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                self._complain(key, path, "has a key that is not text")
                continue
            name = key.value
            here = (*path, name)
            if _FORBIDDEN.search(name):
                self._complain(key, path, f"{name!r} has {_FORBIDDEN_WORDS}")
                continue
            if key.tag == "tag:yaml.org,2002:merge":
                self._complain(key, here, "merging with << is not supported", "the keys written out")
                continue
            if name in lines:
                self._complain(key, here, f"duplicate key, first written at line {lines[name]}")
            lines.setdefault(name, key.start_mark.line + 1)
            result[name] = self._value(value, here, key)
        return result

    def _scalar(self, node: yaml.ScalarNode, path: TreePath) -> Any:
        try:
            value = self._scalars.construct_object(node)
        except (yaml.YAMLError, ValueError, OverflowError, LookupError, AttributeError) as error:
            # PyYAML looks at the value of an explicit tag, such as `!!bool x`, as if it were one.
            odd = isinstance(error, LookupError | AttributeError)
            what = (
                f"no {node.tag.rpartition(':')[2]}" if odd else getattr(error, "problem", None) or str(error)
            )
            self._complain(node, path, f"{describe(node.value)} cannot be read: {what}")
            return None
        if isinstance(value, int) and value.bit_length() > _MOST_BITS:  # no float can be it
            self._complain(node, path, f"{describe(node.value)} is too large a number")
            return None
        if isinstance(value, str) and _FORBIDDEN.search(value):
            self._complain(node, path, f"has {_FORBIDDEN_WORDS}")
            return None
        if node.style is not None:
            return value
        return self._plain(node, path, value)

    def _plain(self, node: yaml.ScalarNode, path: TreePath, value: Any) -> Any:
        """Refuse an unquoted scalar that YAML does not read as a person would, such as 1e-3 (text) or 0100 (octal)."""
        text = node.value
        if isinstance(value, str) and _is_number(text):
            if math.isfinite(float(text)):
                self._complain(node, path, f"{text} is read as text by YAML, write {as_yaml_float(text)}")
            else:
                self._complain(node, path, f"{text} is not a finite number")
            return float(text)
        if isinstance(value, float) and not math.isfinite(value):
            self._complain(node, path, f"{text} is not a finite number")
        elif isinstance(value, int | float) and ":" in text:
            self._complain(node, path, f"{text} is read as the base-60 number {value} by YAML, write {value}")
        elif isinstance(value, int) and re.match(r"[-+]?0[0-9_]", text):
            self._complain(node, path, f"{text} is read as the octal number {value} by YAML, write {value}")
        return value


class _Dumper(yaml.SafeDumper):
    """Writes no anchors, and quotes text that would be read back as a number or not at all."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _represent_text(dumper: yaml.SafeDumper, text: str) -> yaml.ScalarNode:
    plain = text.isprintable() and not _is_number(text)
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=None if plain else '"')


_Dumper.add_representer(str, _represent_text)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def as_yaml_float(text: str) -> str:
    """A number as YAML 1.1 wants it, with a point and a signed exponent: `1e-3` becomes `1.0e-3`."""
    match = _FLOAT.match(text)
    if match is None:
        return repr(float(text))
    sign, whole, fraction, exponent_sign, exponent = match.groups()
    mantissa = f"{sign}{whole or '0'}{fraction if fraction and fraction != '.' else '.0'}"
    return mantissa + (f"e{exponent_sign or '+'}{exponent}" if exponent else "")
