"""Which elevon of a real flying wing was weak, when and how much, from its logs. Writes docs/results/real_flights.md.

    git clone https://github.com/mrtbrnz/fault_detection ../fault_detection
    git -C ../fault_detection checkout 45e0ece
    git clone https://github.com/FabioCarosi/FaultDetection_ALFA-Dataset ../alfa
    git clone https://github.com/gotham29/htm-state ../htm-state
    python benchmarks/real_flights.py ../fault_detection ../alfa ../htm-state

The model and every setting are of 21 July. The other flights are then read with them.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
from alfa_flights import section
from enac_filter import filtered, moments_of
from enac_logs import FLIGHTS, Flight, check, drawn_clock_s, faults, read
from enac_reading import (
    BLOCK,
    CLASSES,
    FLAG,
    LABEL_S,
    LATE_S,
    LIKELY,
    WRONG_S,
    Flags,
    Reading,
    Regression,
    Settings,
    between,
    errors,
    fit_clock_s,
    fitted,
    flags,
    matthews,
    raised,
    regression,
    thinned,
    told,
    true_class,
    weak,
    window_errors,
)

PAGE = Path(__file__).parents[1] / "docs" / "results" / "real_flights.md"
MODEL_DAY, THINNED = "21 July", "13 July"
CHANGES, STEP_CHANGES, SURE = (6.0, 7.0, 9.0), (8.0, 16.0, 30.0), (0.9, 0.98, 0.99, 0.995, 0.998)
"""What `Settings` may be."""
GUSTS, SHIFTS = (2.2, 3.2), (3000, 12000)
"""The settings must also do in gusts: to the errors of 21 July are added its own, from so many samples later, so that they are this
many times larger. No other flight is looked at."""
OTHERS_SURE = (0.9, 0.98, 0.99, 0.995)
"""Of which the page says what they would do in flight; only that of 21 July is used."""


_PAGE = """# Real flights: a flying wing with weak elevons

<!-- Written by python benchmarks/real_flights.py: change that, not this. -->

This page shows what can be read from the logs of real flights about which elevon was weak, when, and how much. ENAC flew a small
flying wing in July 2020 while a program made one elevon at a time weaker: its deflection was multiplied by 0.3 to 0.9.

The model (next roll and pitch rate from the rates and four past deflections, by least squares) and every setting are of 21 July.
Every other flight is read with them. Nothing of the data is in the project: `benchmarks/real_flights.py` says where it is.

| | rms, right | left | Matthews | in flight | drops flagged | in flight | wrong too | in flight | false, per hour | in flight |
{line}
{rows}
{together}

- *rms* is the error of the effectiveness in windows of 10 s in which nothing changed; to reach: 0.1.
- *Matthews* is the coefficient of nine classes, each second: healthy, right 0.3, left 0.9 to 0.3; to reach: 0.6. The authors'
  support vector machine has 0.374 on a flight that it was not trained on.
- *Drops* are sudden ones to 0.3, flagged within {late:g} s as below {flag:g}; *wrong too*: the other elevon within {wrong:g} s;
  to reach: all, and one of ten. *False* flags begin in healthy flight, 5 s after a fault or later, and {label:g} s before the next
  or earlier; to reach: two per hour.
- The first number of a pair reads the whole log, as `testbed diagnose` does. The second, *in flight*, knows only what was before.

## What this rests on

- **The method.** A joint autoregression of errors for each class, which interact; the whole log is read by a hidden Markov model
  and a smoother, of `testbed.logs`. The law's own regression cannot be used: these logs have no airspeed and no attitude, so
  `testbed diagnose` refuses them. Colour and size of the errors are learnt in each flight: gusts make them 2 to 3 times
  those of 21 July.
- **The settings.** Order and memory are those with which 21 July is likeliest. A change costs
  {settings.change:g} in flight and {settings.step_change:g} in a whole log, a flag in flight a probability of {settings.sure:g}:
  chosen on 21 July, with no false flag in its own air and with its errors made larger. That errors differ from flight to flight,
  and settings need this margin, was seen on the others; the filter's form was judged there too. From a whole log a flag
  needs {likely:g}, and goes below {unlikely:.1g}. 21 July is read alike with 0.98; that {likely:g} flags more drops was seen below.
