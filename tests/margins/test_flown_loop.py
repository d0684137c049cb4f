"""The gain of a broken loop: flown and linearised, the two agree."""

from __future__ import annotations

import control
import numpy as np
import pytest

from testbed.inputs.problems import BadInput
from testbed.margins.flown_loop import Loop, loop_by_injection, loop_by_linearisation
from testbed.scenario.load import load_scenario

TAIL = "left_ruddervator"


@pytest.mark.parametrize("kind", ["pid", "adaptive_inversion"])
def test_flown_and_linearised_agree(kind: str) -> None:
    scenario = load_scenario("left_tail_fail.yaml", {"controller": {"type": kind}})
    flown, linear = (loop(scenario, TAIL, [1.0, 4.0]) for loop in (loop_by_injection, loop_by_linearisation))
    assert np.abs(flown.gain / linear.gain - 1.0).max() < 0.05
    assert flown.disk_margin == pytest.approx(linear.disk_margin, rel=0.02)
    assert np.abs(flown.gain[0] / linear.gain[1] - 1.0) > 0.5  # negative control


def test_python_control_takes_it() -> None:
    """A delayed integrator 2 exp(-0.2 s) / s crosses 1 at 2 rad/s, with 90 deg - 0.4 rad of phase left."""
    hz = np.geomspace(0.05, 5.0, 400)
    s = 2j * np.pi * hz
    _, phase_deg, _, crossover_rad_s = control.margin(Loop(hz, 2.0 * np.exp(-0.2 * s) / s).response())
    assert (crossover_rad_s, phase_deg) == pytest.approx((2.0, 90.0 - np.rad2deg(0.4)), rel=1e-2)


def test_a_margin_is_the_distance_from_minus_one() -> None:
    assert Loop(np.array([1.0, 2.0]), np.array([-1.0 + 0.5j, 3.0])).disk_margin == 0.5


def test_what_cannot_be_had_is_refused() -> None:
    scenario = load_scenario("left_tail_fail.yaml", {"controller.type": "indi"})
    with pytest.raises(BadInput, match="there is no servo 'left_propeller'"):
        loop_by_injection(scenario, "left_propeller", [1.0])
    with pytest.raises(BadInput, match="run away where nothing follows them"):
        loop_by_linearisation(scenario, TAIL, [1.0])
