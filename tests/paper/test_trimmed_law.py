"""The law (13) about a trimmed flight, of `paper.trimmed_law`: against (31), (32) and the discrete law's variance."""

from __future__ import annotations

import numpy as np
import pytest
from paper.trimmed_law import TrimmedLaw, law_of

from paper import noise
from testbed.scenario.load import changed, load_scenario


@pytest.fixture(scope="module")
def paper() -> TrimmedLaw:
    plain = {"type": "adaptive_inversion", "preset": "paper", "gamma": 2.0}
    return law_of(changed(load_scenario("scenarios/left_tail_fail.yaml"), {"controller": plain}))


def test_a_reading_moves_the_error_once(paper: TrimmedLaw) -> None:
    """(31): a gyro enters by its difference and by f_m, an accelerometer alone, alpha by f_m; pitch and roll cancel."""
    b, dt = np.array(paper.model.A), paper.setup.dt_s
    gyro = paper.error_response("gyro_p")
    assert gyro[1, 0] == pytest.approx(-1.0 / dt) and not np.abs(gyro[2:]).max() > 1e-6
    assert gyro[0, 0] + gyro[1, 0] == pytest.approx(-b[0, 2], rel=1e-6)  # for long only f_m is left
    assert paper.error_response("accelerometer_x")[0] == pytest.approx([0.0, 0.0, 0.0, 1.0], abs=1e-9)
    assert paper.error_response("beta")[0] == pytest.approx(-b[:, 1], abs=1e-4)
    for channel in ("pitch", "roll"):
        assert np.abs(paper.error_response(channel)).max() < 1e-6


def test_newton_response_is_eq_32(paper: TrimmedLaw) -> None:
    """A lasting e settles where Phi d = e. An e of both sides alike, at which the propellers' constant torque cancels, settles at
    (B^-1 e) / a, and as white noise it has the variance of the discrete law."""
    e = np.zeros((8000, 4))
    e[0] = [0.1, -0.2, 0.05, 0.3]
    assert paper.newton_response(e, 2.0).sum(axis=0) == pytest.approx(
        np.linalg.solve(paper.regressor, e[0]), rel=1e-6
    )
    e[0] = [0.0, -0.2, 0.0, 0.3]
    response = paper.newton_response(e, 2.0)
    n_over_a = np.array(paper.model.B_inv) @ e[0] / paper.positions
    assert response.sum(axis=0) == pytest.approx(n_over_a, rel=1e-6)
    dt, step = paper.setup.dt_s, 2.0 * paper.setup.dt_s
    nu = noise.shape(1.0, 2.0, dt)  # of a unit n/a in each step
    assert np.sqrt(np.square(response).sum(axis=0)) == pytest.approx(
        np.abs(n_over_a) * noise.deviation(nu, step), rel=1e-6
    )
