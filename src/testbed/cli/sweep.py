"""What `testbed sweep` does and prints. Exit: 0 all passed, 1 not all, 3 ended early, 130 Ctrl-C."""

from __future__ import annotations

import argparse
import csv
import io
import sys
from pathlib import Path
from typing import Any

from testbed import monte_carlo as api
from testbed.flight.folder import refuse_existing, write_run_folder
from testbed.inputs.problems import BadInput, Problem
from testbed.reporting.numbers import interval, number
from testbed.sweeps.checks import check
from testbed.sweeps.folder import results
from testbed.sweeps.folder.store import flight_label
from testbed.sweeps.plan import Plan, load_sweep
from testbed.sweeps.run import Options, Stopped, fly_only, fly_sweep
from testbed.sweeps.workers.flying import fly_task

ENDED_EARLY, INTERRUPTED = 3, 130


def run(options: argparse.Namespace) -> int:
    """Fly a sweep, or one run of it; raises BadInput when nothing can be flown."""
    how = api.options(options.jobs, options.cluster, options.save_logs)
    if options.only is not None:
        return _only(options, how)
    if options.runs is not None and options.runs < 1:
        raise BadInput([Problem(f"is {options.runs}", "--runs", expected="at least 1")])
    plan, folder = api.prepare(
        options.sweep, options.out, options.set, runs=options.runs, seed=options.seed, resume=options.resume
    )
    try:
        flights = fly_sweep(plan, folder, how, resume=options.resume)
    except Stopped as stopped:
        print(stopped, file=sys.stderr)
        return INTERRUPTED if isinstance(stopped.__context__, KeyboardInterrupt) else ENDED_EARLY
    try:
        found = api.finish(plan, folder, figures=not options.no_plots)
    except KeyboardInterrupt:
        print(f"{folder}: every flight is kept; `testbed report {folder}` writes the rest", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:
        why = f"{folder}: cannot write: {error.strerror or error}; every flight is kept"
        print(f"{why}, `testbed report {folder}` writes the rest", file=sys.stderr)
        return ENDED_EARLY
    print_answer(found)
    print(flights if flights.count else "nothing was missing")
    print(f"wrote {folder}")
    return status(found)


def report(folder: Path) -> int:
    """Rebuild everything of a sweep folder but its flights."""
    found = api.rebuild(folder)
    print_answer(found)
    return status(found)


def status(found: dict[str, Any]) -> int:
    """0 when every flight passed, else 1."""
    shares = [variant["all_requirements"] for variant in found["variants"]]
    return 0 if all(share["successes"] == share["n"] for share in shares) else 1


def print_answer(found: dict[str, Any]) -> None:
    """P(all) and P(each) of every variant, and how they differ."""
    for variant in found["variants"]:
        total = variant["all_requirements"]
        if total["estimate"] is None:
            continue
        print(f"{variant['label'] or found['sweep']}: {total['n']} runs")
        for known, name in [(total, "all requirements"), *((r, r["name"]) for r in variant["requirements"])]:
            print(f"  {interval(known)}  {name}")
    for pair in found["pairs"]:
        if pair["difference"] is not None:
            difference = interval(pair, "difference", "+.3f")
            print(
                f"{pair['first']} minus {pair['second']}: {difference}, p = {number(pair['p_value'], '.2g')}"
            )


def validate(file: str) -> Plan:
    """Check a sweep file; raises BadInput with every problem."""
    return api.prepare(file)[0]


def _only(options: argparse.Namespace, how: Options) -> int:
    """One run: its rows as they stand in results.csv, and a run folder for each variant."""
    settings = list(options.set)
    settings += [
        f"{name}={value}"
        for name, value in (("runs", options.runs), ("seed", options.seed))
        if value is not None
    ]
    plan = load_sweep(options.sweep, settings)
    check(plan)
    folder = options.out or Path(f"{api.default_folder(plan)}-run-{options.only}")
    refuse_existing(folder)
    flown = [flown for _, flown in fly_only(plan, options.only, how)]
    _show(plan, [each.record for each in flown])
    folder.mkdir(parents=True)
    results.write(plan, lambda: iter([f.record for f in flown]), folder)
    job = how.job(plan)
    for each in flown:
        k = options.only * len(plan.variants) + each.record["variant"]
        if each.record["outcome"] in ("timeout", "crashed"):
            continue  # it would take this process along
        flights: list[Any] = []
        fly_task(job, plan.task(k), keep=flights.append)
        for flight in flights:
            write_run_folder(flight, folder / flight_label(plan, k))
    print(f"wrote {folder}")
    return 0 if all(f.record["passed"] for f in flown) else 1


def _show(plan: Plan, records: list[dict[str, Any]]) -> None:
    """The rows as results.csv has them."""
    rows = results.csv_lines(plan, records)
    text = io.StringIO()
    writer = csv.DictWriter(
        text, list(dict.fromkeys(name for row in rows for name in row)), lineterminator="\n"
    )
    writer.writeheader()
    writer.writerows(rows)
    print(text.getvalue(), end="")
