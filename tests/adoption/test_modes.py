"""Modes of motion of the v-tail's design model."""

from testbed.adoption.adopt import Motion, modes_of
from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model


def vtail():
    return load_design_model(load_aircraft("vtail").folder / DESIGN_MODEL)


def test_the_v_tail_has_the_five_usual_modes():
    names = [mode.name for mode in modes_of(vtail())]
    assert sorted(names) == ["dutch roll", "phugoid", "roll mode", "short period", "spiral"]


def test_the_short_period_is_near_its_approximation():
    """omega^2 = M_q Z_w - M_alpha (Etkin and Reid, Dynamics of Flight, equation 6.3,14, without M_alpha_dot)."""
    model = vtail()
    z_alpha = model.derivatives[5][0] / model.airspeed_m_s
    m_alpha, m_q = model.derivatives[1][0], model.derivatives[1][3]
    squared = m_q * z_alpha - m_alpha
    found = next(mode for mode in modes_of(model) if mode.name == "short period")
    assert abs(abs(found.eigenvalue) / squared**0.5 - 1.0) < 0.1


def test_modes_in_words():
    assert str(Motion("dutch roll", complex(-0.3, 0.4))) == "dutch roll: 0.5 rad/s, damping 0.60"
    assert str(Motion("spiral", complex(0.1, 0))) == "spiral: time constant 10 s, doubles in 6.93 s"
    assert str(Motion("roll mode", complex(-4, 0))) == "roll mode: time constant 0.25 s"
