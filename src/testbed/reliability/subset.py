"""Subset simulation, repeated until the failure probability is known well enough: `subset`; and independent draws, `plain`.

These check the other methods, and take the place of subset simulation where the limit state is flat.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy import stats

from testbed.common.statistics import CONFIDENCE, proportion
from testbed.reliability.limit_state import Asked
from testbed.reliability.results import FailureProbability, Level
from testbed.reliability.subset_run import LENGTH, Run, run_levels

LEAST = 100
"""Fewest points a level: ten chains."""
FIRST = 45.0
"""Points a level of the first run, times the square of the asked c.o.v."""
ALLOWANCE = 1.15
"""Factor on the width of the interval. Thresholds and spreads come from the points that they are used for, which the
estimated variance leaves out; measured on known limit states, the scatter is up to so much greater."""
RESERVE = 0.3
"""Share of a level that each further run leaves of the budget."""
DISAGREE = 1e-3
"""Runs that differ more than by chance in one of a thousand cases are not averaged."""


def subset(asked: Asked, random: np.random.Generator, cov: float) -> FailureProbability:
    """Run subset simulation, and again with as many points as are missing, until `cov` or the budget is reached.

    The estimate is the geometric mean of the runs, weighted by their points. Its interval is log-normal with Student's t, which has
    as many degrees of freedom as independent draws have failures among their descendants, less one. A limit state that is
    flat is sampled plainly instead. Runs that could not go on give an interval from 0.
    """
    return go_on(asked, random, cov, [first_run(asked, random, cov)])


def first_run(asked: Asked, random: np.random.Generator, cov: float) -> Run:
    """A run with the points a level that `cov` needs near a probability of 1e-3, at most an eighth of the budget."""
    wanted = max(LEAST, min(FIRST / cov**2, asked.budget / 8))
    return run_levels(asked, max(LENGTH, _whole(min(wanted, asked.budget))), random)


def go_on(asked: Asked, random: np.random.Generator, cov: float, runs: list[Run]) -> FailureProbability:
    """Add runs to the first one until `cov` or the budget is reached."""
    if runs[0].end == "flat" and len(runs[0].levels) == 1:
        return _flat(asked, random, cov, runs[0])
    while runs[-1].end == "reached" and _cov(runs) > cov:
        missing, left = 1.1 * _missing(runs, cov) + LEAST, asked.left / (_cost(runs) + RESERVE)
        size = _whole(min(missing, left))
        if size < LEAST:
            break
        runs.append(run_levels(asked, size, random))
    if len(runs) > 1 and runs[-1].end == "budget":
        runs.pop()
    return _known(asked, runs, cov) if runs[-1].end == "reached" else _unknown(asked, runs)


def instead(
    asked: Asked, random: np.random.Generator, cov: float, run: Run, doubt: str
) -> FailureProbability:
    """Subset simulation with what is left of the budget, because of a doubt about importance sampling."""
    known = go_on(asked, random, cov, [run])
    return replace(known, reason=f"Not by importance sampling, as {doubt}. {known.reason}")


def _missing(runs: Sequence[Run], cov: float) -> float:
    """Points a level that are missing for `cov`."""
    return sum(run.size for run in runs) * (_cov(runs) ** 2 / cov**2 - 1)


def _cost(runs: Sequence[Run]) -> float:
    """Evaluations of a run, divided by its points a level."""
    return runs[0].evaluations / runs[0].size


def missing_evaluations(run: Run, cov: float) -> float:
    """Evaluations of further runs until `cov` is reached, from that of a first run."""
    return _missing([run], cov) * _cost([run])


def _whole(size: float) -> int:
    return int(size) // LENGTH * LENGTH


def _weights(runs: Sequence[Run]) -> np.ndarray:
    sizes = np.array([run.size for run in runs], dtype=float)
    return sizes / sizes.sum()


def _cov(runs: Sequence[Run]) -> float:
    """Coefficient of variation of the weighted mean."""
    return math.sqrt(np.sum(_weights(runs) ** 2 * [run.variance for run in runs]))


def log_normal(probability: float, cov: float, degrees: int, factor: float = 1.0) -> tuple[float, float]:
    """Interval of a positive estimate, whose logarithm has variance ln(1 + cov^2), known with so many degrees of freedom."""
    width = factor * stats.t.ppf((1 + CONFIDENCE) / 2, max(degrees, 1)) * math.sqrt(math.log1p(cov**2))
    return probability * math.exp(-width), min(1.0, probability * math.exp(min(width, 700.0)))


def _interval(run: Run) -> tuple[float, float]:
    """The interval of a single run."""
    return log_normal(run.probability, math.sqrt(run.variance), run.ancestors - 1, ALLOWANCE)


def _known(asked: Asked, runs: Sequence[Run], cov: float) -> FailureProbability:
    # Geometric mean, weighted by the points: the mean of log-normal estimates would be drawn upward by single runs.
    probability = float(np.exp(_weights(runs) @ np.log([run.probability for run in runs])))
    reached, agreed = _cov(runs), _agree(runs)
    low, high = log_normal(probability, reached, sum(run.ancestors for run in runs) - 1, ALLOWANCE)
    if not agreed:
        ends = np.array(list(map(_interval, runs)))
        low, high = min(low, *ends[:, 0].tolist()), max(high, *ends[:, 1].tolist())
    high = min(1.0, high + max(sum(run.unknown) for run in runs))
    converged = agreed and reached <= cov and not asked.unknown
    reason = _reason(asked, runs, agreed, reached, cov)
    return asked.answer("subset", probability, reached, (low, high), runs[0].levels, converged, reason)


def _agree(runs: Sequence[Run]) -> bool:
    """Whether the logarithms of the runs' estimates differ no more than their variances say (chi-squared test)."""
    logs = np.log([run.probability for run in runs])
    precision = 1 / np.log1p([run.variance for run in runs])
    mean = np.average(logs, weights=precision)
    return len(runs) == 1 or stats.chi2.sf(np.sum(precision * (logs - mean) ** 2), len(runs) - 1) > DISAGREE


