"""The report of a sweep folder: one page with the answer, the map of its flights, what drives it, and every flight.

Any number of its summary.json may be None.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from operator import itemgetter
from pathlib import Path
from typing import Any

from testbed.inputs.received import read_json
from testbed.reporting import html
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.words import DIGITS, interval, number, passing, setting, title
from testbed.studies.folder import table
from testbed.studies.folder.logs import flight_label
from testbed.study_reports.sweep.answer import answer, ranked
from testbed.study_reports.sweep.curves import for_the_script
from testbed.study_reports.sweep.flight_page import FOLDER, only

_CAPTIONS = {
    "probabilities": "Probability that each requirement is met, with 95 % intervals (Wilson).",
    "map": "Every flight, by the two varied numbers that matter most: passed, missed and lost.",
    "pass_share": "Share of flights that pass along each varied value; 95 % intervals.",
    "envelope": "Errors in time: median, 5 to 95 % of the flights still flying, and the flight with the largest.",
    "detection_delay": "Detection delays of the flights in which something was detected.",
    "drivers": "Which varied values decide whether a flight passes: PAWN index (Pianosi and Wagener 2018).",
}
_PLACES = Html("""<div class="moving">
<h2>Where it passes, and where it does not</h2><div id="map"></div>
<h2>The share that passes along each varied value</h2><div id="shares"></div>
<h2>Errors in time</h2><div id="errors"></div>
<h2>Every flight</h2><div id="flights"></div>
</div>""")
"""What the script fills."""
Summary = Mapping[str, Any]


def write_sweep_report(folder: str | Path) -> Path:
    """Write report.html from summary.json, the table and figures/ of a sweep folder; returns the file.

    Without a table, as in a folder with nothing but summary.json, the page has no moving parts. Raises OSError when
    summary.json is missing or the report cannot be written.
    """
    folder = Path(folder).resolve()
    summary = read_json(folder / "summary.json", "the summary that testbed wrote")
    file, name = folder / "report.html", summary["sweep"]
    if not (folder / "sweep.yaml").is_file() or not len(frame := table.load(folder)):
        return html.write_page(file, name, parts(summary, folder))
    data = {"sweep": for_the_script(table.load_plan(folder), frame, folder)}
    return html.write_page(file, name, parts(summary, folder, moving=True), "sweep.js", data)


def parts(summary: Summary, folder: Path, *, moving: bool = False) -> Iterator[Part]:
    """The sections of the report in their order; with `moving`, the places that the script fills."""
    yield head(summary)
    yield probabilities(summary)
    yield pairs(summary)
    if moving:
        yield _PLACES
    yield drivers(summary)
    still = [html.figures(folder / "figures", _CAPTIONS), worst(summary, folder)]
    yield tag("div", still, class_="still")
    yield excursions(summary)
    yield runs_needed(summary)


def head(summary: Summary) -> Iterator[Html]:
    """Title, chips, the answer in sentences."""
    yield html.opening(summary["sweep"], answer(summary), _facts(summary))
    if not summary["probabilistic"]:
        yield html.note(
            "These runs are not a random sample: the shares describe the runs flown and are not probabilities."
        )


def _facts(summary: Summary) -> dict[str, str]:
    asked = "" if summary["complete"] else f" of {summary['runs_asked']}"
    facts = {
        "runs": f"{summary['runs']}{asked}",
        "sampling": str(summary["sampling"]),
        "seed": str(summary["seed"]),
    }
    if len(summary["variants"]) > 1:
        facts["compared"] = ", ".join(variant["label"] for variant in summary["variants"])
    code = {
        f"code of {name}": digest[:DIGITS] for name, digest in summary.get("controllers_sha256", {}).items()
    }
    return facts | {"varied": ", ".join(map(setting, summary["varied"]))} | code


def probabilities(summary: Summary) -> Iterator[Html]:
    """Dots with intervals for each requirement, those missed most first, and how flights ended."""
    variants = summary["variants"]
    yield tag("h2", "How often the requirements are met")
    if len(variants) > 1:
        yield html.legend([variant["label"] for variant in variants])
    each = list(zip(*(variant["requirements"] for variant in variants), strict=True))
    each.sort(
        key=lambda shares: min(1.0 if share["estimate"] is None else share["estimate"] for share in shares)
    )
    total = _dots(passing(each), [v["all_requirements"] for v in variants], "total")
    yield tag("div", total, (_dots(shares[0]["name"], shares) for shares in each), _ends(), class_="dots")
    ended = {"": lambda v: v["label"] or "all", "how flights ended": lambda v: _outcomes(v["outcomes"])}
    yield html.listing(variants, ended)
    yield html.note(
        "Share of flights and 95 % interval (Wilson); summary.json also has the exact interval (Clopper-Pearson). A "
        "flight without a result counts as having met no requirement. What a controller does not say is not judged."
    )


def _dots(name: str, shares: Sequence[Mapping[str, Any]], kind: str = "") -> Html:
    lines = tag("div", (_dot(i, share) for i, share in enumerate(shares)), class_="lines")
    return tag("div", tag("div", name, class_="name"), lines, class_=f"requirement {kind}")


def _ends() -> Html:
    """The numbers of the axis."""
    numbers = tag("div", [tag("span", f"{share} %") for share in (0, 50, 100)], class_="ends")
    line = tag("div", numbers, tag("div", "", class_="number"), class_="line")
    return tag("div", tag("div", "", class_="name"), tag("div", line, class_="lines"), class_="requirement")


def _dot(i: int, share: Mapping[str, Any]) -> Html:
    known = not any(share[k] is None for k in ("low", "estimate", "high"))
    inside, said, count = None, "not judged" if share.get("not_judged") else "no runs", None
    if known:
        low, at, high = (100 * share[k] for k in ("low", "estimate", "high"))
        line = tag("i", class_=f"v{i % 6}", style=f"left:{low:.2f}%;width:{high - low:.2f}%")
        inside = [line, tag("span", html.mark(i), style=f"left:{at:.2f}%")]
        said, count = interval(share), f"{share['successes']} of {share['n']} flights"
        if others := share.get("not_judged"):
            count += f", {others} not judged"
    number = tag("div", said, class_="number", title=count)
    return tag("div", tag("div", inside, class_="track"), number, class_="line")


def _outcomes(outcomes: Mapping[str, int]) -> Html:
    return html.joined((f"{count} {title(name)}" for name, count in outcomes.items()), tag("br"))


def pairs(summary: Summary) -> Iterator[Html]:
    """The variants compared run by run."""
    if not summary["pairs"]:
        return
    columns = {
        "": lambda pair: f"{pair['first']} minus {pair['second']}",
        "difference in P(all)": lambda pair: interval(pair, "difference", "+.3f"),
        "only the first passed": lambda pair: pair["only_first"],
        "only the second passed": lambda pair: pair["only_second"],
        "p (exact McNemar)": lambda pair: number(pair["p_value"], ".2g"),
    }
    yield tag("h2", "Compared, run by run")
    yield html.listing(summary["pairs"], columns)


def excursions(summary: Summary) -> Iterator[Html]:
    """Quantiles and tolerance bounds of the metrics."""
    metrics = [
        {"label": variant["label"], "name": name, **metric}
        for variant in summary["variants"]
        for name, metric in variant["metrics"].items()
    ]
    columns: dict[str, Callable[[Summary], html.Cell]] = {
        "": itemgetter("label"),
        "metric": itemgetter("name"),
        "median": itemgetter("median"),
        "95 %": itemgetter("p95"),
        "largest": itemgetter("largest"),
    }
    for share in metrics[0]["tolerance_bounds"] if metrics else ():
        columns[f"{100 * float(share):g} % stay within"] = lambda metric, share=share: number(  # type: ignore[misc]
            metric["tolerance_bounds"][share], absent="too few"
        )
    said = html.note(
        "The last columns are upper bounds that hold with 95 % confidence for any distribution (order "
        "statistics, Wilks 1941). A lost flight counts as an infinite error. 'too few': more runs are needed "
        "for such a bound."
    )
    inside = html.listing((metric for metric in metrics if metric["n"]), columns) + said
    yield html.folded("How large every metric became", inside)


def drivers(summary: Summary) -> Iterator[Html]:
    """What passing depends on, as bars; and the indices of other results."""
    variants = summary["variants"]
    yield tag("h2", "Which varied values drive the result")
    for i, variant in enumerate(variants):
        if len(variants) > 1:
            yield tag("h3", html.mark(i), " ", variant["label"])
        yield from _bars(variant["sensitivity"].get("passed", {}), variant["all_requirements"]["n"], i)
    yield html.note(
        "Bars: how far the share that passes moves when one value is held in a part of its range (PAWN index, Pianosi and "
        "Wagener 2018). The line is what random numbers reach: what stays below it has no effect that these runs show."
    )
    rows = [
        row
        for variant in variants
        for output, result in variant["sensitivity"].items()
        for row in _indices(variant["label"], output, result)
    ]
    heads = ["", "result", "varied value", "PAWN", "share of variance (RBD-FAST)"]
    yield html.folded("Indices of every result", html.table(heads, rows))


def _bars(result: Mapping[str, Any], runs: int, i: int) -> Iterator[Html]:
    inputs = result.get("inputs")
    if not inputs:
        yield html.note(f"No answer: {result.get('reason', 'nothing varies')}.")
        return
    if result.get("indicative"):
        yield html.note(f"Indicative: {runs} runs; 100 give an answer.")
    yield tag("div", (_bar(name, index, i) for name, index in ranked(inputs)), class_="drivers")


def _bar(name: str, index: Mapping[str, Any], i: int) -> Html:
    size, chance = (min(index[k] or 0.0, 1.0) for k in ("pawn", "pawn_by_chance"))
    return html.bar(
        setting(name), size, number(index["pawn"], ".2f"), i, chance, "" if index["matters"] else " weak"
    )


def _indices(label: str, output: str, result: Mapping[str, Any]) -> Iterator[Html]:
    if "reason" in result:
        yield html.row([label, output, tag("span", result["reason"], class_="note"), "", ""])
    for name, index in ranked(result.get("inputs", {})):
        weak = not index["matters"] and index["pawn"] is not None
        words = setting(name)
        about = [words, " ", tag("span", "no more than chance", class_="note")] if weak else words
        share = number(index["s1"], ".2f")
        if index["s1"] is not None:
            share += f" ± {number(index['s1_half_width'], '.2f', absent='unknown')}"
        yield html.row([label, output, html.joined(about), number(index["pawn"], ".2f"), share])


def worst(summary: Summary, folder: Path) -> Iterator[Html]:
    """The worst flights, each with what it missed, its page or the command that flies it again."""
    flights = [
        {"label": variant["label"], **flight}
        for variant in summary["variants"]
        for flight in variant["worst"]
    ]

    def again(flight: Summary) -> Html:
        page = f"{FOLDER}/{flight_label(flight['run'], flight['label'])}.html"
        if (folder / page).is_file():
            return html.link("report", page)
        return tag("code", only(flight["run"], "", f"{folder.name}/sweep.yaml"))

    columns: dict[str, Callable[[Summary], html.Cell]] = {
        "": itemgetter("label"),
        "run": lambda flight: str(flight["run"]),
        "ended": lambda flight: title(flight["outcome"]),
        "missed by most": lambda flight: flight.get("missed") or flight.get("reason") or "",
        "margin": lambda flight: number(flight.get("margin"), ".3g"),
        "its page, or the command that flies it, from the parent folder": again,
    }
    yield tag("h2", "The worst flights")
    yield html.listing(flights, columns) if flights else tag("p", "None failed.")


def runs_needed(summary: Summary) -> Iterator[Html]:
    """How many runs a claim needs."""
    rows = []
    for variant in summary["variants"]:
        needed = variant["runs_needed"]
        for claim, runs in needed["claim_without_a_failure"].items():
            words = f"P(all) is at least {claim}, with 95 % confidence"
            now = number(needed["claim_with_failures_as_now"][claim], absent="not at the present share")
            rows.append(html.row([variant["label"], words, number(runs), now]))
        for width, runs in needed["half_width"].items():
            rows.append(html.row([variant["label"], f"P(all) to ± {width}", "", number(runs)]))
    heads = ["", "claim", "runs without a failure", "runs with the failures seen so far"]
    yield html.folded("How many runs a claim needs", html.table(heads, rows))
