"""The answer of a sweep in a few sentences, from its summary.json. Any number in it may be None."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from testbed.flight.flight import LOSSES, Outcome
from testbed.reporting.words import count, number, setting

SIGNIFICANT = 0.05
"""Above this p-value, a difference is called one that chance may explain."""


def answer(summary: Mapping[str, Any]) -> list[str]:
    """How often the best variant passed, how it compares with the others, what it missed, and what that depends on."""
    variants = [v for v in summary["variants"] if v["all_requirements"]["estimate"] is not None]
    if not variants:
        return list(_unjudged(summary)) or ["No flight has finished."]
    best = max(variants, key=lambda v: v["all_requirements"]["estimate"])
    others = [v for v in variants if v is not best]
    lines = [_first(summary, best), *(_against(summary, best, other) for other in others)]
    return [*lines, " ".join(_misses(best)), *_unjudged(summary), *_drivers(best)]


def _unjudged(summary: Mapping[str, Any]) -> Iterator[str]:
    """`Not judged in flights of pid: 3 of 5 requirements. It does not say what they limit.`"""
    for variant in summary["variants"]:
        each = variant["requirements"]
        silent = sum(bool(share.get("not_judged")) for share in each)
        if silent:
            who = f" in flights of {variant['label']}" if variant["label"] else ""
            yield f"Not judged{who}: {silent} of {count(len(each), 'requirement')}. It does not say what they limit."


def _first(summary: Mapping[str, Any], best: Mapping[str, Any]) -> str:
    share = _share(best["all_requirements"], summary["probabilistic"])
    if not best["requirements"]:
        return f"{best['label'] or 'It'} flies to the end in {share}; nothing more is asked of it."
    if not best["label"]:
        return f"All requirements are met in {share}."
    return f"{best['label']} meets all requirements in {share}."


def _share(known: Mapping[str, Any], probabilistic: bool) -> str:
    """`58 of 60 flights (89 to 99 %)`; the interval is left out where runs are not a random sample."""
    count = f"{known['successes']} of {known['n']} flights"
    return f"{count} ({_percent(known['low'])} to {_percent(known['high'])} %)" if probabilistic else count


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{100 * share:.0f}"


def _against(summary: Mapping[str, Any], best: Mapping[str, Any], other: Mapping[str, Any]) -> str:
    """`Compared with fixed (42 of 60 flights, 57 to 80 %): better in 16 paired runs, worse in none.`"""
    both = {best["label"], other["label"]}
    pair = next((p for p in summary["pairs"] if {p["first"], p["second"]} == both), None)
    if pair is None:
        return f"{other['label']} was not compared with it."
    better, worse = pair["only_first"], pair["only_second"]
    if pair["first"] != best["label"]:
        better, worse = worse, better
    share = _share(other["all_requirements"], summary["probabilistic"]).replace(" (", ", ").rstrip(")")
    share += f", {_lost(other)} lost" if _lost(other) else ""
    runs = count(better, "paired run") if better else "no paired run"
    text = f"Compared with {other['label']} ({share}): better in {runs}, worse in {worse or 'none'}"
    p = pair["p_value"]
    chance = p is not None and p > SIGNIFICANT and better + worse > 0
    return f"{text}; chance may explain this (p = {number(p, '.2g')})." if chance else f"{text}."


def _misses(best: Mapping[str, Any]) -> Iterator[str]:
    known = [r for r in best["requirements"] if r["estimate"] is not None]
    worst = min(known, key=lambda r: r["successes"], default=None)
    who = best["label"] or "It"
    if worst is not None and worst["successes"] < worst["n"]:
        yield f"{who} missed most often: {worst['name']} (in {worst['n'] - worst['successes']} of {worst['n']})."
    lost = _lost(best)
    ended = f"lost the aircraft in {count(lost, 'flight')}" if lost else "never lost the aircraft"
    yield f"{who} {ended}."
    flown = {str(Outcome.completed), *LOSSES}
    if absent := sum(n for name, n in best["outcomes"].items() if name not in flown):
        yield f"{count(absent, 'flight')} gave no result."


def _lost(variant: Mapping[str, Any]) -> int:
    return sum(variant["outcomes"].get(name, 0) for name in LOSSES)


def _drivers(best: Mapping[str, Any]) -> Iterator[str]:
    found = best["sensitivity"].get("passed", {})
    inputs = found.get("inputs")
    if not inputs:
        return
    sure = f" This is indicative: {best['all_requirements']['n']} runs." if found.get("indicative") else ""
    matter = ranked(inputs)
    names = [setting(name) for name, index in matter if index["matters"]]
    if names:
        rest = f", then on {names[1]}" if len(names) > 1 else ""
        yield f"Whether it passes depends most on {names[0]}{rest}.{sure}"
    else:
        yield f"No varied value shows an effect on passing beyond chance.{sure}"


def ranked(inputs: Mapping[str, Any]) -> Sequence[tuple[str, Any]]:
    """(name, indices) of the varied values, the most important first."""
    return sorted(inputs.items(), key=lambda item: -(item[1]["pawn"] or 0.0))
