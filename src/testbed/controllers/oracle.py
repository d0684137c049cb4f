"""The bound of any diagnosis: the inversion law, told the true state of every actuator in each control step.

It estimates nothing. True effectiveness takes the place of the estimates, and true failures that of the flags, at once. So
what it does not hold, no better diagnosis holds with this law. It is told by `Setup.truth`, which no other controller has.
"""

from __future__ import annotations

from testbed.controllers.config import OracleSettings
from testbed.controllers.initial_records import settings_record
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.inversion.jam_detection import REDESIGN_AFTER
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput, Problem


class OracleController(InversionController):
    """The inversion law without estimation and monitor; before each of its steps the truth is written into its memory.

    Raises:
        BadInput: the set-up has no `truth`; otherwise as in `InversionController`.
    """

    def __init__(self, setup: Setup) -> None:
        if setup.truth is None:
            what = "oracle is told the truth by the simulation, and this set-up has none"
            raise BadInput([Problem(what, path="controller.type", expected="a flight of `testbed.fly`")])
        self._truth, self._scale = setup.truth, setup.scale.tolist()
        self._threshold = setup.settings_as(OracleSettings).threshold
        settings = settings_record(setup, None)
        settings[0].monitors = True  # what it is told is logged as what it believes
        super().__init__(setup, settings)
        memory = self.memory[0]
        self._estimate, self._failed, self._jammed = memory.lambda_hat, memory.failed, memory.jammed
        self._designed = memory.designed_position

    def step(self, step: int) -> memoryview:
        """Commands [n] for row `step`."""
        if self._learn():
            self.switch(step)
        return super().step(step)

    def _learn(self) -> bool:
        """Write the truth into the law's memory; returns whether the mode must be put in force anew."""
        changed = False
        for i, (effectiveness, follows, position) in enumerate(zip(*self._truth(), strict=True)):
            lost = effectiveness <= self._threshold
            jammed = not follows and not lost
            flags = (int(lost or jammed), int(jammed))
            changed = changed or flags != (self._failed[i], self._jammed[i])
            self._failed[i], self._jammed[i] = flags
            self._estimate[i] = effectiveness * (position / self._scale[i] if jammed else 1.0)
            changed = changed or (jammed and abs(self._estimate[i] - self._designed[i]) > REDESIGN_AFTER)
        return changed
