"""How each controller did: a table with a row for each flight, and what it says of each controller, paired by draw.

All controllers fly the same draws, so two are compared draw by draw. A flight without a result is lost: its controller raised
an error, gave what is no number, or took too long. The bound of a draw is the best of all that were flown, those that are told the
truth among them.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from operator import attrgetter
from typing import Any

import numpy as np
import pandas as pd
from scipy.stats import rankdata

from testbed.common.files import plain
from testbed.common.statistics import mean, paired, proportion, rate
from testbed.failures.losses import LOST
from testbed.flight.flight import Outcome
from testbed.inputs.problems import BadInput, Problem
from testbed.studies.benchmark.load import as_given
from testbed.studies.benchmark.plan import Benchmark
from testbed.studies.folder.logs import HISTORY_BYTES, HISTORY_CHANNELS, HISTORY_SHAPE
from testbed.studies.folder.store import NAME, Store
from testbed.studies.folder.table import records
from testbed.studies.record import NO_RESULT, Record, key_of

BOUND = "best of all"
"""The name of the bound beside those of controllers."""
FACTORS = ("failures", "course", "aircraft", "truth", "weather", "gust", "sensors")
"""What results are counted by."""
_METRICS = (
    "altitude_error_max_m", "heading_error_max_deg", "detection_delay_s", "missed_detections", "false_alarms",
    "control_effort_per_s", "saturated_time_s",
)  # fmt: skip
_WORST = 5
"""Draws of each controller that are named as lost."""
_RESAMPLES = 2000
"""Resamples of the draws from which the interval of a rank is."""
Summary = dict[str, Any]


def table(plan: Benchmark, store: Store) -> pd.DataFrame:
    """A row for each flight, in the order of draws and controllers; draws that not every controller has flown are left out.

    Raises BadInput where a flight was of another draw than the suite has now, as of another version of the program.
    """
    rows = []
    for number, flights in itertools.groupby(records(plan, store), attrgetter("run")):
        flown = list(flights)
        if len(flown) == len(plan.variants):
            values = plan.task(number * len(flown)).values
            limits = [each["at_most"] for each in values["requirements"]]
            if any(record.values != plain(values) for record in flown):
                raise BadInput([Problem(f"draw {number} was drawn otherwise than this version does")])
            rows += [_row(plan, record, _history(plan, store, record), limits) for record in flown]
    return pd.DataFrame(rows)


def _history(plan: Benchmark, store: Store, record: Record) -> bytes:
    """The error history of a flight; raises BadInput for one that has not as many bytes as each has."""
    history = store.history(key_of(record.run * len(plan.variants) + record.variant))
    if len(history) not in (0, HISTORY_BYTES):
        what = f"has an error history of {len(history)} bytes in draw {record.run}"
        raise BadInput([Problem(what, str(store.folder / NAME), expected=f"{HISTORY_BYTES} bytes")])
    return history


def _row(plan: Benchmark, record: Record, history: bytes, limits: Sequence[float]) -> dict[str, Any]:
    return {
        "draw": record.run,
        "controller": plan.labels[record.variant],
        **{factor: plan.groups(record.run)[factor] for factor in FACTORS},
        "breaks": any(map(_breaks, record.values["failures"])),
        "outcome": record.outcome,
        "survived": record.outcome == Outcome.completed,
        "held": bool(record.passed),
        "inside": _inside(history, limits),
        "end_time_s": record.end_time_s,
        **{name: record.metrics.get(name, math.nan) for name in _METRICS},
        **({"environment": record.environment} if record.environment else {}),
        "reason": record.reason,
    }


def _breaks(failure: Mapping[str, Any]) -> bool:
    """Whether a failure breaks its actuator, so that it is to be flagged (`flight.breakage`)."""
    return "actuator" in failure and (failure["type"] != "effectiveness" or failure["value"] <= LOST)


def _inside(history: bytes, limits: Sequence[float]) -> float:
    """Share of the flight's planned time within the limits of altitude and heading, 0 to 1, by the points of its history."""
    if not history:
        return 0.0
    errors = np.frombuffer(history, "<f4").reshape(HISTORY_SHAPE)
    names = [name.partition("_")[0] for name in HISTORY_CHANNELS]
    altitude, heading = (np.abs(errors[names.index(name)]) for name in ("altitude", "heading"))
    return float(np.mean((altitude <= limits[0]) & (heading <= limits[1])))  # NaN after the end is outside


def summarize(plan: Benchmark, frame: pd.DataFrame) -> Summary:
    """What the table says; nothing in it depends on the clock, the machine or the order of the flights."""
    wide = {name: frame.pivot(index="draw", columns="controller", values=name)[plan.labels]
            for name in ("survived", "held", "inside")}  # fmt: skip
    for each in wide.values():
        each[BOUND] = each.max(axis=1)
    return plain(
        {
            **{key: value for key, value in plan.tree.items() if key != "suite"},
            "suite": plan.suite.suite,
            "version": plan.suite.version,
            "suite_sha256": plan.digest,
            "law_sha256": plan.law,
            "draws": len(wide["held"]),
            "reference": plan.labels[0],
            "order": [*plan.labels, BOUND],
            "told": [name for name in plan.suite.told if name in plan.labels],
            "given": {
                name: as_given(plan.suite, name, said) for name, said in plan.tree["controllers"].items()
            },
            "ablated": _ablated(plan.tree["controllers"]),
            "scores": {name: _score(plan, frame, wide, name) for name in [*plan.labels, BOUND]},
            "halves": _halves(plan, wide),
            "by": {factor: _by(frame, wide["held"], factor) for factor in FACTORS},
            "lost": {name: list(_lost(plan, frame, wide, name)) for name in plan.labels},
        }
    )


