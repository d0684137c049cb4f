"""Points of the unit cube, seeds, and distributions of varied values, each used by its inverse, so that all methods work with it.

Points and seeds are pure functions of the sweep's seed and the number of the run. Sobol and Halton sequences and independent
draws can be continued: the first 1000 of 2000 runs are the runs of a sweep of 1000. A latin hypercube cannot be continued, because
its points depend on their number.
"""

from __future__ import annotations

import hashlib
import inspect
import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from pydantic import Field, model_validator
from scipy import special, stats
from scipy.stats import qmc

from testbed.inputs.base import Settings, refuse
from testbed.inputs.problems import did_you_mean
from testbed.inputs.yaml_source import describe

_OPEN = 2.0**-53
"""Probabilities are kept this far from 0 and 1, where the inverse of an unbounded distribution is infinite."""
_LARGEST_WHOLE = 2**53
"""Whole numbers beyond it have no exact value as floating point numbers, by which they are drawn."""
_KINDS = stats.rv_continuous | stats.rv_discrete

_SLOW = ("ksone", "kstwo", "levy_stable", "studentized_range", "yulesimon", "zipf")
"""Distributions of scipy.stats whose inverse takes seconds to hours: integrals, many terms, or a search in steps of ten."""

_OWN = {
    "uniform": "[low, high]",
    "normal": "[mean, standard deviation]",
    "log_uniform": "[low, high], both above 0",
    "integers": "[first, last], both included",
}
"""What the two parameters of our own mean; all but those of `normal` are the ends of a range."""


