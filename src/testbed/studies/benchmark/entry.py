"""An entry: a benchmark's result with a digest of every flight; what `benchmark --verify` checks and flies again of it.

It is data. Who checks an entry of a controller of its author's says which file to run.
"""

from __future__ import annotations

import hashlib
import json
import platform
import random
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import Field

from testbed.common import writing
from testbed.common.arithmetic import differences, environment
from testbed.common.files import plain
from testbed.inputs import yaml_source as yamlfile
from testbed.inputs.base import Number, Settings, Text, Whole
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.validation import validated
from testbed.studies.benchmark.load import law_sha256, load_suite
from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.drawing.distributions import hashed
from testbed.studies.flying.flight import FLY
from testbed.studies.flying.pool import workers
from testbed.studies.folder.begin import begun_with
from testbed.studies.folder.store import Store
from testbed.studies.record import Flown, key_of
from testbed.studies.run import Options

_HELD, _SURVIVED, _LOST = "hsl"
"""Begins the mark of a flight that was held, only survived, or was lost; then come hexadecimal digits of its digest."""
_DIGITS = 10


class Score(Settings):
    """A share or a mean with its interval of 95 %."""

    estimate: Number
    low: Number
    high: Number


class Flier(Settings):
    """One controller: the digest of its code if it is the author's, its scores, and a mark of each draw's flight."""

    reference: Text | dict[str, Any]
    code_sha256: str | None = None
    survived: Score
    held: Score
    inside: Score
    flights: Text


class Entry(Settings):
    """What a file of `--entry` says."""

    suite: Text
    version: Whole
    suite_sha256: Text
    seed: Whole
    word: Text | None = None
    law_sha256: Text
    draws: int = Field(strict=True, gt=0)
    environment: dict[str, str]
    arithmetic: dict[str, str] | None = None
    aircraft_sha256: Text
    controllers: dict[str, Flier] = Field(min_length=1)


class Checked(NamedTuple):
    """One flight that was flown again: its draw and controller, and the mark that it has in the entry and now."""

    draw: int
    controller: str
    said: str
    now: str


def write(file: Path, plan: Benchmark, store: Store, summary: Mapping[str, Any]) -> None:
    """Write an entry over an earlier one, from a folder in which every draw was flown; raises BadInput for one of `--mixed`."""
    if any(record.environment for _, record in store.records()):
        what = "cannot be checked by others, as flights were made in several environments"
        raise BadInput([Problem(what, "--entry", expected="a benchmark without --mixed")])
    keys = ("suite", "version", "suite_sha256", "seed", "word", "law_sha256", "draws")
    said: dict[str, Any] = {key: summary[key] for key in keys if key in summary}
    begun = store.inputs
    said |= {
        "environment": _environment(begun),
        "arithmetic": begun["arithmetic"],
        "aircraft_sha256": begun["aircraft_sha256"],
        "controllers": {},
    }
    for j, name in enumerate(plan.labels):
        own, numbers = begun["controllers_sha256"].get(name), range(j, plan.size, len(plan.labels))
        marks = (Flown(store.record(key_of(k)), store.history(key_of(k))) for k in numbers)
        said["controllers"][name] = {
            "reference": plan.tree["controllers"][name],
            **({} if own is None else {"code_sha256": own}),
            **{key: {part: summary["scores"][name][key][part] for part in ("estimate", "low", "high")}
               for key in ("survived", "held", "inside")},
            "flights": " ".join(map(mark, marks)),
        }  # fmt: skip
    writing.write(file, yamlfile.dump(said))


def mark(flown: Flown) -> str:
    """What an entry has of a flight: how it ended, and a digest of every number that it was measured by."""
    record = flown.record
    word = _HELD if record.passed else _SURVIVED if record.outcome == "completed" else _LOST
    numbers = [record.outcome, record.end_time_s, record.metrics, record.requirements]
    text = json.dumps(plain(numbers), sort_keys=True).encode()
    return word + hashlib.sha256(text + flown.history).hexdigest()[:_DIGITS]


