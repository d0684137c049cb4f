"""The certificate of a scenario: its numbers against the design model's own, and what cannot be certified."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from short_flights import scenario

from testbed.aircraft.description import load_aircraft
from testbed.inputs.problems import BadInput
from testbed.margins.bounds import (
    Flown,
    bias_bound,
    biases,
    error_bound,
    error_limits,
    sector_limit,
    uniform_limit,
)
from testbed.margins.certificate import Certificate, certify
from testbed.margins.matrix_classes import jacobi_radius
from testbed.plant.identification import stored

SCALE = np.array([0.2, 0.2, 2.0, 2.0])
MODEL = stored(load_aircraft("vtail"))
B = np.array(MODEL.input_matrix)[:4] * SCALE
FACTORS = {"Cm_left_ruddervator": 1.3, "Cl_right_propeller": 0.8}


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> Certificate:
    """Of a flight that loses its left tail after a second, with a model that is wrong in two entries."""
    folder = tmp_path_factory.mktemp("certificate")
    lost = "failures=[{type: effectiveness, actuator: left_ruddervator, at_s: 1, value: 0}]"
    wrong = f"controller.model_error={{{', '.join(f'{key}: {value}' for key, value in FACTORS.items())}}}"
    return certify(scenario(folder, "adaptive_inversion", 4, "controller.preset=paper", lost, wrong), 0.05)


def test_modes_are_those_of_the_law_and_a_loss_leaves_more_room(certificate: Certificate) -> None:
    """A principal submatrix has no larger radius, so the estimates of those that are left tolerate more."""
    first, *others = certificate.modes
    model = np.array(MODEL.with_error(FACTORS).input_matrix)[:4] * SCALE
    assert first.title == "nothing failed, nothing released"
    assert first.estimates == first.inversion == pytest.approx(uniform_limit(model))
    assert others[0].title == "left_ruddervator failed, r_dot released"
    assert all(mode.estimates >= first.estimates and len(mode.available) == 3 for mode in others)


def test_mismatch_at_the_reference_is_that_of_the_model_error(certificate: Certificate) -> None:
    """M there is the inverse of the wrong model times the right one; further away the truth itself differs too."""
    model = np.array(MODEL.with_error(FACTORS).input_matrix)[:4] * SCALE
    m = np.linalg.solve(model, B)
    at = {
        round(each.airspeed_m_s, 1): each
        for each in certificate.conditions
        if each.mode == certificate.modes[0].title
    }
    assert at[18.0].effectiveness == pytest.approx(np.diag(m), rel=1e-6)
    assert at[18.0].radius == pytest.approx(float(jacobi_radius(m)), rel=1e-5)
    assert at[18.0].margin is not None and 1.0 - at[18.0].radius <= at[18.0].margin + 1e-6 < 1.0
    assert at[12.6].effectiveness[0] < 0.6 < at[18.0].effectiveness[0]  # less dynamic pressure
    assert certificate.no_flight == pytest.approx([10.8])
    assert all(0.0 < each.remaining < certificate.modes[1].inversion for each in at.values())


def test_bias_at_the_start_is_that_of_the_trim_and_a_flagged_actuator_has_none_later(
    certificate: Certificate,
) -> None:
    model = np.array(MODEL.with_error(FACTORS).input_matrix)[:4] * SCALE
    trim = np.array(MODEL.trim) / SCALE
    beta = bias_bound(error_bound(model, 0.05 * np.abs(model)), trim)
    assert [each.trim_beta for each in certificate.biases] == pytest.approx(beta, rel=0.02)
    left = certificate.biases[0]
    assert left.threshold == 0.1 and left.no_false_alarm
    assert left.range == pytest.approx((1.0 / (1.0 + left.trim_beta), 1.0 / (1.0 - left.trim_beta)))
    assert left.seen_below == pytest.approx(0.1 * (1.0 - left.trim_beta))
    assert 0.0 < certificate.sector_limit < left.error_limit < certificate.modes[0].estimates
    assert certificate.exact_law


def test_flagged_actuators_are_left_out_and_the_others_are_bounded_without_them() -> None:
    """Two rows: all healthy, and the first one flagged with a reference of zero, which would make everything infinite."""
    r = np.array([[0.3, 0.3, 1.5, 1.5], [0.0, 0.3, 1.5, 1.5]])
    each = Flown(r, np.array([[True] * 4, [False, True, True, True]]))
    found = biases(B, each, MODEL.actuators, np.full(4, 0.1), 0.05)
    assert found[0].high_beta == found[0].trim_beta and found[0].share == 1.0
    assert found[1].median_beta < found[1].high_beta == found[1].trim_beta
    assert 0.0 < sector_limit(B, each) < sector_limit(B, Flown(r[:1], each.healthy[:1])) + 1e-9
    assert sector_limit(B, Flown(r, np.full((2, 4), True))) == pytest.approx(0.0, abs=1e-9)


def test_error_limit_is_where_the_bound_passes_one() -> None:
    r = np.array([0.3, 0.2, 1.5, 1.2])
    for i, limit in enumerate(error_limits(B, r)):
        below, above = (bias_bound(error_bound(B, f * limit * np.abs(B)), r)[i] for f in (0.999, 1.001))
        assert below < 1.0 < above


@pytest.mark.parametrize(
    ("controller", "settings", "what"),
    [
        ("pid", [], "controller.type: pid has no estimates to certify, expected adaptive_inversion"),
        (
            "adaptive_inversion",
            [
                f"controller.model_error={{{', '.join(f'{s}_left_propeller: 0' for s in ('Cl', 'Cm', 'Cn', 'CX'))}}}"
            ],
            "the controlled rates of vtail tell 3 of 4 actuators apart",
        ),
    ],
)
def test_what_cannot_be_certified_is_refused_with_its_place(
    tmp_path: Path, controller: str, settings: list[str], what: str
) -> None:
    with pytest.raises(BadInput) as caught:
        certify(scenario(tmp_path, controller, 4, *settings))
    (problem,) = caught.value.problems
    assert what in str(problem) and str(problem).startswith(str(tmp_path))
