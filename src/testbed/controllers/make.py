"""The controller that a scenario asks for: which class flies which settings."""

from __future__ import annotations

from collections.abc import Callable

from testbed.controllers import Controller
from testbed.controllers.augmentation import l1_inversion, mrac
from testbed.controllers.estimators import imm_inversion, rls_inversion
from testbed.controllers.indi import adaptive_indi, indi
from testbed.controllers.informed import InformedController
from testbed.controllers.inversion.controller import InversionController, fixed_inversion
from testbed.controllers.pid import pid
from testbed.controllers.setup import Setup
from testbed.controllers.user.adapter import adapted
from testbed.controllers.user.loader import Factory
from testbed.controllers.user.own import unused_parameters
from testbed.inputs.problems import BadInput

CONSTRUCTORS: dict[str, Callable[[Setup], Controller]] = {
    "adaptive_inversion": InversionController,
    "fixed_inversion": fixed_inversion,
    "pid": pid,
    "indi": indi,
    "adaptive_indi": adaptive_indi,
    "mrac": mrac,
    "l1_inversion": l1_inversion,
    "informed_inversion": InformedController,
    "rls_inversion": rls_inversion,
    "imm_inversion": imm_inversion,
}
"""By the `type` of their settings."""


def make_controller(setup: Setup, own: Factory | None = None) -> Controller:
    """A new controller for these settings, or of a class of the user's own in its place.

    Raises BadInput when the aircraft cannot be flown by it, the user's class fails, or a shipped controller is given parameters.
    """
    if own is not None:
        return adapted(own, setup)
    if problems := unused_parameters(setup.settings):
        raise BadInput(problems)
    return CONSTRUCTORS[setup.settings.type](setup)
