"""A controller of the user's with a parameter and a module beside it, and a short sweep that compares it."""

from __future__ import annotations

from pathlib import Path

SWEEP = """\
name: own
scenario: scenarios/left_tail_fail.yaml
runs: 3
seed: 3
set:
  duration_s: 1
  failures: []
  requirements: [{metric: altitude_error_max_m, at_most: 0.5}]
vary:
  controller.parameters.gain: {uniform: [0.5, 1.5]}
  controller.gamma: {uniform: [2, 4]}
compare: {controller.type: [adaptive_inversion, pid]}
"""
CLASS = """\
from beside_mine import HALF

class Mine:
    parameters = {"gain": 1.0, "unused": 7}

    def __init__(self, setup):
        assert setup.parameters["unused"] == 7
        self.trim, self.gain = list(setup.trim_commands), HALF * setup.parameters["gain"]

    def update(self, time_s, state, reference):
        elevator = self.gain * (state.pitch - 0.02)
        return [self.trim[0] + elevator, self.trim[1] + elevator, *self.trim[2:]]
"""


def own_controller(folder: Path) -> str:
    """Write class and sweep; returns `mine=FILE.py:Mine`."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "own.yaml").write_text(SWEEP)
    (folder / "mine_flies.py").write_text(CLASS)
    (folder / "beside_mine.py").write_text("HALF = 0.5\n")
    return f"mine={folder / 'mine_flies.py'}:Mine"
