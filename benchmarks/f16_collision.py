"""Ground collision of an F-16 in a dive, after the benchmark F16 of ARCH-COMP. Writes docs/results/f16_collision.md.

ARCH-COMP (Heidlauf, Collins, Bolender and Bak 2018, "Verification challenges in F-16 ground collision avoidance") flies the
model of Stevens and Lewis with an LQR and a recovery automaton. Here JSBSim's own `f16` flies, with its flight control
system, the same ranges of attitude, the same 540 ft/s, 15 s and requirement: the altitude stays above 0. The recovery is
that of a pilot: roll wings level, then pull fully until the path is level. It loses 2025 to 2545 ft from 3000 ft.

python benchmarks/f16_collision.py     # some 7000 flights of 15 s: six minutes
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import jsbsim
import numpy as np
from scipy.special import ndtr

from testbed.reliability import failure_probability, smallest_failure

PAGE = Path(__file__).parents[1] / "docs" / "results" / "f16_collision.md"
RANGES = (
    (math.pi / 4 - math.pi / 20, math.pi / 4 + math.pi / 30),
    (-0.4 * math.pi, -0.4 * math.pi + math.pi / 20),
    (-math.pi / 4 - math.pi / 8, -math.pi / 4 + math.pi / 8),
)
"""Least and greatest initial roll, pitch and heading [rad], each uniform."""
ARCH_COMP_FT, RARE_FT = 2338.0, 2515.0
"""Initial altitudes: that of ARCH-COMP, and one from which few flights collide."""
AIRSPEED_FT_S, DURATION_S, RATE_HZ = 540.0, 15.0, 60
LEVEL_RAD = 0.2
"""Bank within which the pilot pulls."""


def attitudes(u: np.ndarray) -> np.ndarray:
    """Roll, pitch and heading [n, 3] of standard normals [n, 3]."""
    low, high = np.array(RANGES).T
    return low + ndtr(u) * (high - low)


def limit_state(altitude_ft: float, u: np.ndarray) -> np.ndarray:
    """For each row of standard normals [n, 3] the lowest altitude [ft]; below 0 by how much of the flight was not flown."""
    return np.array([lowest(altitude_ft, *attitude) for attitude in attitudes(u)])


def lowest(altitude_ft: float, roll: float, pitch: float, heading: float) -> float:
    """Fly one recovery: its lowest altitude [ft], or after a collision minus the share of the flight that is missing."""
    aircraft = _started(altitude_ft, roll, pitch, heading)
    least = altitude_ft
    for step in range(int(DURATION_S * RATE_HZ)):
        _recover(aircraft)
        aircraft.run()
        least = min(least, aircraft["position/h-sl-ft"])
        if least <= 0:
            return step / (DURATION_S * RATE_HZ) - 1
    return float(least)


def _started(altitude_ft: float, roll: float, pitch: float, heading: float) -> jsbsim.FGFDMExec:
    """A new aircraft in its dive: a used one differs in the last digits."""
    jsbsim.FGJSBBase().debug_lvl = 0
    aircraft = jsbsim.FGFDMExec(None)
    aircraft.load_model("f16")
    aircraft.set_dt(1 / RATE_HZ)
    start = {
        "ic/h-sl-ft": altitude_ft,
        "ic/vt-fps": AIRSPEED_FT_S,
        "ic/alpha-deg": 2.1215,
        "ic/beta-deg": 0.0,
    }
    start["ic/terrain-elevation-ft"] = -5000.0  # no ground to bounce from, as in the benchmark
    start |= {"ic/phi-rad": roll, "ic/theta-rad": pitch, "ic/psi-true-rad": heading}
    for name, value in start.items():
        aircraft[name] = value
    aircraft.run_ic()
    aircraft["propulsion/engine/set-running"] = 1
    aircraft["fcs/throttle-cmd-norm"] = aircraft["fcs/throttle-pos-norm"] = 0.8
    aircraft["gear/gear-cmd-norm"] = 0
    return aircraft


def _recover(aircraft: jsbsim.FGFDMExec) -> None:
    """Roll toward wings level; once there, pull fully while the path descends."""
    roll = aircraft["attitude/phi-rad"]
    stick = -roll - 0.3 * aircraft["velocities/p-rad_sec"]
    aircraft["fcs/aileron-cmd-norm"] = float(np.clip(stick, -1, 1))
    pull = abs(roll) < LEVEL_RAD and aircraft["flight-path/gamma-rad"] < 0
    aircraft["fcs/elevator-cmd-norm"] = -1.0 if pull else 0.0


TEXT = """# Ground collision of an F-16

