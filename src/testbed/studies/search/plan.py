"""A search as its file asks for it: its parts, each a search of its own, the space of each, and the flight at each point.

The space has a standard normal coordinate for each value that varies, so that distance is likelihood. The value at a coordinate z
is exceeded as often as z is (the transformation of independent marginals; Der Kiureghian and Liu 1986, without correlation). A
value that is measured from the end of its range, such as a severity from "no effect", has the coordinate u with P(a value farther
from that end) = P(a normal number farther from 0 than u): its distribution is the same, and u = 0 is that end.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import ValidationError
from scipy.integrate import quad
from scipy.special import ndtr, ndtri

from testbed.aircraft.changes import load_with_changes
from testbed.aircraft.shipped import find_scenario
from testbed.controllers.user.own import OwnController
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.kinds import refuse_other, study_in
from testbed.inputs.problems import BadInput, guess
from testbed.inputs.yaml_source import Source
from testbed.scenario.requirement import Requirement
from testbed.studies.drawing.builder import Builder, Task
from testbed.studies.drawing.distributions import Distribution, hashed
from testbed.studies.load import name_of, study_of
from testbed.studies.model import Goal, Search, Study, Sweep
from testbed.studies.plan import Plan

Point = tuple[float, ...]
"""Coordinates of a flight in the space of its part."""
MOST_PARTS = 100
"""Most searches of one file: variants times options of its choices."""
_DRAWS = 16
"""Runs of the sweep over the same values, whose scenarios are checked before the search."""


Origin = Literal["median", "low", "high"]
"""Where in the range of a value its coordinate is 0."""
_TAIL = 9.0
"""Standard deviations after which the density of a normal number is taken for zero."""


@dataclass(frozen=True)
class Coordinate:
    """One value that varies: its dotted path, its distribution, and what distance is measured from."""

    path: str
    distribution: Distribution
    origin: Origin = "median"

    def values(self, u: np.ndarray) -> list[Any]:
        """The values at these coordinates [n]."""
        return self.distribution.at_normal(_from_end(u, self.origin))

    @property
    def nominal(self) -> Any:
        """The value at the origin."""
        return self.values(np.zeros(1))[0]

    def distance(self, u: float) -> float:
        """The coordinate, without its sign where the value is measured from an end: u and -u are the same value there."""
        return u if self.origin == "median" else abs(u)

    def beyond(self, u: float) -> float:
        """Probability of a value at least this far from where distance is measured, on this side of it."""
        return float(ndtr(-abs(u))) * (1.0 if self.origin == "median" else 2.0)


def _from_end(u: np.ndarray, origin: Origin) -> np.ndarray:
    if origin == "median":
        return u
    below = ndtri(2.0 * ndtr(-np.abs(u)))  # infinite at u = 0, which is the end itself
    return below if origin == "high" else -below


@dataclass(frozen=True)
class Space:
    """The coordinates of a search, in the order of its file."""

    coordinates: tuple[Coordinate, ...]

    def __len__(self) -> int:
        return len(self.coordinates)

    @property
    def mirrored(self) -> tuple[int, ...]:
        """Which coordinates have the same value at u and -u: those measured from an end."""
        return tuple(j for j, each in enumerate(self.coordinates) if each.origin != "median")

    def values(self, u: np.ndarray) -> list[dict[str, Any]]:
        """The values by dotted path at each of the points [n, dimensions]."""
        columns = [each.values(u[:, j]) for j, each in enumerate(self.coordinates)]
        paths = [each.path for each in self.coordinates]
        return [dict(zip(paths, row, strict=True)) for row in zip(*columns, strict=True)]

    def beyond(self, u: np.ndarray) -> float:
        """Probability of what lies beyond a limit that is flat at the point u [dimensions]: P(n z > |u|), with n = u / |u|.

        Where a value is measured from an end, z and -z are the same value, so z there is the size of a normal number: with m such
        coordinates the probability is 2^m P(n z > |u|, all m positive), which is 2 P(z > u) if u is one of them alone. Given
        n z = r, the coordinate i has the mean n_i r and the variance 1 - n_i^2. Between two of them its correlation is neglected.
        """
        distance = float(np.linalg.norm(u))
        ends = list(self.mirrored)
        if distance == 0.0 or not ends:
            return float(ndtr(-distance))
        n = np.abs(u[ends]) / distance
        slope = n / np.sqrt(np.maximum(1.0 - n * n, np.finfo(float).tiny))

        def density(past: float) -> float:
            """That of n z at |u| + past, as a share of the normal density at |u|."""
            return math.exp(-past * (distance + 0.5 * past)) * float(
                np.prod(2.0 * ndtr(slope * (distance + past)))
            )

        normal = math.exp(-0.5 * distance * distance) / math.sqrt(2.0 * math.pi)
        return min(1.0, normal * quad(density, 0.0, _TAIL)[0])


def origin_at(distribution: Distribution, nominal: float) -> Origin | None:
    """Which end of the range a value is; None if it is no end."""
    if distribution.name == "choice":
        return None
    low, high = distribution.ends
    return "low" if nominal == low else "high" if nominal == high else None


@dataclass(frozen=True)
class Part:
    """One search of those that a file asks for: one variant, with one option of every `choice`.

    Attributes:
        options: the option of each choice by its dotted path.
        weight: probability of these options.
    """

    number: int
    variant: int
    options: Mapping[str, Any]
    weight: float
    space: Space


@dataclass(frozen=True, kw_only=True)
class SearchPlan(Plan):
    """A resolved search. As a plan it is the sweep over the same values, with whose first runs its scenarios are checked."""

    study: Search
    parts: tuple[Part, ...]
    histories: ClassVar[bool] = False
    at_most: ClassVar[str] = "at most "

    @property
    def size(self) -> int:
        """The most flights that it may make."""
        return self.study.budget * len(self.parts)

    def label(self, part: Part) -> str:
        """The variant and the options of a part in words; empty if there is only one part."""
        options = [
            value if isinstance(value, str) else f"{path} {value}" for path, value in part.options.items()
        ]
        return ", ".join(filter(None, [self.variants[part.variant].label, *options]))

    def seed(self, part: Part) -> int:
        """Seed of the search's own random numbers: the same for all variants, which so meet the same points."""
        return hashed(self.study.seed, "search", *sorted(f"{p}={v}" for p, v in part.options.items()))

    def tasks(self, part: Part, points: np.ndarray, first: int) -> list[Task]:
        """The flights at these points [n, dimensions], numbered from `first` on."""
        drawn = part.space.values(points)
        return [
            Task(first + i, part.variant, self._flight_seed(point), {**part.options, **values})
            for i, (point, values) in enumerate(zip(points, drawn, strict=True))
        ]

    def _flight_seed(self, point: np.ndarray) -> int:
        """Seed of what a flight draws for itself, such as turbulence.

        In the search for the smallest failure it is the same for all flights, which then differ in their point only. For a
        probability it is drawn anew with each point: it acts as further random numbers, which the search does not move.
        """
        if self.study.goal == "smallest":
            return hashed(self.study.seed, "flight")
        return hashed(self.study.seed, "flight", point.astype("<f8").tobytes().hex())


