"""The report of a sweep folder, written from summary.json and its figures. Any number in summary.json may be None."""

from __future__ import annotations

import json
from collections.abc import Iterator
from html import escape
from pathlib import Path
from typing import Any

from testbed.reporting import html
from testbed.reporting.html import Html
from testbed.reporting.numbers import interval, number

Summary = dict[str, Any]

_CAPTIONS = {
    "probabilities": "Probability that each requirement is met, with 95 % intervals (Wilson).",
    "survival": "Share of flights that pass, against the effectiveness that the failure leaves; 95 % intervals.",
    "envelope": "Errors against time: median, 5 to 95 % of the flights still flying, and the largest.",
    "detection_delay": "Detection delays of the flights in which something was detected.",
    "drivers": "Which varied values decide whether a flight passes: PAWN index (Pianosi and Wagener 2018).",
}


def write_sweep_report(folder: str | Path) -> Path:
    """Write report.html from summary.json and figures/ of a sweep folder; returns the file.

    Raises OSError when summary.json is missing or the report cannot be written.
    """
    folder = Path(folder)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return html.write_page(folder / "report.html", summary["sweep"], parts(summary, folder))


def parts(summary: Summary, folder: Path) -> Iterator[str]:
    """The sections of the report, as HTML, in their order."""
    yield from _head(summary)
    yield from _probabilities(summary)
    yield from _pairs(summary)
    yield from html.figures(folder / "figures", _CAPTIONS)
    yield from _excursions(summary)
    yield from _sensitivity(summary)
    yield from _worst(summary, folder)
    yield from _runs_needed(summary)


def _head(summary: Summary) -> Iterator[str]:
    state = "" if summary["complete"] else f" (of {summary['runs_asked']} asked for)"
    count = len(summary["variants"])
    each = f", each flown by {count} variants under the same draws" if count > 1 else ""
    drawn = f"sampling {escape(summary['sampling'])}, seed {summary['seed']}"
    yield f"<h1>{escape(summary['sweep'])}</h1>\n<p>{summary['runs']} runs{state}{each}; {drawn}.</p>"
    if not summary["probabilistic"]:
        yield html.note(
            "These runs are not a random sample: the shares describe the runs flown and are not probabilities."
        )


def _probabilities(summary: Summary) -> Iterator[str]:
    variants = summary["variants"]
    total = Html("<b>all requirements</b>")
    rows = [html.row([total, *(_share(variant["all_requirements"]) for variant in variants)])]
    for j, requirement in enumerate(variants[0]["requirements"] if variants else []):
        rows.append(html.row([requirement["name"], *(_share(v["requirements"][j]) for v in variants)]))
    rows.append(html.row(["how flights ended", *(_outcomes(v["outcomes"]) for v in variants)]))
    yield "<h2>How often the requirements are met</h2>"
    yield html.table(["", *(variant["label"] or "probability" for variant in variants)], rows)
    yield html.note(
        "Estimate and 95 % interval (Wilson); summary.json also has the exact interval (Clopper-Pearson). A flight "
        "without a result counts as having met no requirement."
    )


def _share(known: dict[str, Any]) -> str:
    return "no runs" if known["estimate"] is None else interval(known)


def _outcomes(outcomes: dict[str, int]) -> Html:
    return Html("<br>".join(f"{count} {escape(_words(name))}" for name, count in outcomes.items()))


def _pairs(summary: Summary) -> Iterator[str]:
    if not summary["pairs"]:
        return
    rows = [
        html.row(
            [
                f"{pair['first']} minus {pair['second']}",
                interval(pair, "difference", "+.3f"),
                pair["only_first"],
                pair["only_second"],
                number(pair["p_value"], ".2g"),
            ]
        )
        for pair in summary["pairs"]
    ]
    heads = (
        "",
        "difference in P(all)",
        "only the first passed",
        "only the second passed",
        "p (exact McNemar)",
    )
    yield "<h2>Compared, run by run</h2>"
    yield html.table(heads, rows)


def _excursions(summary: Summary) -> Iterator[str]:
    metrics = [(v["label"], name, m) for v in summary["variants"] for name, m in v["metrics"].items()]
    shares = list(metrics[0][2]["tolerance_bounds"]) if metrics else []
    rows = [
        html.row(
            [
                label,
                name,
                *(metric[of] for of in ("median", "p95", "largest")),
                *(number(metric["tolerance_bounds"][share], absent="too few") for share in shares),
            ]
        )
        for label, name, metric in metrics
        if metric["n"]
    ]
    stays = (f"{100 * float(share):g} % stay within" for share in shares)
    yield "<h2>How large the errors became</h2>"
    yield html.table(["", "metric", "median", "95 %", "largest", *stays], rows)
    yield html.note(
        "The last columns are upper bounds that hold with 95 % confidence for any distribution (order "
        "statistics, Wilks 1941). A lost flight counts as an infinite error. 'too few': more runs are needed "
        "for such a bound."
    )


def _sensitivity(summary: Summary) -> Iterator[str]:
    rows = [
        row
        for variant in summary["variants"]
        for output, result in variant["sensitivity"].items()
        for row in _sensitivity_rows(variant["label"], output, result)
    ]
    yield "<h2>Which varied values drive the result</h2>"
    yield html.table(["", "result", "varied value", "PAWN", "share of variance (RBD-FAST)"], rows)


def _sensitivity_rows(label: str, output: str, result: dict[str, Any]) -> Iterator[Html]:
    if "reason" in result:
        yield html.row([label, output, Html(f'<span class="note">{escape(result["reason"])}</span>'), "", ""])
    inputs = result.get("inputs", {})
    for name in sorted(inputs, key=lambda name: -(inputs[name]["pawn"] or 0.0)):
        index = inputs[name]
        by_chance = (
            ""
            if index["matters"] or index["pawn"] is None
            else ' <span class="note">no more than chance</span>'
        )
        share = number(index["s1"], ".2f")
        if index["s1"] is not None:
            share += f" ± {number(index['s1_half_width'], '.2f', absent='unknown')}"
        yield html.row([label, output, Html(escape(name) + by_chance), number(index["pawn"], ".2f"), share])


def _worst(summary: Summary, folder: Path) -> Iterator[str]:
    yield "<h2>The worst runs</h2>"
    rows = [
        html.row([variant["label"], str(flight["run"]), _words(flight["outcome"]), _again(folder, flight)])
        for variant in summary["variants"]
        for flight in variant["worst"]
    ]
    heads = ("", "run", "ended", "command that flies it again, from the parent folder")
    yield html.table(heads, rows) if rows else "<p>None failed.</p>"


def _again(folder: Path, flight: dict[str, Any]) -> Html:
    command = f"python -m testbed sweep {folder.name}/sweep.yaml --only {flight['run']}"
    return Html(f"<code>{escape(command)}</code>")


def _runs_needed(summary: Summary) -> Iterator[str]:
    rows = []
    for variant in summary["variants"]:
        needed = variant["runs_needed"]
        for claim, runs in needed["claim_without_a_failure"].items():
            words = f"P(all) is at least {claim}, with 95 % confidence"
            now = number(needed["claim_with_failures_as_now"][claim], absent="not at the present share")
            rows.append(html.row([variant["label"], words, number(runs), now]))
        for width, runs in needed["half_width"].items():
            rows.append(html.row([variant["label"], f"P(all) to ± {width}", "", number(runs)]))
    yield "<h2>How many runs a claim needs</h2>"
    yield html.table(["", "claim", "runs without a failure", "runs with the failures seen so far"], rows)


def _words(name: str) -> str:
    return name.replace("_", " ")
