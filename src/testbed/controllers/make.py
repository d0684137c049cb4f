"""The controller that a scenario asks for: which class flies which settings."""

from __future__ import annotations

from collections.abc import Callable

from testbed.controllers import Controller
from testbed.controllers.config import (
    AdaptiveInversionSettings,
    ControllerSettings,
    FixedInversionSettings,
    ImmInversionSettings,
    IndiSettings,
    L1InversionSettings,
    OracleSettings,
    PidSettings,
    RlsInversionSettings,
)
from testbed.controllers.imm import imm_inversion
from testbed.controllers.indi import IndiController
from testbed.controllers.inversion.controller import InversionController, fixed_inversion
from testbed.controllers.l1 import L1Controller
from testbed.controllers.oracle import OracleController
from testbed.controllers.pid import PidController
from testbed.controllers.rls import rls_inversion
from testbed.controllers.setup import Setup

CONSTRUCTORS: dict[type[ControllerSettings], Callable[[Setup], Controller]] = {
    AdaptiveInversionSettings: InversionController,
    FixedInversionSettings: fixed_inversion,
    PidSettings: PidController,
    IndiSettings: IndiController,
    L1InversionSettings: L1Controller,
    OracleSettings: OracleController,
    RlsInversionSettings: rls_inversion,
    ImmInversionSettings: imm_inversion,
}


def make_controller(setup: Setup) -> Controller:
    """A new controller for these settings; raises BadInput when the aircraft cannot be flown by it."""
    return CONSTRUCTORS[type(setup.settings)](setup)
