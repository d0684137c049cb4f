"""What a log says of each actuator over time, in sentences and in numbers."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from testbed.common.files import plain
from testbed.logs.flight_log import FlightLog
from testbed.logs.hypotheses import STATES
from testbed.reporting.words import number, title

WINDOW_S = 10.0
"""Length of the windows in which it is said what can be known."""
UNKNOWN_STD = 0.3
"""Standard deviation of an effectiveness from a window alone [1] beyond which it says nothing."""
_MUCH = 0.2
"""Share of a log in which nothing can be known of an actuator, from which on the story says so."""
_INFLATED = 10.0


@dataclass(frozen=True)
class Finding:
    """What one actuator did during a stretch: `state` of `hypotheses.STATES`, from and until [s].

    `probability` is that of this state of this actuator, averaged over the stretch. `effectiveness` and `std` are the smoothed
    ones; `position` is where it was held, or by how much it was offset, in its unit. NaN is what a state has not.
    """

    actuator: str
    state: str
    from_s: float
    until_s: float
    probability: float
    effectiveness: float
    std: float
    position: float


@dataclass(frozen=True)
class Diagnosis:
    """What a log says; `print` shows its story.

    Attributes:
        actuators: their names.
        units: of their positions, `deg` or `N`.
        time_s: [T] beginning of each block of 0.2 s.
        states: [T, n] number of `hypotheses.STATES`.
        probability: [T, n] of that state.
        effectiveness, std: [T, n] smoothed; NaN where an actuator is held, as nothing follows its command.
        alone_std: [T, n] what a window of 10 s says by itself.
        inflation: [T, n] of that variance by the other actuators' moving alike.
        findings: each stretch in which an actuator did not work.
    """

    log: FlightLog
    actuators: tuple[str, ...]
    units: tuple[str, ...]
    time_s: np.ndarray
    states: np.ndarray
    probability: np.ndarray
    effectiveness: np.ndarray
    std: np.ndarray
    alone_std: np.ndarray
    inflation: np.ndarray
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        return "\n".join(story(self))

    def unknown_share(self, actuator: int) -> float:
        """Share of the log in which nothing can be known of an actuator."""
        return float(np.mean(self.alone_std[:, actuator] > UNKNOWN_STD))


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


def summary(diagnosis: Diagnosis, model: str) -> str:
    """summary.json."""
    return as_json(
        {
            "log": diagnosis.log.name,
            "model": model,
            "duration_s": float(diagnosis.log.time_s[-1] - diagnosis.log.time_s[0]),
            "findings": [{k: _rounded(v) for k, v in vars(each).items()} for each in diagnosis.findings],
            "actuators": {
                name: {
                    "unknown_share": diagnosis.unknown_share(i),
                    "alone_std_median": _rounded(np.median(diagnosis.alone_std[:, i])),
                    "variance_inflation_median": _rounded(np.median(diagnosis.inflation[:, i])),
                }
                for i, name in enumerate(diagnosis.actuators)
            },
            "remarks": diagnosis.log.remarks,
            "story": story(diagnosis),
        }
    )


def as_json(contents: dict[str, Any]) -> str:
    """A summary as text. JSON has no NaN, so what is not there is null."""
    return json.dumps(plain(contents), indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"


def _rounded(value: Any) -> Any:
    return value if isinstance(value, str) else round(float(value), 6)


def table(diagnosis: Diagnosis) -> str:
    """diagnosis.csv: a row for each 0.2 s; `A_state` is a word; what a state has not is empty."""
    columns = {"time_s": [f"{time:.3f}" for time in diagnosis.time_s]}
    numbers = {
        "probability": diagnosis.probability, "effectiveness": diagnosis.effectiveness, "effectiveness_std": diagnosis.std,
        "alone_std": diagnosis.alone_std, "variance_inflation": diagnosis.inflation,
    }  # fmt: skip
    for i, name in enumerate(diagnosis.actuators):
        columns[f"{name}_state"] = [STATES[state] for state in diagnosis.states[:, i]]
        for what, values in numbers.items():
            columns[f"{name}_{what}"] = [number(value, absent="") for value in values[:, i]]
    return "".join(",".join(row) + "\n" for row in [columns, *zip(*columns.values(), strict=True)])
