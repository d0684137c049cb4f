"""The regulator of a mode: derivatives, the linear plant, the gains, and that the designed loop is stable."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from command_line import ROOT
from scipy.linalg import expm
from vtail_setup import vtail_setup

from testbed.controllers.inversion import regulator as regulator_module
from testbed.controllers.inversion.degraded_aircraft import DegradedAircraft
from testbed.controllers.inversion.mode_trim import NoSteadyFlight, steady_flight
from testbed.controllers.inversion.modes import Mode, enumerate_modes
from testbed.controllers.inversion.regulator import (
    design_regulator,
    linearise,
    lq_gains,
    regulator_for,
)
from testbed.controllers.inversion.steady_flights import jacobian
from testbed.controllers.records import ALTITUDE

SETUP = vtail_setup()
MODES = enumerate_modes(SETUP.model, SETUP.scale, SETUP.control)
REGULATED = [
    failed for failed, mode in MODES.items() if mode.released and not mode.refused and len(failed) < 3
]


def test_jacobian_of_a_known_function() -> None:
    found = jacobian(lambda x: np.array([x[0] * x[1], math.sin(x[0]), 3.0]), np.array([0.5, 2.0]))
    assert found == pytest.approx(np.array([[2.0, 0.5], [math.cos(0.5), 0.0], [0.0, 0.0]]), abs=1e-8)


def test_gains_of_the_double_integrator_are_the_textbooks() -> None:
    """x'' = u, Q = I, R = 1: K = (1, sqrt 3), poles (-sqrt 3 +- i) / 2 (Anderson and Moore, Optimal Control, 1990)."""
    A, B = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]])
    K, poles = lq_gains(A, B, np.eye(2), np.eye(1))
    assert pytest.approx(np.array([[1.0, math.sqrt(3.0)]])) == K
    assert sorted(poles, key=lambda z: z.imag) == pytest.approx(
        [(-math.sqrt(3) - 1j) / 2, (-math.sqrt(3) + 1j) / 2]
    )


def test_what_is_unstable_and_not_controlled_has_no_gains() -> None:
    with pytest.raises(np.linalg.LinAlgError):
        lq_gains(np.array([[1.0]]), np.array([[0.0]]), np.eye(1), np.eye(1))


def test_the_linear_plant_moves_as_the_design_model_does() -> None:
    """A small disturbance for 0.1 s: expm(A t) against small steps of the nonlinear motion, lags and integrals."""
    degraded = DegradedAircraft.after(SETUP, MODES[(0,)], {})
    flight, held = steady_flight(degraded, SETUP.control.loops, "")
    A, _ = linearise(degraded, SETUP.lags, flight, held)
    dz = 1e-3 * np.random.default_rng(2).normal(size=len(A))
    z, steps = np.concatenate([*flight, np.zeros(3)]) + dz, 4000
    for _ in range(steps):
        x, a = z[:10], z[10:14]
        rates = np.concatenate(
            [degraded.motion(x, a), SETUP.lags * (flight.positions - a), (x - flight.state)[[0, ALTITUDE, 8]]]
        )
        z = z + 0.1 / steps * rates
    moved = z - np.concatenate([*flight, np.zeros(3)])
    assert moved == pytest.approx(expm(0.1 * A) @ dz, abs=2e-5)


@pytest.mark.parametrize("failed", REGULATED)
def test_every_mode_of_the_vtail_is_stable_about_its_trim(failed: tuple[int, ...]) -> None:
    mode = MODES[failed]
    regulator = design_regulator(SETUP, mode, {})
    assert regulator.eigenvalues.real.max() < 0.0
    released = [i for i, axis in enumerate(("p_dot", "q_dot", "r_dot", "u_dot")) if axis in mode.released]
    for gains in (regulator.K, regulator.K_actuator, regulator.K_integral):
        assert not gains[released].any(), "nothing is asked of a released axis"
    assert not regulator.K_actuator[:, list(failed)].any(), "nor fed back from a failed actuator"
    if "altitude" not in regulator.held:
        assert not regulator.K[:, ALTITUDE].any()


def test_bryson_a_smaller_deviation_is_held_more_tightly() -> None:
    weights = SETUP.control.regulator
    states = weights.states.model_copy(update={"roll": 0.1})
    control = SETUP.control.model_copy(update={"regulator": weights.model_copy(update={"states": states})})
    tight = design_regulator(replace(SETUP, control=control), MODES[(0,)], {})
    assert np.abs(tight.K[:, 6]).max() > 1.5 * np.abs(design_regulator(SETUP, MODES[(0,)], {}).K[:, 6]).max()


def test_a_jammed_surface_moves_the_trim() -> None:
    there = design_regulator(SETUP, MODES[(0,)], {0: 0.6})
    assert there.r_trim[0] == 0.6
    assert abs(there.x_trim[2] - design_regulator(SETUP, MODES[(0,)], {}).x_trim[2]) > 0.01


def test_at_the_airspeed_of_its_trim_the_loop_is_the_designed_one() -> None:
    """The law divides the deflections that nu asks of surfaces by (V/V_0)^2. At 12.5 m/s that doubles them, which the gains
    must know: the plant of the design, with the law's own division, has the designed eigenvalues."""
    mode, jammed = MODES[(0,)], {0: -25.8 * math.radians(1.0) / SETUP.scale[0]}
    regulator = design_regulator(SETUP, mode, jammed)
    degraded = DegradedAircraft.after(SETUP, mode, jammed)
    flight, held = steady_flight(degraded, SETUP.control.loops, "")
    A, B = linearise(degraded, SETUP.lags, flight, held)
    pressure_ratio = (flight.state[0] / SETUP.model.airspeed_m_s) ** 2
    assert pressure_ratio < 0.55
    divided = mode.inverse / np.array([pressure_ratio, pressure_ratio, 1.0, 1.0])[:, None]
    gains = np.hstack([regulator.K, regulator.K_actuator, regulator.K_integral])
    used = [i for i in range(len(A)) if i != 10]  # a jammed actuator's position is no state of the design
    loop = (A - B @ divided @ gains)[np.ix_(used, used)]
    assert np.sort_complex(np.linalg.eigvals(loop)) == pytest.approx(
        np.sort_complex(regulator.eigenvalues), rel=1e-6
    )
    assert regulator.trim_effect == pytest.approx(
        flight.positions * [pressure_ratio, pressure_ratio, 1.0, 1.0]
    )


