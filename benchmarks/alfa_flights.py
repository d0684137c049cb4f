"""Whether something failed, from recordings of the ALFA dataset: detection only, each recording left out once.

The data is that of the AIR Lab of CMU (Keipour, Mousaei, Scherer: ALFA, IJRR 40(2-3), 2021; CC BY 4.0). It stays out of this
project. Derived copies are read: https://github.com/FabioCarosi/FaultDetection_ALFA-Dataset, commit 50456b9 (20 Hz: gyros,
accelerometers, attitude, errors of the autopilot), and for the rule that reads the leak https://github.com/gotham29/htm-state,
commit d087ab2, which has a command, the throttle. No copy found has the actuators' outputs.

The relations and the protocol are those of https://github.com/bvsrasen/alfa-fault-detection: a sensor is foretold from others by
least squares on healthy flight, and a logistic regression judges what is left; nothing is said in the first 15 s.
"""

from __future__ import annotations

import csv
import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize
from scipy.special import expit

from testbed.inputs.problems import BadInput, Problem

STEP_S, QUIET_S, HOLD_S = 0.05, 15.0, 0.5
"""Between samples; without alarms at the beginning; for which a score must stay above the threshold."""
STILL_S = 6.0
DIGESTS = (
    "b2ce33262cfa1c61b2ae9c189a313eebdac10a6f8bd89122510feb54b3104f0e",
    "666fd92b4b9b9fac11abcc08874272036886225d50b143a954ef35e99381ea1d",
)
"""SHA-256 of the digests of all recordings that are read of both copies, in the order of their names."""
_RELATIONS: dict[str, tuple[str, ...]] = {
    "linear_acceleration.x": ("alt_error", "aspd_error", "orientation.y", "delta_pitch"),
    "linear_acceleration.y": (),
    "angular_velocity.x": ("delta_roll",),
    "angular_velocity.y": ("delta_pitch", "orientation.x"),
    "angular_velocity.z": ("orientation.x", "twist.linear.x"),
}
"""What is foretold, and from what."""


class Recording(NamedTuple):
    """Columns by name [rows], and the row in which something failed; None in healthy flight. `group` are parts of one recording."""

    group: str
    columns: dict[str, np.ndarray]
    failed: int | None


class Score(NamedTuple):
    """Of recordings: how many; failures with the first alarm after them; healthy ones without alarm; false alarms; failures without
    a right one; and delays [s]."""

    recordings: int
    right: int
    quiet: int
    false: int
    missed: int
    delays_s: tuple[float, ...]

    @property
    def words(self) -> str:
        """Accuracy, precision, recall and mean delay, as cells of a table."""
        faults = self.right + self.missed
        accuracy = (self.right + self.quiet) / self.recordings
        cells = [accuracy, self.right / max(self.right + self.false, 1), self.right / max(faults, 1)]
        return " | ".join(f"{cell:.2f}" for cell in [*cells, float(np.mean(self.delays_s or [np.nan]))])


def files_of(folder: Path, pattern: str, digest: str) -> list[Path]:
    """The recordings of a folder, each once. Raises BadInput where they are others."""
    found = {file.name: file for file in sorted(folder.glob(pattern))}
    files = [found[name] for name in sorted(found)]
    each = "".join(hashlib.sha256(file.read_bytes()).hexdigest() for file in files)
    if hashlib.sha256(each.encode()).hexdigest() != digest:
        raise BadInput(
            [Problem(f"has other recordings: {len(files)} {pattern}", str(folder), expected=digest)]
        )
    return files


def read(file: Path) -> Recording:
    """A recording at 20 Hz; what is missing stays as it was."""
    with file.open(newline="") as stream:
        rows = list(csv.reader(stream))
    columns = {}
    for name, values in zip(rows[0], zip(*rows[1:], strict=True), strict=True):
        if name != "%time":
            columns[name.removeprefix("field.")] = _filled(
                np.array([float(v) if v else np.nan for v in values])
            )
    on = np.flatnonzero(columns["data"] > 0.5) if "data" in columns else np.zeros(0, dtype=int)
    failed = int(on[0]) if len(on) else None
    return Recording("_".join(file.name.split("_")[1:2]), columns, failed)


