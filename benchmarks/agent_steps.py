"""Agent steps per second beside those of jsbgym, in one run: python benchmarks/agent_steps.py C172P_FOLDER

Both fly the c172p of the jsbsim package with 60 physics steps and 5 actions per second, with random actions, and begin a new
episode when one ends. C172P_FOLDER is what `testbed adopt c172p` made; jsbgym is installed beside the testbed. They take turns
for some rounds; the median of each counts, and the times are processor times. Prints one line of JSON. JSBSim's own 12 steps take
most of jsbgym's time; the testbed makes a new simulator for each episode, and reads, checks and logs the state 60 times a second.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time

import gymnasium

ROUNDS, STEPS = 7, 3000
JSBGYM = "C172-HeadingControlTask-Shaping.STANDARD-NoFG-v0"


def steps_per_s(env: gymnasium.Env, steps: int) -> tuple[float, float]:
    """Agent steps per second of processor time, and without the time of resets."""
    env.reset(seed=1)
    env.action_space.seed(1)
    actions, resets_s = [env.action_space.sample() for _ in range(steps)], 0.0
    begin = time.process_time()
    for action in actions:
        _, _, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            over = time.process_time()
            env.reset()
            resets_s += time.process_time() - over
    whole_s = time.process_time() - begin
    return steps / whole_s, steps / (whole_s - resets_s)


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("aircraft", help="folder of the adopted c172p")
    arguments = parser.parse_args()
    import jsbgym  # noqa: F401 # registers its environments

    import testbed.env

    same = {"rate_hz": 60, "duration_s": 60}
    ours = gymnasium.make(testbed.env.ANY, aircraft=arguments.aircraft, action_hz=5, set=same)
    rates: dict[str, list[tuple[float, float]]] = {"testbed": [], "jsbgym": []}
    for _ in range(ROUNDS):
        rates["testbed"].append(steps_per_s(ours, STEPS))
        rates["jsbgym"].append(steps_per_s(gymnasium.make(JSBGYM), STEPS))
    medians = {
        name: [round(statistics.median(each)) for each in zip(*of, strict=True)] for name, of in rates.items()
    }
    print(
        json.dumps(
            {name: {"with_resets": all_in, "steps_alone": alone} for name, (all_in, alone) in medians.items()}
        )
    )


if __name__ == "__main__":
    main()
