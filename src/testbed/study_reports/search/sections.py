"""The parts of a search's page in HTML, from its summary.json. Any number in it may be None."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from html import escape
from typing import Any

from testbed.reporting import html
from testbed.reporting.numbers import number
from testbed.study_reports.search.words import answer, rounded

Summary = Mapping[str, Any]


def head(summary: Summary) -> Iterator[str]:
    """Title, chips, the answer in sentences."""
    facts = {"goal": summary["goal"], "flights": str(summary["flights"]), "budget": f"{summary['budget']} each",
             "seed": str(summary["seed"]), "varied": ", ".join(summary["varied"])}  # fmt: skip
    if summary["requirement"]:
        facts["requirement"] = summary["requirement"]
    yield f"<h1>{escape(summary['search'])}</h1>"
    yield html.chips(facts)
    yield html.listed(answer(summary), "story")


def probabilities(summary: Summary) -> Iterator[str]:
    """The probability of each variant, and of each part, with what plain sampling would need."""
    if summary["goal"] != "probability":
        return
    yield "<h2>How likely a requirement is broken</h2>"
    rows = [
        _probability(variant["label"] or "all", "", variant["probability"]) for variant in summary["variants"]
    ]
    if len(summary["parts"]) > len(summary["variants"]):
        rows += [
            _probability(part["label"], number(part["weight"], ".3g"), part["probability"], part["reason"])
            for part in summary["parts"]
        ]
    heads = [
        "",
        "weight",
        "probability",
        "95 % interval",
        "coefficient of variation",
        "flights",
        "plain sampling needs",
        "",
    ]
    yield html.table(heads, rows)
    yield html.note(
        f"By {summary['method']} sampling, with the same random numbers for all variants. Plain sampling needs "
        "(1 - P) / (P c²) flights for the same coefficient of variation c."
    )


def _probability(label: str, weight: str, known: Summary, reason: str = "") -> html.Html:
    span = f"{number(known['low'], '.2g')} to {number(known['high'], '.2g')}"
    cells = [
        label,
        weight,
        number(known["estimate"], ".2g"),
        span,
        number(known["coefficient_of_variation"], ".2f"),
    ]
    return html.row([*cells, known["flights"], rounded(known["plain_flights"]), reason])


def design_points(summary: Summary) -> Iterator[str]:
    """For each part that found a failure: every input with its value, and a bar for its share of the squared distance."""
    found = [part for part in summary["parts"] if part["found"] and part["distance"]]
    if not found:
        return
    yield "<h2>What it takes</h2>"
    for part in found:
        yield f"<h3>{escape(part['label'])}</h3>" if part["label"] else ""
        rows = [
            _input(name, each)
            for name, each in sorted(part["point"].items(), key=lambda item: -item[1]["share"])
        ]
        yield f'<div class="drivers">{"".join(rows)}</div>'
        heads = [
            "input",
            "value found",
            "value at the origin",
            "standard deviations",
            "values at least as far",
        ]
        yield html.folded(
            "As numbers", html.table(heads, [_numbers(*item) for item in part["point"].items()])
        )
    yield html.note(
        "Bars: the share of each input in the squared distance of the failure found from the origin; in the number, its value. "
        "The origin is the median of an input or, for the severity of a failure, the value without effect."
    )


def _input(name: str, each: Summary) -> str:
    return (
        f'<div class="driver"><div class="name">{escape(name)}</div><div class="track">'
        f'<i class="v0" style="width:{100 * each["share"]:.1f}%"></i></div>'
        f'<div class="number">{escape(number(each["value"], ".3g"))}</div></div>'
    )


def _numbers(name: str, each: Summary) -> html.Html:
    return html.row(
        [
            name,
            each["value"],
            each["nominal"],
            number(each["coordinate"], "+.2f"),
            number(each["beyond"], ".2g"),
        ]
    )


def levels(summary: Summary) -> Iterator[str]:
    """The levels of subset simulation: how the probability is the product of larger ones."""
    for part in summary["parts"]:
        if len(part.get("levels", ())) < 2:
            continue
        rows, product = [], 1.0
        for level in part["levels"]:
            product *= level["probability"] or 0.0
            rows.append(html.row([level["threshold"], number(level["probability"], ".3g"), number(product, ".2g"),
                                  number(level["cov"], ".2f"), level["evaluations"]]))  # fmt: skip
        heads = [
            "robustness at most",
            "given the level above",
            "probability",
            "coefficient of variation",
            "flights",
        ]
        yield html.folded(f"Levels {part['label']}".strip(), html.table(heads, rows))


def searches(summary: Summary) -> Iterator[str]:
    """Every search that was made, in a table."""
    rows = [
        html.row([part["label"] or "all", part["flights"], part["without_result"], number(part["distance"], ".3f", "none found"),
                  ", ".join(part.get("broken", ())), part["reason"]])
        for part in summary["parts"]
    ]  # fmt: skip
    heads = ["search", "flights", "without a result", "distance", "breaks", "how it ended"]
    yield html.folded("The searches", html.table(heads, rows))
    kept = "results.csv has every flight"
    again = "; found.yaml is the scenario found, and flies again as it is" if summary["found"] else ""
    yield html.note(f"{kept}{again}.")
