"""Benchmarks from Python. `benchmark` does everything; the other functions are its steps, which the command line uses too."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.api.study import folder_of, write_summary
from testbed.common.writing import write
from testbed.controllers.user.own import not_given
from testbed.inputs.problems import BadInput, Problem
from testbed.inputs.received import believed, refuse_links
from testbed.parts import digests
from testbed.reporting.attempt import attempt
from testbed.reporting.junit import Test
from testbed.studies.benchmark.load import as_given, chosen, law_sha256, load_suite, read_back, seed_of
from testbed.studies.benchmark.plan import Benchmark, benchmark_of
from testbed.studies.folder import store
from testbed.studies.folder.begin import refuse_blocked
from testbed.studies.run import Flights, Options, fly_part
from testbed.study_reports.benchmark import markdown, tests_of_benchmark, write_benchmark_page

if TYPE_CHECKING:
    import pandas as pd

DEFAULT_DRAWS, DEFAULT_SEED, VERIFIED_DRAWS = 1000, 1, 20
fly = fly_part


def benchmark(
    suite: str | Path = "open",
    out: str | Path | None = None,
    *,
    controllers: Sequence[str] = (),
    draws: int | None = None,
    seed: int | None = None,
    word: str | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
    resume: bool = False,
    mixed: bool = False,
    entry: str | Path | None = None,
) -> pd.DataFrame:
    """Fly controllers on the flights of a suite, write the folder, and return its table with a row for each flight.

    Args:
        suite: name of a shipped suite, or a suite's file.
        out: the folder to make, `runs/benchmark-<suite>-<seed>` by default.
        controllers: each NAME of one of the suite's controllers, to fly these alone; NAME=FILE.py:CLASS, to fly that too; or
            NAME={type: ...}, a shipped one with settings.
        draws: number of flights of each controller; 1000 by default.
        seed: from which the flights are drawn; 1 by default.
        word: a public word, from which and the digest of the law the seed is made, so that nobody can choose it.
        entry: a file to write, with which others can check the result.

    `jobs`, `cluster`, `resume` and `mixed` are as of `sweep`.
    Raises BadInput when nothing can be flown, Stopped when it ended early; the finished flights are then kept.
    """
    how = Options(jobs, cluster, "none", mixed=mixed)
    plan, folder = prepare(
        suite, out, controllers=controllers, draws=draws, seed=seed, word=word, entry=entry
    )
    finish(plan, folder, fly_part(plan, folder, how, resume=resume))
    return table(folder)


def prepare(
    file: str | Path,
    out: str | Path | None = None,
    settings: Sequence[str] = (),
    *,
    seed: int | None = None,
    resume: bool = False,
    controllers: Sequence[str] = (),
    draws: int | None = None,
    word: str | None = None,
    entry: str | Path | None = None,
) -> tuple[Benchmark, Path]:
    """Read and check a suite; returns what is to be flown and the folder. Raises BadInput with every problem found."""
    if draws is not None and draws < 1:
        raise BadInput([Problem(f"is {draws}", "--draws", expected="at least 1")])
    if entry is not None and digests():
        what = "would need parts of your own, with which nobody else can check it"
        raise BadInput([Problem(what, "--entry", expected="no --with")])
    if word is not None and not word.strip():
        raise BadInput([Problem("is empty", "--word", expected="a public word")])
    if seed is not None and word is not None:
        raise BadInput([Problem("makes a seed, and one is given", "--word", expected="--word or --seed")])
    if seed is None:
        seed = DEFAULT_SEED if word is None else seed_of(word)
    suite, said = load_suite(file)
    plan = benchmark_of(
        suite,
        said,
        chosen(suite, said, controllers),
        draws=DEFAULT_DRAWS if draws is None else draws,
        seed=seed,
        file=str(file),
        law=law_sha256(),
        word=word or "",
        entry=None if entry is None else Path(entry),
    )
    plan.task(0)  # raises BadInput for a suite of which nothing is a scenario
    return plan, folder_of(plan, out)


def finish(
    plan: Benchmark, folder: Path, flights: Flights | None = None, *, figures: bool = True
) -> dict[str, Any]:
    """As `Kind.finish`: results.csv, summary.json, the report, and the entry if one is asked for."""
    from testbed.studies.benchmark import entry, scores  # with pandas

    with store.reading(folder) as stored:
        frame = scores.table(plan, stored)
        if not len(frame):
            raise BadInput([Problem("no draw was flown by every controller", str(folder))])
        summary = scores.summarize(plan, frame)
        write(folder / "results.csv", frame.to_csv(index=False, lineterminator="\n"))
        write_summary(summary, folder)
        if plan.entry is not None:
            entry.write(plan.entry, plan, stored, summary)
    if figures:
        attempt("the report", lambda: write_benchmark_page(summary, folder))
    return summary


def rebuild(folder: Path) -> dict[str, Any]:
    """As `Kind.rebuild`; of an unfinished benchmark, of the draws that every controller has flown."""
    refuse_blocked(folder)
    refuse_links(folder)
    return finish(plan_of(folder), folder)


def plan_of(folder: Path) -> Benchmark:
    """The plan of a benchmark's folder, as its file has it, and of the user's controllers without their code; raises BadInput."""
    suite, compared, tree = read_back(folder)
    known = {key: tree[key] for key in ("draws", "seed", "file")}
    said = {key: tree.get(name, "") for key, name in (("law", "law_sha256"), ("word", "word"))}
    return benchmark_of(suite, tree["suite"], compared, **known, **said)


def tests(plan: Benchmark, folder: Path, summary: Mapping[str, Any]) -> Iterator[Test]:
    """A test of each flight, which fails where it was not held, for `--junit`."""
    return tests_of_benchmark(summary, table(folder))


def answer(summary: Mapping[str, Any]) -> Sequence[str]:
    """As `Kind.answer`: the tables, first where the reference loses."""
    return markdown(summary)


def met(summary: Mapping[str, Any]) -> bool:
    """As `Kind.met`: a benchmark requires nothing."""
    return True


def table(folder: str | Path) -> pd.DataFrame:
    """The table of a benchmark's folder, with a row for each flight; raises BadInput when there is none."""
    import pandas as pd

    file, expected = Path(folder) / "results.csv", "the table of a benchmark"
    with believed(file, expected):
        frame = pd.read_csv(file, dtype={"reason": str}).fillna({"reason": ""})
    if missing := {"draw", "controller", "outcome", "held", "survived"} - set(frame.columns):
        raise BadInput([Problem(f"has no column {min(missing)}", str(file), expected=expected)])
    return frame


