"""Which varied values affect the result most: sensitivity indices from the flights of the sweep, by SALib.

PAWN (Pianosi and Wagener 2018): how far the distribution of the result moves (Kolmogorov-Smirnov distance) when one input
is restricted to a part of its values, a tenth where there are runs enough; the index is the median over the parts. Random
dummy inputs, on which no flight depends, show how large the index becomes by chance. RBD-FAST (Tarantola, Gatelli and Mara
2006; Plischke 2010): the share of the variance of the result that one input explains by itself.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pandas as pd

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
