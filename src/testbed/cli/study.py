"""What the commands of all kinds of studies do alike: fly, write, print the answer, and say how to go on when they end early."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.cli.ending import ENDED_EARLY, INTERRUPTED, MET, NOT_MET, Ended, later, tidily
from testbed.cli.run import print_verdict
from testbed.cli.terminal import working
from testbed.inputs.problems import BadInput, Problem, did_you_mean

if TYPE_CHECKING:
    from testbed.api.study import Kind
    from testbed.studies.plan import Plan
    from testbed.studies.run import Options


def run(kind: Kind, options: Namespace, file: str, *, one: str = "run", **own: Any) -> int:
    """Carry out the study of a file, or one run or a shard of it, as the options say; returns the exit status.

    `own` are the options of this kind alone, and `one` is what it calls a run. Raises BadInput when nothing can be flown, and
    Ended when it ends early.
    """
    from testbed.reporting import junit
    from testbed.studies.run import Options

    if options.only is None and options.variant is not None:
        raise BadInput([Problem("is for one run", "--variant", expected="--only I beside it")])
    how = Options(
        options.jobs, options.cluster, options.save_logs, shard=options.shard, cluster_wait_s=options.cluster_wait,
        mixed=options.mixed,
    )  # fmt: skip
    own |= {"seed": options.seed, "controllers": options.controller}
    if options.only is not None:
        plan, usual = kind.prepare(file, None, options.set, **own)
        return _fly_only(plan, options, how, usual.with_name(f"{usual.name}-{one}-{options.only}"))
    plan, folder = kind.prepare(file, options.out, options.set, resume=options.resume, **own)
    if options.resume and options.copy_to is None:
        _refuse_missing(folder)
    if options.shard is not None:  # which `testbed merge` joins with the others
        with tidily(), _copied(folder, options), _flying():
            flights = kind.fly(plan, folder, how, resume=options.resume)
        print(flights)
        print(f"wrote {folder}, shard {options.shard}")
        return MET
    if options.junit is not None:
        junit.refuse(options.junit, folder)
    with tidily(), _copied(folder, options):
        with _flying():
            flights = kind.fly(plan, folder, how, resume=options.resume)
        with _writing(folder):
            summary = kind.finish(plan, folder, flights, figures=not options.no_plots)
            if options.junit is not None:
                write_junit(kind, plan, folder, summary, options.junit)
    status = told(kind, summary)
    print(flights)
    print(f"wrote {folder}")
    return status


def _refuse_missing(folder: Path) -> None:
    """Raise BadInput where there is nothing to resume: a mistyped name must not begin a study anew."""
    if not folder.exists():
        beside = folder.parent.iterdir() if folder.parent.is_dir() else ()
        near = did_you_mean(folder.name, (each.name for each in beside if each.is_dir()))
        meant = str(folder.with_name(near)) if near else ""
        raise BadInput(
            [Problem("does not exist", str(folder), expected="a folder to resume", suggestion=meant)]
        )


def _fly_only(plan: Plan, options: Namespace, how: Options, usual: Path) -> int:
    """Fly one run alone, tell each of its flights, and return the exit status."""
    from testbed.api.sweep import fly_run
    from testbed.common.files import slug
    from testbed.flight.folder import refuse_existing, refuse_unwritable
    from testbed.reporting import junit

    one, variant = options.only, options.variant
    which = f"-{slug(variant, otherwise='variant')}" if variant else ""
    folder = options.out or usual.with_name(f"{usual.name}{which}")
    refuse_existing(folder)
    if options.junit is not None:
        junit.refuse(options.junit, folder)
    with later():
        refuse_unwritable(folder)
    with tidily():
        passed, flights = fly_run(plan, one, folder, how, variant=variant, figures=not options.no_plots)
    for flight in flights:
        print_verdict(flight)
    if options.junit is not None:
        junit.write(options.junit, plan.name, chain.from_iterable(map(junit.tests_of, flights)))
    print(f"wrote {folder}")
    return MET if passed else NOT_MET


def write_junit(kind: Any, plan: Plan, folder: Path, summary: dict[str, Any], file: Path) -> None:
    """Write the verdict of a study as JUnit XML."""
    from testbed.reporting import junit

    junit.write(file, plan.name, kind.tests(plan, folder, summary))


def told(kind: Kind, summary: dict[str, Any]) -> int:
    """Print the answer of a study; returns the exit status."""
    for line in kind.answer(summary):
        print(line)
    return MET if kind.met(summary) else NOT_MET


@contextmanager
def _flying() -> Iterator[None]:
    """For the block that flies: raises Ended when it stops before the last flight."""
    from testbed.studies.run import Stopped

    try:
        yield
    except Stopped as stopped:
        by_user = isinstance(stopped.__context__, KeyboardInterrupt)
        raise Ended(str(stopped), INTERRUPTED if by_user else ENDED_EARLY) from None


@contextmanager
def _copied(folder: Path, options: Namespace) -> Iterator[None]:
    """For the block that fills a study's folder: copies it to `--copy-to` when it ends, also early.

    What is to be resumed is fetched from there if the folder is not here, as on another machine. Raises Ended where it cannot
    be copied.
    """
    if options.copy_to is None:
        yield
        return
    from testbed.inputs import bucket

    bucket.refuse(options.copy_to, there=options.resume)
    if options.resume and not folder.exists():
        bucket.fetch(options.copy_to, folder)
    try:
        yield
    except Ended:
        _send(folder, options.copy_to)
        raise
    _send(folder, options.copy_to)


def _send(folder: Path, address: str) -> None:
    from testbed.inputs import bucket

    try:
        bucket.send(folder, address)
    except BadInput as error:
        raise Ended(f"{error}; everything is in {folder}, and --resume copies it", ENDED_EARLY) from None
    print(f"copied to {address}")


@contextmanager
def _writing(folder: Path) -> Iterator[None]:
    """For the block that writes what was found: raises Ended, with what writes the rest, when it cannot."""
    kept = "every flight is kept; --resume writes the rest"
    try:
        with working("drawing and writing"):
            yield
    except KeyboardInterrupt:
        raise Ended(f"{folder}: interrupted; {kept}", INTERRUPTED) from None
    except OSError as error:
        raise Ended(f"{folder}: cannot write: {error.strerror or error}; {kept}", ENDED_EARLY) from None
