"""What is computed once and kept: results of pure functions, under everything that they depend on.

A flight is the same whether they were kept or not; keeping them is what makes the second flight of a worker cheap.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

T = TypeVar("T")


class Kept(Generic[T]):
    """The latest `most` results, by key; unlike `lru_cache`, arguments need not be hashable themselves."""

    def __init__(self, most: int) -> None:
        self._most, self._results = most, dict[Hashable, T]()

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """The result of this key, made now if it is not there."""
        if key not in self._results:
            if len(self._results) >= self._most:
                del self._results[next(iter(self._results))]  # the oldest
            self._results[key] = make()
        return self._results[key]

    def clear(self) -> None:
        """Forget them all."""
        self._results.clear()
