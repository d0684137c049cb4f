"""x"""

from __future__ import annotations

import pytest

from testbed.inputs.problems import BadInput
from testbed.scenario.load import Scenario, load_scenario


def scenario(*settings: str) -> Scenario:
    return load_scenario(
        "scenarios/left_tail_fail.yaml", ["duration_s=2", "failures=[]", "requirements=[]", *settings]
    )


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("Cm_alfa", "did you mean Cm_alpha?"),
        ("Cm_left_rudervator", "did you mean Cm_left_ruddervator?"),
        ("x", "such as Cl_alpha"),
    ],
)
def test_unknown_coefficients(name: str, words: str) -> None:
    with pytest.raises(BadInput) as caught:
        scenario(f"controller.model_error={{{name}: 1.2}}")
    assert f"controller.model_error.{name}: unknown coefficient" in str(caught.value)
    assert words in str(caught.value)