def read(file: Path, suite: str | Path | None = None) -> Entry:
    """The entry in a file; raises BadInput for one that contradicts itself, or is of another suite than the shipped one.

    Args:
        suite: the suite's file if it is not shipped.
    """
    source = yamlfile.read(file)
    entry = validated(Entry, source)
    problems = []
    if entry.word is not None and entry.seed != hashed(entry.law_sha256, entry.word):
        problems.append(source.problem(("seed",), "is not the one that law and word give"))
    for name, one in entry.controllers.items():
        problems += [source.problem(("controllers", name, *path), what) for path, what in _wrong(entry, one)]
    known, _ = load_suite(suite or entry.suite)
    if (known.suite, known.version) != (entry.suite, entry.version):
        what = f"is of {entry.suite} {entry.version}, and this is {known.suite} {known.version}"
        problems.append(source.problem(("suite",), what))
    if problems:
        raise BadInput(problems)
    return entry


def _wrong(entry: Entry, one: Flier) -> list[tuple[tuple[str, ...], str]]:
    """Where the scores of a controller are not those of its flights."""
    marks = one.flights.split()
    if len(marks) != entry.draws:
        return [(("flights",), f"has {len(marks)} flights of {entry.draws}")]
    ends = [each[0] for each in marks]
    shares = {"held": ends.count(_HELD), "survived": len(ends) - ends.count(_LOST)}
    return [
        ((key, "estimate"), f"is {getattr(one, key).estimate:g}, and its flights say {count / entry.draws:g}")
        for key, count in shares.items()
        if abs(getattr(one, key).estimate - count / entry.draws) > 1e-9
    ]


def refuse_other(entry: Entry, plan: Benchmark, file: Path) -> None:
    """Raise BadInput when an entry cannot be compared with flights of this plan, environment and code."""
    if problems := [Problem(f"was flown with {what}", str(file)) for what in _others(entry, plan)]:
        raise BadInput(problems)


def _others(entry: Entry, plan: Benchmark) -> Iterator[str]:
    here = begun_with(plan, FLY)
    yield from differences({"versions": entry.environment}, {"versions": _environment(here)})
    if entry.suite_sha256 != plan.digest:
        yield "another content of its suite"
    if entry.aircraft_sha256 != here["aircraft_sha256"]:
        yield "another content of its aircraft"
    shipped = any(one.code_sha256 is None for one in entry.controllers.values())
    if shipped and entry.law_sha256 != law_sha256():
        yield "other code of the shipped controllers"
    for name, one in entry.controllers.items():
        own = plan.builder.own.get(name)
        if one.code_sha256 is not None and own is not None and own.digest != one.code_sha256:
            yield f"other code of {name}"


def fly_again(entry: Entry, plan: Benchmark, draws: int, options: Options) -> list[Checked]:
    """Fly some draws of an entry again, chosen anew in each call, by every controller of the entry."""
    chosen = sorted(random.SystemRandom().sample(range(entry.draws), min(draws, entry.draws)))
    fliers = [j for j, name in enumerate(plan.labels) if name in entry.controllers]
    tasks = [plan.task(number * len(plan.labels) + j) for number in chosen for j in fliers]
    with workers(options.job(plan), options.jobs, options.cluster) as fly_all:
        flights = ((flown.record, mark(flown)) for flown in fly_all(tasks))
        done = [(record.run, plan.labels[record.variant], now) for record, now in flights]
    marks = {name: one.flights.split() for name, one in entry.controllers.items()}
    return [Checked(draw, name, marks[name][draw], now) for draw, name, now in sorted(done)]


def verdict(entry: Entry, checked: Sequence[Checked]) -> tuple[bool, list[str]]:
    """Whether every flight ended as the entry says, and that in words."""
    ended = [each for each in checked if each.said[0] != each.now[0]]
    other = [each for each in checked if each.said != each.now and each not in ended]
    same = len(checked) - len(ended) - len(other)
    lines = [f"{same} of {len(checked)} flights are the same to the last bit"]
    if other:
        lines.append(f"{len(other)} ended the same with other digits, {_why(entry)}")
    lines += [f"draw {each.draw}, {each.controller}: did not end as the entry says" for each in ended]
    return not ended, lines


def _why(entry: Entry) -> str:
    """Why digits may be others than an entry's."""
    if entry.arithmetic is None:
        return "as on another kind of processor"
    here = environment()
    other = "; ".join(differences({**here, "arithmetic": entry.arithmetic}, here))
    return f"as it was flown with {other}" if other else "though this machine calculates alike"


def _environment(begun: Mapping[str, Any]) -> dict[str, str]:
    """The versions on which the bytes of a flight depend, from what a folder was begun with."""
    return {"python": ".".join(platform.python_version_tuple()[:2]), **begun["versions"]}
