"""report.html of a sweep: one file, readable anywhere, with nothing to fetch and nothing to run."""

from __future__ import annotations

import base64
import html
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 60rem;
       margin: 2rem auto; padding: 0 1rem; color: #222 }
table { border-collapse: collapse; margin: .6rem 0 1.4rem }
th, td { border-bottom: 1px solid #ddd; padding: .25rem .8rem .25rem 0;
         text-align: left; vertical-align: top }
th { font-weight: 600 } td.n { text-align: right; font-variant-numeric: tabular-nums }
code { background: #f3f3f3; padding: .1rem .3rem } img { max-width: 100% } .note { color: #666 }
"""
_CAPTIONS = {
    "probabilities": "Probability that each requirement is met, with 95 % intervals (Wilson).",
    "survival": "Share of flights that pass, by what the failure leaves; 95 % intervals of each tenth.",
    "envelope": "Errors against time: median, 5 to 95 % of those still flying, and the largest.",
    "detection_delay": "Delay of detections, over the flights that had one.",
    "drivers": "What drives passing: PAWN index of each varied value (Pianosi and Wagener 2018).",
}


def write_sweep_report(folder: str | Path) -> Path:
    """Write report.html from summary.json and figures/ of a sweep folder; raises OSError when they are
    missing.
    """
    folder = Path(folder)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    parts = (_head, _probabilities, _pairs, _figures, _excursions, _sensitivity, _worst, _needed)
    body = "\n".join(line for part in parts for line in part(summary, folder))
    title = html.escape(summary["sweep"])
    page = (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>\n'
        f"<style>{_STYLE}</style></head><body>\n<h1>{title}</h1>\n{body}\n</body></html>\n"
    )
    partial = folder / ".report.html.partial"
    partial.write_text(page, encoding="utf-8")
    return partial.replace(folder / "report.html")


def _head(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    asked = summary["runs_asked"]
    state = "" if summary["complete"] else f" (of {asked} asked for)"
    many = (
        f", each flown by {len(summary['variants'])} variants under the same draws"
        if summary["pairs"]
        else ""
    )
    drawn = f"sampling {html.escape(summary['sampling'])}, seed {summary['seed']}"
    yield f"<p>{summary['runs']} runs{state}{many}; {drawn}.</p>"
    if not summary["probabilistic"]:
        yield "<p class=note>No random sample: shares are of the cases flown, not probabilities.</p>"


def _probabilities(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    variants = summary["variants"]
    yield "<h2>How often the requirements are met</h2>"
    rows = [["<b>all requirements</b>", *(_share(v["all_requirements"]) for v in variants)]]
    for j, requirement in enumerate(variants[0]["requirements"] if variants else []):
        rows.append([html.escape(requirement["name"]), *(_share(v["requirements"][j]) for v in variants)])
    rows.append(["how flights ended", *(_outcomes(v["outcomes"]) for v in variants)])
    yield _table(["", *(html.escape(v["label"]) or "probability" for v in variants)], rows)
    yield (
        "<p class=note>Estimate and 95 % interval by Wilson; Clopper-Pearson in summary.json. A flight "
        "without a result counts as having met nothing.</p>"
    )


def _share(known: dict[str, Any]) -> str:
    if known["estimate"] is None:
        return "no runs"
    return f"{known['estimate']:.3f} <span class=note>({known['low']:.3f} to {known['high']:.3f})</span>"


def _outcomes(outcomes: dict[str, int]) -> str:
    return "<br>".join(f"{count} {html.escape(name.replace('_', ' '))}" for name, count in outcomes.items())


def _pairs(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    if not summary["pairs"]:
        return
    yield "<h2>Compared, run by run</h2>"
    rows = [
        [f"{html.escape(p['first'])} minus {html.escape(p['second'])}",
         f"{p['difference']:+.3f} ({p['low']:+.3f} to {p['high']:+.3f})",
         str(p["only_first"]), str(p["only_second"]), f"{p['p_value']:.2g}"]
        for p in summary["pairs"] if p["difference"] is not None
    ]  # fmt: skip
    yield _table(
        ["", "difference in P(all)", "only the first passed", "only the second passed", "p (exact McNemar)"],
        rows,
    )


def _figures(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    for name, caption in _CAPTIONS.items():
        file = folder / "figures" / f"{name}.png"
        if file.is_file():
            data = base64.b64encode(file.read_bytes()).decode()
            yield f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
            yield f"<figcaption class=note>{html.escape(caption)}</figcaption></figure>"


def _excursions(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    yield "<h2>How far it went</h2>"
    rows = []
    for variant in summary["variants"]:
        for name, metric in variant["metrics"].items():
            if metric["n"]:
                bounds = [_number(bound) for bound in metric["tolerance_bounds"].values()]
                rows.append([html.escape(variant["label"]), html.escape(name), *(_number(metric[k]) for k in
                             ("median", "p95", "largest")), *bounds])  # fmt: skip
    shares = list(
        next((m["tolerance_bounds"] for v in summary["variants"] for m in v["metrics"].values()), {})
    )
    yield _table(
        ["", "metric", "median", "95 %", "largest", *(f"{100 * float(s):g} % stay within" for s in shares)],
        rows,
    )
    yield (
        "<p class=note>The last columns hold with 95 % confidence, whatever the distribution (order "
        "statistics, Wilks 1941); a lost flight counts as infinitely far. 'too few': even the largest of so "
        "few runs says less.</p>"
    )


def _sensitivity(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    yield "<h2>What drives it</h2>"
    rows = []
    for variant in summary["variants"]:
        for output, result in variant["sensitivity"].items():
            where = [html.escape(variant["label"]), html.escape(output)]
            if "reason" in result:
                rows.append([*where, f"<span class=note>{html.escape(result['reason'])}</span>", "", ""])
            for name, index in sorted(result.get("inputs", {}).items(), key=lambda item: -item[1]["pawn"]):
                matters = "" if index["matters"] else " <span class=note>no more than chance</span>"
                s1 = (
                    f"{index['s1']:.2f} &plusmn; {index['s1_half_width']:.2f}"
                    if index["s1"] is not None
                    else ""
                )
                rows.append([*where, html.escape(name) + matters, f"{index['pawn']:.2f}", s1])
    yield _table(["", "result", "input", "PAWN", "share of variance (RBD-FAST)"], rows)


def _worst(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    yield "<h2>The worst runs</h2>"
    rows = [
        [html.escape(variant["label"]), str(flight["run"]), html.escape(flight["outcome"].replace("_", " ")),
         f"<code>python -m testbed sweep {html.escape(folder.name)}/sweep.yaml --only {flight['run']}</code>"]
        for variant in summary["variants"] for flight in variant["worst"]
    ]  # fmt: skip
    yield (
        _table(["", "run", "ended", "flies it again, from the folder above this one"], rows)
        if rows
        else "<p>None failed.</p>"
    )


def _needed(summary: dict[str, Any], folder: Path) -> Iterable[str]:
    yield "<h2>How many runs a claim needs</h2>"
    rows = []
    for variant in summary["variants"]:
        needed = variant["runs_needed"]
        for claim, runs in needed["claim_without_a_failure"].items():
            now = needed["claim_with_failures_as_now"][claim]
            rows.append([html.escape(variant["label"]), f"P(all) is at least {claim}, with 95 % confidence",
                         str(runs), str(now) if now else "not at the present share"])  # fmt: skip
        for width, runs in needed["half_width"].items():
            rows.append([html.escape(variant["label"]), f"P(all) to &plusmn; {width}", "", str(runs)])
    yield _table(["", "claim", "runs without a failure", "runs with the failures seen so far"], rows)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    top = "".join(f"<th>{cell}</th>" for cell in head)
    body = "\n".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><tr>{top}</tr>\n{body}</table>"


def _number(value: Any) -> str:
    if value is None:
        return "too few"
    return html.escape(value) if isinstance(value, str) else f"{value:.4g}"
