"""Benchmarks from Python. `benchmark` does everything; the other functions are its steps, which the command line uses too."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.api.options import checked_options
from testbed.common.files import slug, write_whole
from testbed.controllers.user.own import not_given
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.benchmark import entry as entries
from testbed.studies.benchmark.law import law_sha256, seed_of
from testbed.studies.benchmark.load import chosen, load_suite, variants
from testbed.studies.benchmark.plan import Benchmark, benchmark_of
from testbed.studies.benchmark.run import fly_benchmark
from testbed.studies.folder import store

if TYPE_CHECKING:
    import pandas as pd

DEFAULT_DRAWS, DEFAULT_SEED, VERIFIED_DRAWS = 1000, 1, 20


def benchmark(
    suite: str | Path = "open",
    out: str | Path | None = None,
    *,
    controllers: Sequence[str] = (),
    draws: int = DEFAULT_DRAWS,
    seed: int | None = None,
    word: str | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    entry: str | Path | None = None,
) -> pd.DataFrame:
    """Fly controllers on the flights of a suite, write the folder, and return its table with a row for each flight.

    Args:
        suite: name of a shipped suite, or a suite's file.
        out: the folder to make, `runs/benchmark-<suite>-<seed>` by default.
        controllers: each NAME of one of the suite's controllers, to fly these alone; or NAME=FILE.py:CLASS, to fly that too.
        draws: number of flights of each controller.
        seed: from which the flights are drawn.
        word: a public word, from which and the digest of the law the seed is made, so that nobody can choose it.
        jobs: number of processes; one for each core by default.
        cluster: address of a Dask cluster to fly on instead.
        resume: go on with an existing folder, and fly only the missing flights.
        entry: a file to write, with which others can check the result.

    Raises BadInput when nothing can be flown, Stopped when it ended early; the finished flights are then kept.
    """
    how = checked_options(jobs, cluster)
    plan, folder = prepare(suite, out, controllers=controllers, draws=draws, seed=seed, word=word)
    fly_benchmark(plan, folder, how, resume=resume)
    return finish(plan, folder, suite, word, entry)[1]


def prepare(
    suite: str | Path,
    out: str | Path | None = None,
    *,
    controllers: Sequence[str] = (),
    draws: int = DEFAULT_DRAWS,
    seed: int | None = None,
    word: str | None = None,
) -> tuple[Benchmark, Path]:
    """Read and check a suite; returns what is to be flown and the folder. Raises BadInput with every problem found."""
    if draws < 1:
        raise BadInput([Problem(f"is {draws}", "--draws", expected="at least 1")])
    if seed is not None and word is not None:
        raise BadInput([Problem("makes a seed, and one is given", "--word", expected="--word or --seed")])
    if seed is None:
        seed = DEFAULT_SEED if word is None else seed_of(word)
    said = load_suite(suite)
    shipped, own = chosen(said, controllers)
    plan = benchmark_of(said, variants(shipped, own), own, draws, seed)
    plan.task(0)  # raises BadInput for a suite of which nothing is a scenario
    name = slug(f"benchmark {said.suite} {seed}", otherwise="benchmark")
    return plan, Path(out) if out is not None else Path("runs") / name


def finish(
    plan: Benchmark,
    folder: Path,
    suite: str | Path,
    word: str | None = None,
    entry: str | Path | None = None,
) -> tuple[dict[str, Any], pd.DataFrame]:
    """Write results.csv, summary.json, benchmark.md and the entry, from a folder that was flown; returns summary and table."""
    from testbed.studies.benchmark import scores  # with pandas
    from testbed.study_reports.benchmark import page

    known = {"file": str(suite), "law_sha256": law_sha256(), "word": word}
    with store.reading(folder) as stored:
        frame = scores.table(plan, stored)
        summary = scores.summarize(plan, frame) | known
        if entry is not None:
            entries.write(Path(entry), plan, stored, summary)
    text = json.dumps(summary, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False)
    title = f"# Benchmark {plan.name}"
    write_whole(folder / "results.csv", frame.to_csv(index=False, lineterminator="\n").encode())
    write_whole(folder / "summary.json", f"{text}\n".encode())
    write_whole(folder / "benchmark.md", "\n".join([title, "", *page(summary), ""]).encode())
    return summary, frame


def verify(
    file: str | Path,
    suite: str | Path | None = None,
    *,
    controllers: Sequence[str] = (),
    draws: int = VERIFIED_DRAWS,
    jobs: int | None = None,
    cluster: str | None = None,
) -> tuple[bool, list[str]]:
    """Fly draws of an entry again; returns whether all ended as it says, and that in words.

    Args:
        file: the entry.
        suite: the suite's file, if it is not a shipped one.
        controllers: NAME=FILE.py:CLASS of each controller of the author's: an entry names no code to run.
        draws: how many draws, which are chosen anew each time.

    Raises BadInput for an entry that is of another suite, version, environment or code, or contradicts itself.
    """
    how, entry = checked_options(jobs, cluster), entries.read(Path(file), suite)
    own = [name for name, one in entry.controllers.items() if one.code_sha256 is not None]
    given = [text.partition("=")[0] for text in controllers]
    if missing := [not_given(name) for name in own if name not in given]:
        raise BadInput(missing)
    shipped = [name for name in entry.controllers if name not in own]
    plan, _ = prepare(
        suite or entry.suite, controllers=[*shipped, *controllers], draws=entry.draws, seed=entry.seed
    )
    entries.refuse_other(entry, plan, Path(file))
    return entries.verdict(entries.fly_again(entry, plan, draws, how))
