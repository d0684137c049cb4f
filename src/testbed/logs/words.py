"""A diagnosis in sentences and in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from testbed.logs.diagnosis import UNKNOWN_STD, WINDOW_S, Diagnosis, Finding
from testbed.logs.hypotheses import STATES
from testbed.reporting.words import title

_MUCH = 0.2
"""Share of a log in which nothing can be known of an actuator, from which on the story says so."""
_INFLATED = 10.0


def story(diagnosis: Diagnosis) -> list[str]:
    """What the log says, in sentences: what was found, what cannot be known, and what was mended in the log."""
    log = diagnosis.log
    length = log.time_s[-1] - log.time_s[0]
    found = [sentence(finding, diagnosis) for finding in diagnosis.findings]
    return [*(found or [f"Nothing was found wrong in {length:.0f} s."]), *_unknown(diagnosis), *log.remarks]


def sentence(finding: Finding, diagnosis: Diagnosis) -> str:
    """`The left tail kept 20 % of its effect (+-6) from 20.0 s on (probability 0.99).`"""
    unit = diagnosis.units[diagnosis.actuators.index(finding.actuator)]
    at = f"{finding.position:.1f} {unit}"
    did = {
        "weak": f"kept {100 * finding.effectiveness:.0f} % of its effect (+-{100 * finding.std:.0f})",
        "lost": "had no effect",
        "held": f"did not follow its commands, and acted as if held at {at}",
        "offset": f"followed with an offset of {at}",
        "reversed": "acted against its commands",
        "slow": "followed more slowly than designed",
        "late": "followed late",
        "swings": "moved by itself",
    }[finding.state]
    last = finding.until_s >= diagnosis.time_s[-1]
    until = "on" if last else f"until {finding.until_s:.1f} s"
    return f"The {title(finding.actuator)} {did} from {finding.from_s:.1f} s {until} (probability {finding.probability:.2f})."


def _unknown(diagnosis: Diagnosis) -> Iterator[str]:
    for i, name in enumerate(diagnosis.actuators):
        share = diagnosis.unknown_share(i)
        if share > _MUCH:
            alike = float(np.median(diagnosis.inflation[:, i])) > _INFLATED
            why = "it moved like others" if alike else "it hardly moved"
            known = f"{WINDOW_S:g} s give its effectiveness with a standard deviation above {UNKNOWN_STD:g}"
            yield f"What the {title(name)} did cannot be known in {100 * share:.0f} % of the log: {why}, and {known}."


def summary(diagnosis: Diagnosis, model: str) -> dict[str, Any]:
    """The contents of summary.json: JSON has no NaN, so what a state has not is null."""
    return {
        "log": diagnosis.log.name,
        "model": model,
        "duration_s": float(diagnosis.log.time_s[-1] - diagnosis.log.time_s[0]),
        "findings": [{k: _plain(v) for k, v in vars(finding).items()} for finding in diagnosis.findings],
        "actuators": {
            name: {
                "unknown_share": diagnosis.unknown_share(i),
                "alone_std_median": _plain(np.median(diagnosis.alone_std[:, i])),
                "variance_inflation_median": _plain(np.median(diagnosis.inflation[:, i])),
            }
            for i, name in enumerate(diagnosis.actuators)
        },
        "remarks": list(diagnosis.log.remarks),
        "story": story(diagnosis),
    }


def _plain(value: Any) -> Any:
    if isinstance(value, str):
        return value
    return round(float(value), 6) if math.isfinite(value) else None


def table(diagnosis: Diagnosis) -> str:
    """diagnosis.csv: a row for each 0.2 s; `A_state` is a word; what a state has not is empty."""
    heads, columns = ["time_s"], [[f"{time:.3f}" for time in diagnosis.time_s]]
    numbers = {
        "probability": diagnosis.probability, "effectiveness": diagnosis.effectiveness, "effectiveness_std": diagnosis.std,
        "alone_std": diagnosis.alone_std, "variance_inflation": diagnosis.inflation,
    }  # fmt: skip
    for i, name in enumerate(diagnosis.actuators):
        heads.append(f"{name}_state")
        columns.append([STATES[state] for state in diagnosis.states[:, i]])
        for what, values in numbers.items():
            heads.append(f"{name}_{what}")
            columns.append([f"{value:.4g}" if math.isfinite(value) else "" for value in values[:, i]])
    rows = [",".join(heads), *map(",".join, zip(*columns, strict=True))]
    return "\n".join(rows) + "\n"
