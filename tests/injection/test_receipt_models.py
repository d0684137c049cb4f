"""The expected response of an actuator against closed forms; the plant itself is compared in every flight's receipts."""

from __future__ import annotations

import math

import pytest

from testbed.injection.receipt import MOTOR, SERVO, MotorModel, ServoModel

DT_S, LAG_RAD_S = 0.005, 30.0
HEALTHY_SERVO = {
    **dict.fromkeys(SERVO, 0.0),
    "command-scale": 1.0,
    "servo-lag-rad_sec": LAG_RAD_S,
    "servo-rate-rad_sec": 7.0,
    "servo-min-rad": -0.45,
    "servo-max-rad": 0.45,
    "effectiveness": 1.0,
}
HEALTHY_MOTOR = {
    **dict.fromkeys(MOTOR, 0.0),
    "command-norm": 0.6,
    "command-scale": 1.0,
    "throttle-max-norm": 1.0,
    "effectiveness": 1.0,
    "rpm": 3000.0,
    "thrust_N": 5.0,
}


def servo(steps: int = 1, substeps: int = 1, **changed: float) -> float:
    """Deflection [deg] of a servo that was at rest at zero, some control steps after its command went to 0.1 rad."""
    values = {**HEALTHY_SERVO, "command-rad": 0.1, **{n.replace("__", "/"): v for n, v in changed.items()}}
    model = ServoModel(0.0, 0.0)
    for _ in range(steps):
        found = model.advance(values, DT_S, substeps)
    return found["effective_deg"]


def test_a_step_is_followed_as_by_a_first_order_lag() -> None:
    """1 - exp(-t/T) with the lag's T = 1/30 s; Tustin's rule is half a step ahead at a jump of its input."""
    for steps in (10, 20, 60):
        expected = 1.0 - math.exp(-LAG_RAD_S * DT_S * (steps - 0.5))
        assert servo(steps) == pytest.approx(math.degrees(0.1) * expected, rel=0.02)


def test_substeps_are_physics_steps() -> None:
    assert servo(steps=3, substeps=4) == servo(steps=12)


def test_rate_and_stops_limit_the_servo() -> None:
    rate = 0.2
    assert servo(10, **{"servo-rate-rad_sec": rate}) == pytest.approx(math.degrees(rate * DT_S * 10))
    assert servo(400, **{"servo-max-rad": 0.06}) == pytest.approx(math.degrees(0.06))


@pytest.mark.parametrize(
    ("changed", "position_rad"),
    [
        ({}, 0.1),
        ({"command-scale": -1.0}, -0.1),
        ({"command-bias-rad": 0.05}, 0.15),
        ({"override-active": 1.0, "override-rad": -0.2}, -0.2),
        ({"servo__malfunction__fail_stuck": 1.0}, 0.0),
        ({"linkage-bias-rad": 0.02}, 0.12),
        ({"effectiveness": 0.5}, 0.05),
        ({"float-active": 1.0, "float-gain": 0.8, "incidence-rad": 0.1}, -0.08),
    ],
    ids=lambda value: str(value),
)
def test_where_a_servo_settles(changed: dict[str, float], position_rad: float) -> None:
    assert servo(400, **changed) == pytest.approx(math.degrees(position_rad))


@pytest.mark.parametrize(
    ("changed", "throttle", "thrust_n"),
    [
        ({}, 0.6, 5.0),
        ({"command-scale": 0.5}, 0.3, 5.0),
        ({"command-bias-norm": -0.2}, 0.4, 5.0),
        ({"command-bias-norm": 2.0}, 1.0, 5.0),
        ({"override-active": 1.0, "override-norm": 0.1}, 0.1, 5.0),
        ({"throttle-max-norm": 0.4}, 0.4, 5.0),
        ({"throttle-min-norm": 0.7}, 0.7, 5.0),
        ({"power-lost": 1.0}, 0.25, 5.0),  # 3000 of 12000 rpm
        ({"effectiveness": 0.2}, 0.6, 1.0),
    ],
    ids=lambda value: str(value),
)
def test_motor(changed: dict[str, float], throttle: float, thrust_n: float) -> None:
    found = MotorModel(12000.0).advance({**HEALTHY_MOTOR, **changed}, DT_S, 1)
    assert found == pytest.approx({"throttle": throttle, "thrust_N": thrust_n})
