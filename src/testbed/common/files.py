"""What the writers of files share: a safe file name, and values that JSON can hold."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

_LONGEST_SLUG = 100
"""Most file systems take names of 255 bytes, of which temporary names need some."""


def slug(name: str, otherwise: str) -> str:
    """A name as a file name: at most 100 lower case letters, digits and hyphens; `otherwise` when nothing of it is left."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:_LONGEST_SLUG].strip("-") or otherwise


def plain(value: Any) -> Any:
    """Python's own types, for JSON; None for a number that is not finite.

    Mappings become dicts with text keys; lists, tuples and numpy arrays become lists; numpy's numbers become
    Python's. Anything else is returned as it is.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):  # of numpy, which is not imported for this
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
