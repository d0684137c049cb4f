"""What a dotted path into a scenario finds where the file says nothing: the default, as far as the rest of the path needs it."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from testbed.inputs.problems import TreePath
from testbed.scenario.model import Scenario


def made(path: TreePath) -> dict[str, Any] | list[Any]:
    """What is put where a file has no value, so that a path can lead on into it.

    A list with its default entries, of which one is then replaced; settings of one of several types with their default type;
    else an empty mapping, which validation completes.
    """
    kind: type = Scenario
    default: Any = None
    for part in path:
        fields = kind.model_fields if issubclass(kind, BaseModel) else {}
        default = fields[part].get_default(call_default_factory=True) if part in fields else None
        kind = type(default)
    if isinstance(default, tuple):
        return list(default)
    if isinstance(default, BaseModel) and "type" in type(default).model_fields:
        return {"type": default.type}  # type: ignore[attr-defined] # which each of its types has
    return {}
