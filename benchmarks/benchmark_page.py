"""The page of benchmark results, from the folders that `testbed benchmark` flew and the entries of `leaderboard/`.

    python benchmarks/benchmark_page.py runs/benchmark runs/healthy --fly
    python benchmarks/benchmark_page.py runs/benchmark runs/healthy --commit 97ad5e2
    python benchmarks/benchmark_page.py runs/benchmark runs/healthy --beside runs/others --parts runs/ablations --more runs/more

The first folder is of the suite `open`, the second of `healthy`; with `--fly` they are flown, or their missing flights are.
Else a folder may be unfinished: the draws that every controller has flown count. Of folders `--beside` further controllers on
the same draws are taken. Those of `--parts` have the default with and without its parts, on the same draws; the page keeps what it
says of them if none is given. Those of `--acts` have it without one part each (`parts_where_they_act.py`) and take the place of
those that the page has. The one of `--more` has the default and its nearest rival on more draws: the groups are of these. With
`--commit` the page is stamped with the commit that flew them and the environment that they say. An entry is a folder in
`leaderboard/` with `entry.yaml`.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pages
import pandas as pd
import yaml

import testbed
from testbed.api import benchmark
from testbed.reporting.words import joined
from testbed.studies.benchmark import scores
from testbed.studies.folder import store
from testbed.study_reports.benchmark import markdown

SUITES, HEALTHY = ("open", "healthy"), 20  # and flights of each controller in `healthy`
ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "results" / "benchmark.md"
ENTRIES = ROOT / "leaderboard"
HEAD = """\
# Benchmark

<!-- Written by python benchmarks/benchmark_page.py: change that, not this. -->

This page compares controllers on flights that are drawn from a [suite](../reference/benchmark.md): any failure of any aircraft in
any weather. Their seed is made from a digest of the controllers' code and a word, here the hash of the
commit that froze the code. Its author could have committed again for another seed.
**Held** is flown to the end and never farther from the
references of altitude and heading than limits that grow with the aircraft's span and speed: a span and 0.45 s of flight, 10 m for
the v-tail at 18 m/s, and 20 deg. **Inside** is the share of the time within them.
"""
ROUGHEST_M_S = 15.24
"""W20 of 50 ft/s, to which a healthy flight must have no false alarm."""
NOTES = """\
## How to read it

