"""Flights per second of the shipped sweep with one and with two processes. Run it on an otherwise idle machine.

    python benchmarks/sweep_speed.py [RUNS]

The time includes the start of the processes (imports, loading compiled code), so with few runs the ratio is too small.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from time import perf_counter

from testbed.studies.load import load_sweep
from testbed.studies.run import Options, fly_sweep

SWEEP = "scenarios/sweeps/left_tail_monte_carlo.yaml"


def main(runs: int) -> None:
    """Print the flights per second with one and with two processes, and the ratio of the two."""
    plan, warm_up = (load_sweep(SWEEP, [f"runs={count}"]) for count in (runs, 1))
    rates = []
    with tempfile.TemporaryDirectory() as folder:
        fly_sweep(warm_up, Path(folder, "warm"), Options())
        for jobs in (1, 2):
            begun = perf_counter()
            flights = fly_sweep(plan, Path(folder, str(jobs)), Options(jobs=jobs, save_logs="none"))
            rates.append(flights.count / (perf_counter() - begun))
            print(f"{jobs} process{'es' if jobs > 1 else ''}: {flights}")
    print(f"two against one: {rates[1] / rates[0]:.2f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
