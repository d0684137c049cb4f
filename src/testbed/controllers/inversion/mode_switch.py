"""Switching of control modes: puts the mode in force that belongs to the flagged failures (section 2.3)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress

import numpy as np

from testbed.common.signals import GUARDED, RATES
from testbed.common.units import GRAVITY_M_S2
from testbed.controllers.inversion.evidence import MEAN_S, SLOW_S
from testbed.controllers.inversion.mode_trim import NoSteadyFlight, lost_thrust
from testbed.controllers.inversion.modes import Mode, allocation_of, enumerate_modes
from testbed.controllers.inversion.regulator import Regulator, regulator_for
from testbed.controllers.records import AIRSPEED, ALPHA, INTEGRALS, PITCH, Q_DOT, U_DOT, mode_dtype
from testbed.controllers.setup import Setup
from testbed.inputs.problems import BadInput, Problem

_WORTH_SAYING_M_S = 0.5  # difference of airspeed from its reference that an event says, m/s
_SLOWEST = 0.3  # measured airspeed that is believed, in units of the reference airspeed
_JAM_SHARES = (0.5, 0.6, 0.7, 0.8, 0.9)
"""Of the jammed actuators' positions, for which a trim is looked for where there is no level one with all of them."""

_JAMMED = "not a loss of effectiveness: its force does not follow its command (jammed, offset or reversed)"
_REVERSED = "its force goes against its command: reversed, used again with the opposite sign"
_SEEMS_LOST = (
    f"seems lost, but without it altitude cannot be held: used until it has seemed so for {SLOW_S:g} s"
)
_STUCK = "its sensor repeats itself: taken for stuck, and computed from the other sensors"
_OFFSET = "its force follows its command with an offset: not jammed, used on"


