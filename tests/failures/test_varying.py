"""What the types do whose held value changes with time, or which delay commands, in numbers."""

from __future__ import annotations

import numpy as np
import pytest
from broken_flights import AIRCRAFT, WINDOW, fly, on_left_ruddervator

from testbed.failures import TABLE
from testbed.injection.injector import Injector
from testbed.plant.jsbsim import Plant

SINCE_START_S = np.arange(0, 140) / 200.0


def test_delay_by_whole_steps() -> None:
    """Two steps late from step 3 to step 8; the last command before is held until the first late one arrives."""
    plant, actuator = Plant(AIRCRAFT, 100), {"actuator": "left_propeller", "at_s": 0.03, "until_s": 0.08}
    failure = TABLE["delay"].model_validate({"type": "delay", **actuator, "delay_s": 0.02})
    injector = Injector(plant, AIRCRAFT, [failure], 100)
    arrived = []
    for k in range(10):
        if k >= injector.next_step:
            injector.apply(k)
        plant.command([0.0, 0.0, k / 10, 0.0])
        for delay in injector.filters:
            delay()
        plant.settle(1)
        arrived.append(round(10 * plant["fcs/throttle-pos-norm"]))
    assert arrived == [0, 1, 2, 2, 2, 3, 4, 5, 8, 9]
    assert [failure.delay_steps(rate) for rate in (200, 100, 10)] == [4, 2, 0]


def test_oscillation_is_a_sine_from_the_start_on() -> None:
    failure = TABLE["oscillation"].model_validate(
        {
            "type": "oscillation",
            "actuator": "left_propeller",
            "at_s": 0,
            "amplitude": 0.2,
            "frequency_hz": 2.0,
        }
    )
    changing = failure.course(AIRCRAFT, np.random.default_rng(1))
    assert changing is not None and changing[0].endswith("command-bias-norm")
    values = [changing[1](t, 0.0) for t in SINCE_START_S]
    assert values == pytest.approx(0.2 * np.sin(2.0 * np.pi * 2.0 * SINCE_START_S))


def test_runaway_ramps() -> None:
    position = on_left_ruddervator("runaway", rate=10.0)[1][WINDOW]
    assert np.diff(position)[60:].mean() == pytest.approx(10.0 / 200, rel=1e-3)


@pytest.mark.parametrize(("to", "end"), [("max", 25.8), ("min", -25.8)])
def test_runaway_stays_at_its_stop(to: str, end: float) -> None:
    failure = TABLE["runaway"].model_validate(
        {"type": "runaway", "actuator": "left_ruddervator", "at_s": 0, "rate": 10.0, "to": to}
    )
    changing = failure.course(AIRCRAFT, np.random.default_rng(1))
    assert changing is not None
    assert np.degrees(changing[1](100.0, np.radians(3.0))) == pytest.approx(end)


def test_decay_in_numbers() -> None:
    decay = {"value": 0.2, "over_s": 0.5}
    linear = on_left_ruddervator("decay", **decay)[0].column("left_ruddervator_effectiveness")[WINDOW]
    assert linear == pytest.approx(np.maximum(1.0 - 0.8 * SINCE_START_S / 0.5, 0.2))
    slow = on_left_ruddervator("decay", **decay, shape="exponential")[0]
    exponential = slow.column("left_ruddervator_effectiveness")[WINDOW]
    assert exponential == pytest.approx(0.2 + 0.8 * np.exp(-SINCE_START_S / 0.5))


def test_intermittent_spells_have_their_means() -> None:
    failure = TABLE["intermittent"].model_validate(
        {"type": "intermittent", "actuator": "left_propeller", "at_s": 0, "off_s": 0.2, "on_s": 0.6}
    )
    course = failure.course(AIRCRAFT, np.random.default_rng(1))
    assert course is not None
    broken = [course[1](t, 0.0) == 0.0 for t in np.arange(0.0, 2000.0, 0.01)]
    assert np.mean(broken) == pytest.approx(0.25, abs=0.02)  # 2500 cycles: standard error 0.005
    assert np.sum(np.diff(broken)) / 2 == pytest.approx(2500, rel=0.08)


def test_the_later_of_one_type_replaces_the_earlier() -> None:
    at = {"type": "intermittent", "actuator": "left_propeller", "off_s": 0.05, "on_s": 0.05}
    flown = fly({**at, "at_s": 0.4, "value": 0.5}, {**at, "at_s": 0.8, "value": 0.25})
    effectiveness = flown.column("left_propeller_effectiveness")
    assert set(effectiveness[80:160]) == {0.5, 1.0}
    assert set(effectiveness[160:]) == {0.25, 1.0}