def coordinates(key: bytes) -> Point:
    """The point of the flight that has this key."""
    return tuple(np.frombuffer(key[4:], dtype=">f8").tolist())


def key_of(part: Part, point: Point) -> bytes:
    """The key by which the flight of a part at a point is stored (see `folder.store`)."""
    return part.number.to_bytes(4, "big") + (np.array(point, dtype=">f8") + 0.0).tobytes()  # + 0.0: no -0.0


def load_search(
    path: str | Path,
    settings: Iterable[str] = (),
    own: Mapping[str, OwnController] | None = None,
    goal: Goal | None = None,
) -> SearchPlan:
    """Read and resolve a search file, as `studies.load.load_sweep` does a sweep's; raises BadInput with every problem.

    With `goal` it may be a sweep's file: of its keys, those are used that a search has too.
    """
    source = yamlfile.read(find_scenario(path))
    if goal is None or not study_in(source.tree):
        refuse_other(source, "search")
    if goal is not None:
        _become(source, goal)
    search, builder = study_of(Search, source, settings, own)
    _choose_requirement(search, source, builder.base)
    parts = tuple(_parts(search, source, builder))
    return SearchPlan(study=search, name=name_of(search, path), builder=builder, runs=_DRAWS, parts=parts)


def _become(source: Source, goal: Goal) -> None:
    """Set the goal; leave out of a sweep's file what a search does not have."""
    if "goal" not in source.tree and study_in(source.tree):
        for key in set(Sweep.model_fields) - set(Study.model_fields) - {"cases"}:
            source.tree.pop(key, None)
    source.tree["goal"] = goal


