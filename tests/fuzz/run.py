"""Fuzz the program: give it mutants of the shipped files for as long as asked, and count what comes of them.

    python tests/fuzz/run.py --kind scenario --count 10000 --seed 1
    python tests/fuzz/run.py --minutes 30            all kinds in turn, with further seeds

Mutants are made by hypothesis (`mutants`) and looked at in processes that may die (`examine`). Every mutant that does not end
in words, or computes longer than 10 s, is written into --keep. Exit status: 0 if there is none, 1 if there is one.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from mutants import KINDS, ROOT, Mutant

sys.path.append(str(ROOT / "tests" / "support"))
import compiled_code

LONGEST_S = 10.0
"""Longest computing time for one mutant [s]: the program promises an answer within it."""
_BUSY = 60
"""On the clock, at most this many times as long: a busy machine gives it a small share."""
_ROUND = 200
"""Mutants that are drawn with one seed."""
_COMPILE_S = 1800.0
"""On the clock, the longest start of the process that looks at mutants."""
BAD = ("DEFECT", "HANG", "DIED")
"""Outcomes that must not be."""


class Examiner:
    """A process of `examine`, whose forks look at mutants."""

    def __init__(self, cache: str) -> None:
        """Start the process; raises TimeoutError when it is not ready in time, RuntimeError when it ends instead."""
        # Its own folder for records, because each mutant of an aircraft leaves one; compiled code is that of other flights.
        environment = {
            **os.environ,
            "PYTHONPATH": str(ROOT / "src"),
            "OPENBLAS_NUM_THREADS": "1",
            "PYTHONDONTWRITEBYTECODE": "1",  # else a first import is heard as a file written outside
            **compiled_code.environment(Path(cache)),
        }
        command = [sys.executable, str(Path(__file__).with_name("examine.py"))]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env=environment, bufsize=0,
        )  # fmt: skip
        assert self._process.stdin is not None and self._process.stdout is not None
        self._requests, self._answers = self._process.stdin, self._process.stdout
        try:
            self._fork = self._next_fork()
        except BaseException:
            self._process.kill()
            raise

    def examine(self, request: dict[str, Any], longest_s: float = LONGEST_S) -> dict[str, str]:
        """The outcome of a mutant; see `examine`. Besides, HANG and DIED, and `ended JSBSim`, which a first load reports."""
        self._requests.write(json.dumps(request).encode() + b"\n")
        self._requests.flush()
        stage, begun, used = "starting", time.monotonic(), _cpu_s(self._fork)
        while True:
            answer = self._answer(_LOOK_S)
            if answer is None:
                used_s, waited_s = _cpu_s(self._fork) - used, time.monotonic() - begun
                if used_s < longest_s and waited_s < _BUSY * longest_s:
                    continue
                with suppress(ProcessLookupError):
                    os.kill(self._fork, signal.SIGKILL)
                self._fork = self._next_fork()
                return {"outcome": "HANG", "words": f"no answer after {used_s:.0f} s of {stage}"}
            if "outcome" in answer:
                return answer
            if "ended" in answer:
                self._fork = self._next_fork()
                outcome = "ended JSBSim" if stage == "loading" else "DIED"
                return {"outcome": outcome, "words": f"exit status {answer['ended']} while {stage}"}
            stage = answer["stage"]

    def close(self) -> None:
        """End the process."""
        self._requests.close()
        self._answers.close()
        self._process.wait()

    def _next_fork(self) -> int:
        """Wait for the next fork, and return its process; raises TimeoutError when there is none."""
        until = time.monotonic() + _COMPILE_S
        while (answer := self._answer(max(until - time.monotonic(), 0.0))) is not None:
            if "pid" in answer:
                return int(answer["pid"])
        raise TimeoutError("the process that looks at mutants does not start")

    def _answer(self, longest_s: float) -> dict[str, Any] | None:
        """The next answer; None if there is none for so long. Raises RuntimeError when the process itself has ended."""
        if not select.select([self._answers], [], [], longest_s)[0]:
            return None
        line = self._answers.readline()
        if not line:
            raise RuntimeError(f"the process that looks at mutants ended: exit status {self._process.wait()}")
        answer: dict[str, Any] = json.loads(line)
        return answer


_LOOK_S = 0.05  # how often an answer is looked for


def _cpu_s(pid: int) -> float:
    """Computing time of a process [s]: on a busy machine the time on the clock says little."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except (FileNotFoundError, ProcessLookupError):  # it has ended, which its last answer says
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@dataclass
class Found:
    """What came of the mutants of one kind: number of each outcome, slowest [s], and the bad ones."""

    outcomes: Counter[str] = field(default_factory=Counter)
    slowest_s: float = 0.0
    bad: list[tuple[dict[str, str], Mutant]] = field(default_factory=list)

    def add(self, answer: dict[str, str], mutant: Mutant, seconds: float) -> None:
        self.outcomes[answer["outcome"]] += 1
        self.slowest_s = max(self.slowest_s, seconds)
        if answer["outcome"] in BAD:
            self.bad.append((answer, mutant))


