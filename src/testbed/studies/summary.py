"""summary.json of a sweep, computed from its table: shares, metrics, and which varied values affect the result most.

Its contents do not depend on the clock or the machine.
"""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from testbed.common import statistics
from testbed.common.files import plain
from testbed.scenario.requirement import Requirement
from testbed.studies.folder.table import groups_of
from testbed.studies.plan import Plan
from testbed.studies.record import NO_RESULT
from testbed.studies.verdicts import judged, missed, requirements_of

if TYPE_CHECKING:
    import pandas as pd


CLAIMS = (0.9, 0.99, 0.999)
COVERAGES = (0.9, 0.95, 0.99)
HALF_WIDTHS = (0.05, 0.01)
WORST = 5


def summarize(plan: Plan, frame: pd.DataFrame) -> dict[str, Any]:
    """Contents of summary.json for the finished flights; a number that is not finite becomes None."""
    groups = list(groups_of(plan, frame))
    probabilistic = plan.cases is None and plan.sampling != "grid"
    return plain(
        {
            "sweep": plan.name,
            "seed": plan.study.seed,
            "sampling": "cases" if plan.cases is not None else plan.sampling,
            "probabilistic": probabilistic,
            "runs": int(frame["run"].nunique()),
            "runs_asked": plan.runs,
            "complete": len(frame) == plan.size,
            "varied": plan.paths,
            "variants": [_variant(plan, label, rows) for label, rows in groups],
            "pairs": [_pair(*one, *other) for one, other in itertools.combinations(groups, 2)],
        }
    )


def metric_names(plan: Plan, frame: pd.DataFrame) -> list[str]:
    """Names of the columns that are metrics."""
    others = {"run", "seed", "outcome", "passed", "reason", "environment", "end_time_s", "robustness"}
    others |= {*plan.paths, *plan.study.compare}
    return [name for name in frame.columns if name not in others and not name.startswith("requirements.")]


def worst(rows: pd.DataFrame) -> pd.DataFrame:
    """The worst flights of those that did not pass, the worst first.

    Flights without a result come first, then lost flights (the earliest first), then the others by their number of unmet
    requirements, and by their largest altitude error.
    """
    failed = rows[rows["passed"] == False]  # noqa: E712  (one that was not judged is neither True nor False)
    flown = failed["outcome"].isin(["completed", "ground_contact", "envelope_exceeded", "diverged"])
    verdicts = [
        name for name in rows.columns if name.startswith("requirements.") and name.endswith(".passed")
    ]
    keys = {
        "no_result": ~flown,
        "lost": failed["outcome"] != "completed",
        "early": -failed["end_time_s"].where(failed["outcome"] != "completed", 0.0).fillna(0.0),
        "unmet": (failed[verdicts] == False).sum(axis=1),  # noqa: E712  (a missing verdict is neither True nor False)
        "error": failed.get("altitude_error_max_m", failed["end_time_s"] * 0.0).fillna(0.0),
    }
    order = failed[[]].assign(**keys).sort_values([*keys], ascending=False, kind="stable")
    return failed.loc[order.index].head(WORST)


def _variant(plan: Plan, label: str, rows: pd.DataFrame) -> dict[str, Any]:
    known, requirements = judged(rows["passed"]), requirements_of(plan)
    passed, n = int(known.sum()), len(known)
    metrics = metric_names(plan, rows)
    drivers = ["passed", *(name for name in metrics if "error_max" in name)]
    return {
        "label": label,
        "outcomes": {str(k): int(v) for k, v in sorted(rows["outcome"].value_counts().items()) if v},
        "all_requirements": _share(passed, n, len(rows)),
        "requirements": [
            {"name": each.title, **_share(*requirement_shares(rows, j), len(rows))}
            for j, each in enumerate(requirements)
        ],
        "metrics": {name: _metric(rows, name) for name in metrics},
        "runs_needed": _runs_needed(passed, n),
        "sensitivity": sensitivity(rows, plan.paths, drivers),
        "worst": [_told(requirements, row) for row in worst(rows).to_dict("records")],
    }