def test_jams_at_nearly_the_same_position_share_a_design() -> None:
    one, other, next_one = (regulator_for(SETUP, MODES[(0,)], {0: x}) for x in (0.58, 0.62, 0.68))
    assert one is other and one is not next_one
    assert one.r_trim[0] == pytest.approx(0.6)


def test_an_ill_conditioned_design_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """With one axis kept of fourteen states, the order of the eigenvalues was beyond the solver, and the flight ended with its
    ValueError. Which matrices are, depends on the BLAS: so the error is raised here."""

    def ill_conditioned(*_: np.ndarray) -> np.ndarray:
        raise ValueError("Reordering of (A, B) failed")

    monkeypatch.setattr(regulator_module, "solve_continuous_are", ill_conditioned)
    with pytest.raises(NoSteadyFlight, match="cannot stabilise"):
        design_regulator(SETUP, MODES[(0,)], {})


def test_a_regulator_is_kept_and_so_is_that_there_is_none() -> None:
    assert regulator_for(SETUP, MODES[(2,)], {}) is regulator_for(SETUP, MODES[(2,)], {})
    assert regulator_for(SETUP, MODES[(2,)], {}) is not regulator_for(SETUP, MODES[(3,)], {})
    hopeless = Mode(
        ("left_ruddervator", "right_ruddervator", "left_propeller"), ("p_dot",), np.zeros((4, 4)), 1.0
    )
    for _ in range(2):
        with pytest.raises(NoSteadyFlight, match="one actuator cannot hold"):
            regulator_for(SETUP, hopeless, {})


@pytest.mark.nightly
def test_the_number_of_blas_threads_changes_no_bit() -> None:
    """A flight alone has all threads, a sweep's worker one. With two, LAPACK solves larger problems in another order."""
    code = (
        "from vtail_setup import vtail_setup; from testbed.controllers.inversion.modes import enumerate_modes\n"
        "from testbed.controllers.inversion.regulator import design_regulator\n"
        "setup = vtail_setup(); modes = enumerate_modes(setup.model, setup.scale, setup.control)\n"
        "print(*(design_regulator(setup, modes[pair], {}).K.tobytes().hex() for pair in [(0, 3), (2, 3), (1,)]))"
    )
    path = os.pathsep.join([str(ROOT / "tests" / "support"), os.environ.get("PYTHONPATH", "")])
    designs = set()
    for threads in ("1", "2"):
        environment = {**os.environ, "PYTHONPATH": path, "OPENBLAS_NUM_THREADS": threads}
        command = [sys.executable, "-c", code]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        designs.add(done.stdout)
    assert len(designs) == 1
