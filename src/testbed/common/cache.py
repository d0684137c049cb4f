"""Results that are costly to compute, kept for the next flight of the same process.

A flight has the same bytes whether a result was kept or computed anew. This holds as long as the function is pure and the
key names everything that its result depends on: of a file its contents, never its name alone.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Any, ClassVar, Generic, TypeVar
from weakref import WeakSet

T = TypeVar("T")


class Cache(Generic[T]):
    """The results of one function by key, at most `size` of them; a new one then replaces the oldest.

    Unlike with `functools.lru_cache`, the caller names the key, so arguments need not be hashable.
    """

    _all: ClassVar[WeakSet[Cache[Any]]] = WeakSet()

    def __init__(self, size: int) -> None:
        self._size, self._results = size, dict[Hashable, T]()
        Cache._all.add(self)

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """The result of this key; `make` computes it if it is not there yet. An exception of `make` is not kept."""
        if key not in self._results:
            result = make()
            if len(self._results) >= self._size:
                del self._results[next(iter(self._results))]  # the oldest
            self._results[key] = result
        return self._results[key]

    def clear(self) -> None:
        """Forget all results."""
        self._results.clear()

    @classmethod
    def clear_all(cls) -> None:
        """Forget the results of every cache: the next flight computes everything anew, as in a new process."""
        for cache in cls._all:
            cache.clear()