def _told(requirements: Sequence[Requirement], row: Mapping[Any, Any]) -> dict[str, Any]:
    """A failed flight: its run, how it ended, and the requirement that it missed by most, with the worst value and the margin."""
    by_most = missed(requirements, row)
    told = {"run": int(row["run"]), "outcome": str(row["outcome"]), "reason": row.get("reason") or ""}
    if by_most is None:
        return told | {"missed": None, "value": None, "margin": None}
    title = requirements[by_most.number].title
    return told | {"missed": title, "value": by_most.value, "margin": by_most.margin}


def _share(met: int, judged: int, flown: int) -> dict[str, Any]:
    """How many of those that were judged, with both intervals, and how many of the flights were not."""
    wilson, exact = statistics.proportion(met, judged), statistics.proportion(met, judged, method="exact")
    others = {"not_judged": flown - judged} if judged < flown else {}
    return {**wilson.plain, "exact_low": exact.low, "exact_high": exact.high, **others}


def requirement_shares(rows: pd.DataFrame, j: int) -> tuple[int, int]:
    """(met, judged) of requirement j; a flight without a result counts as not having met it."""
    name = f"requirements.{j}.passed"
    known = judged(rows[name]) if name in rows else rows["passed"][:0]
    return int(known.sum()), len(known) + int(rows["outcome"].isin(NO_RESULT).sum())


def _metric(rows: pd.DataFrame, name: str) -> dict[str, Any]:
    """Quantiles of a metric, and its tolerance bounds; in the bounds a lost flight counts as an infinite value."""
    values = rows[name].to_numpy(dtype=float)
    known = values[np.isfinite(values)]
    lost = (rows["outcome"] != "completed").to_numpy()
    counted = np.where(lost, math.inf, values)
    counted = counted[~np.isnan(counted)]
    quantiles = np.quantile(known, [0.05, 0.5, 0.95]) if len(known) else [math.nan] * 3
    bounds = {f"{c:g}": statistics.tolerance_bound(counted.tolist(), c) for c in COVERAGES}
    return {
        "n": len(known),
        "lost": int(lost.sum()),
        "p5": float(quantiles[0]),
        "median": float(quantiles[1]),
        "p95": float(quantiles[2]),
        "largest": float(known.max()) if len(known) else math.nan,
        "tolerance_confidence": statistics.CONFIDENCE,
        "tolerance_bounds": {c: "none: flights were lost" if b == math.inf else b for c, b in bounds.items()},
    }


def _runs_needed(passed: int, n: int) -> dict[str, Any]:
    """Runs needed for claims about P(all requirements met), and for narrower intervals."""
    share = passed / n if n else 0.5
    return {
        "claim_without_a_failure": {f"{c:g}": statistics.runs_needed(c) for c in CLAIMS},
        "claim_with_failures_as_now": {
            f"{c:g}": statistics.runs_needed(c, n - passed) if share > c else None for c in CLAIMS
        },
        "half_width": {f"{w:g}": statistics.runs_for_half_width(share, w) for w in HALF_WIDTHS},
        "tolerance_by_the_largest": {f"{c:g}": statistics.runs_for_tolerance(c) for c in COVERAGES},
    }


def _pair(one: str, first: pd.DataFrame, other: str, second: pd.DataFrame) -> dict[str, Any]:
    """Two variants compared, over the runs in which both were judged."""
    a, b = (judged(rows.set_index("run")["passed"]) for rows in (first, second))
    runs = a.index.intersection(b.index)
    result = statistics.paired(a[runs].tolist(), b[runs].tolist())
    return {"first": one, "second": other, "n": len(runs), **result.plain}


LEAST_RUNS = 20
"""With fewer runs there is no answer."""
ENOUGH_RUNS = 100
"""With fewer runs the answer is indicative: inputs are restricted to larger parts of their values, and there is no `s1`."""
_FLIGHTS_OF_A_PART = 10
"""Flights in each part of an input's values, at least, unless that makes less than three parts."""
_PARTS = (10, 8, 7, 5, 4, 3)  # with 6 and 9, rounding takes SALib's last quantile beyond 1
_DUMMIES = 20


