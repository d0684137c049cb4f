"""Does a change leave all flights as they were? Fly two commits and compare what they write, byte by byte.

    python benchmarks/same_bytes.py BEFORE [AFTER] [--runs 64]

BEFORE and AFTER are commits; AFTER is the working tree if it is left out. Each commit flies every scenario in its own
scenarios/, the further flights of HARD, the shipped sweep, the first flights of the shipped searches by each method, and adopts
two models, with its own src/ and this Python. Compared are log.csv and summary.json of each flight, results.csv of the sweep and
the searches, and the files of the adopted aircraft. A table that has columns more than before is the same if the columns that
both have are; they are named, and so are files that BEFORE does not have. Exit status: 0 if all files of BEFORE are the same,
1 if one differs or is missing.

If all are the same, the digests of both programs are added to proven_equal.json, so that pages flown with BEFORE count as flown
with AFTER (`digests.py`).
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
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
SEARCHES = {
    "smallest gust": ("smallest_gust",),
    "smallest turbulence": ("smallest_turbulence",),
    **{name: ("rare_gust", f"method={name}") for name in ("adaptive", "subset", "importance", "plain")},
}
"""Shipped searches, each with the settings with which it is flown."""
BUDGET, ADOPTED = "60", ("c172p", "T37")
"""Flights of each search; models of the jsbsim package."""


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
    command = [sys.executable, "-m", "testbed", *arguments]
    done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"{tree}: {' '.join(command)} ended with {done.returncode}:\n{done.stderr}")


def flown(tree: Path, out: Path, runs: int) -> dict[str, bytes]:
    """The files that this tree's program writes: their contents, by their paths below `out`."""
    for scenario in sorted((tree / "scenarios").glob("*.yaml")):
        testbed(tree, "run", str(scenario), "--out", str(out / scenario.stem), "--no-plots")
    for name, settings in HARD.items():
        changes = [part for setting in ("requirements=[]", *settings) for part in ("--set", setting)]
        testbed(tree, "run", WEATHER, "--out", str(out / name), *changes, "--no-plots")
    testbed(tree, "sweep", SWEEP, "--runs", str(runs), "--out", str(out / "studies" / "sweep"), "--no-plots")
    for name, (search, *settings) in SEARCHES.items():
        changes = [part for setting in settings for part in ("--set", setting)]
        where = ["--budget", BUDGET, "--out", str(out / "studies" / name), "--no-plots"]
        testbed(tree, "search", f"scenarios/searches/{search}.yaml", *where, *changes)
    for model in ADOPTED:
        testbed(tree, "adopt", model, "--out", str(out / "adopted" / model))
    names = ("*/log.csv", "*/summary.json", "studies/*/results.csv", "adopted/*/*.yaml", "adopted/*/*.json")
    files = {file for name in names for file in out.glob(name)}
    return {str(file.relative_to(out)): file.read_bytes() for file in files}


def columns_of(table: bytes) -> dict[str, list[str]]:
    """The cells of a CSV file, as they are written, by column."""
    names, *rows = csv.reader(table.decode().splitlines())
    return dict(zip(names, map(list, zip(*rows, strict=True)), strict=True))


def compared(name: str, before: bytes | None, after: bytes | None) -> tuple[bool, str]:
    """Whether a file is the same before and after, and what is to be said of it; empty if nothing is."""
    if before is None or after is None:
        return before is None, f"only {'after' if before is None else 'before'}: {name}"
    if before == after:
        return True, ""
    if not name.endswith(".csv"):
        return False, f"differs: {name}"
    old, new = columns_of(before), columns_of(after)
    others = [column for column in old if old[column] != new.get(column)]
    if others:
        return False, f"differs: {name}: {', '.join(others)}"
    added = [column for column in new if column not in old]
    # The same cells of the same columns in other bytes: another order of the columns, or quotes.
    return bool(added), f"columns added: {name}: {', '.join(added)}" if added else f"differs: {name}"


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
    before, after = results
    names = sorted(before.keys() | after.keys())
    found = [compared(name, before.get(name), after.get(name)) for name in names]
    print(*(text for _, text in found if text), sep="\n")
    same = sum(is_same for is_same, _ in found)
    print(f"{same} of {len(names)} files are the same")
    if same < len(names):
        return 1
    prove(options.before, options.after, len(before))
    return 0


if __name__ == "__main__":
    sys.exit(main())
