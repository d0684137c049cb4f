"""What flying a sweep and running a search have in common: how to fly, the folder that is flown into, and how they end early."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from testbed.inputs.problems import BadInput, Problem
from testbed.studies.flying.cluster import refuse_dead
from testbed.studies.flying.flight import Fly, Job, fly_reference
from testbed.studies.flying.pool import FlyAll, Workers, workers
from testbed.studies.folder.begin import Kind, begin
from testbed.studies.folder.store import Store
from testbed.studies.plan import Plan


class Stopped(Exception):
    """A sweep or a search ended early. The finished flights are kept, and --resume flies the rest."""


class Refused(BadInput):
    """A study of which the first flights show that it is none: it leaves no folder."""


@dataclass(frozen=True)
class Options:
    """How to fly: number of processes or a cluster, logs to keep, function that flies, and what flies many flights.

    Only `fly` can change the results.
    """

    jobs: int | None = None
    cluster: str | None = None
    save_logs: str = "failed"
    fly: Fly | None = None
    workers: Workers = workers

    def job(self, plan: Plan) -> Job:
        """The job that workers need to fly this plan; raises BadInput when it cannot be flown so."""
        if self.fly is not None and plan.builder.own:
            what = "flies the scenario in its own way, and so no controller of one's own"
            raise BadInput([Problem(what, path="fly", expected="no fly, or no controllers")])
        return Job(plan.builder, fly_reference(self.fly), self.save_logs, plan.sweep.time_limit_s)


@contextmanager
def flying_into(
    folder: Path,
    kind: Kind,
    plan: Plan,
    tree: Mapping[str, Any],
    options: Options,
    kept: str,
    *,
    resume: bool,
) -> Iterator[tuple[Store, FlyAll]]:
    """The store of the study's folder and what flies, until the end of the block.

    Raises BadInput when it cannot begin, Stopped when the block ended early: Ctrl-C, disk full, cluster gone. If no flight had
    finished then, a new folder is removed.

    Args:
        tree: the resolved study, as its file is to have it.
        kept: what follows the number of flights in the words of Stopped.
    """
    job = options.job(plan)
    if options.cluster is not None:
        refuse_dead(options.cluster)  # before the folder is made
    new = not os.path.lexists(folder)
    store = begin(folder, kind, plan, tree, job.fly, resume=resume)
    useless = False
    try:
        with options.workers(job, options.jobs, options.cluster) as fly_all:
            yield store, fly_all
    except Refused:
        useless = new
        raise
    except (KeyboardInterrupt, OSError, BadInput) as error:
        useless = new and not len(store)
        rest = "no flight had finished, and nothing is kept" if useless else f"{len(store)} {kept}"
        raise Stopped(f"{folder}: {_why(error)}; {rest}") from None
    finally:
        with suppress(OSError):  # a full disk has been reported above
            store.close()
        if useless:
            shutil.rmtree(folder, ignore_errors=True)


def _why(error: BaseException) -> str:
    if isinstance(error, OSError):
        return f"cannot write: {error.strerror or error}"
    return "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
