"""What a controller of each kind costs, in one run: python benchmarks/controller_kinds.py NAME=REFERENCE ...

Each REFERENCE is what `--controller` takes; the first is the one that the others are compared with. They fly the healthy v-tail in
turns, `SHORT_S` and `LONG_S` long. Times are processor times of this process and of those that it starts. The difference of the two
flights is the cost of a control step, with the aircraft's; what is left of the short one is start-up, and an autopilot's warm-up.
Three flights of each are the same, or the table says so. Prints the rows of the table of docs/reference/any_language.md.
"""

from __future__ import annotations

import hashlib
import resource
import statistics
import sys
import warnings
from typing import Any

import testbed
from testbed.controllers.user.loader import load_controller

SHORT_S, LONG_S, ROUNDS, RATE_HZ = 1.0, 11.0, 3, 200
SET = {"failures": [], "requirements": [], "sensors": "mems"}


def spent_s() -> float:
    """Processor time so far of this process, and of those that it has started and waited for [s]."""
    each = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(use.ru_utime + use.ru_stime for use in each)


def flown(reference: str, duration_s: float) -> tuple[float, str]:
    """Processor time of a flight [s], and the SHA-256 of its log."""
    controller: Any = load_controller(reference)
    begin_s = spent_s()
    flight = testbed.fly("left_tail_fail.yaml", controller, set={**SET, "duration_s": duration_s})
    return spent_s() - begin_s, hashlib.sha256(flight.data.tobytes()).hexdigest()


def measured(reference: str) -> tuple[float, float, bool]:
    """Processor time of a control step [us] and of the rest of a flight [s], and whether the flights were the same."""
    flown(reference, SHORT_S)  # compiled and cached then
    rounds = [(flown(reference, SHORT_S), flown(reference, LONG_S)) for _ in range(ROUNDS)]
    steps = (LONG_S - SHORT_S) * RATE_HZ
    step_s = statistics.median((long[0] - short[0]) / steps for short, long in rounds)
    rest_s = statistics.median(short[0] for short, _ in rounds) - step_s * SHORT_S * RATE_HZ
    return 1e6 * step_s, rest_s, len({long[1] for _, long in rounds}) == 1


def main() -> None:
    """Measure, and print."""
    warnings.simplefilter("ignore")
    first_us = 0.0
    for given in sys.argv[1:]:
        name, _, reference = given.partition("=")
        step_us, rest_s, same = measured(reference)
        first_us = first_us or step_us
        row = f"| {name} | {step_us:.0f} | {step_us / first_us:.1f} | {rest_s:.2f} |"
        print(row if same else f"{row} flights differ", flush=True)


if __name__ == "__main__":
    main()
