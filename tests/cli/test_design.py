"""`testbed design`: text, and YAML that the scenario takes."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from command_line import Called

from testbed.scenario.load import changed, load_scenario

PAPER = ("scenarios/left_tail_fail.yaml", "--set", "controller.preset=paper")


def test_design_prints_a_controller_block_and_writes_it(here: Path, called: Called) -> None:
    status, out, _ = called("design", *PAPER, "--out", "gains.yaml")
    assert status == 0
    text = out[out.index("controller:") : out.index("wrote gains.yaml")]
    assert (here / "gains.yaml").read_text() == text
    block = yaml.safe_load(text)
    scenario = changed(load_scenario(PAPER[0]), block)
    assert scenario.controller.model_dump()["gamma"] == {"servo": 7.18, "motor": 7.18}
    assert "left_ruddervator" in out and "false alarms: 0 an hour" in out


@pytest.mark.nightly
def test_design_says_what_is_impossible(here: Path, called: Called) -> None:
    status, out, _ = called("design", *PAPER, "--set", "sensors.beta.bias_sigma_deg=0.3")
    assert status == 1
    assert "IMPOSSIBLE  left_ruddervator: errors that last" in out
    assert "would help" in out and "controller:" in out


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (("--keep", "1.5"), "--keep: is 1.5, expected more than 0 and less than 1"),
        (("--out", "mine.yaml"), "mine.yaml: exists already, expected a file that does not exist yet"),
        (("--out", "mine.yaml/gains.yaml"), "mine.yaml/gains.yaml: cannot be written"),
    ],
)
def test_bad_input_is_one_line(here: Path, called: Called, arguments: tuple[str, ...], problem: str) -> None:
    (here / "mine.yaml").write_text("mine")
    status, out, error = called("design", *PAPER, *arguments)
    assert (status, out) == (2, "")
    assert (here / "mine.yaml").read_text() == "mine"
    assert problem in error
