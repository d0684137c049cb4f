"""The controller that a scenario asks for: which class flies which settings."""

from __future__ import annotations

from collections.abc import Callable

from testbed.controllers import Controller
from testbed.controllers.imm import imm_inversion
from testbed.controllers.indi import indi
from testbed.controllers.inversion.controller import InversionController, fixed_inversion
from testbed.controllers.l1 import l1_inversion
from testbed.controllers.oracle import OracleController
from testbed.controllers.pid import pid
from testbed.controllers.rls import rls_inversion
from testbed.controllers.setup import Setup

CONSTRUCTORS: dict[str, Callable[[Setup], Controller]] = {
    "adaptive_inversion": InversionController,
    "fixed_inversion": fixed_inversion,
    "pid": pid,
    "indi": indi,
    "l1_inversion": l1_inversion,
    "oracle": OracleController,
    "rls_inversion": rls_inversion,
    "imm_inversion": imm_inversion,
}
"""By the `type` of their settings."""


def make_controller(setup: Setup) -> Controller:
    """A new controller for these settings; raises BadInput when the aircraft cannot be flown by it."""
    return CONSTRUCTORS[setup.settings.type](setup)
