"""Does a change leave all flights as they were? Fly two commits and compare what they write, byte by byte.

    python benchmarks/same_bytes.py BEFORE [AFTER] [--runs 64]

BEFORE and AFTER are commits; AFTER is the working tree if it is left out. Each commit flies every scenario in its own
scenarios/, the further flights of HARD and the shipped sweep, with its own src/ and this Python. Compared are summary.json of
each flight, and the columns of log.csv and of the sweep's results.csv that BEFORE has; further columns and scenarios are named.
Exit status: 0 if all are the same, 1 if something differs or is missing.

If all are the same, the digests of both programs are added to proven_equal.json, so that the pages flown with BEFORE count as
flown with AFTER (`digests.py`).
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from digests import EQUAL, PROVABLE, digest, proofs

ROOT = Path(__file__).parents[1]
SWEEP = "scenarios/sweeps/left_tail_monte_carlo.yaml"
WEATHER = "scenarios/mems_turbulence.yaml"
_LOST = "{{type: effectiveness, actuator: {}, at_s: 20, value: 0}}"
HARD = {
    "newton": ["controller={type: adaptive_inversion, estimation: newton, released: [], filter_rad_s: 20}"],
    "fixed": ["controller={type: fixed_inversion, released: [p_dot]}"],
    "pid": ["controller={type: pid}"],
    "indi": ["controller={type: indi, released: [p_dot]}"],
    "both tails": [f"failures=[{_LOST.format('left_ruddervator')}, {_LOST.format('right_ruddervator')}]"],
    "opposite": [f"failures=[{_LOST.format('left_ruddervator')}, {_LOST.format('right_propeller')}]"],
    "both propellers": [f"failures=[{_LOST.format('left_propeller')}, {_LOST.format('right_propeller')}]"],
    "jam": ["failures=[{type: stuck_at, actuator: left_ruddervator, at_s: 20, value: 5}]"],
    "propeller jam": ["failures=[{type: hardover, actuator: right_propeller, at_s: 20}]"],
    "reversal": ["failures=[{type: reversal, actuator: left_ruddervator, at_s: 20}]"],
}
"""Settings of further flights in weather, which reach modes, jams and controllers that no shipped scenario reaches."""


@contextmanager
def checked_out(commit: str | None) -> Iterator[Path]:
    """A folder with the files of a commit; the working tree for None."""
    if commit is None:
        yield ROOT
        return
    with tempfile.TemporaryDirectory() as folder:
        git = ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", folder, commit], check=True)
        try:
            yield Path(folder)
        finally:
            subprocess.run([*git, "remove", "--force", folder], check=True)


def testbed(tree: Path, *arguments: str) -> None:
    """Run a command of that tree's testbed; exits unless its status is 0 or 1 (1: a requirement is not met)."""
    # One BLAS thread: until the design of control modes saw to that itself, more changed the last bits of some.
    environment = {**os.environ, "PYTHONPATH": str(tree / "src"), "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-m", "testbed", *arguments, "--no-plots"]
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"{tree}: {' '.join(command)} ended with {done.returncode}:\n{done.stderr}")


def flown(tree: Path, out: Path, runs: int) -> dict[str, bytes]:
    """The files that this tree's program writes: their contents, by their paths below `out`."""
    for scenario in sorted((tree / "scenarios").glob("*.yaml")):
        testbed(tree, "run", str(scenario), "--out", str(out / scenario.stem))
    for name, settings in HARD.items():
        changes = [part for setting in ("requirements=[]", *settings) for part in ("--set", setting)]
        testbed(tree, "run", WEATHER, "--out", str(out / name), *changes)
    testbed(tree, "sweep", SWEEP, "--runs", str(runs), "--out", str(out / "sweep"))
    names = ("*/log.csv", "*/summary.json", "sweep/results.csv")
    files = {file for name in names for file in out.glob(name) if file != out / "sweep" / "summary.json"}
    return {str(file.relative_to(out)): file.read_bytes() for file in files}


def common(before: bytes, after: bytes) -> tuple[bool, list[str]]:
    """Whether two tables are the same in the columns of the first, text by text, and the further columns of the second."""
    old, new = (list(csv.reader(io.StringIO(text.decode()))) for text in (before, after))
    if not set(old[0]) <= set(new[0]):
        return False, []
    places = [new[0].index(name) for name in old[0]]
    same = before == after or old == [[row[place] for place in places] for row in new]
    return same, [name for name in new[0] if name not in old[0]]


def compared(before: Mapping[str, bytes], after: Mapping[str, bytes]) -> tuple[list[str], list[str]]:
    """What differs or is missing, and what AFTER has more, each as a line."""
    differing: list[str] = []
    further = [f"only after: {name}" for name in sorted(after.keys() - before.keys())]
    columns: set[str] = set()
    for name in sorted(before):
        if name not in after:
            differing.append(f"missing: {name}")
            continue
        same = before[name] == after[name]
        if name.endswith(".csv"):
            same, more = common(before[name], after[name])
            columns |= set(more)
        differing += [] if same else [f"differs: {name}"]
    return differing, further + [f"only after: column {name}" for name in sorted(columns)]


def prove(before: str, after: str | None, files: int) -> None:
    """Add to EQUAL that the two programs fly the same."""
    trees = []
    for commit in (before, after):
        with checked_out(commit) as tree:
            trees.append({part: value for part in PROVABLE if (value := digest(part, tree))})
    entry = {"commit": before, "files": files, "before": trees[0], "after": trees[1]}
    if entry not in proofs():
        EQUAL.write_text(json.dumps([*proofs(), entry], indent=1) + "\n", encoding="utf-8")
        print(f"wrote {EQUAL}")


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("before")
    parser.add_argument("after", nargs="?")
    parser.add_argument("--runs", type=int, default=64, help="runs of the sweep (default: 64)")
    options = parser.parse_args()
    results = []
    for commit in (options.before, options.after):
        with checked_out(commit) as tree, tempfile.TemporaryDirectory() as out:
            results.append(flown(tree, Path(out), options.runs))
    differing, further = compared(*results)
    for line in [*differing, *further]:
        print(line)
    print(f"{len(results[0]) - len(differing)} of {len(results[0])} files are the same")
    if not differing:
        prove(options.before, options.after, len(results[0]))
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
