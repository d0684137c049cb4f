"""Values as Python's own types, fit for JSON."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np


def plain(value: Any) -> Any:
    """Python's own types, for JSON; None for a number that is not finite.

    Mappings become dicts with text keys; lists, tuples and numpy arrays become lists; numpy's numbers become
    Python's. Anything else is returned as it is.
    """
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist())
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