- **The gain** of both elevons is found in each whole log, without labels: {gains}.
- **The truth** is read from the authors' own drawing, in which a fault's beginning is known within 0.6 s. Clocks are joined by the
  drawn commands (correlations {correlations}). **23 July** has no drawn commands: its clock is the one with which the faults
  explain the log best, which flatters its numbers a little.
- **12 July**: the log has other quantities, so its rates and commands are those that the authors drew.
- Only 21 and 23 July have all nine classes; the others have 0.3 alone, which is easier.

## What falls short

In flight, weak right elevons are flagged late in gusts. What is possible: with fault, time, gain and the noise of the very
stretch known, the best of all tests with two false flags an hour flags {reach:.1f} of the {others} drops in
{late:g} s. The right elevon of 12 July is read wrong by more than 0.1: its drawing leaves points out. With every second
sample of its log left out, the error of 13 July is {thin:.2f}. On the other four days, by
the probability for a flag:

| probability | drops in {late:g} s | in flight | false, per hour | in flight |
| --- | --- | --- | --- | --- |
{trade}

{lost}
"""
_LOST = """False in whole logs: two flags of 12 July begin 6 and 8 s before their elevon's drop; its drawing has one point for three
samples."""


def page(
    readings: dict[str, Reading], clocks: dict[str, tuple[float, float]], settings: Settings, thin: Reading
) -> str:
    """The page in Markdown; `thin` is the reading of 13 July with every second sample left out."""
    joined = [f"{day} {clock[1]:.3f}" for day, clock in clocks.items() if 0.0 < clock[1] < 1.0]
    others = [reading for day, reading in readings.items() if day != MODEL_DAY]
    reach = np.concatenate([reading.reachable for reading in others])
    return _PAGE.format(
        line="| --- " * 11 + "|", rows="\n".join(_row(day, reading) for day, reading in readings.items()),
        together=_together(others), late=LATE_S, flag=FLAG, thin=_rms(thin)[0],
        likely=LIKELY, unlikely=1.0 - LIKELY, wrong=WRONG_S, label=LABEL_S,
        settings=settings,
        reach=reach.sum(), others=len(reach), correlations=", ".join(joined),
        gains=", ".join(f"{reading.gain:.2f} on {day}" for day, reading in readings.items()),
        trade="\n".join(_trade(readings, sure) for sure in OTHERS_SURE), lost=_LOST,
    )  # fmt: skip


def _both(reading: Reading) -> tuple[Flags, Flags]:
    """From the whole log, and in flight."""
    whole, in_flight = reading.flagged, reading.flagged_in_flight
    return flags(reading.time_s, reading.truth, whole), flags(reading.time_s, reading.truth, in_flight)


def _row(day: str, reading: Reading) -> str:
    right, left = _rms(reading)
    each_s = slice(BLOCK // 2, None, BLOCK)
    truth = true_class(reading.truth[each_s])
    said = [f"{matthews(truth, each[each_s]):.2f}" for each in (reading.told, reading.told_in_flight)]
    counts = zip(*(_cells([each]) for each in _both(reading)), strict=True)
    cells = [day, f"{right:.3f}", f"{left:.3f}", *said, *(cell for pair in counts for cell in pair)]
    return f"| {' | '.join(cells)} |"


def _rms(reading: Reading) -> np.ndarray:
    return np.asarray(np.sqrt(np.mean(window_errors(reading) ** 2, axis=0)))


def _together(readings: Sequence[Reading]) -> str:
    counts = zip(*(_cells(each) for each in zip(*map(_both, readings), strict=True)), strict=True)
    return f"| the other four | | | | | {' | '.join(cell for pair in counts for cell in pair)} |"


def _trade(readings: dict[str, Reading], sure: float) -> str:
    """What a probability for a flag does, on the days that are not the model's."""
    others = [each for day, each in readings.items() if day != MODEL_DAY]
    after, _, false_after = _cells([flags(r.time_s, r.truth, raised(r.weak, sure)) for r in others])
    before, _, false = _cells([flags(r.time_s, r.truth, raised(r.weak_in_flight, sure)) for r in others])
    return f"| {sure:g} | {after} | {before} | {false_after} | {false} |"


def _cells(each: Sequence[Flags]) -> list[str]:
    delays = np.concatenate([f.delays_s for f in each])
    hours, false = sum(f.healthy_h for f in each), sum(f.false for f in each)
    drops = f"{np.sum(delays <= LATE_S)} of {len(delays)}"
    return [drops, str(sum(f.wrong for f in each)), f"{false} in {hours:.2f} h, {false / hours:.1f}"]


