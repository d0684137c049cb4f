"""ENAC's flying wing with faults of its elevons: logs, and what was broken, read from the authors' own drawings.

The data is that of https://github.com/mrtbrnz/fault_detection (Bronz, Baskaya, Delahaye, Puechmorel: Real-Time Fault Detection on
Small Fixed-Wing UAVs using Machine Learning, DASC 2020), commit 45e0ece. It is under the GPL and stays out of this project.

The onboard logs do not say what was broken. The drawing of all flights (`flights_all.pdf`) does, as lines whose points have six
decimals. Its clock is the autopilot's; three other drawings have the commands on that clock, and so tie the logs to it.
"""

from __future__ import annotations

import hashlib
import re
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from testbed.inputs.problems import BadInput, Problem

STEP_S = 0.1
FULL = 9600.0
"""A full command."""
_RIGHT, _LEFT, _OFFSET = "0.00 0.56 0.84", "0.99 0.31 0.19", "0.90 0.68 0.22"  # colours of the faults' lines
_DATA, _DRAWN = "data", "SVM/plots"
_ALL, _WIND = f"{_DRAWN}/flights_all.pdf", f"{_DRAWN}/flight_12_13_wind_effect.pdf"


class Panel(NamedTuple):
    """A panel of a drawing: lower left corner of its frame, the horizontal places of two times, and these times [s]."""

    file: str
    corner: tuple[float, float]
    places: tuple[float, float]
    times_s: tuple[float, float]


class Source(NamedTuple):
    """A flight: its log, the row of its faults in the drawing of all, the panel of its commands, and what is judged [s]."""

    log: str
    row: int
    panel: Panel | None
    judged_s: tuple[float, float]


FLIGHTS = {
    "12 July": Source("", 6, Panel(_WIND, (59.736, 43.835), (72.678189, 331.521164), (500.0, 1399.9)), (520.0, 1390.0)),
    "13 July": Source(f"{_DATA}/13_07_2020_Faulty_Daredevil/log.txt", 7,
                      Panel(_WIND, (401.409, 43.835), (414.350916, 673.193892), (500.0, 1399.9)), (500.0, 2700.0)),
    "17 July": Source(f"{_DATA}/17_07_2020_Faulty_Daredevil_MultiClass/final_log.txt", 8,
                      Panel(f"{_DRAWN}/flight_17_twisted_wing.pdf", (55.942, 43.835), (84.415163, 653.869708), (500.0, 3199.9)),
                      (520.0, 3243.0)),  # it lands at 3243.7
    "21 July": Source(f"{_DATA}/21_07_2020_Faulty_Daredevil_MultiClass_Sweep/21_07_2020_log.txt", 9,
                      Panel(f"{_DRAWN}/flight21072020.pdf", (59.736, 1060.584), (88.208768, 657.663313), (400.0, 2599.9)),
                      (400.0, 2600.0)),
    "23 July": Source(f"{_DATA}/23_07_2020_Faulty_Daredevil_MultiClass_Sweep_2/23_07_2020_log.txt", 10, None, (600.0, 2850.0)),
}  # fmt: skip
DIGESTS = {
    FLIGHTS["13 July"].log: "e4bf250507b4da410130a8c90ec385d943a8d250cbb58c7df97e43cb26fce946",
    FLIGHTS["17 July"].log: "bee92c31e833352d0d70ac6e16680135b12fe13a05a8be883cb979db03ed075e",
    FLIGHTS["21 July"].log: "786b23f6ac6d67a7addf210bc1ac51a62194baf058a778edcf1ae55edf97ec4b",
    FLIGHTS["23 July"].log: "8b32656bdfeee6f55ff8778ea8f479a9cc45832679c9ec72945931ab02fbe2af",
    _ALL: "a782f054a69363a462b758fa9f50c4b09774cacf1c9800f2674acf635d8ed579",
    _WIND: "bfbeeb628da0c02d9462ce81da71ac3b7f2f7698b38cd7e41157a6a43f3b1671",
    f"{_DRAWN}/flight_17_twisted_wing.pdf": "a433a30f3525a32f3f9a6ff0106c4d933af96c81f084bc8b24754dc34c864544",
    f"{_DRAWN}/flight21072020.pdf": "cc4f8056ef8c6a15277dbe85bd4c7622d6c249b49a7162d516de4f25e55fe1b9",
}
"""SHA-256 of every file that is read."""


class Flight(NamedTuple):
    """Rates p, q, r [rows, 3, rad/s], commands of roll and pitch [rows, 2, of a full one], at even times [rows, s] of the log."""

    time_s: np.ndarray
    rates: np.ndarray
    commands: np.ndarray


def check(folder: Path) -> None:
    """Raises BadInput for every file that is missing or another one."""
    problems = []
    for name, digest in DIGESTS.items():
        file = folder / name
        if not file.is_file():
            problems.append(
                Problem("is missing", str(file), expected="a checkout of mrtbrnz/fault_detection, 45e0ece")
            )
        elif hashlib.sha256(file.read_bytes()).hexdigest() != digest:
            problems.append(Problem("is another file", str(file), expected=f"SHA-256 {digest}"))
    if problems:
        raise BadInput(problems)


