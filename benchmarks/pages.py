"""Fly the pages of results again, and write into each with what it was flown.

    python benchmarks/pages.py --list              # the pages, what each costs, and which are older than the program
    python benchmarks/pages.py paper_table readme  # these
    python benchmarks/pages.py --stale             # those that are older than the program
    python benchmarks/pages.py --quick             # those that cost less than two minutes
    python benchmarks/pages.py                     # all: hours
    python benchmarks/pages.py --known gallery 61edc57    # flies nothing: the page as it is was flown with that commit

Costs are processor time of one core. `result_pages.py` says how each page is made and what it depends on.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import resource
import shlex
import subprocess
import sys
from collections.abc import Mapping, Sequence
from datetime import date
from pathlib import Path

from digests import ROOT
from result_pages import PAGES, Page
from same_bytes import checked_out
from stamps import NOT_RECORDED, Stamp, digests_of, environment, read, stamped

QUICK_S = 120


def main(arguments: Sequence[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    if options.known:
        return known(*options.known)
    pages = chosen(options.names)
    if options.stale:
        pages = [page for page in pages if page.stamped and older(page)]
    if options.quick:
        pages = [page for page in pages if page.cost_s <= QUICK_S]
    if options.list:
        return print("\n".join(_listed(page) for page in pages)) or 0
    print(
        f"{len(pages)} pages, some {sum(page.cost_s for page in pages):.0f} s of processor time", flush=True
    )
    for page in pages:
        make(page)
    return 0


def chosen(names: Sequence[str]) -> list[Page]:
    """The pages of these names, all if there are none; exits for a name that is no page's."""
    known = {page.name: page for page in PAGES}
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"{unknown[0]} is none of the pages: {', '.join(known)}")
    return [known[name] for name in names] or list(PAGES)


def older(page: Page) -> list[str]:
    """The parts that have changed since the page was flown; all of them if it has no stamp."""
    stamps = [read(file.read_text(encoding="utf-8")) for file in page.files]
    return sorted({part for stamp in stamps for part in (stamp.changed() if stamp else page.on)})


def make(page: Page) -> None:
    """Fly a page, and stamp it; exits if a command of it fails."""
    commit, before = _commit(), resource.getrusage(resource.RUSAGE_CHILDREN)
    digests, folders = digests_of(page.on), os.pathsep.join((str(ROOT / "src"), str(ROOT / "benchmarks")))
    for command in page.commands:
        run = [sys.executable, *_expanded(kept_apart(command, digests))]
        print(f"{page.name}: {command}", flush=True)
        if subprocess.run(run, cwd=ROOT, env={**os.environ, "PYTHONPATH": folders}, check=False).returncode:
            sys.exit(f"{page.name}: `python {command}` failed; the page keeps its stamp")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    put(page, Stamp(commit, f"{date.today()}", page.seeds, page.command, environment(), digests))
    print(f"{page.name}: {spent:.0f} s of processor time", flush=True)


def kept_apart(command: str, digests: Mapping[str, str]) -> str:
    """The command with a folder of this program's own in `runs/`: scripts go on with the flights that they find, and those of
    another program would come into the page under this one's stamp."""
    key = hashlib.sha256(json.dumps(dict(digests), sort_keys=True).encode()).hexdigest()[:12]
    folder = Path("runs") / key
    (ROOT / folder).mkdir(parents=True, exist_ok=True)
    return re.sub(r"(?<!\S)runs/", f"{folder}/", command)


def put(page: Page, stamp: Stamp) -> None:
    """Write the stamp into each of the page's files, unless the page has none."""
    for file in page.files if page.stamped else ():
        file.write_text(stamped(file.read_text(encoding="utf-8"), stamp), encoding="utf-8")


def known(name: str, commit: str, flown_in: str = NOT_RECORDED) -> int:
    """Stamp a page as it is with the commit that it was flown with, and the environment in words."""
    (page,) = chosen([name])
    day = git("show", "--no-patch", "--format=%cs", commit)
    with checked_out(commit) as tree:
        digests = {part: value for part, value in digests_of(page.on, tree).items() if value}
    put(page, Stamp(commit, day, page.seeds, page.command, flown_in, digests))
    return 0


def _expanded(command: str) -> list[str]:
    """The words of a command; one that ends in `/*` stands for the folders of aircraft there."""
    words: list[str] = []
    for word in shlex.split(command):
        place = ROOT / word.removesuffix("/*")
        words += (
            [
                f"{each.relative_to(ROOT)}"
                for each in sorted(place.iterdir())
                if (each / f"{each.name}.yaml").is_file()
            ]
            if word.endswith("/*")
            else [word]
        )
    return words


def _commit() -> str:
    """The commit that is checked out; `with changes` follows where files that flights depend on differ from it."""
    changed = git("status", "--porcelain", "--", "src", "aircraft", "scenarios")
    return git("rev-parse", "--short", "HEAD") + (" with changes" if changed else "")


def git(*arguments: str) -> str:
    """What git says in this repository."""
    run = ["git", "-C", str(ROOT), *arguments]
    return subprocess.run(run, check=True, capture_output=True, text=True).stdout.strip()


def _listed(page: Page) -> str:
    state = ", ".join(older(page)) if page.stamped else "its test flies it"
    return f"{page.name:<22} {page.cost_s:>6.0f} s  {f'older: {state}' if page.stamped and state else state or 'up to date'}"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help="pages; all by default")
    parser.add_argument(
        "--list", action="store_true", help="print the pages, their cost and their age; fly nothing"
    )
    parser.add_argument("--stale", action="store_true", help="only those that are older than the program")
    parser.add_argument("--quick", action="store_true", help=f"only those that cost at most {QUICK_S} s")
    parser.add_argument(
        "--known", nargs=2, metavar=("NAME", "COMMIT"), help="stamp a page as it is; fly nothing"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
