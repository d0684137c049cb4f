"""What the commands of all kinds of studies do alike: fly, write, print the answer, and say how to go on when they end early."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from testbed.cli.interrupts import tidily
from testbed.cli.status import ENDED_EARLY, INTERRUPTED, MET, NOT_MET, Ended
from testbed.cli.working import working
from testbed.inputs.problems import BadInput

if TYPE_CHECKING:
    from testbed.api.study import Kind
    from testbed.studies.plan import Plan


def run(kind: Kind, options: Namespace, file: str, *, save_logs: str = "none", **own: Any) -> int:
    """Carry out the study of a file with the options of `command.add_many_flights`, and return the exit status.

    `own` are the options of this kind alone. Raises BadInput when nothing can be flown, and Ended when it ends early.
    """
    from testbed.studies.run import Options

    junit = getattr(options, "junit", None)  # which kinds with a verdict take
    how = Options(
        options.jobs, options.cluster, save_logs, cluster_wait_s=options.cluster_wait, mixed=options.mixed
    )
    shared = {"seed": options.seed, "resume": options.resume, "controllers": options.controller}
    plan, folder = kind.prepare(file, options.out, options.set, **shared, **own)
    if junit is not None:
        from testbed.reporting.junit import refuse

        refuse(junit, folder)
    with tidily(), copied(folder, options):
        with flying():
            flights = kind.fly(plan, folder, how, resume=options.resume)
        with _writing(folder):
            summary = kind.finish(plan, folder, flights, figures=not options.no_plots)
            if junit is not None:
                write_junit(kind, plan, folder, summary, junit)
    status = told(kind, summary)
    print(flights)
    print(f"wrote {folder}")
    return status


def write_junit(kind: Any, plan: Plan, folder: Path, summary: dict[str, Any], file: Path) -> None:
    """Write the verdict of a study as JUnit XML."""
    from testbed.reporting import junit

    junit.write(file, plan.name, kind.tests(plan, folder, summary))


def report(kind: Kind, folder: Path) -> int:
    """Write what was found in a study's folder again; returns the exit status."""
    with working("drawing and writing"), tidily():
        summary = kind.rebuild(folder)
    return told(kind, summary)


def told(kind: Kind, summary: dict[str, Any]) -> int:
    """Print the answer of a study; returns the exit status."""
    for line in kind.answer(summary):
        print(line)
    return MET if kind.met(summary) else NOT_MET


@contextmanager
def flying() -> Iterator[None]:
    """For the block that flies: raises Ended when it stops before the last flight."""
    from testbed.studies.run import Stopped

    try:
        yield
    except Stopped as stopped:
        by_user = isinstance(stopped.__context__, KeyboardInterrupt)
        raise Ended(str(stopped), INTERRUPTED if by_user else ENDED_EARLY) from None


@contextmanager
def copied(folder: Path, options: Namespace) -> Iterator[None]:
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