def read(folder: Path, day: str) -> Flight:
    """The log of a flight. That of 12 July has other quantities, so its rates and commands are read from the drawing."""
    source = FLIGHTS[day]
    if not source.log:
        return _drawn_flight(folder, source.panel)
    rows = np.load(folder / source.log, allow_pickle=False)  # [2 s, time and 20 samples of 8]
    values = rows[:, 1:].reshape(-1, 8)
    time_s = (rows[:, 0] - rows[0, 0])[:, None] + STEP_S * np.arange(20)
    return Flight(time_s.ravel(), values[:, 3:6], values[:, 6:8] / FULL)


def _drawn_flight(folder: Path, panel: Panel | None) -> Flight:
    assert panel is not None
    lines, above = _lines(folder / panel.file), 298.322 - panel.corner[1]
    time_s = np.arange(panel.times_s[0], panel.times_s[1], STEP_S)
    commands = [line for _, line in _within(lines, panel.corner)]
    rates = [line for _, line in _within(lines, (panel.corner[0], panel.corner[1] + above))]
    place = np.interp(time_s, panel.times_s, panel.places)
    # the rates' axis goes from -1 to 1 rad/s, that of the commands from -20 to 10 deg, with 25 deg for a full one
    low, high = panel.corner[1], 212.0727
    p, q, r = ((np.interp(place, *each.T) - low - above) / high * 2.0 - 1.0 for each in rates)
    first, second = ((np.interp(place, *each.T) - low) / high * 30.0 - 20.0 for each in commands)
    return Flight(time_s, np.stack([p, q, r], axis=1), np.stack([-first, second], axis=1) / 25.0)


def faults(folder: Path, day: str) -> tuple[np.ndarray, np.ndarray]:
    """(times [s] of the autopilot, [times, 2] factors on the right and the left elevon's deflection)."""
    lines = [(corner, colour, line) for corner, colour, line in _lines(folder / _ALL) if _wide(corner)]
    rows = sorted({corner[1] for corner, _, _ in lines}, reverse=True)
    own: dict[str, np.ndarray] = {}
    for corner, colour, line in lines:  # the last of a colour is the legend's
        if corner[1] == rows[FLIGHTS[day].row]:
            own.setdefault(colour, line)
    top, zero = max(own[_RIGHT][:, 1].max(), own[_LEFT][:, 1].max()), own[_OFFSET][0, 1]
    right, left = (
        (300.0 + (own[c][:, 0] - 28.1505820458) / 626.4 * 3300.0, (own[c][:, 1] - zero) / (top - zero))
        for c in (_RIGHT, _LEFT)
    )
    times = np.unique(np.concatenate([right[0], left[0]]))
    return times, np.stack([np.interp(times, *right), np.interp(times, *left)], axis=1)


def drawn_clock_s(folder: Path, day: str, flight: Flight) -> tuple[float, float]:
    """(what to add to the log's times [s], correlation of its commands with those of the drawing)."""
    panel = FLIGHTS[day].panel
    assert panel is not None
    drawn = next(line for _, line in _within(_lines(folder / panel.file), panel.corner))
    grid = np.arange(panel.times_s[0] + 1.0, panel.times_s[1] - 1.0, STEP_S)
    curve = np.interp(np.interp(grid, panel.times_s, panel.places), *drawn.T)
    found = [(0.0, -1.0)]
    for late_s in np.arange(0.0, 300.0, STEP_S):
        there = (grid - late_s > 0.0) & (grid - late_s < flight.time_s[-1])
        command = np.interp(grid[there] - late_s, flight.time_s, flight.commands[:, 0])
        found.append((float(late_s), float(-np.corrcoef(curve[there], command)[0, 1])))
    return max(found, key=lambda each: each[1])


def _wide(corner: tuple[float, float]) -> bool:
    return abs(corner[0] - 28.15) < 0.01


def _within(
    lines: list[tuple[tuple[float, float], str, np.ndarray]], corner: tuple[float, float]
) -> list[tuple[str, np.ndarray]]:
    """The long lines of a panel, in the order in which they were drawn."""
    return [
        (colour, line)
        for at, colour, line in lines
        if max(abs(a - b) for a, b in zip(at, corner, strict=True)) < 0.01 and len(line) > 500
    ]


def _lines(file: Path) -> list[tuple[tuple[float, float], str, np.ndarray]]:
    """(corner of the frame, colour, [points, 2]) of every line of a drawing by matplotlib."""
    found = []
    for text in _streams(file.read_bytes()):
        stack: list[str] = []
        corner, colour, line = (0.0, 0.0), "", []
        for word in text.split():
            if word in ("m", "l"):
                line = [] if word == "m" else line
                line.append((float(stack[-2]), float(stack[-1])))
            elif word == "re":
                corner = (float(stack[-4]), float(stack[-3]))
            elif word == "RG":
                colour = " ".join(f"{float(each):.2f}" for each in stack[-3:])
            elif word == "S" and len(line) > 1:
                found.append((corner, colour, np.array(line)))
            elif not word[0].isalpha():
                stack.append(word)
                continue
            stack = []
    return found


def _streams(content: bytes) -> Iterator[str]:
    for start in re.finditer(rb"stream\r?\n", content):
        end = content.find(b"endstream", start.end())
        try:
            text = zlib.decompress(content[start.end() : end]).decode("latin1")
        except zlib.error:
            continue
        if " l\n" in text:  # others are fonts
            yield text
