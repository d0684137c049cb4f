"""Is a flight a pure function? Fly one scenario a thousand times under all that must not matter, and count the digests.

    python benchmarks/repeatability.py [--flights 1000] [--seconds 5] [SCENARIO]

Half of the flights are flown in processes that differ in hash seed, time zone, locale, threads, optimisation, cache of compiled
code and working folder; the other half in sweeps of one, two and three jobs, each killed and resumed on its way. The digest of
a flight is that of its record (metrics, verdicts), its error history and its log. Exit status: 0 if all are the same, else 1.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.folder import store
from testbed.studies.load import load_sweep
from testbed.studies.record import Record

ROOT = Path(__file__).parents[1]
SCENARIO = ROOT / "scenarios" / "mems_turbulence.yaml"
_BATCH = 20
"""Flights in one process, and so under the same conditions."""


def written(folder: Path, scenario: Path, seconds: float, flights: int) -> Path:
    """A sweep whose runs are all the same flight, because the table of cases gives them one seed."""
    (folder / "cases.csv").write_text("seed\n" + "7\n" * flights)
    failures = "[{type: effectiveness, actuator: left_ruddervator, at_s: 0.5, value: 0}]"
    file = folder / "same.yaml"
    file.write_text(
        f"scenario: {scenario}\ncases: cases.csv\n"
        f"set: {{duration_s: {seconds:g}, failures: {failures}, commands: [], requirements: []}}\n"
    )
    return file


def digest(record: Record, history: bytes, log: bytes) -> str:
    """Digest of a flight; the number of its run is no part of it."""
    text = json.dumps({**vars(record), "run": 0}, sort_keys=True)
    return hashlib.sha256(text.encode() + history + log).hexdigest()[:16]


def here(sweep: Path, flights: int) -> None:
    """Fly in this process, and print the digest of each flight."""
    plan = load_sweep(sweep)
    for k in range(flights):
        flown = fly_task(Job(plan.builder, save_logs="all"), plan.task(k))
        print(digest(flown.record, flown.history, flown.log), flush=True)


def conditions(rng: random.Random, folder: Path) -> dict[str, str]:
    """An environment drawn at random."""
    threads = {name: rng.choice("1234") for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")}
    drawn = {
        "PYTHONHASHSEED": str(rng.randrange(2**32)),
        "TZ": rng.choice(["UTC", "Asia/Kolkata", "America/St_Johns", "Pacific/Chatham"]),
        "LC_ALL": rng.choice(["C", "C.UTF-8", "de_DE.UTF-8", "POSIX"]),
        "PYTHONOPTIMIZE": rng.choice(["", "1", "2"]),
        "PYTHONUTF8": rng.choice("01"),
        "MALLOC_PERTURB_": rng.choice(["0", "165"]),
    }
    if rng.random() < 0.1:  # compiled anew
        drawn["NUMBA_CACHE_DIR"] = str(folder / f"code-{rng.randrange(10**9)}")
    return {**os.environ, "PYTHONPATH": str(ROOT / "src"), **threads, **drawn}


def in_processes(folder: Path, sweep: Path, flights: int) -> Iterator[str]:
    """Digests of flights in processes that differ in all but the flight."""
    rng = random.Random(1)
    for i in itertools.count():
        if flights <= 0:
            return
        cwd = folder / f"here {i} ü"
        cwd.mkdir()
        count = min(_BATCH, flights)
        command = [sys.executable, __file__, "--child", str(count), str(sweep)]
        environment = conditions(rng, folder)
        yield from subprocess.check_output(command, cwd=cwd, env=environment, text=True).split()
        flights -= count


def in_sweeps(folder: Path, sweep: Path, flights: int) -> Iterator[str]:
    """Digests of flights in sweeps that are killed once and resumed."""
    for jobs in (1, 2, 3):
        out, count = folder / f"sweep-{jobs}", flights // 3 + (jobs <= flights % 3)
        command = [
            sys.executable,
            "-m",
            "testbed",
            "sweep",
            str(sweep),
            "--out",
            str(out),
            "--jobs",
            str(jobs),
        ]
        command += ["--runs", str(count), "--save-logs", "all", "--no-plots"]
        environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
        while process.poll() is None and finished(out) < count // 2:
            time.sleep(0.1)
        process.send_signal(signal.SIGKILL)
        process.wait()
        resumed = subprocess.run(
            [*command, "--resume"], env=environment, stdout=subprocess.DEVNULL, check=False
        )
        if resumed.returncode not in (0, 1):
            sys.exit(f"the resumed sweep ended with {resumed.returncode}")
        yield from in_folder(out)


def finished(out: Path) -> int:
    """Number of finished flights of a sweep folder."""
    if not store.exists(out):
        return 0
    with store.reading(out) as flights:
        return len(flights)


def in_folder(out: Path) -> Iterator[str]:
    """Digests of the flights of a sweep folder."""
    with store.reading(out) as flights:
        for key, record in flights.records():
            log = out / "logs" / f"run-{record.run:06d}.parquet"
            yield digest(record, flights.history(key), log.read_bytes())


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("scenario", nargs="?", type=Path, default=SCENARIO)
    parser.add_argument("--flights", type=int, default=1000)
    parser.add_argument("--seconds", type=float, default=5.0, help="duration of each flight (default: 5)")
    parser.add_argument("--child", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        here(options.scenario, options.child)
        return 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        sweep = written(folder, options.scenario.resolve(), options.seconds, options.flights)
        half = options.flights // 2
        counts = {
            "processes": Counter(in_processes(folder, sweep, half)),
            "sweeps": Counter(in_sweeps(folder, sweep, options.flights - half)),
        }
    for where, found in counts.items():
        print(f"{found.total()} flights in {where}: " + ", ".join(f"{n} x {d}" for d, n in found.items()))
    digests = set().union(*counts.values())
    total = sum(found.total() for found in counts.values())
    print(f"{total} flights, {len(digests)} digest{'s' if len(digests) != 1 else ''}")
    return 0 if len(digests) == 1 and total == options.flights else 1


if __name__ == "__main__":
    sys.exit(main())