def verify(
    file: str | Path,
    suite: str | Path | None = None,
    *,
    controllers: Sequence[str] = (),
    draws: int | None = None,
    jobs: int | None = None,
    cluster: str | None = None,
) -> tuple[bool, list[str]]:
    """Fly draws of an entry again; returns whether all ended as it says, and that in words.

    Args:
        file: the entry.
        suite: the suite's file, if it is not a shipped one.
        controllers: NAME=FILE.py:CLASS of each controller of the author's: an entry names no code to run.
        draws: how many draws, which are chosen anew each time; 20 by default.

    Raises BadInput for an entry that is of another suite, version, environment or code, or contradicts itself.
    """
    from testbed.studies.benchmark import entry as entries

    how = Options(jobs, cluster, "none", mixed=True)  # what differs is said with the verdict
    entry = entries.read(Path(file), suite)
    own = [name for name, one in entry.controllers.items() if one.code_sha256 is not None]
    given = [text.partition("=")[0] for text in controllers]
    if missing := [not_given(name) for name in own if name not in given]:
        raise BadInput(missing)
    known, _ = load_suite(suite or entry.suite)
    shipped = [
        as_given(known, name, one.reference) for name, one in entry.controllers.items() if name not in own
    ]
    plan, _ = prepare(
        suite or entry.suite, controllers=[*shipped, *controllers], draws=entry.draws, seed=entry.seed
    )
    entries.refuse_other(entry, plan, Path(file))
    return entries.verdict(
        entry, entries.fly_again(entry, plan, VERIFIED_DRAWS if draws is None else draws, how)
    )
