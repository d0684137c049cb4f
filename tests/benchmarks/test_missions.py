"""The campaign of missions: what it flies, what it counts as held, and how it compares."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import missions
import pytest
from mission_list import BASE, MISSIONS, PROPELLERS, ROUTES, TAILS, Condition, Mission, chosen
from mission_results import FAMILIES, Row, Table, by_mission, family, held_more, loses, totals
from true_trims import failures_of, steady_flights

from testbed.inputs.yaml_source import parse
from testbed.studies.drawing.builder import Builder, Task, Variant

HELD = Row("a", "hard_healthy", "vtail", 25.0, 0.0, 1, "completed", 5.0, 15.0, 0.5, 0, 0)


def test_every_mission_is_a_valid_scenario() -> None:
    builder = Builder(parse(BASE, "campaign"), (Variant("", {}),))
    condition = Condition(model_error=0.2)
    for number, mission in enumerate(MISSIONS):
        scenario = builder.scenario(Task(number, 0, 3, condition.values(mission, 3)))
        assert len(scenario.failures) == len(mission.failures)
        assert set(scenario.controller.model_error.values()) == {0.8, 1.2}
    assert len({mission.name for mission in MISSIONS}) == len(MISSIONS)
    assert {mission.name.partition("_")[0] for mission in MISSIONS} == set(ROUTES)


@pytest.mark.parametrize(
    "flags", [["--first-seed", "49999", "--seeds", "2"], ["--reporting", "--first-seed", "90000"]]
)
def test_seeds_for_tuning_and_for_reporting_are_kept_apart(tmp_path: Path, flags: list[str]) -> None:
    with pytest.raises(SystemExit, match="seeds"):
        missions.main([*flags, "--csv", str(tmp_path / "none.csv")])
    assert not (tmp_path / "none.csv").exists()


def test_what_is_held() -> None:
    assert HELD.held
    assert not replace(HELD, altitude_m=5.1).held
    assert not replace(HELD, heading_deg=15.1).held
    assert not replace(HELD, outcome="ground_contact").held


def test_tables_compare_flights_of_the_same_seed() -> None:
    lost = replace(HELD, controller="b", outcome="diverged", altitude_m=math.inf, heading_deg=math.inf)
    rows = [HELD, replace(HELD, seed=2, altitude_m=6.0), lost, replace(lost, seed=2), replace(lost, seed=3)]
    difference = held_more(rows[:2], rows[2:])
    assert difference is not None
    assert (difference.only_first, difference.only_second, difference.neither) == (
        1,
        0,
        1,
    )  # seed 3 has no partner
    assert by_mission(rows)[-1] == "| hard_healthy | 1/2 | 0/**0**/3 |"
    assert "+0.500" in totals(rows, "a")[-1]
    assert loses(rows, "b", by=1) == ["- hard_healthy (vtail, W20 = 25 ft/s): a holds 1, b 0"]
    assert not loses(rows, "b")


def test_a_table_survives_a_cut_line(tmp_path: Path) -> None:
    table = Table(tmp_path / "flights.csv")
    assert table.read() == []
    assert list(table.write([HELD, replace(HELD, seed=2)])) == table.read()
    whole = table.file.read_text()
    table.file.write_text(whole[: whole.rindex("completed") + 4])
    assert table.read() == [HELD]


def test_every_mission_has_a_kind() -> None:
    assert {family(mission.name) for mission in MISSIONS} == set(FAMILIES)


def test_the_truth_has_a_trim_with_a_lost_tail_and_none_without_actuators() -> None:
    """Level flight with the left tail lost at 18 m/s as the design model finds it; nothing holds all four jammed."""
    lost = steady_flights("vtail", failures_of(chosen(MISSIONS, "hard_left_tail_lost")[0]), (18,))
    assert [(flight.airspeed_m_s, flight.path_angle_deg) for flight in lost] == [(18, 0)]
    assert 0.05 < lost[0].margin < 0.9
    jams = [{"type": "stuck_at", "actuator": a, "at_s": 1.0, "value": v} for a, v in
            zip((*TAILS, *PROPELLERS), (10.0, -10.0, 0.1, 0.9), strict=True)]  # fmt: skip
    assert not steady_flights("vtail", failures_of(Mission("hard_none", jams)), (18,))


@pytest.mark.nightly
def test_it_flies_resumes_and_compares_with_before(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "flights.csv"
    chosen = [
        "--missions",
        "hard_left_tail_lost",
        "--controllers",
        "oracle,pid",
        "--jobs",
        "1",
        "--csv",
        str(out),
    ]
    missions.main([*chosen, "--seeds", "1"])
    first = Table(out).read()
    assert [(row.controller, row.seed) for row in first] == [("oracle", 1), ("pid", 1)]
    out.write_text(out.read_text().replace("completed", "diverged", 1))  # kept as it is: not flown again
    missions.main([*chosen, "--seeds", "2", "--resume", "--against", str(out)])
    assert next(row.outcome for row in Table(out).read()) == "diverged"
    assert len(Table(out).read()) == 4
    assert "oracle, before" in capsys.readouterr().out