def _filled(values: np.ndarray) -> np.ndarray:
    last = np.maximum.accumulate(np.where(np.isfinite(values), np.arange(len(values)), -1))
    return np.where(last >= 0, values[np.maximum(last, 0)], 0.0)


def _sides(recording: Recording) -> list[tuple[np.ndarray, np.ndarray]]:
    """(what is foretold [rows], what from [rows, terms]) of each relation."""
    made = []
    for name, terms in _RELATIONS.items():
        x = [recording.columns[each] for each in terms]
        made.append((recording.columns[name], np.stack([*x, np.ones(len(recording.columns[name]))], axis=1)))
    return made


def _healthy(recording: Recording) -> slice:
    return slice(round(QUIET_S / STEP_S), recording.failed)


def relations(recordings: Sequence[Recording]) -> list[np.ndarray]:
    """Coefficients of each relation, by least squares on healthy flight."""
    sides = [[(y[_healthy(r)], X[_healthy(r)]) for y, X in _sides(r)] for r in recordings]
    return [
        np.linalg.lstsq(np.concatenate([s[i][1] for s in sides]), np.concatenate([s[i][0] for s in sides]), rcond=None)[0]
        for i in range(len(_RELATIONS))
    ]  # fmt: skip


def features(recording: Recording, found: Sequence[np.ndarray]) -> np.ndarray:
    """[rows, 25] of what is left of each relation: itself, its size, its means over 1 and 3 s, and its spread over 1 s."""
    made = []
    for (y, X), one in zip(_sides(recording), found, strict=True):
        left = y - X @ one
        mean, square = _mean(left, 1.0), _mean(left**2, 1.0)
        spread = np.sqrt(np.maximum(square - mean**2, 0.0))
        made += [left, np.abs(left), mean, _mean(left, 3.0), spread]
    return np.stack(made, axis=1)


def _mean(values: np.ndarray, length_s: float) -> np.ndarray:
    """Of what was before."""
    count = round(length_s / STEP_S)
    sums = np.cumsum(np.concatenate([np.zeros(1), values]))
    first = np.maximum(np.arange(len(values)) + 1 - count, 0)
    return np.asarray((sums[1:] - sums[first]) / (np.arange(len(values)) + 1 - first))


def logistic(X: np.ndarray, y: np.ndarray) -> np.ndarray:
    """[columns + 1] weights, both classes counting alike."""
    X = np.column_stack([X, np.ones(len(X))])
    weight = np.where(y, 0.5 / y.mean(), 0.5 / (1.0 - y.mean())) / len(y)

    def loss(w: np.ndarray) -> tuple[float, np.ndarray]:
        score = X @ w
        value = weight @ (np.logaddexp(0.0, score) - y * score) + 0.5e-3 * w @ w
        return float(value), X.T @ (weight * (expit(score) - y)) + 1e-3 * w

    return np.asarray(minimize(loss, np.zeros(X.shape[1]), jac=True, method="L-BFGS-B").x)


def alarm(score: np.ndarray, threshold: float) -> int | None:
    """The row in which the score has been above the threshold for HOLD_S, after QUIET_S."""
    count = round(HOLD_S / STEP_S)
    above = (score > threshold) & (np.arange(len(score)) >= round(QUIET_S / STEP_S))
    runs = np.convolve(above.astype(int), np.ones(count, dtype=int))[: len(score)] == count
    return int(np.argmax(runs)) if runs.any() else None


def judged(recordings: Sequence[Recording], alarms: Sequence[int | None], step_s: float) -> Score:
    """By recording, as ALFA's authors do: an alarm before the failure, or in healthy flight, is false."""
    delays, false, missed, quiet = [], 0, 0, 0
    for recording, at in zip(recordings, alarms, strict=True):
        if at is not None and (recording.failed is None or at < recording.failed):
            false += 1
            missed += recording.failed is not None
        elif at is not None and recording.failed is not None:
            delays.append((at - recording.failed) * step_s)
        else:
            missed += recording.failed is not None
            quiet += recording.failed is None
    return Score(len(recordings), len(delays), quiet, false, missed, tuple(delays))


def left_out(recordings: Sequence[Recording]) -> Score:
    """Each group of parts of one recording is judged with what the others taught."""
    alarms: list[int | None] = [None] * len(recordings)
    for group in sorted({recording.group for recording in recordings}):
        detector = taught([recording for recording in recordings if recording.group != group])
        for i, recording in enumerate(recordings):
            if recording.group == group:
                alarms[i] = detector.alarm(recording)
    return judged(recordings, alarms, STEP_S)