class ModeSwitch:
    """The control modes of one flight, and the one in force; it begins with the mode for no failure.

    Args:
        memory: the law's memory, an array of one record. The flags in it are read here; its integrals are reset with each mode.

    Attributes:
        mode: the mode in force.
        record: the same mode as the compiled functions read it, an array of one record of `records.MODE`.
        reasons: (step, text) of each failure that no mode can hold or that is no loss of effectiveness, each text once.

    Raises:
        BadInput: the aircraft cannot be flown in the mode for no failure.
    """

    def __init__(self, setup: Setup, memory: np.ndarray) -> None:
        self._setup, self._memory = setup, memory
        self._modes = enumerate_modes(setup.model, setup.scale, setup.control, setup.released)
        self._reported: set[object] = set()
        self.record = np.zeros(1, mode_dtype(len(setup.actuators)))
        self.reasons: list[tuple[int, str]] = []
        self.mode = self._modes[()]
        self._begin()

    def _begin(self) -> None:
        setup = self._setup
        if self.mode.refused:
            expected = (
                "`control.condition_max` of the aircraft above that, other `scale`s of its actuators, "
                "or more axes in the controller's `released`"
            )
            what = f"{setup.aircraft} cannot be flown by inversion: {self.mode.refused}"
            raise BadInput([Problem(what, path="controller", expected=expected)])
        try:
            regulator = regulator_for(setup, self.mode, {}) if self.mode.released else None
        except NoSteadyFlight as reason:
            what = f"{setup.aircraft} cannot be flown with these axes released: {reason}"
            raise BadInput(
                [Problem(what, path="controller.released", expected="other axes, or none")]
            ) from None
        self._put_in_force(self.mode, regulator, ())

    def switch(self, step: int, airspeed: float | None = None) -> None:
        """Put the mode for the flagged failures in force; if it cannot be flown, the reason is noted and the present mode stays.

        Without a steady flight the outer loops fly on with the axes that are left, unless axes are released from the start or one
        actuator is left.

        Args:
            airspeed: at which jammed motors and engines have their estimated thrust [m/s]; by default the reference airspeed.
        """
        s = self._memory[0]
        failed = tuple(int(i) for i in np.flatnonzero(s.failed & ~s.reversed))  # these are used
        jammed = {i: float(s.lambda_hat[i]) for i in failed if s.jammed[i]}
        for i, position in jammed.items():
            s.designed_position[i] = position
        self._note_diagnoses(step, jammed)
        for sensor, stuck in zip(GUARDED, s.stuck, strict=True):
            if stuck:
                self._report(step, f"{sensor}: {_STUCK}")
        if airspeed is not None:
            jammed = {i: self._at_reference(i, position, airspeed) for i, position in jammed.items()}
        if not failed and not self.mode.failed:
            return None  # the mode in force is the one for no failure: its integrals go on
        mode = self._modes.get(failed)
        if mode is None:
            return self._report(step, f"{len(failed)} actuators failed: nothing left to control with")
        if mode.refused:
            return self._report(step, mode.refused)
        regulator, reason = None, ""
        try:
            regulator = self._regulator(step, mode, jammed) if mode.released else None
        except NoSteadyFlight as none:
            reason = str(none)
        if regulator is not None and not _holds_altitude(regulator):
            reason = _cannot_hold_altitude(mode, regulator)
        if reason:
            if self._holds_altitude and self._wait(step, mode):
                return self.switch(step, airspeed)
            self._report(step, reason, once_for=mode.failed if regulator else None)
            # The outer loops do not control what is released from the start, nor does one actuator.
            if not regulator and (self._setup.released or len(failed) > len(self._setup.actuators) - 2):
                return None
        self._put_in_force(mode, regulator, failed)
        if words := self._airspeed_in_words():
            text = f"{', '.join(mode.failed)} failed: {words}"
            self._report(step, text, once_for=("airspeed", mode.failed))

    def _wait(self, step: int, mode: Mode) -> bool:
        """Take back the flags of a mode that came early, so that these actuators are used on; returns whether there are any.

        Giving up an actuator that only fails on and off costs altitude (docs/explanation/control.md, after a release).
        """
        s, names = self._memory[0], self._setup.model.actuators
        more = set(mode.failed) - set(self.mode.failed)
        early = [i for i, name in enumerate(names) if name in more and s.early[i] and not s.jammed[i]]
        for i in early:
            s.failed[i] = 0
            self._report(step, f"{names[i]}: {_SEEMS_LOST}")
        return bool(early)

    def _at_reference(self, i: int, position: float, airspeed: float) -> float:
        """Scaled position of a jammed actuator at the reference airspeed: a motor that is stuck has another thrust there."""
        model, scale = self._setup.model, self._setup.scale[i]
        propulsor = model.propulsors[i]
        if propulsor is None:
            return position
        reference = np.array([model.airspeed_m_s])
        here = max(_SLOWEST * model.airspeed_m_s, airspeed)
        thrust = propulsor.at_same_throttle(position * scale, here, reference, model.density_kg_m3)
        return float(thrust[0] / scale)

    def _airspeed_in_words(self) -> str:
        """At which airspeed the mode in force is flown, if it is not the commanded one, and why; or empty."""
        k, v = self.record[0], self._setup.model.airspeed_m_s
        faster, low, high = float(k.airspeed_offset), float(k.airspeed_low), float(k.airspeed_high)
        if not k.regulated or (low <= v + faster <= high and faster < _WORTH_SAYING_M_S):
            return ""
        if not low <= v + faster <= high:
            at = f"{low:.1f} m/s" if high - low < 0.1 else f"{low:.1f} to {high:.1f} m/s"
            return f"flies at {at}, where a steady flight is farthest from the stops, or sinks slowest"
        height = ((v + faster) ** 2 - v * v) / (2.0 * GRAVITY_M_S2)
        return f"flies {faster:.1f} m/s faster than commanded, to have {height:.0f} m of altitude stored as airspeed"

    def _note_diagnoses(self, step: int, jammed: Iterable[int]) -> None:
        """Note each actuator whose failure is no loss of effectiveness."""
        s, names = self._memory[0], self._setup.model.actuators
        diagnoses = (
            (jammed, _JAMMED),
            (np.flatnonzero(s.reversed), _REVERSED),
            (np.flatnonzero((s.moved != 0.0) & (s.offset_timer > MEAN_S)), _OFFSET),
        )
        for actuators, text in diagnoses:
            for i in actuators:
                self._report(step, f"{names[i]}: {text}")

    def _regulator(self, step: int, mode: Mode, jammed: Mapping[int, float]) -> Regulator:
        """The mode's regulator for all of the jammed actuators' forces, or where altitude cannot be held with them for the largest
        of `_JAM_SHARES` of them with which it can: an aircraft that is not quite balanced strays less than one that climbs or sinks
        for the balance. They are tried upwards as long as they do. Where neither all nor the smallest share has a trim, it is for
        none of these forces."""

        def of_share(share: float) -> Regulator | None:
            with suppress(NoSteadyFlight):
                return regulator_for(self._setup, mode, {i: share * x for i, x in jammed.items()})
            return None

        best, of = of_share(1.0), 1.0
        for share in _JAM_SHARES if jammed and not (best and _holds_altitude(best)) else ():
            part = of_share(share)
            if part is None or (best is not None and not _holds_altitude(part)):
                break
            best, of = part, share
        if of < 1.0:
            text = f"no level trim balances the jam; flies by that of {100 * of:.0f} % of its force"
            self._report(step, f"{', '.join(mode.failed)} failed: {text}", once_for=("share", mode.failed))
        return best or regulator_for(self._setup, mode, {})

    def _put_in_force(self, mode: Mode, regulator: Regulator | None, failed: tuple[int, ...]) -> None:
        s = self._memory[0]
        s.airspeed_integral = s.heading_integral = s.sideslip_integral = 0.0
        s.pitch_integral = self._setup.trim_pitch
        s.integral[:] = self._carried_over(mode, regulator)  # by the gains of the mode before
        if mode.failed != self.mode.failed:
            s.early[:] = 0  # whether level flight is given up is asked anew
        self._set_allocation(mode, failed)
        self._set_regulator(regulator, failed)
        self.mode, self._holds_altitude = mode, _holds_altitude(regulator)

    def _set_allocation(self, mode: Mode, failed: tuple[int, ...]) -> None:
        """The actuators that are used, and how the virtual control is shared among them."""
        k, setup = self.record[0], self._setup
        k.available[:] = [i not in failed for i in range(len(setup.actuators))]
        k.B_hat_inv[:], k.released[:] = mode.inverse, [axis in mode.released for axis in RATES]
        b, weights = np.array(setup.model.input_matrix)[:4] * setup.scale, setup.control.allocation
        k.row_weight[:], k.hessian[:] = allocation_of(b, mode.released, weights)

    def _set_regulator(self, regulator: Regulator | None, failed: tuple[int, ...]) -> None:
        """Trim, gains and airspeed of the regulator; without one, the paper's outer loops at any airspeed."""
        k, setup = self.record[0], self._setup
        loops = setup.control.loops
        motor_lost = any(setup.model.kinds[i] != "servo" for i in failed)
        k.slow_descent = loops.slow_descent_s
        k.slow_descent_from = loops.lost_thrust_protect_from_m_s if motor_lost else loops.protect_from_m_s
        k.regulated, k.airspeed_offset = regulator is not None, 0.0
        k.x_trim[:], k.r_trim[:], k.trim_effect[:] = 0.0, 0.0, 0.0  # of the trim in which the flight began
        k.airspeed_low, k.airspeed_high, k.airspeed_too_fast, k.fast_climb = 0.0, math.inf, math.inf, 0.0
        k.glides = 0
        if regulator is not None:
            for name in ("x_trim", "r_trim", "trim_effect", "K", "K_actuator", "K_integral"):
                k[name] = getattr(regulator, name)
            self._choose_airspeed(regulator, failed)

    def _choose_airspeed(self, regulator: Regulator, failed: tuple[int, ...]) -> None:
        """How the mode's airspeed follows from its reference, and what is done above the airspeeds at which it can be flown."""
        k, s, setup = self.record[0], self._memory[0], self._setup
        loops, jammed = setup.control.loops, bool(s.jammed.any())
        forces = s.jammed * s.lambda_hat * setup.scale
        k.glides = "altitude" not in regulator.held and k.released[U_DOT] and not k.released[Q_DOT]
        k.airspeed_low, k.airspeed_high, k.airspeed_too_fast = regulator.airspeeds
        beyond = float(regulator.x_trim[AIRSPEED]) - setup.model.airspeed_m_s
        if not jammed:
            k.airspeed_offset = 0.0 if k.glides else beyond
        elif lost_thrust(setup.model, failed, forces):
            k.airspeed_offset = loops.lost_thrust_faster_m_s
        # Thrust that balances a turning moment cannot slow the aircraft down.
        balances = bool(np.any(setup.turns & (k.available > 0) & (np.array(setup.model.kinds) != "servo")))
        k.fast_climb = loops.fast_climb_s if jammed and beyond < 0.0 and balances else 0.0

    def _carried_over(self, mode: Mode, regulator: Regulator | None) -> np.ndarray:
        """[3] integrals of the regulator, with which the part of nu that comes from them stays as it is.

        The regulator of a mode is designed again when the estimated position of a jammed actuator has moved. What the integrals
        have made up for so far, such as the design model's error, is there still. Another mode starts with zeros: its axes are
        others, and so is what has to be made up for.
        """
        k, s = self.record[0], self._memory[0]
        if regulator is None or not k.regulated or mode.failed != self.mode.failed:
            return np.zeros(len(INTEGRALS))
        return np.linalg.pinv(regulator.K_integral) @ (k.K_integral @ s.integral)

    def _report(self, step: int, text: str, once_for: object = None) -> None:
        """Note a text once; with `once_for`, note one text for each value of it.

        The regulator for a jammed actuator is designed many times, each time with slightly different numbers in the text.
        """
        if (once_for or text) not in self._reported:
            self._reported.add(once_for or text)
            self.reasons.append((step, text))


def _holds_altitude(regulator: Regulator | None) -> bool:
    """Without a regulator the outer loops hold it."""
    return regulator is None or "altitude" in regulator.held


def _cannot_hold_altitude(mode: Mode, regulator: Regulator) -> str:
    slope_deg = math.degrees(regulator.x_trim[PITCH] - regulator.x_trim[ALPHA])
    return (
        f"{', '.join(mode.failed)} failed: altitude cannot be held. The remaining input matrix is well conditioned "
        f"(condition number {mode.condition:.3g}), but the stops leave no level trim at any airspeed; "
        f"flies at a path angle of about {slope_deg:.1f} deg"
    )
