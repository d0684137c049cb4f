"""What a page can choose to fly: a closed list, of which each can be flown."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from testbed.inputs.problems import BadInput
from testbed.live.choices import AS_GIVEN, Choices
from testbed.scenario.load import load_scenario

FILE = "left_tail_fail.yaml"


def made() -> Choices:
    return Choices(FILE, load_scenario(FILE), own="mine.py:Mine")


def test_the_first_is_what_was_given() -> None:
    first = made().flight(**made().given)
    assert first.session.scenario.name == load_scenario(FILE).name and first.own == "mine.py:Mine"
    first.close()


@pytest.mark.parametrize("controller", [AS_GIVEN, "pid"])
@pytest.mark.parametrize("flight", ["stuck_ruddervator.yaml", "aerosonde"])
def test_scenarios_and_aircraft_fly(flight: str, controller: str) -> None:
    live = made().flight(flight, controller)
    live.fly(50)
    scenario = live.session.scenario
    stem, _, ending = flight.partition(".")
    assert scenario.name == (stem.replace("_", " ") if ending else f"{stem} by hand")
    assert controller in (AS_GIVEN, scenario.controller.type)
    assert live.session.ended is None and (live.own is None) == (controller != AS_GIVEN)
    live.close()


def test_aircraft_of_the_working_folder_can_be_chosen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree("aircraft/aerosonde", tmp_path / "mine")
    (tmp_path / "mine/aerosonde.yaml").rename(tmp_path / "mine/mine.yaml")
    monkeypatch.chdir(tmp_path)
    choices = made()
    assert "./mine" in choices.names["aircraft"]
    live = choices.flight("./mine", AS_GIVEN)
    live.fly(50)
    live.close()


@pytest.mark.parametrize(
    ("flight", "controller", "said"),
    [
        ("stuk_ruddervator.yaml", "pid", "stuck_ruddervator.yaml"),
        (FILE, "pidd", "pid"),
        ("/etc/passwd", "pid", "no flight"),
    ],
)
def test_nothing_else_can_be_chosen(flight: str, controller: str, said: str) -> None:
    with pytest.raises(BadInput, match=said):
        made().flight(flight, controller)