def _reason(asked: Asked, runs: Sequence[Run], agreed: bool, reached: float, cov: float) -> str:
    if asked.unknown:
        return f"{asked.unknown} of {asked.evaluations} values were not a number; the interval's upper end has them as failures."
    if not agreed:
        return f"{len(runs)} runs disagree by more than their scatter; the interval holds that of each."
    said = f"{len(runs)} run{'s' * (len(runs) > 1)} of subset simulation, c.o.v. {reached:.2f}"
    return f"{said}." if reached <= cov else f"{said}; the budget was spent before {cov:g} was reached."


def _unknown(asked: Asked, runs: Sequence[Run]) -> FailureProbability:
    """The last run did not get to the failures, or its chains did not move: an upper end is all that is known."""
    run = runs[-1]
    last = run.levels[-1].probability if run.end != "stuck" else 1.0
    spread = math.sqrt(math.log1p(sum(level.cov**2 for level in run.levels[:-1])))
    chains = run.size // LENGTH  # each counts as one point
    share = proportion(math.ceil(last * chains), chains, method="exact").high
    ends = [run.above * share * math.exp(stats.norm.ppf(CONFIDENCE) * spread)]
    ends += [_interval(one)[1] for one in runs[:-1]]
    high = min(1.0, max(ends) + max(sum(one.unknown) for one in runs))
    probability = math.nan if run.end == "stuck" else run.above * len(run.failures) / (run.size or 1)
    return asked.answer("subset", probability, math.inf, (0.0, high), run.levels, False, _why(run))


def _why(run: Run) -> str:
    level = run.levels[-1]
    if run.end == "stuck":
        return f"The chains hardly move ({run.accepted:.0%} of the steps taken): the limit state is too rough to be followed down."
    if run.end == "flat":
        return f"The limit state is flat at {level.threshold:.3g}: {level.probability:.0%} of a level have the same lowest value."
    return f"The budget was spent at the level {level.threshold:.3g}, before the failures were reached."


def _flat(asked: Asked, random: np.random.Generator, cov: float, run: Run) -> FailureProbability:
    """Plain sampling with what is left, where nothing shows the way down."""
    known = plain(asked, random, cov, failures=len(run.failures), n=run.size)
    words = f"The limit state is flat, so the points were drawn plainly: {known.reason}"
    return replace(known, method="subset", reason=words)


BATCH = 1000


def plain(
    asked: Asked, random: np.random.Generator, cov: float, failures: int = 0, n: int = 0
) -> FailureProbability:
    """Draw batches, after `failures` in `n` draws, until the coefficient of variation is at most `cov` or the budget is spent.

    It is sqrt((1 - p) / (p n)). The interval is that of Clopper and Pearson (1934). Points without a number widen it: its
    upper end counts them as failures.
    """
    while asked.left > 0 and _plain_cov(failures, n) > cov:
        values = asked(random.standard_normal((min(BATCH, asked.left), asked.dimensions)))
        failures += int((values <= 0).sum())
        n += len(values)
    known, found = proportion(failures, n, method="exact"), _plain_cov(failures, n)
    high = proportion(failures + asked.unknown, n, method="exact").high
    level = Level(0.0, known.estimate, found, n)
    converged = found <= cov and not asked.unknown
    reason = _plain_reason(asked, failures, n, converged)
    return asked.answer("plain", known.estimate, found, (known.low, high), [level], converged, reason)


def _plain_cov(failures: int, n: int) -> float:
    return math.sqrt((n - failures) / (failures * n)) if failures else math.inf


def _plain_reason(asked: Asked, failures: int, n: int, converged: bool) -> str:
    if asked.unknown:
        return f"{asked.unknown} of {n} values were not a number; the interval's upper end counts them as failures."
    said = f"{failures} failure{'s' * (failures != 1)} in {n} independent draws"
    return (
        f"{said}." if converged else f"{said}; the budget was spent before the asked precision was reached."
    )