def fuzz(
    kind: str, count: int, number: int, examiner: Examiner, fly_every: int = 1, until: float = float("inf")
) -> Found:
    """Examine `count` mutants of a kind, drawn with the seed `number`; every `fly_every`-th valid one is flown."""
    found, counter = Found(), itertools.count()

    @seed(number)
    @settings(max_examples=count, deadline=None, database=None, phases=[Phase.generate],
              suppress_health_check=list(HealthCheck))  # fmt: skip
    @given(KINDS[kind])
    def examined(mutant: Mutant) -> None:
        if time.monotonic() > until:
            return
        begun = time.monotonic()
        fly = next(counter) % fly_every == 0
        answer = examiner.examine({"kind": kind, "files": mutant, "fly": fly})
        found.add(answer, mutant, time.monotonic() - begun)

    examined()
    return found


@contextmanager
def examiners() -> Iterator[Examiner]:
    """An examiner that is ended with the block."""
    with tempfile.TemporaryDirectory() as cache:
        examiner = Examiner(cache)
        try:
            yield examiner
        finally:
            examiner.close()


def keep(found: Found, kind: str, folder: Path) -> None:
    """Write the bad mutants into a folder, each with what was said of it."""
    for i, (answer, mutant) in enumerate(found.bad):
        for name, text in {**mutant, "outcome.json": json.dumps(answer, indent=1)}.items():
            file = folder / f"{kind}-{i:03d}" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(text.encode("utf-8", "surrogatepass"))


def _rounds(options: argparse.Namespace) -> Iterator[tuple[str, int, int]]:
    """(kind, seed, mutants) of each round; each is short, so that its result is seen soon."""
    kinds = [options.kind] if options.kind else list(KINDS)
    if options.minutes:
        yield from ((kind, number, _ROUND) for number in itertools.count(options.seed) for kind in kinds)
    for kind in kinds:
        for i, first in enumerate(range(0, options.count, _ROUND)):
            yield kind, options.seed + i, min(_ROUND, options.count - first)


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kind", choices=KINDS, help="default: all kinds")
    parser.add_argument("--count", type=int, default=1000, help="mutants of each kind (default: 1000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, help="go on for so long, with any number of mutants")
    parser.add_argument(
        "--fly-every", type=int, default=1, metavar="N", help="fly every Nth mutant that is valid"
    )
    parser.add_argument("--keep", type=Path, default=Path("fuzz-found"), help="folder for bad mutants")
    options = parser.parse_args()
    until = time.monotonic() + 60.0 * options.minutes if options.minutes else float("inf")
    totals: dict[str, Counter[str]] = {}
    slowest: dict[str, float] = {}
    with examiners() as examiner:
        for kind, number, count in _rounds(options):
            found = fuzz(kind, count, number, examiner, options.fly_every, until)
            totals[kind] = totals.get(kind, Counter()) + found.outcomes
            slowest[kind] = max(slowest.get(kind, 0.0), found.slowest_s)
            keep(found, f"{kind}-{number}", options.keep)
            _print(f"{kind}, seed {number}", found)
            if time.monotonic() > until:
                break
    print("total")
    for kind, outcomes in totals.items():
        print(_line(kind, outcomes, slowest[kind]))
    return 1 if any(outcomes[bad] for outcomes in totals.values() for bad in BAD) else 0


def _print(what: str, found: Found) -> None:
    print(_line(what, found.outcomes, found.slowest_s), flush=True)
    for words, times in Counter(answer["words"] for answer, _ in found.bad).most_common(20):
        print(f"  {times} x {words}", flush=True)


def _line(what: str, outcomes: Counter[str], slowest_s: float) -> str:
    counts = ", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.items()))
    return f"{what}: {outcomes.total()} mutants: {counts}; slowest {slowest_s:.1f} s"


if __name__ == "__main__":
    sys.exit(main())
