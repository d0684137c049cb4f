"""The `atmosphere` block of a scenario: words for turbulence, and what is refused."""

from __future__ import annotations

import pytest

from testbed.air.config import Atmosphere, severity
from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario, load_scenario

W20 = 7.62  # 25 ft/s


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=2", "failures=[]", "requirements=[]", *settings]
    )


def test_words_for_turbulence() -> None:
    knot = 1852.0 / 3600.0
    for word, knots, index in (("light", 15, 3), ("moderate", 30, 4), ("severe", 45, 6)):
        settings = Atmosphere.model_validate({"turbulence": word})
        assert settings.turbulence_w20_m_s == pytest.approx(knots * knot)
        assert severity(settings.turbulence_w20_m_s) == index
        assert Atmosphere.model_validate(settings.model_dump()) == settings
    assert severity(W20) == 3


@pytest.mark.parametrize(
    ("setting", "words"),
    [
        ("turbulence=moderat", "atmosphere.turbulence: 'moderat' is not known, did you mean moderate?"),
        ("gusts=[{at_s: 1, magnitude_m_s: [1, 0, 0]}]", "has no size, expected either length_m"),
        ("gusts=[{at_s: 5, magnitude_m_s: [1, 0, 0], length_m: 3}]", "5 s is not within the flight"),
        ("gusts=[{at_s: 1, magnitude_m_s: [1, 0], length_m: 3}]", "magnitude_m_s.2: is missing"),
        ("gusts=[{at_s: 1, magnitude_m_s: [1, 0, 0], length_m: 3, frame: bdy}]", "did you mean body?"),
        ("gusts=[{at_s: 1, magnitude_m_s: [1, 0, 0], length: 3}]", "did you mean length_m?"),
    ],
)
def test_refusals(setting: str, words: str) -> None:
    with pytest.raises(BadInput) as caught:
        scenario(f"atmosphere.{setting}")
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ("noise: {w: [1]}", "JSBSim's turbulence draws its own noise, expected model: dryden_8785c"),
        ("model: dryden_8785, noise: {w: [1]}", "did you mean dryden_8785c?"),
        ("model: dryden_8785c, noise: {x: [1]}", "atmosphere.noise.x: unknown"),
        ("model: dryden_8785c, noise: {w: [a]}", "atmosphere.noise.w.0"),
        ("model: dryden_8785c, noise: {from_s: 1, until_s: 1}", "1 s is not after from_s"),
        ("model: dryden_8785c, noise: {from_s: 3}", "noise.from_s: 3 s is not within the flight"),
        ("model: dryden_8785c, noise: {until_s: 1.0e+9}", "noise.until_s: 1e+09 s is control step"),
        (
            "model: dryden_8785c, noise: {from_s: 1, until_s: 1.01, p: [1, 0, 1]}",
            "noise.p: has 3 coefficients for 2 control steps, expected at most 2",
        ),
    ],
)
def test_noise_is_refused(settings: str, words: str) -> None:
    with pytest.raises(BadInput) as caught:
        scenario(f"atmosphere={{{settings}}}")
    assert words in str(caught.value)


def test_two_intensities_are_one_too_many() -> None:
    with pytest.raises(BadInput, match=r"turbulence_w20_m_s: is 3, and turbulence is light, which is 7.717"):
        scenario("atmosphere={turbulence: light, turbulence_w20_m_s: 3}")


def test_a_coefficient_is_set_by_its_path() -> None:
    given = "atmosphere={model: dryden_1797b, turbulence: light, noise: {w: [0, 0, 0]}}"
    noise = scenario(given, "atmosphere.noise.w.1=0.5").atmosphere.noise
    assert noise is not None and noise.w == (0.0, 0.5, 0.0)
