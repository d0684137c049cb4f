"""What a failure does to its actuator, as the predicate of a sentence: "was lost completely"."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from testbed.failures import Failure
from testbed.flight.breakage import LOST

Words = Callable[[Any, str, str], str]
"""Predicate from the failure, the actuator's kind ("servo", ...) and the unit of its deflections ("deg", or "of throttle")."""


def predicate(failure: Failure, facts: Mapping[str, Any]) -> str:
    """What happened to the actuator; `facts` are those of `Flight.actuators`, empty where the failure names none."""
    kind = str(facts.get("kind", "servo"))
    unit = str(facts.get("unit", "deg")) if kind == "servo" else "of throttle"
    return TABLE[failure.type](failure, kind, unit)


def _share(value: float) -> str:
    """Words for an effectiveness."""
    if value == 0.0:
        return "was lost completely"
    if value < 0.0:
        return f"acted in reverse, with {-100 * value:.0f} % of its effect"
    if value == 1.0:
        return "had its full effect"
    if value < LOST:
        return f"was lost but for {100 * value:.0f} % of its effect"
    return f"kept {100 * value:.0f} % of its effect"


def _decay(failure: Any, *_: str) -> str:
    how = "within" if failure.shape == "linear" else "with a time constant of"
    return f"began to lose its effect (to {100 * failure.value:.0f} % {how} {failure.over_s:g} s)"


def _stop(failure: Any, kind: str, _: str) -> str:
    if kind == "servo":
        return f"ran to its {'highest' if failure.to == 'max' else 'lowest'} stop"
    return "ran at full throttle" if failure.to == "max" else "ran at its lowest throttle"


def _limits(failure: Any, _: str, unit: str) -> str:
    low, high = failure.low, failure.high
    if low is None:
        return f"could go no higher than {high:g} {unit}"
    return (
        f"could go no lower than {low:g} {unit}"
        if high is None
        else f"was limited to {low:g} to {high:g} {unit}"
    )


def _runaway(failure: Any, kind: str, unit: str) -> str:
    return f"moved to its {'highest' if failure.to == 'max' else 'lowest'} stop at {failure.rate:g} {unit}/s"


def _properties(failure: Any, *_: str) -> str:
    return ", ".join(f"{name} was held at {value:g}" for name, value in failure.set.items())


TABLE: dict[str, Words] = {
    "effectiveness": lambda f, kind, unit: _share(f.value),
    "decay": _decay,
    "intermittent": lambda f, kind, unit: (
        f"began to fail on and off (at {100 * f.value:.0f} % for {f.off_s:g} s, healthy for {f.on_s:g} s on average)"
    ),
    "prop_loss": lambda f, kind, unit: "was lost completely (its propeller is gone)",
    "motor_stop": lambda f, kind, unit: f"stopped{' and was braked' if f.braked else ''}",
    "surface_lost": lambda f, kind, unit: "broke off",
    "command_scale": lambda f, kind, unit: (
        f"followed {'only ' if f.value < 1.0 else ''}{100 * f.value:.0f} % of its commands"
    ),
    "reversal": lambda f, kind, unit: "acted against its commands",
    "stuck": lambda f, kind, unit: "got stuck where it was",
    "stuck_at": lambda f, kind, unit: f"got stuck at {f.value:g} {unit}",
    "hardover": _stop,
    "float": lambda f, kind, unit: "floated freely",
    "bias": lambda f, kind, unit: f"was offset by {f.value:g} {unit}",
    "position_limit": _limits,
    "rate_limit": lambda f, kind, unit: f"moved at no more than {f.value:g} {unit}/s",
    "lag": lambda f, kind, unit: f"became slow (a lag of {1.0 / f.lag_rad_s:.2g} s)",
    "delay": lambda f, kind, unit: f"followed its commands {f.delay_s:g} s late",
    "oscillation": lambda f, kind, unit: f"oscillated by {f.amplitude:g} {unit} at {f.frequency_hz:g} Hz",
    "runaway": _runaway,
    "property": _properties,
}
"""By the type of the failure."""
