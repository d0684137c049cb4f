"""`testbed list`: everything that can be named, each with its meaning."""

from __future__ import annotations

from pathlib import Path

import pytest
from command_line import Called

from testbed.aircraft.shipped import data_root, files_in, find_scenario
from testbed.cli.list import TABLE
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.metrics import TABLE as METRICS

KNOWN = {
    "aircraft": ["vtail"],
    "controllers": list(CONTROLLERS),
    "failures": ["effectiveness", "stuck_at", "reversal", "property"],
    "matrices": ["scenarios/matrices/every_failure.yaml"],
    "metrics": list(METRICS),
    "scenarios": ["scenarios/left_tail_fail.yaml", "scenarios/mems_turbulence.yaml"],
    "searches": ["scenarios/searches/rare_gust.yaml"],
    "sensor_faults": ["stuck", "drift"],
    "suites": ["scenarios/suites/open.yaml"],
    "sweeps": ["scenarios/sweeps/left_tail_monte_carlo.yaml"],
}


def listed(text: str) -> dict[str, str]:
    """Names and meanings that `list` has printed of one table."""
    entries = (line.split(maxsplit=1) for line in text.splitlines()[1:])
    return {name: meaning for name, meaning in entries}  # fails where there is no meaning


@pytest.mark.parametrize("what", KNOWN)
def test_names_and_meanings(here: Path, called: Called, what: str) -> None:
    status, out, _ = called("list", what)
    assert status == 0 and out.splitlines()[0] == what
    assert set(KNOWN[what]) <= set(listed(out))


def test_parts_of_ones_own_are_listed_where_they_are_given(here: Path, called: Called) -> None:
    assert set(TABLE) == {*KNOWN, "own"}
    assert called("list", "own")[1] == "own\n  none: --with FILE.py gives some\n"
    own = str(data_root() / "examples" / "my_parts.py")
    assert listed(called("list", "own", "--with", own)[1])["sticky"].startswith("failure: The servo sticks")
    assert "sticky" in listed(called("list", "failures", "--with", own)[1])
    assert "sticky" not in listed(called("list", "failures")[1])


def test_without_a_name_everything_is_listed(here: Path, called: Called) -> None:
    _, everything, _ = called("list")
    assert everything == "".join(called("list", what)[1] for what in TABLE)


def test_scenarios_and_sweeps_are_listed_by_what_commands_take(here: Path, called: Called) -> None:
    names = [name for what in ("scenarios", "searches", "sweeps") for name in listed(called("list", what)[1])]
    assert [find_scenario(name) for name in names] == [
        *files_in("scenarios"),
        *files_in("scenarios/searches"),
        *files_in("scenarios/sweeps"),
    ]
    about = listed(called("list", "scenarios")[1])["scenarios/lost_surface.yaml"]
    assert about == "The left ruddervator is torn off at 5 s, with its mass."


def test_of_a_long_comment_the_first_paragraph_is_listed(here: Path, called: Called) -> None:
    about = listed(called("list", "scenarios")[1])["scenarios/mems_turbulence.yaml"]
    assert about.startswith("A realistic small UAV") and about.endswith("between manoeuvres.")