def _choose_requirement(search: Search, source: Source, base: Source) -> None:
    """Leave the searched requirement alone in the scenario; raise BadInput when there is none, or none of this name."""
    given = base.tree.get("requirements")
    if not given or not isinstance(given, list):
        what = "the scenario has no requirement, so that nothing can be broken"
        raise BadInput([source.problem(("scenario",), what, "requirements in the scenario, or in set")])
    if search.requirement is None:
        return
    titles = [_title(each) for each in given]
    if search.requirement not in titles:
        what = f"there is no requirement {search.requirement!r}"
        raise BadInput([source.problem(("requirement",), what, *guess(search.requirement, titles))])
    base.tree["requirements"] = [given[titles.index(search.requirement)]]
    base.problems[:] = [p for p in base.problems if not p.path.startswith("requirements.")]
    for place in [place for place in base.places if place[:1] == ("requirements",)]:
        del base.places[place]


def _title(requirement: Any) -> str:
    try:
        return Requirement.model_validate(requirement).title
    except ValidationError:  # refused with its place when the scenario is checked
        return ""


def _parts(search: Search, source: Source, builder: Builder) -> Iterator[Part]:
    """A part for each variant and each combination of options, with the coordinates of everything else."""
    choices = {path: d for path, d in search.vary.items() if d.name == "choice"}
    rest = {path: d for path, d in search.vary.items() if d.name != "choice"}
    if not rest:
        expected = "a value with a distribution to search in"
        raise BadInput([source.problem(("vary",), "has choices only", expected)])
    combinations = list(itertools.product(*(_options(d) for d in choices.values())))
    number = len(combinations) * len(builder.variants)
    if number > MOST_PARTS:
        what = f"asks for {number} searches, one for each variant and option"
        raise BadInput([source.problem(("vary",), what, f"at most {MOST_PARTS}")])
    for k, (variant, chosen_ones) in enumerate(itertools.product(range(len(builder.variants)), combinations)):
        options = dict(zip(choices, (value for value, _ in chosen_ones), strict=True))
        origins = _origins(search, source, builder, variant, options)
        space = Space(tuple(Coordinate(path, d, origins[path]) for path, d in rest.items()))
        yield Part(k, variant, options, math.prod(weight for _, weight in chosen_ones), space)


def _options(distribution: Any) -> list[tuple[Any, float]]:
    """(option, probability) of each option of a choice that can be drawn."""
    weights = np.asarray(distribution.weights or [1.0] * len(distribution.parameters), dtype=float)
    pairs = zip(distribution.parameters, (weights / weights.sum()).tolist(), strict=True)
    return [(option, weight) for option, weight in pairs if weight > 0.0]


def _origins(
    search: Search, source: Source, builder: Builder, variant: int, options: Mapping[str, Any]
) -> dict[str, Origin]:
    """What the coordinate of each value is measured from."""
    neutral = _neutral(search, builder, variant, options)
    found: dict[str, Origin] = {}
    for path, distribution in search.vary.items():
        value = search.nominal.get(path, neutral.get(path))
        origin = None if value is None else origin_at(distribution, float(value))
        if origin is None and path in search.nominal:
            low, high = distribution.ends
            what = f"is {search.nominal[path]:g}, which is no end of its range"
            raise BadInput([source.problem(("nominal", path), what, f"{low:g} or {high:g}")])
        found[path] = origin or "median"
    return found


def _neutral(search: Search, builder: Builder, variant: int, options: Mapping[str, Any]) -> dict[str, float]:
    """The value with which a failure has no effect, of each varied key of a failure that has one, by dotted path."""
    varied = [path.split(".") for path in search.vary if path.startswith("failures.")]
    keys = [(int(parts[1]), parts[2]) for parts in varied if len(parts) == 3 and parts[1].isdigit()]
    if not keys:
        return {}
    middle = {path: d.at_normal(np.zeros(1))[0] for path, d in search.vary.items() if path not in options}
    try:
        scenario = builder.scenario(Task(0, variant, 2, {**options, **middle}))
        actuators = load_with_changes(scenario.aircraft).actuators
    except BadInput:  # which the check of the plan refuses, with its place
        return {}
    found = {}
    for j, key in keys:
        failure = scenario.failures[j]
        actuator = actuators.get(str(getattr(failure, "actuator", "")))
        value = (failure.neutral(actuator) or {}).get(key) if actuator is not None else None
        if isinstance(value, int | float):
            found[f"failures.{j}.{key}"] = float(value)
    return found
