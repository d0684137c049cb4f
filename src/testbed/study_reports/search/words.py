"""What a search found, in sentences. Any number of a summary may be None."""

from __future__ import annotations

import math
import shlex
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from testbed.air.config import COLUMNS
from testbed.common.statistics import proportion
from testbed.common.units import unit
from testbed.flight.flight import Flight
from testbed.reporting.comparison.differences import settings_by_path
from testbed.reporting.words import broke, joined, number

Summary = Mapping[str, Any]


def answer(summary: Summary) -> list[str]:
    """A sentence or two for each part of a search; for a probability, first one for each variant."""
    lines = []
    if summary["goal"] == "probability":
        lines += [_probability(variant) for variant in summary["variants"]]
        if len(summary["parts"]) > len(summary["variants"]):
            lines += [_share(part) for part in summary["parts"]]
    lines += [_smallest(summary, part) for part in summary["parts"]]
    return lines + list(_more_than_one(summary))


def _probability(variant: Summary) -> str:
    known = variant["probability"]
    who = f"{variant['label']}: a" if variant["label"] else "A"
    span = f"{number(known['low'], '.2g')} to {number(known['high'], '.2g')}"
    if known["estimate"] is None:
        return f"{who} requirement is broken with a probability that is not known: {span} (95 %), from {known['flights']} flights."
    if not known["estimate"]:
        most = number(known["high"], ".2g")
        none = f"{who} requirement was broken in none of {known['flights']} flights: its probability is at most {most} (95 %)."
        return none + _against_plain(known)
    scatter = known["coefficient_of_variation"]
    cov = "" if scatter is None else f"; coefficient of variation {scatter:.2f}"
    plain = known["plain_flights"]
    more = "" if plain is None else f"; plain sampling would need {rounded(plain)}"
    unsure = "" if known["converged"] else " This is not as precise as was asked for."
    return (
        f"{who} requirement is broken with probability {number(known['estimate'], '.2g')} ({span}, 95 %{cov}), from "
        f"{known['flights']} flights{more}.{unsure}"
    )


def _against_plain(known: Summary) -> str:
    """Why that is more than as many independent flights would say, where it is."""
    plain = proportion(0, int(known["flights"]), method="exact").high
    if not known["high"] > 1.01 * plain:
        return ""
    return (
        f" As many flights drawn independently would say {number(plain, '.2g')}; these were drawn from one another, towards "
        "failures that they did not reach, and leave room for others elsewhere: more budget goes further."
    )


def _share(part: Summary) -> str:
    known = part["probability"]
    span = f"{number(known['low'], '.2g')} to {number(known['high'], '.2g')}"
    return f"{part['label']}: {number(known['estimate'], '.2g')} ({span}), in {100 * part['weight']:.0f} % of flights."


def _smallest(summary: Summary, part: Summary) -> str:
    if not part["found"]:
        return _said(part["label"], f"not found in {part['flights']} flights.{_bound(part)}")
    if part["distance"] == 0.0:
        return _said(part["label"], f"the flight at the origin breaks {joined(part['broken'])} already.")
    what = "the smallest failure found" if summary["goal"] == "smallest" else "the most likely failure seen"
    words = "; ".join(part.get("words", ()))
    said = f"{what}: {words}. It breaks {joined(part['broken'])}. {_distance(part)}{_flown_again(part)}"
    return _said(part["label"], said)


def _flown_again(part: Summary) -> str:
    """With what the scenario found flies again, where it does not by itself: a scenario cannot name a class."""
    if "own_controller" not in part:
        return ""
    words = shlex.join([f"{part['folder']}/scenario.yaml", "--controller", str(part["own_controller"])])
    return f" `testbed run {words}` flies it again."


def _bound(part: Summary) -> str:
    if not part.get("independent"):
        return ""
    most = number(part["upper_bound"], ".2g")
    return f" {part['independent']} of them were independent draws, which allow a probability of at most {most} (95 %)."


def _distance(part: Summary) -> str:
    beyond = part["beyond"]
    rare = "worse ones are beyond counting"
    if beyond:
        rare = f"about 1 flight in {rounded(1.0 / beyond)} is worse"
    return f"Distance {part['distance']:.2f} standard deviations; if the limit is flat there, {rare}."


