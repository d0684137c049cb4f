"""A policy that learns to hold altitude and heading with weak tails, by an evolution strategy: python learn.py [POLICY.npz]

Fly what was learnt: testbed run scenarios/left_tail_fail.yaml --controller learn.py:Learnt
"""

import sys
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

import numpy as np

from testbed.env.cockpit import Cockpit

FILE = Path(__file__).with_name("weak_tails.npz")
ACTION_HZ, FLIGHTS, GENERATIONS = 10, 4, 100
MEMORY_S = 5.0  # errors of altitude and heading are summed over about this time


class Policy:
    """Actions from observations: a matrix, and a tanh. It sees the sums of two errors too: a weak tail needs another trim."""

    def __init__(self, weights):
        self.weights, self.summed = weights, np.zeros(2)

    def act(self, observation):
        errors = observation[[0, 2]]  # of altitude and heading
        self.summed = np.clip(self.summed + errors / (ACTION_HZ * MEMORY_S), -1, 1)
        seen = np.concatenate((observation[:14], self.summed))
        return np.tanh(self.weights @ seen)


class Learnt:
    """The learnt policy as a controller; `controller.parameters.policy` names another file, from the folder of this one."""

    parameters = {"policy": FILE.name}  # noqa: RUF012

    def __init__(self, setup):
        with np.load(FILE.parent / setup.parameters["policy"], allow_pickle=False) as saved:
            self.policy = Policy(saved["weights"])
        self.cockpit, self.every = Cockpit(setup), round(1 / (setup.dt_s * ACTION_HZ))
        self.steps = 0

    def update(self, time_s, state, reference):
        if self.steps % self.every == 0:
            action = self.policy.act(self.cockpit.observe(state, reference))
            self.commands = self.cockpit.command(action)
        self.steps += 1
        return self.commands


@cache
def environment():
    import gymnasium

    import testbed.env  # noqa: F401 # registers the environments

    short = {"duration_s": 20, "rate_hz": 100, "physics_hz": 200, "requirements": []}
    sweep = "scenarios/sweeps/left_tail_monte_carlo.yaml"
    return gymnasium.make("testbed/vtail-v0", action_hz=ACTION_HZ, sweep=sweep, set=short)


def cost(weights, seed):
    """1 less the mean reward per step of some flights; those of a seed have the same failures for every policy."""
    env, total = environment(), 0.0
    for flight in range(FLIGHTS):
        policy, over = Policy(weights.reshape(4, -1)), False
        observation, _ = env.reset(seed=FLIGHTS * seed + flight)
        while not over:
            observation, reward, terminated, truncated, _ = env.step(policy.act(observation))
            total, over = total + reward, terminated or truncated
    return 1.0 - total / (FLIGHTS * 20 * ACTION_HZ)


def main(file=FILE):
    import cma

    strategy = cma.CMAEvolutionStrategy(np.zeros(4 * 16), 0.1, {"seed": 1, "popsize": 16, "verbose": -9})
    with ProcessPoolExecutor() as processes:
        for generation in range(GENERATIONS):
            candidates = strategy.ask()
            costs = list(processes.map(cost, candidates, [generation] * len(candidates)))
            strategy.tell(candidates, costs)
            print(f"generation {generation}: best reward {1 - min(costs):.3f} a step")
            np.savez(file, weights=strategy.mean.reshape(4, -1))


if __name__ == "__main__":
    main(*sys.argv[1:])