def _ablated(controllers: Mapping[str, Any]) -> list[str]:
    """The controllers that are the reference without some of its parts."""
    first = next(iter(controllers.values()))
    kind = first["type"] if isinstance(first, Mapping) and not first.get("ablate") else None
    shipped = {name: said for name, said in controllers.items() if isinstance(said, Mapping)}
    return [name for name, said in shipped.items() if said.get("ablate") and said["type"] == kind]


def _rivals(plan: Benchmark) -> list[str]:
    """Who is compared: all but those that are told the truth, and the reference without some of its parts."""
    apart = {*plan.suite.told, *_ablated(plan.tree["controllers"])}
    return [name for name in plan.labels if name not in apart]


def _score(plan: Benchmark, frame: pd.DataFrame, wide: Mapping[str, pd.DataFrame], name: str) -> Summary:
    """The shares and means of one controller, and its differences from the reference."""
    first = plan.labels[0]
    survived, held, inside = (wide[each][name] for each in ("survived", "held", "inside"))
    score = {
        "survived": _share(survived),
        "held": _share(held),
        "inside": _mean(inside),
        "short_of_bound": _mean(wide["inside"][BOUND] - inside),
        "against_reference": {
            "survived": paired(survived.tolist(), wide["survived"][first].tolist()).plain,
            "held": paired(held.tolist(), wide["held"][first].tolist()).plain,
            "inside": _mean(inside - wide["inside"][first]),
        },
    }
    if name == BOUND:
        return score
    rows, ours = (frame[frame["controller"] == each].set_index("draw") for each in (name, first))
    effort = rows["control_effort_per_s"] / ours["control_effort_per_s"]
    return score | {"effort": effort.median()} | _noticed(rows)


def _halves(plan: Benchmark, wide: Mapping[str, pd.DataFrame]) -> list[Summary]:
    """The scores and the rank by *inside* in the first and in the second half of the draws, of the rivals."""
    names = _rivals(plan)
    held, inside = (wide[name][names] for name in ("held", "inside"))
    half = len(held) // 2
    found = []
    for part in (slice(half), slice(half, None)) if half else ():
        ranks = _ranks(inside[part].to_numpy())
        found.append({
            name: {"held": _share(held[name][part]), "inside": _mean(inside[name][part]), "rank": rank}
            for name, rank in zip(names, ranks, strict=True)
        })  # fmt: skip
    return found


def _ranks(inside: np.ndarray) -> list[Summary]:
    """The rank of each column [draws, n] by its mean, 1 the largest, with the interval of 95 % of the bootstrap of the rows.

    Of equal ones the first comes first.
    """
    draws = len(inside)
    counts = np.random.default_rng(draws).multinomial(draws, [1.0 / draws] * draws, size=_RESAMPLES)
    low, high = np.quantile(rankdata(-(counts @ inside), "ordinal", axis=-1), [0.025, 0.975], axis=0)
    known = zip(rankdata(-inside.sum(axis=0), "ordinal"), low, high, strict=True)
    return [{"estimate": int(a), "low": float(b), "high": float(c)} for a, b, c in known]


def _noticed(rows: pd.DataFrame) -> Summary:
    """What was flagged, how soon, and what control cost, of the flights of one controller."""
    healthy, broken = (rows[(rows["failures"] == "none") == flag] for flag in (True, False))
    hours = float(healthy["end_time_s"].sum() / 3600.0)
    flags = bool(rows["false_alarms"].notna().any())
    broken = broken if flags else broken[:0]  # one that says nothing of failures is not judged by them
    alarms = int(healthy["false_alarms"].sum()) if flags else None
    return {
        "noticed": _share(broken[broken["breaks"]]["detection_delay_s"].notna()),
        "missed": _share(broken["missed_detections"] > 0),
        "named_wrongly": _share(broken["false_alarms"] > 0),
        "delay_s": {f"p{100 * q:g}": rows["detection_delay_s"].quantile(q) for q in (0.5, 0.9)},
        "healthy_hours": hours,
        "healthy_false_alarms": alarms,
        "healthy_false_alarms_per_h": None if alarms is None else rate(alarms, hours).plain,
        "saturated_s": rows["saturated_time_s"].mean(),
        "without_result": rows[rows["outcome"].isin(NO_RESULT)]["reason"].value_counts().to_dict(),
    }


def _by(frame: pd.DataFrame, held: pd.DataFrame, factor: str) -> Summary:
    """For each group of a factor, the number of draws and how many of them each controller held."""
    groups = frame.drop_duplicates("draw").set_index("draw")[factor]
    return {
        str(group): {"draws": len(draws), "held": held.loc[draws.index].sum().astype(int).to_dict()}
        for group, draws in sorted(groups.groupby(groups))
    }


def _lost(
    plan: Benchmark, frame: pd.DataFrame, wide: Mapping[str, pd.DataFrame], name: str
) -> Iterable[Summary]:
    """The draws that a controller did not hold and others did, those first in which it was outside longest."""
    untold = [other for other in _rivals(plan) if other != name]
    held, inside = wide["held"], wide["inside"][name]
    which = inside[~held[name].astype(bool) & held[untold].any(axis=1)].sort_values(kind="stable")
    rows = frame[frame["controller"] == name].set_index("draw")
    for draw in which.index[:_WORST]:
        said = {key: str(rows.loc[draw, key]) for key in ("outcome", *FACTORS)}
        others = [other for other in untold if held.loc[draw, other]]
        yield {"draw": int(draw), "of": len(which), "inside": inside[draw], "held_by": others, **said}


def _share(flags: pd.Series) -> Summary:
    return proportion(int(flags.sum()), len(flags)).plain


def _mean(values: pd.Series) -> Summary:
    return mean(values.tolist()).plain
