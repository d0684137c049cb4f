"""The controller that a scenario asks for: which class flies which settings."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from testbed.controllers import Controller
from testbed.controllers.config import (
    AdaptiveInversionSettings,
    ControllerSettings,
    FixedInversionSettings,
    IndiSettings,
    OracleSettings,
    PidSettings,
)
from testbed.controllers.indi import IndiController
from testbed.controllers.inversion.controller import InversionController
from testbed.controllers.oracle import OracleController
from testbed.controllers.pid import PidController
from testbed.controllers.setup import Setup

CONSTRUCTORS: dict[type[ControllerSettings], Callable[[Setup], Controller]] = {
    AdaptiveInversionSettings: InversionController,
    FixedInversionSettings: partial(InversionController, adapts=False),
    PidSettings: PidController,
    IndiSettings: IndiController,
    OracleSettings: OracleController,
}


def make_controller(setup: Setup) -> Controller:
    """A new controller for these settings; raises BadInput when the aircraft cannot be flown by it."""
    return CONSTRUCTORS[type(setup.settings)](setup)
