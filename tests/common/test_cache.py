"""A result is computed once for each key, and as often as it is needed after it had to go."""

from __future__ import annotations

import pytest

from testbed.common.cache import Cache


class Counter:
    """A function that counts its calls."""

    def __init__(self) -> None:
        self.calls = 0

    def __call__(self) -> int:
        self.calls += 1
        return self.calls


def test_a_key_is_computed_once() -> None:
    cache, make = Cache[int](4), Counter()
    assert [cache.get("a", make), cache.get("a", make)] == [1, 1]
    assert cache.get(("a", 2), make) == 2


def test_the_oldest_goes() -> None:
    cache, make = Cache[int](2), Counter()
    for key in "abc":
        cache.get(key, make)
    assert cache.get("b", make) == 2
    assert cache.get("c", make) == 3
    assert cache.get("a", make) == 4, "a was the oldest, and is computed anew"


def test_an_error_is_not_kept() -> None:
    cache, make = Cache[int](1), Counter()
    cache.get("a", make)

    def fail() -> int:
        raise ValueError

    with pytest.raises(ValueError):
        cache.get("b", fail)
    assert cache.get("a", make) == 1, "and nothing had to make room for it"
    assert cache.get("b", make) == 2


def test_none_is_a_result() -> None:
    cache, calls = Cache[None](2), Counter()

    def nothing() -> None:
        calls()

    cache.get("a", nothing)
    cache.get("a", nothing)
    assert calls.calls == 1