def chosen(home: Regression, moments: np.ndarray) -> Settings:
    """The settings with which 21 July is read best, in its own air and in gusts, in flight and from the whole log.

    Most drops in time where no flag is false; of these, those with the best classes, and in flight the surest. One flag in these
    .9 h is the most that FALSE_PER_H would allow, and the gusts of other days are worse.
    """
    left = errors(home)
    flights = [home]
    for f, at in product(GUSTS, SHIFTS):
        flights.append(replace(home, z=home.z + np.sqrt(f * f - 1.0) * np.roll(left, at, axis=0)))
    in_flight, whole = {}, {}
    for change in CHANGES:
        made = [filtered(each.z, each.phi, CLASSES, change, moments) for each in flights]
        classes, each_weak = [each.log_probability.argmax(axis=1) for each in made], [*map(weak, made)]
        for sure in SURE:
            flagged = [raised(each, sure) for each in each_weak]
            in_flight[change, sure] = (*_mark(home, classes, flagged), sure)
    change, sure = max(in_flight, key=lambda each: in_flight[each])
    for step in STEP_CHANGES:
        read_so = [told(each, moments, Settings(change, step, sure)) for each in flights]
        whole[step] = _mark(home, [each.told for each in read_so], [each.flagged for each in read_so])
    return Settings(change, max(whole, key=lambda each: whole[each]), sure)


def _mark(
    home: Regression, classes: Sequence[np.ndarray], flagged: Sequence[np.ndarray]
) -> tuple[bool, int, float]:
    """Whether no flag is false, drops in time, and the mean coefficient of the classes, of readings of the same flight."""
    found = [flags(home.time_s, home.truth, each) for each in flagged]
    truth = true_class(home.truth)
    mean = float(np.mean([matthews(truth, each) for each in classes]))
    return not any(f.false for f in found), sum(int(np.sum(f.delays_s <= LATE_S)) for f in found), mean


def measured(
    folder: Path,
) -> tuple[dict[str, Reading], dict[str, tuple[float, float]], Settings, Reading]:
    """({day: reading}, {day: clock and correlation}, settings, reading of THINNED without every second sample); raises BadInput for
    another checkout."""
    check(folder)
    flights = {day: read(folder, day) for day in FLIGHTS}
    broken = {day: faults(folder, day) for day in FLIGHTS}
    clocks = {
        day: drawn_clock_s(folder, day, flights[day]) for day, s in FLIGHTS.items() if s.panel and s.log
    }
    clocks["12 July"] = (0.0, 1.0)
    own, judged = flights[MODEL_DAY], FLIGHTS[MODEL_DAY].judged_s
    time_s = own.time_s + clocks[MODEL_DAY][0]
    truth = between(time_s, *broken[MODEL_DAY])
    model = fitted(own, truth, (time_s > judged[0]) & (time_s < judged[1]))
    home = regression(own, clocks[MODEL_DAY][0], truth, model, judged)
    moments = moments_of(errors(home))
    settings = chosen(home, moments)
    for day in FLIGHTS:
        if day not in clocks:
            late_s = fit_clock_s(flights[day], broken[day], model, moments, FLIGHTS[day].judged_s)
            clocks[day] = (late_s, float("nan"))

    def read_so(day: str, flight: Flight) -> Reading:
        late_s, within = clocks[day][0], FLIGHTS[day].judged_s
        truth = between(flight.time_s + late_s, *broken[day])
        return told(regression(flight, late_s, truth, model, within), moments, settings)

    readings = {day: read_so(day, flight) for day, flight in flights.items()}
    return readings, clocks, settings, read_so(THINNED, thinned(flights[THINNED]))


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="checkout of mrtbrnz/fault_detection")
    parser.add_argument("alfa", type=Path, help="checkout of FaultDetection_ALFA-Dataset")
    parser.add_argument("throttle", type=Path, help="checkout of htm-state")
    parser.add_argument("--page", type=Path, default=PAGE)
    options = parser.parse_args(arguments)
    text = page(*measured(options.folder)) + section(options.alfa, options.throttle)
    options.page.write_text(text, encoding="utf-8")
    print(f"wrote {options.page}")


if __name__ == "__main__":
    main()