class Detector(NamedTuple):
    """Relations, the scale of the features, weights, and a threshold."""

    found: list[np.ndarray]
    mean: np.ndarray
    spread: np.ndarray
    weights: np.ndarray
    threshold: float

    def score(self, recording: Recording) -> np.ndarray:
        """[rows], larger the likelier a failure."""
        scaled = (features(recording, self.found) - self.mean) / self.spread
        return np.asarray(scaled @ self.weights[:-1] + self.weights[-1])

    def alarm(self, recording: Recording) -> int | None:
        return alarm(self.score(recording), self.threshold)


def taught(recordings: Sequence[Recording]) -> Detector:
    """What some recordings teach; the threshold is the one with which most of them are judged rightly."""
    found, first = relations(recordings), round(QUIET_S / STEP_S)
    parts = [features(recording, found)[first:] for recording in recordings]
    X = np.concatenate(parts)
    mean, spread = X.mean(axis=0), X.std(axis=0) + 1e-9
    failed = [
        len(part) + first if r.failed is None else r.failed for part, r in zip(parts, recordings, strict=True)
    ]
    y = np.concatenate([np.arange(len(p)) + first >= at for p, at in zip(parts, failed, strict=True)]).astype(
        float
    )
    made = Detector(found, mean, spread, logistic((X - mean) / spread, y), 0.0)
    scores = [made.score(recording) for recording in recordings]

    def right(threshold: float) -> int:
        score = judged(recordings, [alarm(each, threshold) for each in scores], STEP_S)
        return score.right + score.quiet

    return made._replace(threshold=float(max(np.arange(-2.0, 8.0, 0.25), key=right)))


def still(file: Path) -> tuple[Recording, int | None]:
    """A recording at 10 Hz, and the row in which its throttle has not changed for STILL_S."""
    rows = np.genfromtxt(file, delimiter=",", names=True)
    moved = np.abs(np.diff(rows["throttle"], prepend=np.inf)) > 1e-9
    since = np.arange(len(rows)) - np.maximum.accumulate(np.where(moved, np.arange(len(rows)), 0))
    reached, on = np.flatnonzero(since >= 10 * STILL_S), np.flatnonzero(rows["is_boundary"] > 0.5)
    found = Recording("", {}, int(on[0]) if len(on) else None)
    return found, int(reached[0]) if len(reached) else None


def section(derived: Path, with_throttle: Path) -> str:
    """The part of the page about ALFA, in Markdown."""
    recordings = [read(file) for file in files_of(derived, "failures/*/carbonZ*.csv", DIGESTS[0])]
    pairs = [
        still(file) for file in files_of(with_throttle, "demos/uav/generated/streams/*/*.csv", DIGESTS[1])
    ]
    rule = judged([one for one, _ in pairs], [at for _, at in pairs], 0.1)
    own = left_out(recordings)
    return _SECTION.format(
        own=own.words, rule=rule.words, count=own.recordings, faults=own.right + own.missed, still=STILL_S, quiet=QUIET_S,
        groups=len({recording.group for recording in recordings}),
    )  # fmt: skip


_SECTION = """
## ALFA: that something failed

{count} recordings of a model aircraft of CMU ({faults} with a failure: engine, ailerons, rudder, elevator), judged as its authors
do: an alarm before the failure, or in healthy flight, is false. Sensors are foretold from others, and a logistic regression judges
what is left; each of {groups} flights is left out of what it is judged with. Nothing is said in the first {quiet:g} s.

| | accuracy | precision | recall | mean delay, s |
| --- | --- | --- | --- | --- |
| left out one at a time | {own} |
| published, so | 0.72 | 0.80 | 0.67 | 2.53 |
| published, on the 22 of the authors | | 0.88 | | 2.02 |
| **the leak**: the throttle has not changed for {still:g} s | {rule} |
| the leak, published: an output has not changed for 6 s | | 0.97 | 1.00 | |

The last two rows detect nothing: failures were made by holding an output, which is in the log. The throttle, the one command of
the copies at hand, tells the engine's failures alone.
"""
