"""The report of a search folder: one page with the answer in sentences, the design point, the way to it, and the flight found.

Everything is read from the folder. Any number of its summary.json may be None. To add a figure, name it in TABLE.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import accumulate
from operator import itemgetter, mul
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from testbed.flight import folder as run_folder
from testbed.inputs.received import read_json
from testbed.reporting import html
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.figure import picture
from testbed.reporting.html import Html, Part, tag
from testbed.reporting.palette import nth
from testbed.reporting.words import number, setting
from testbed.study_reports.drawing import Draw, draw_all, figure, legend
from testbed.study_reports.search.words import answer, rounded

Summary = Mapping[str, Any]
Columns = dict[str, Callable[[Summary], html.Cell]]
CAPTIONS = {
    "convergence": "Distance of the nearest failure found, by the number of flights made.",
    "path": "The way to the answer: the coordinates of each nearer failure that was found, the last on the right.",
    "levels": "Probability that the robustness is at most a value, by level, with 95 % intervals; at 0, the answer.",
}
_MOST_INPUTS, _MOST_PANELS = 12, 6


def write_search_page(folder: str | Path) -> Path:
    """Draw the figures and write report.html of a search folder from its summary.json; returns the file.

    Beside it, comparison*.html has each flight found and the one at the origin. Raises OSError when it cannot be written.
    """
    folder = Path(folder).resolve()
    summary: Summary = read_json(folder / "summary.json", "the summary that testbed wrote")
    draw_all(TABLE, folder, summary)
    return html.write_page(folder / "report.html", summary["search"], _parts(summary, folder))


def _parts(summary: Summary, folder: Path) -> Iterator[Part]:
    yield _head(summary)
    yield _probabilities(summary)
    yield _design_points(summary)
    yield (_flight(part, folder) for part in summary["parts"] if part["found"])
    yield html.figures(folder / "figures", CAPTIONS)
    yield _levels(summary)
    yield _searches(summary)


def _flight(part: Summary, folder: Path) -> Iterator[Html]:
    """The flight found beside the one at the origin: a picture, and a link to the page that compares them."""
    name = Path(part["folder"]).name  # a summary from somebody else names no other place
    found, origin = folder / name, folder / name.replace("found", "origin", 1)
    if not name.startswith("found") or not all((each / "log.csv").is_file() for each in (found, origin)):
        return
    flights = [run_folder.load(origin), run_folder.load(found)]
    if not all(flight.actuators for flight in flights):  # made up by a function of the user's
        return
    comparison = Comparison(flights, ["at the origin", "found"])
    page = comparison.write(folder / f"{name.replace('found', 'comparison', 1)}.html")
    label = f" ({part['label']})" if part["label"] else ""
    caption = f"The flight found, and the one at the origin of the search{label}"
    yield html.picture(picture(comparison), caption)
    both = html.link("Both flights side by side", page.name)
    yield html.note(both, ", ", html.link("the flight found", f"{name}/report.html"), ".")


def _head(summary: Summary) -> Html:
    """Title, chips, the answer in sentences."""
    facts = {"goal": summary["goal"], "flights": str(summary["flights"]), "budget": f"{summary['budget']} each",
             "seed": str(summary["seed"]), "varied": ", ".join(map(setting, summary["varied"]))}  # fmt: skip
    if summary["requirement"]:
        facts["requirement"] = summary["requirement"]
    return html.opening(summary["search"], answer(summary), facts)


def _probabilities(summary: Summary) -> Iterator[Html]:
    """The probability of each variant, and of each part, with what plain sampling would need."""
    if summary["goal"] != "probability":
        return
    yield tag("h2", "How likely a requirement is broken")
    known = [{**v["probability"], "label": v["label"] or "all", "weight": ""} for v in summary["variants"]]
    if len(summary["parts"]) > len(summary["variants"]):
        for part in summary["parts"]:
            weight = number(part["weight"], ".3g")
            about = {"label": part["label"], "reason": part["reason"], "weight": weight}
            known.append({**part["probability"], **about})
    columns: Columns = {
        "": itemgetter("label"),
        "weight": itemgetter("weight"),
        "probability": lambda p: number(p["estimate"], ".2g"),
        "95 % interval": lambda p: f"{number(p['low'], '.2g')} to {number(p['high'], '.2g')}",
        "coefficient of variation": lambda p: number(p["coefficient_of_variation"], ".2f"),
        "flights": itemgetter("flights"),
        "plain sampling needs": lambda p: rounded(p["plain_flights"]),
        "remark": lambda p: p.get("reason", ""),
    }
    yield html.listing(known, columns)
    yield html.note(
        f"By {summary['method']} sampling, with the same random numbers for all variants. Plain sampling needs "
        "(1 - P) / (P c²) flights for the same coefficient of variation c."
    )


def _design_points(summary: Summary) -> Iterator[Html]:
    """For each part that found a failure: every input with its value, and a bar for its share of the squared distance."""
    found = [part for part in summary["parts"] if part["found"] and part["distance"]]
    if not found:
        return
    yield tag("h2", "What it takes")
    columns: Columns = {
        "input": itemgetter("input"),
        "value found": itemgetter("value"),
        "value at the origin": itemgetter("nominal"),
        "standard deviations": lambda each: number(each["coordinate"], "+.2f"),
        "values at least as far": lambda each: number(each["beyond"], ".2g"),
    }
    for part in found:
        yield tag("h3", part["label"]) if part["label"] else Html()
        inputs = [{"input": setting(name), **each} for name, each in part["point"].items()]
        bars = (
            html.bar(each["input"], each["share"], number(each["value"], ".3g"))
            for each in sorted(inputs, key=lambda each: -each["share"])
        )
        yield tag("div", bars, class_="drivers")
        yield html.folded("As numbers", html.listing(inputs, columns))
    yield html.note(
        "Bars: the share of each input in the squared distance of the failure found from the origin; in the number, its value. "
        "The origin is the median of an input or, for the severity of a failure, the value without effect."
    )


def _levels(summary: Summary) -> Iterator[Html]:
    """The levels of subset simulation: how the probability is the product of larger ones."""
    columns: Columns = {
        "robustness at most": itemgetter("threshold"),
        "given the level above": lambda level: number(level["probability"], ".3g"),
        "probability": lambda level: number(level["product"], ".2g"),
        "coefficient of variation": lambda level: number(level["cov"], ".2f"),
        "flights": itemgetter("evaluations"),
    }
    for part in summary["parts"]:
        found = part.get("levels", ())
        if len(found) > 1:
            products = accumulate((level["probability"] or 0.0 for level in found), mul)
            rows = [{**level, "product": product} for level, product in zip(found, products, strict=True)]
            yield html.folded(f"Levels {part['label']}".strip(), html.listing(rows, columns))


def _searches(summary: Summary) -> Iterator[Html]:
    """Every search that was made, in a table."""
    columns: Columns = {
        "search": lambda part: part["label"] or "all",
        "flights": itemgetter("flights"),
        "without a result": itemgetter("without_result"),
        "distance": lambda part: number(part["distance"], ".3f", "none found"),
        "breaks": lambda part: ", ".join(part.get("broken", ())),
        "how it ended": itemgetter("reason"),
    }
    yield html.folded("The searches", html.listing(summary["parts"], columns))
    kept = "results.csv has every flight"
    again = "; found.yaml is the scenario found, and flies again as it is" if summary["found"] else ""
    yield html.note(f"{kept}{again}.")


def convergence(summary: Summary) -> Figure | None:
    """Distance of the nearest failure against flights made, a line for each part."""
    shown = [part for part in summary["parts"] if part.get("path")]
    if not shown:
        return None
    drawn, ((axes,),) = figure(8.0, 4.0)
    for i, part in enumerate(shown):
        flights, distance = ([step[what] for step in part["path"]] for what in ("flights", "distance"))
        flights.append(max(part["flights"], flights[-1]))  # points that were asked for twice are flown once
        look = {"label": _label(part, shown), "ms": 4, **nth(i, "marker")}
        axes.step(flights, [*distance, distance[-1]], where="post", **look)
    axes.set(xlabel="flights", ylabel="distance of the nearest failure")
    legend(axes, beside=True)
    axes.set_ylim(0.0, 1.1 * max(part["path"][0]["distance"] for part in shown) or 1.0)
    axes.set_xlim(left=0.0)
    return drawn


def path(summary: Summary) -> Figure | None:
    """The values of each nearer failure, a panel for each part and a line for each input."""
    shown = [part for part in summary["parts"] if len(part.get("path", ())) > 1][:_MOST_PANELS]
    if not shown:
        return None
    drawn, grid = figure(8.0, 2.6 * len(shown), len(shown))
    for axes, part in zip(grid.flat, shown, strict=True):
        names = sorted(part["point"], key=lambda name: -part["point"][name]["share"])[:_MOST_INPUTS]
        for j, name in enumerate(names):
            values = [step["coordinates"][name] for step in part["path"]]
            axes.plot(range(1, len(values) + 1), values, label=setting(name), ms=4, **nth(j, "marker"))
        axes.set(ylabel="standard deviations", title=part["label"])
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        legend(axes, beside=True)
    grid[-1, 0].set_xlabel("nearer failures, in the order in which they were found")
    return drawn


def levels(summary: Summary) -> Figure | None:
    """P(robustness at most g) against g, in logarithms."""
    shown = [part for part in summary["parts"] if len(part.get("levels", ())) > 1]
    if not shown:
        return None
    drawn, ((axes,),) = figure(8.0, 4.0)
    for i, part in enumerate(shown):
        known = [level for level in part["levels"] if level["threshold"] is not None and level["probability"]]
        products = np.cumprod([level["probability"] for level in known])
        spread = np.sqrt(np.cumsum([(level["cov"] or 0.0) ** 2 for level in known]))
        ends = products * np.exp(np.outer([-1.96, 1.96], np.sqrt(np.log1p(spread**2))))
        look = {"capsize": 3, "ms": 4, "label": _label(part, shown), **nth(i, "marker")}
        thresholds = [level["threshold"] for level in known]
        axes.errorbar(thresholds, products, yerr=[products - ends[0], ends[1] - products], **look)
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set(xlabel="robustness", ylabel="probability of at most this")
    axes.axvline(0.0, color="0.35", ls=":")
    legend(axes, beside=True)
    return drawn


def _label(part: Summary, among: list[Summary]) -> str | None:
    """The name of a part in the legend, if it is not the only one."""
    return part["label"] or None if len(among) > 1 else None


TABLE: dict[str, Draw] = {"convergence": convergence, "path": path, "levels": levels}