Intervals are of 95 %: Wilson's of a share, Newcombe's of a difference of shares by pairs, Garwood's of a rate, the bootstrap's of a
mean or a rank. *Best of all* is the best controller in each draw; where some that are told the truth flew, they are among them, and
the table shows the best of these: what can be held is that or more. `indi_monitor` and `l1_inversion` have the
default's diagnosis, with its guard of stuck sensors. *Effort* is the
median ratio in the same draw.
[Columns and groups](../reference/benchmark.md#what-is-measured).
"""
HEALTHY_HEAD = """\
# Healthy flights

Suite `healthy`: flights of 900 s in which nothing fails, by the same limits, so that any flag is a false alarm.
"""


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="+", type=Path, help="folders of testbed benchmark")
    parser.add_argument(
        "--fly", action="store_true", help="fly the suites into the folders, and go on with what is there"
    )
    head = pages.git("rev-parse", "HEAD")[:12]
    parser.add_argument(
        "--word", default=f"commit {head}", help="from which, with the law's digest, the seed is made"
    )
    parser.add_argument(
        "--controller",
        action="append",
        default=[],
        metavar="NAME[=...]",
        help="as of `testbed benchmark`: only these in `open`, and those with settings too",
    )
    parser.add_argument("--draws", type=int, default=1000, help="flights of each controller in `open`")
    parser.add_argument(
        "--beside", nargs="+", type=Path, default=[], help="folders of other controllers, same draws"
    )
    parser.add_argument(
        "--parts", nargs="+", type=Path, default=[], help="folders of the default with and without parts"
    )
    parser.add_argument("--acts", nargs="+", type=Path, default=[], help="folders of kinds of flights")
    parser.add_argument(
        "--more", nargs="+", type=Path, default=[],
        help="folder of the default and its nearest rival on more draws, and folders of others on the same",
    )  # fmt: skip
    parser.add_argument("--remark", default="", help="what else a reader must know of the flights")
    parser.add_argument("--commit", help="that flew the folders, for the page's stamp")
    options = parser.parse_args(arguments)
    for folder, suite, draws in zip(options.folders, SUITES, (options.draws, HEALTHY), strict=False):
        if options.fly:
            chosen = options.controller if suite == SUITES[0] else ()
            testbed.benchmark(
                suite, folder, controllers=chosen, word=options.word, draws=draws, resume=folder.exists()
            )
    first, *others = options.folders
    summaries = [summary_of(first, options.beside)]
    summaries += [summary_of(other) | {"weather": by_roughness(other)} for other in others]
    law = summaries[0]["law_sha256"]
    parts = kept(PAGE.read_text(encoding="utf-8"), law)
    acts = [*map(summary_of, options.acts)]
    if options.parts:
        of_before = [] if acts else parts[2:]
        parts = [*parts_of(summary_of(options.parts[0], options.parts[1:]), law, acts), *of_before]
    elif acts:
        parts = [*without(parts[:2], acts), *where_they_act(acts, law)]
    more = nearest(options.more, summaries[0]) if options.more else []
    PAGE.write_text(text(summaries, parts, more, options.remark), encoding="utf-8")
    if options.commit:
        pages.known("benchmark", options.commit, environment_of(options.folders[0]))


def summary_of(folder: Path, beside: Sequence[Path] = ()) -> dict[str, Any]:
    """What the tables of a folder, and of others of the same draws, say; with the law's digest as the folder has it: its flights
    need not be of this commit. Exits if the others have other draws."""
    for each in (folder, *beside):
        if not (each / "results.csv").is_file():
            benchmark.rebuild(each)
    law = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["law_sha256"]
    plan, frames = benchmark.plan_of(folder), [benchmark.table(folder)]
    for other in beside:
        more = benchmark.plan_of(other)
        if (more.digest, more.study.seed) != (plan.digest, plan.study.seed):
            sys.exit(f"{other} has other draws than {folder}")
        new = [variant for variant in more.variants if variant.label not in plan.labels]
        flights = benchmark.table(other)
        frames.append(flights[flights["controller"].isin([variant.label for variant in new])])
        plan = replace(plan, builder=replace(plan.builder, variants=(*plan.variants, *new)))
    frame = pd.concat(frames)
    flown = frame.groupby("draw")["controller"].transform("nunique") == len(plan.labels)
    return scores.summarize(plan, frame[flown]) | {"law_sha256": law}


def by_roughness(folder: Path) -> str:
    """What a folder's flights in weather to `ROUGHEST_M_S`, and beyond, say, in two sentences."""
    with store.reading(folder) as stored:
        w20 = {record.run: (record.values.get("atmosphere") or {}).get("turbulence_w20_m_s", 0.0)
               for _, record in stored.records()}  # fmt: skip
    flights = benchmark.table(folder)
    rough = flights["draw"].map(w20) > ROUGHEST_M_S
    said = []
    for words, these in (("To 50 ft/s (W20)", flights[~rough]), ("Beyond", flights[rough])):
        each = [
            f"`{name}` holds {flown['held'].sum()}, false alarms in {flown['end_time_s'].sum() / 3600.0:.1f} h: "
            f"{flown['false_alarms'].sum():.0f}"
            for name, flown in these.groupby("controller")
        ]
        said.append(f"{words}, {these['draw'].nunique()} draws: {'; '.join(each)}.")
    return " ".join(said)


def parts_of(summary: dict[str, Any], law: str, acts: Sequence[dict[str, Any]] = ()) -> list[str]:
    """The lines of what each part of the default brings, also where it acts, which say it if they were flown with another law."""
    _, lines = cut(markdown(summary), "## What the parts of")
    before = summary["law_sha256"]
    other = "" if before == law else f", seed {summary['seed']}{_with_another(before)}"
    held = summary["scores"]["default"]["held"]["estimate"]
    of_all = f"Of the first {summary['draws']} draws, of which `default` holds {held:.3f}{other}."
    return ["", *lines, of_all, *where_they_act(acts, law)]


def _with_another(law: str) -> str:
    return f", flown with another law, `{law[:16]}`"


def where_they_act(summaries: Sequence[dict[str, Any]], law: str) -> Iterator[str]:
    """A table of what single parts bring in the kinds of flights that they are for: differences from the default."""
    if not summaries:
        return
    first, harm, unclear = summaries[0], [], []
    yield ""
    other = "" if first["law_sha256"] == law else _with_another(first["law_sha256"])
    yield f"Where they act: of each {first['draws']} draws with these failures alone, seed {first['seed']}{other}, minus `default`."
    yield from ("", "| flights | without | survived | held | inside |", "| --- | --- | --- | --- | --- |")
    for summary in summaries:
        for name in summary["ablated"]:
            against, without = summary["scores"][name]["against_reference"], summary["controllers"][name]
            cells = [_difference(against[key]) for key in ("survived", "held", "inside")]
            flights, parts = summary["suite"].replace("_", " "), ", ".join(without["ablate"])
            yield f"| {flights} | {parts} | {' | '.join(cells)} |"
            if against["held"]["low"] > 0.0:
                harm.append(f"{parts} on {flights}")
            elif against["held"]["high"] >= 0.0:
                unclear.append(f"{parts} on {flights}")
    if harm:
        yield from ("", f"**More is held without** {', '.join(harm)}.")
    if unclear:
        yield from ("", f"In *held* these are not clear of zero: {', '.join(unclear)}.")


def without(lines: Sequence[str], acts: Sequence[dict[str, Any]]) -> list[str]:
    """The lines without the rows of parts that are flown where they act: those say it with the present law."""
    rows = tuple(f"| `{name}` |" for summary in acts for name in summary["ablated"])
    return ["\n".join(row for row in each.split("\n") if not row.startswith(rows)) for each in lines]


def cut(lines: Sequence[str], title: str) -> tuple[list[str], list[str]]:
    """The lines without the section whose heading begins so, and those of the section; none if there is no such section."""
    level = f"{title.split()[0]} "
    begin = next((i for i, line in enumerate(lines) if line.startswith(title)), len(lines))
    end = next((i for i in range(begin + 1, len(lines)) if lines[i].startswith(level)), len(lines))
    return [*lines[:begin], *lines[end:]], [*lines[begin:end]]


def nearest(folders: Sequence[Path], first: dict[str, Any]) -> list[str]:
    """The lines of the default and its nearest rival on more draws, and what others, in the further folders, hold of the same.
    Exits if they are not of the same seed and law."""
    summary, of_all = summary_of(folders[0]), summary_of(folders[0], folders[1:])
    for key in ("seed", "law_sha256"):
        if summary[key] != first[key]:
            sys.exit(f"the flights of --more have another {key}")
    headline, *rest = markdown(summary)
    _, groups = cut(rest, "## By group")
    headline = headline.partition(" The best controller in each draw")[0]  # of two: no bound
    rivals = {
        name: score["against_reference"]
        for name, score in summary["scores"].items()
        if name in summary["controllers"] and name != summary["reference"]
    }
    rival = next(iter(rivals))
    alone = rivals[rival]["held"]["only_first"]
    differences = "; ".join(
        f"`{name}` {_difference(one['held'])} and {_difference(one['inside'])}"
        for name, one in rivals.items()
    )
    said = f"`{rival}` alone holds {alone} of {summary['draws']} draws. *Held* and *inside*, minus `default`: {differences}."
    flew = joined([f"`{name}`" for name in summary["controllers"]])
    words = f"{headline} {said} Only {flew} flew all of them, the first {first['draws']} of which are those above. {groups[2]}"
    tables = [re.sub(r" [^|]* \|$", "", line) for line in groups[3:]]  # best of all two says nothing more
    others = [name for name in of_all["scores"] if name not in summary["scores"]]
    against = {name: of_all["scores"][name]["against_reference"] for name in others}
    more = [_against(against, of_all["draws"]), ""] if others else []
    return ["", "## The nearest rival on more draws", "", *more, words, *tables]


def _against(others: dict[str, Any], draws: int) -> str:
    """Differences of controllers from the default in a sentence: of each in *held*, of the nearest in *inside*."""
    held = (f"`{name}` {_difference(one['held'])}" for name, one in others.items())
    name, best = max(others.items(), key=lambda each: each[1]["inside"]["estimate"])
    inside = _difference(best["inside"])
    all_held = f"On the first {draws} draws others flew, too. *Held*: {'; '.join(held)}."
    return f"{all_held} *Inside*, the nearest of these: `{name}`, {inside}."


def _difference(one: dict[str, float]) -> str:
    value = one["difference"] if "difference" in one else one["estimate"]
    return f"{value:+.3f} ({one['low']:+.3f} to {one['high']:+.3f})"


def kept(page: str, law: str) -> list[str]:
    """Those lines of a page that is there, with the law that they were flown with: they stay until others are flown."""
    section = re.search(r"^## What the parts of .*?^Of the first .*?$", page, re.DOTALL | re.MULTILINE)
    if section is None:
        return []
    acts = re.search(r"^Where they act: .*?(?=^## |\Z)", page, re.DOTALL | re.MULTILINE)
    table = ["", acts[0].rstrip()] if acts else []
    flown = re.search(r"seed (\d+), .*? digest `(\w+)`", page)
    if flown is None or law.startswith(flown[2]) or "another law" in section[0]:
        return ["", section[0], *table]
    other = _with_another(flown[2])
    before = f"{section[0].removesuffix('.')}, seed {flown[1]}{other}."
    said = (
        line if "another law" in line else line.replace(", minus `default`", f"{other}, minus `default`")
        for line in table
    )
    return ["", before, *said]


def environment_of(folder: Path) -> str:
    """In which environment a folder's flights were begun, in words."""
    with store.reading(folder) as stored:
        versions, calculates = stored.inputs["versions"], stored.inputs["arithmetic"]
    packages = ", ".join(f"{name} {version}" for name, version in versions.items() if name != "testbed")
    return (
        f"{packages}, {calculates['processor']}, BLAS kernel {calculates['kernel']}, {calculates['library']}"
    )


def text(
    summaries: Sequence[dict[str, Any]], parts: Sequence[str] = (), more: Sequence[str] = (), remark: str = ""
) -> str:
    """The page's Markdown."""
    first = markdown(summaries[0])
    if more:  # which has the groups
        first, _ = cut(first, "## By group")
    first, halves = cut(first, "## Two halves")
    first += ["", *halves[:3]] if halves else []  # the words: its table says the same twice
    lines = [HEAD, *([remark, ""] if remark else []), *first, *more, *parts]
    for summary in summaries[1:]:
        healthy = markdown(summary, "###")
        for empty in (
            "### Where `default`",
            "### Where the others",
            "### Two halves",
        ):  # where nothing breaks
            healthy, _ = cut(healthy, empty)
        lines += ["", f"#{HEALTHY_HEAD}", summary["weather"], "", *healthy]
    return "\n".join([*lines, "", NOTES, *leaderboard(sorted(ENTRIES.glob("*/entry.yaml")))]) + "\n"


def leaderboard(files: Sequence[Path]) -> Iterator[str]:
    """The table of entries, each of its own seed: so they are compared with the default on the same draws."""
    yield from (
        "## Entries",
        "",
        "`CONTRIBUTING.md` in the checkout says how to enter. A workflow flies a part of each again.",
        "",
    )
    if not files:
        yield "There is none yet."
        return
    yield "| entry | suite | draws | controller | survived | held | inside |"
    yield "| --- | --- | --- | --- | --- | --- | --- |"
    for file in files:
        said = yaml.safe_load(file.read_text(encoding="utf-8"))
        for name, one in said["controllers"].items():
            numbers = " | ".join(
                "{estimate:.3f} ({low:.3f} to {high:.3f})".format(**one[key])
                for key in ("survived", "held", "inside")
            )
            yield f"| {file.parent.name} | {said['suite']} {said['version']} | {said['draws']} | `{name}` | {numbers} |"


if __name__ == "__main__":
    main()