def rounded(count: float | None) -> str:
    """A number of flights with two digits: `1400`, `2.6 million`."""
    if count is None or not math.isfinite(count) or count <= 0.0:
        return "-"
    digits = 1 - math.floor(math.log10(count))
    if count < 999_500:
        return f"{round(count, digits):.0f}"
    return f"{count / 1e6:.2g} million" if count < 1e8 else f"{count:.1e}"


def _more_than_one(summary: Summary) -> Iterator[str]:
    """Which of the compared variants needs the bigger failure."""
    variants = [v for v in summary["variants"] if v["label"]]
    if summary["goal"] != "smallest" or len(variants) < 2 or not any(v["found"] for v in variants):
        return
    ranked = sorted(
        variants, key=lambda v: math.inf if v["distance"] is None else v["distance"], reverse=True
    )
    said = [f"{v['label']} ({number(v['distance'], '.2f', 'none found')})" for v in ranked]
    yield f"From the bigger failure needed to the smaller: {', '.join(said)}."


def settings_of(flight: Flight, paths: Iterable[str]) -> list[str]:
    """What these varied values make of a flight, in words: `at 41.0 s the right propeller kept 38 % of its effect`."""
    said: dict[str, None] = {}
    for path in paths:
        parts = path.split(".")
        said.setdefault(_failure(flight, parts) or _weather(flight, parts) or _value(flight, parts))
    return list(said)


def _failure(flight: Flight, parts: list[str]) -> str:
    if parts[0] != "failures" or len(parts) < 2:
        return ""
    at_s = flight.scenario.failures[int(parts[1])].at_s
    return f"{'' if at_s is None else f'at {at_s:.1f} s '}{broke(flight, int(parts[1]))}"


def _weather(flight: Flight, parts: list[str]) -> str:
    air = flight.scenario.atmosphere
    if parts[:2] == ["atmosphere", "wind_m_s"]:
        north, east, down = air.wind_m_s
        up = f", {abs(down):.1f} m/s {'down' if down > 0 else 'up'}" if abs(down) >= 0.05 else ""
        origin_deg = math.degrees(math.atan2(-east, -north)) % 360.0
        return f"a steady wind of {math.hypot(north, east):.1f} m/s from {origin_deg:.0f} deg{up}"
    if parts[:2] == ["atmosphere", "gusts"] and len(parts) > 2:
        gust = air.gusts[int(parts[2])]
        return f"a gust of {np.linalg.norm(gust.magnitude_m_s):.1f} m/s at {gust.at_s:.1f} s"
    return _turbulence(flight) if parts[:2] == ["atmosphere", "noise"] else ""


def _turbulence(flight: Flight) -> str:
    """The fastest that the air moves in the window of the noise; empty for a flight without a log of the air."""
    air, log = flight.scenario.atmosphere, dict(zip(flight.columns, flight.data.T, strict=True))
    if air.noise is None or not set(COLUMNS) <= set(log):
        return ""
    until = flight.scenario.duration_s if air.noise.until_s is None else air.noise.until_s
    inside = (log["time_s"] >= air.noise.from_s) & (log["time_s"] <= until)
    moved = np.column_stack([log[name] for name in COLUMNS])[inside] - air.wind_m_s
    most = np.linalg.norm(moved, axis=1).max(initial=0.0)
    return f"turbulence of up to {most:.1f} m/s between {air.noise.from_s:g} and {until:g} s"


def _value(flight: Flight, parts: list[str]) -> str:
    """`controller.model_error.Cm_alpha = 1.21`."""
    path = ".".join(parts)
    value = settings_by_path(flight.scenario).get(path)
    shown = number(value, ".3g") if isinstance(value, int | float) else str(value)
    return f"{path} = {shown} {unit(path)}".rstrip()


def _said(label: str, sentence: str) -> str:
    """A sentence about a part: after its label, or with a capital letter."""
    return f"{label}: {sentence}" if label else sentence[:1].upper() + sentence[1:]