class Distribution(Settings):
    """`{uniform: [low, high]}`, `{normal: [mean, sd]}`, `{log_uniform: [low, high]}`, `{integers: [first,
    last]}`, `{choice: [...], weights: [...]}`, or a name of scipy.stats with its parameters, as a list or by
    name."""

    name: str
    parameters: Any
    weights: tuple[float, ...] | None = Field(default=None)

    @model_validator(mode="before")
    @classmethod
    def _read(cls, value: Any) -> Any:
        if isinstance(value, Distribution):
            return value
        if not isinstance(value, dict) or not value:
            raise refuse(f"is {describe(value)}", "a distribution, as {uniform: [0, 1]}")
        rest = dict(value)
        weights = rest.pop("weights", None)
        if len(rest) != 1:
            raise refuse(f"names {len(rest)} distributions", "one, as {uniform: [0, 1]}")
        name, parameters = rest.popitem()
        if weights is not None and name != "choice":
            raise refuse("has weights", "weights only with choice")
        return {"name": str(name), "parameters": parameters, "weights": weights}

    @classmethod
    def __get_pydantic_json_schema__(cls, _: Any, handler: Any) -> dict[str, Any]:
        """As it is written: one name with its parameters."""
        parameters = {"type": ["array", "object"]}
        own = {name: {**parameters, "description": meaning} for name, meaning in _OWN.items()}
        choice = {
            "choice": {"type": "array", "minItems": 1},
            "weights": {"type": "array", "items": {"type": "number"}},
        }
        return {
            "type": "object", "title": cls.__name__, "description": inspect.cleandoc(cls.__doc__ or ""),
            "minProperties": 1, "maxProperties": 2,
            "properties": {**own, **choice}, "additionalProperties": parameters,
        }  # fmt: skip

    @model_validator(mode="after")
    def _check(self) -> Distribution:
        if self.name == "choice":
            self._check_choice()
            return self
        self._check_own() if self.name in _OWN else self._check_scipy()
        try:
            with np.errstate(all="ignore"):
                ends = self.quantiles(np.array([_OPEN, 1.0 - _OPEN]))
        except (OverflowError, ValueError, TypeError):
            ends = [math.inf]
        if not all(map(_finite, ends)):
            raise refuse(f"{self.name} draws numbers that are not finite", "smaller parameters")
        return self

    def quantiles(self, u: np.ndarray) -> list[Any]:
        """The n values at the probabilities `u` [n], as Python's own types."""
        if self.name == "choice":
            return [self.parameters[k] for k in np.searchsorted(self._steps[1:-1], u, side="right")]
        if self.name == "integers":
            first, last = self.parameters
            return [min(first + int(p * (last - first + 1)), last) for p in u.tolist()]
        if self.name != "uniform":
            u = np.clip(u, _OPEN, 1.0 - _OPEN)
        values = self._frozen.ppf(u)
        if not np.isfinite(values).all():  # of halfnorm and others the inverse rounds to that of 1
            values = np.where(np.isfinite(values), values, self._frozen.isf(1.0 - u))
        return [self._number(value) for value in values]

    def at_normal(self, z: np.ndarray) -> list[Any]:
        """The n values that are as likely to be exceeded as the standard normals `z` [n], which may be infinite at a finite end.

        The same as `quantiles` of their probabilities, but exact in the upper tail too, where those round to 1.
        """
        if self.name == "normal":
            mean, deviation = map(float, self.parameters)
            return [mean + deviation * each for each in z.tolist()]
        if self.name in ("choice", "integers", "uniform") or self._number is int:
            return self.quantiles(special.ndtr(z))
        found = np.where(z < 0, self._frozen.ppf(special.ndtr(z)), self._frozen.isf(special.ndtr(-z)))
        return np.clip(found, *self.ends).tolist()

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest value, infinite where there is none, of a distribution of numbers."""
        ranged = self.name in _OWN and self.name != "normal"
        low, high = self.parameters if ranged else self._frozen.support()
        return float(low), float(high)

    @property
    def bounds(self) -> list[Any]:
        """[lowest, highest] value, or every option of a choice; empty if the distribution is unbounded."""
        if self.name == "choice" or (self.name in _OWN and self.name != "normal"):
            return list(self.parameters)
        return [self._number(end) for end in self.ends] if all(map(math.isfinite, self.ends)) else []

    def grid(self, levels: int) -> np.ndarray:
        """Probabilities of a grid's levels: each option of `choice` or number of `integers` once, else `levels` of them.

        The levels of a bounded range include both ends; those of an unbounded one are the middles of equally likely parts.
        """
        if self.name == "choice":
            return (self._steps[:-1] + self._steps[1:]) / 2.0
        if self.bounds and self._number is float:
            return np.linspace(0.0, 1.0, levels)
        levels = self.grid_size(levels)
        return (np.arange(levels) + 0.5) / levels

    def grid_size(self, levels: int) -> int:
        """Number of levels that `grid` gives, without making them."""
        if self.name == "integers":
            return int(self.parameters[1] - self.parameters[0] + 1)
        return len(self.parameters) if self.name == "choice" else levels

    @cached_property
    def _steps(self) -> np.ndarray:
        """Probability [k + 1] of an option before each of a choice, and of any: from 0 to 1."""
        weights = np.array(self.weights or [1.0] * len(self.parameters))
        steps = np.concatenate([[0.0], np.cumsum(weights)])
        return np.asarray(steps / weights.sum())

    @cached_property
    def _number(self) -> type[int] | type[float]:
        """The type of the numbers that are drawn."""
        whole = self.name == "integers" or isinstance(getattr(stats, self.name, None), stats.rv_discrete)
        return int if whole else float

    @cached_property
    def _frozen(self) -> Any:
        given = self.parameters
        if self.name in _OWN:
            first, second = map(float, given)
            own = {"uniform": stats.uniform(first, second - first), "normal": stats.norm(first, second)}
            return own.get(self.name) or stats.loguniform(first, second)
        family = getattr(stats, self.name)
        return family(**given) if isinstance(given, dict) else family(*given)

    def _check_choice(self) -> None:
        if not isinstance(self.parameters, list) or not self.parameters:
            raise refuse(
                f"choice is {describe(self.parameters) if self.parameters else 'empty'}", "a list of values"
            )
        if self.weights is None:
            return
        if len(self.weights) != len(self.parameters):
            raise refuse(
                f"has {len(self.weights)} weights for {len(self.parameters)} choices", "one weight each"
            )
        if min(self.weights) < 0 or not 0 < sum(self.weights) < math.inf:
            raise refuse(f"weights are {list(self.weights)}", "none below 0, and one above")

    def _check_own(self) -> None:
        given, meaning = self.parameters, _OWN[self.name]
        if not _numbers(given) or len(given) != 2:
            raise refuse(f"{self.name} has {describe(given)}", meaning)
        low, high = given
        between = f"{self.name} is from {low} to {high}"
        if self.name == "integers":
            if not all(isinstance(end, int) and abs(end) <= _LARGEST_WHOLE for end in given):
                raise refuse(f"integers has {given}", f"{meaning}, whole, within +-2^53")
            high += 1
        if self.name == "normal":
            if high <= 0:
                raise refuse(f"the standard deviation is {high}", "more than 0")
        elif not _finite(float(high) - float(low)):
            raise refuse(between, "a range that is a finite number")
        elif low >= high or (self.name == "log_uniform" and low <= 0):
            raise refuse(between, meaning)

    def _check_scipy(self) -> None:
        family = getattr(stats, self.name, None)
        if not isinstance(family, _KINDS):
            close = did_you_mean(self.name, distribution_names())
            raise refuse(
                f"unknown distribution {self.name!r}",
                "" if close else "uniform, normal, choice, integers, log_uniform or a name of scipy.stats",
                close,
            )
        if self.name in _SLOW:
            raise refuse(
                f"{self.name} takes too long to draw from", "another distribution, or a table of cases"
            )
        shapes = [s.strip() for s in family.shapes.split(",")] if family.shapes else []
        wanted = [*shapes, "loc", *(["scale"] if isinstance(family, stats.rv_continuous) else [])]
        given = self.parameters
        words = f"{', '.join(wanted)}, by name or in this order"
        values = list(given.values()) if isinstance(given, dict) else given
        if not _numbers(values) or len(values) > len(wanted):
            raise refuse(f"{self.name} has {describe(given)}", words)
        if isinstance(given, dict) and (wrong := [n for n in given if n not in wanted]):
            raise refuse(f"{self.name} has no parameter {wrong[0]!r}", words, did_you_mean(wrong[0], wanted))
        try:
            median = float(self._frozen.ppf(0.5))
        except (TypeError, ValueError):
            raise refuse(f"{self.name} has {len(values)} parameters", words) from None
        if not math.isfinite(median):
            raise refuse(f"{self.name} does not take {values}", f"parameters in their range: {words}")


def distribution_names() -> list[str]:
    """The names of all distributions that `vary` accepts."""
    usable = [name for name in dir(stats) if isinstance(getattr(stats, name), _KINDS) and name not in _SLOW]
    return [*_OWN, "choice", *usable]


def _numbers(values: Any) -> bool:
    """Whether this is a list of finite numbers."""
    if not isinstance(values, list):
        return False
    return all(isinstance(v, int | float) and not isinstance(v, bool) and _finite(v) for v in values)


def _finite(value: float) -> bool:
    """Whether a number is finite, also as a float: YAML has whole numbers of any length."""
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


BATCH = 1024
"""Number of points made at a time: a power of two, for which a Sobol sequence is balanced."""


def hashed(*words: object) -> int:
    """A seed of 31 bits from any words; never 0 or 1, which JSBSim takes for "no seed".

    It is a hash, because JSBSim's random numbers from neighbouring seeds are correlated.
    """
    digest = hashlib.sha256("\0".join(map(str, words)).encode()).digest()
    return 2 + int.from_bytes(digest[:8], "big") % (2**31 - 3)


def batch(sampling: str, seed: int, names: Sequence[str], runs: int, index: int) -> np.ndarray:
    """[BATCH, dimensions] points from number BATCH * index on; the last batch of a latin hypercube may have fewer.

    Args:
        names: the varied paths, one for each dimension.
        runs: number of runs of the sweep, on which only a latin hypercube depends.
    """
    rng = np.random.default_rng(hashed(seed, "sampling"))
    first = BATCH * index
    if sampling == "latin_hypercube":
        return np.asarray(qmc.LatinHypercube(len(names), rng=rng).random(runs)[first : first + BATCH])
    if sampling == "random":
        # Each value has its own stream, so that varying another does not change it.
        streams = (np.random.default_rng(hashed(seed, "draw", name, index)) for name in names)
        return np.column_stack([stream.random(BATCH) for stream in streams])
    sequence = (qmc.Sobol if sampling == "sobol" else qmc.Halton)(len(names), rng=rng)
    if first:
        sequence.fast_forward(first)
    return np.asarray(sequence.random(BATCH))