This page says how a search finds the collision of an F-16 with the ground, and how rare it is.

The F-16 dives at 540 ft/s with a random attitude, rolls level and pulls. The requirement is that its altitude stays above 0
for 15 s. It is the benchmark F16 of ARCH-COMP with another model: JSBSim's own `f16` and its flight control system, and a
recovery of two lines. Ranges of attitude, airspeed, time and requirement are the same, so the numbers of flights compare in
kind only. Everything is measured by `python benchmarks/f16_collision.py`.

Roll is uniform between 36 and 51 deg, pitch between -72 and -63 deg, heading between -67.5 and -22.5 deg.

## A collision is found

Flights until the first collision, and the nearest one after {budget} flights, in standard deviations of a standard normal for
each of the three; {seeds} seeds. Flights are counted in whole batches, of which the first two have 11.

{falsified}

From ARCH-COMP's 2338 ft some three in ten of these recoveries end in the ground. From {rare:.0f} ft only those near
one corner of the ranges do.

## How rare it is

{probabilities}

Plain draws are the check.
"""
BUDGET, SEEDS = 200, 5


def main() -> None:
    PAGE.write_text(
        TEXT.format(
            rare=RARE_FT, budget=BUDGET, seeds=SEEDS, falsified=falsified(), probabilities=probabilities()
        ),
        encoding="utf-8",
    )


def falsified() -> str:
    """Rows: first collision, and the nearest one."""
    rows = []
    for altitude in (ARCH_COMP_FT, RARE_FT):
        found = [
            smallest_failure(lambda u, ft=altitude: limit_state(ft, u), 3, seed=seed, budget=BUDGET)
            for seed in range(SEEDS)
        ]
        first = [one.path[0].evaluations for one in found if one.found]
        distances = [one.distance for one in found if one.found]
        nearest = min(found, key=lambda one: one.distance).design_point
        assert nearest is not None, f"no collision from {altitude:g} ft"
        roll, pitch, heading = np.degrees(attitudes(nearest[None])[0])
        rows.append(
            (
                f"{altitude:.0f} ft",
                f"{len(first)} of {SEEDS}",
                f"{np.mean(first):.0f} ({max(first)})",
                f"{min(distances):.2f} to {max(distances):.2f}",
                f"{roll:.1f}, {pitch:.1f}, {heading:.1f} deg",
            )
        )
        print(*rows[-1], flush=True)
    head = (
        "from",
        "found",
        "flights to the first, mean (most)",
        "distance of the nearest",
        "its roll, pitch, heading",
    )
    return table(head, rows)


def probabilities() -> str:
    """Rows: probability from both altitudes by every method."""
    rows = []
    for altitude, plain in ((ARCH_COMP_FT, 400), (RARE_FT, 2000)):
        for method, budget in (("importance", 1500), ("subset", 1500), ("plain", plain)):
            found = failure_probability(
                lambda u, ft=altitude: limit_state(ft, u), 3, method=method, budget=budget
            )
            low, high = found.interval
            rows.append(
                (
                    f"{altitude:.0f} ft",
                    f"`{method}`",
                    f"{found.probability:.2e}",
                    f"{low:.1e} to {high:.1e}",
                    str(found.evaluations),
                )
            )
            print(*rows[-1], flush=True)
    return table(("from", "method", "probability", "95 % interval", "flights"), rows)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    return "\n".join(f"| {' | '.join(line)} |" for line in [head, ["---"] * len(head), *rows])


if __name__ == "__main__":
    main()
