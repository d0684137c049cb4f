"""Results that are costly to compute, kept for the next flight of the same process.

A flight has the same bytes whether a result was kept or computed anew. This holds as long as the function is pure and the
key names everything that its result depends on: of a file its contents, never its name alone.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

T = TypeVar("T")


class Cache(Generic[T]):
    """The results of one function by key, at most `size` of them; a new one then replaces the oldest.

    Unlike with `functools.lru_cache`, the caller names the key, so arguments need not be hashable.
    """

    def __init__(self, size: int) -> None:
        self._size, self._results = size, dict[Hashable, T]()

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """The result of this key; `make` computes it if it is not there yet. An exception of `make` is not kept."""
        if key not in self._results:
            result = make()
            if len(self._results) >= self._size:
                del self._results[next(iter(self._results))]  # the oldest
            self._results[key] = result
        return self._results[key]