def sensitivity(frame: pd.DataFrame, inputs: Sequence[str], outputs: Sequence[str]) -> dict[str, Any]:
    """{output: {"inputs": {input: indices}, "indicative": bool}} for one variant's rows; else {output: {"reason": why}}.

    By SALib. PAWN (Pianosi and Wagener 2018): how far the distribution of the result moves (Kolmogorov-Smirnov distance) when one
    input is restricted to a part of its values, a tenth where there are runs enough; the index is the median over the parts.
    Random dummy inputs, on which no flight depends, show how large the index becomes by chance. RBD-FAST (Tarantola, Gatelli and
    Mara 2006; Plischke 2010): the share of the variance of the result that one input explains by itself.

    Indices: `pawn`; `pawn_by_chance`, the 95 % quantile of the dummies' PAWN; `matters`, whether `pawn` is above that; `s1`,
    the share of variance; `s1_half_width` of its 95 % interval. These may be NaN, which becomes None in summary.json.
    `indicative` is True beside the inputs where there are fewer than ENOUGH_RUNS runs.
    """
    return {output: _of_output(frame, inputs, output) for output in outputs}


def _of_output(frame: pd.DataFrame, inputs: Sequence[str], output: str) -> dict[str, Any]:
    y = frame[output].to_numpy(dtype=float)
    rows = np.isfinite(y)
    y, chosen = y[rows], frame[rows]
    varied = [name for name in inputs if chosen[name].nunique() > 1]
    reason = _too_few(y, output, varied)
    if reason:
        return {"reason": reason}
    from SALib.analyze import pawn, rbd_fast

    rng, n = np.random.default_rng(20), len(y)
    x = np.column_stack([*(_ranks(chosen[name], rng) for name in varied), rng.random((n, _DUMMIES))])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about empty slices, which PAWN skips
        moved = pawn.analyze(_problem(x.shape[1]), x, y, S=_parts(n))["median"]
        alone = {"S1": [np.nan] * len(varied), "S1_conf": [np.nan] * len(varied)}
        if n >= ENOUGH_RUNS:
            alone = rbd_fast.analyze(
                _problem(len(varied)), x[:, : len(varied)], y, num_resamples=50, seed=rng
            )
    chance = float(np.quantile(moved[len(varied) :], 0.95))
    return {
        "indicative": n < ENOUGH_RUNS,
        "inputs": {
            name: {
                "pawn": float(moved[j]),
                "pawn_by_chance": chance,
                "matters": bool(moved[j] > chance),
                "s1": float(alone["S1"][j]),
                "s1_half_width": float(alone["S1_conf"][j]),
            }
            for j, name in enumerate(varied)
        },
    }


def _parts(n: int) -> int:
    """Number of parts into which the values of an input are divided: ten, or fewer with few flights."""
    return next((parts for parts in _PARTS if parts <= n // _FLIGHTS_OF_A_PART), _PARTS[-1])


def _too_few(y: np.ndarray, output: str, varied: Sequence[str]) -> str:
    if not varied:
        return "nothing varies"
    if len(y) < LEAST_RUNS:
        return f"{len(y)} runs, at least {LEAST_RUNS} are needed"
    least = _parts(len(y))
    if len(np.unique(y)) <= 2 and min(np.sum(y == y.min()), np.sum(y != y.min())) < least:
        return f"{output} is nearly always the same: fewer than {least} flights differ"
    return ""


def _ranks(values: pd.Series, rng: np.random.Generator) -> np.ndarray:
    """Ranks in (0, 1) of numbers or names; equal values are ranked in random order."""
    codes = (
        values.factorize(sort=True)[0] if values.dtype.kind not in "fiub" else values.to_numpy(dtype=float)
    )
    order = np.lexsort((rng.random(len(codes)), codes))
    ranks = np.empty(len(codes))
    ranks[order] = (np.arange(len(codes)) + 0.5) / len(codes)
    return ranks


def _problem(count: int) -> dict[str, Any]:
    return {"num_vars": count, "names": [str(j) for j in range(count)], "bounds": [[0.0, 1.0]] * count}
