"""JUnit XML of runs, sweeps, matrices and benchmarks: read back by another program, with the stories of what failed."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pandas as pd
import pytest
from sweep_files import here, written

import testbed
from testbed.api import matrix, sweep
from testbed.cli.commands import main
from testbed.inputs.problems import BadInput
from testbed.reporting import junit
from testbed.reporting.story import story
from testbed.studies.load import load_sweep
from testbed.studies.matrix import load_matrix
from testbed.study_reports import benchmark as of_benchmark


def read(file: Path) -> list[ElementTree.Element]:
    """The test cases; the suite's counts are those of its cases."""
    suite = ElementTree.parse(file).getroot()[0]
    cases = list(suite)
    for kind, tag in (("failures", "failure"), ("skipped", "skipped")):
        assert int(suite.attrib[kind]) == sum(case.find(tag) is not None for case in cases)
    assert int(suite.attrib["tests"]) == len(cases)
    return cases


def test_a_flight_has_a_test_for_each_requirement_with_its_story(tmp_path: Path) -> None:
    limits = [{"metric": "altitude_error_max_m", "at_most": most} for most in (1e-9, 100.0)]
    flight = testbed.fly("left_tail_fail.yaml", set={"duration_s": 6, "failures": [], "requirements": limits})
    junit.write(tmp_path / "run.xml", flight.scenario.name, junit.tests_of(flight))
    end, missed, met = read(tmp_path / "run.xml")
    assert end.find("failure") is met.find("failure") is None
    failure = missed.find("failure")
    assert failure is not None and failure.text == "\n".join(story(flight))
    assert missed.attrib["name"] in failure.attrib["message"]


def test_a_sweep_has_a_test_for_each_flight(tmp_path: Path) -> None:
    plan = load_sweep(written(tmp_path), ["runs=3"])
    folder = tmp_path / "out"
    summary = sweep.finish(plan, folder, sweep.fly(plan, folder, here(save_logs="all")), figures=False)
    junit.write(tmp_path / "sweep.xml", plan.name, sweep.tests(plan, folder, summary))
    cases, rows = read(tmp_path / "sweep.xml"), testbed.load(folder)
    assert [case.find("failure") is None for case in cases] == list(rows["passed"])  # type: ignore[index]
    failure = next(case for case in cases if case.find("failure") is not None)
    assert f"--only {failure.attrib['name'].split()[1].rstrip(',')} --variant " in "".join(failure.itertext())


def test_a_matrix_has_a_test_for_each_cell(tmp_path: Path) -> None:
    weak = {
        "type": "effectiveness",
        "value": 0.2,
    }  # made-up flights pass with more than 0.5, and know no other failure
    baseline = [{"actuator": "left_propeller", "severity": 0.5, "result": "lost"}]
    plan = load_matrix("vtail", keys={"failures": [weak, "prop_loss"], "baseline": baseline})
    folder = tmp_path / "out"
    summary = matrix.finish(plan, folder, matrix.fly(plan, folder, here()), figures=False)
    junit.write(tmp_path / "matrix.xml", plan.name, matrix.tests(plan, folder, summary))
    cases = {case.attrib["name"]: [part.tag for part in case] for case in read(tmp_path / "matrix.xml")}
    cell = "{}, effectiveness value=0.2, {}, adaptive_inversion".format
    assert len(cases) == 12
    assert cases[cell("right_propeller", 0.5)] == [] and cases[cell("left_propeller", 0.5)] == ["failure"]
    assert cases[cell("right_propeller", 1)] == ["failure"]
    assert cases["left_ruddervator, prop_loss, 1, adaptive_inversion"] == ["skipped"]


def test_a_benchmarks_failures_tell_what_was_drawn() -> None:
    row = {"draw": 3, "controller": "pid", "failures": "several", "course": "2 in turn", "aircraft": "T37", "truth": "as designed",
           "weather": "light", "gust": "none", "sensors": "ideal", "outcome": "completed", "survived": True, "held": False,
           "inside": 0.835, "end_time_s": 150.0, "altitude_error_max_m": 17.12, "heading_error_max_deg": 25.3,
           "reason": ""}  # fmt: skip
    said = {"file": "open", "seed": 1, "given": {"pid": "pid"}}
    missed, held, lost = of_benchmark.tests_of_benchmark(
        said, pd.DataFrame([row, row | {"held": True}, row | {"survived": False, "outcome": "crashed"}])
    )
    assert (missed.name, missed.failure, held.failure) == ("draw 3, pid", "left its limits", "")
    told, worst, command = missed.text.splitlines()
    assert (
        told
        == "T37, as designed: weather light, gust none, sensors ideal, failures several, course 2 in turn."
    )
    assert worst.startswith("Worst: 17.1 m of altitude, 25 deg of heading; within its limits in 84 % of")
    assert command.startswith("testbed benchmark open --seed 1 --only 3") and lost.failure == "lost: crashed"


def test_names_of_strangers_stay_text(tmp_path: Path) -> None:
    junit.write(tmp_path / "a.xml", 'a"><b>', [junit.Test("\x1b[2J]]>", "<x>&", "\x00 \ud800")])
    (case,) = read(tmp_path / "a.xml")
    assert case.attrib == {"classname": 'a"><b>', "name": r"\x1b[2J]]>"} and case[0].text == r"\x00 \ud800"


def test_only_an_earlier_verdict_is_replaced(tmp_path: Path) -> None:
    junit.write(tmp_path / "a.xml", "a", [])
    junit.refuse(tmp_path / "a.xml", None)
    (tmp_path / "b.xml").write_text("<mine/>")
    with pytest.raises(BadInput, match="exists already"):
        junit.refuse(tmp_path / "b.xml", tmp_path / "out")


@pytest.mark.parametrize("file", ["out", "out/flights.sqlite", "elsewhere/../out/new/a.xml"])
@pytest.mark.parametrize("command", ["run left_tail_fail.yaml", "sweep sweep.yaml", "merge one two"])
def test_none_is_written_among_the_results(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: str,
    file: str,
) -> None:
    """It would take the place of the flights; and a folder that its check had made would stand in the way of the command's."""
    monkeypatch.chdir(tmp_path)
    sweep_file = written(tmp_path)
    before = sorted(tmp_path.rglob("*"))
    assert (
        main([*command.replace("sweep.yaml", str(sweep_file)).split(), "--out", "out", "--junit", file]) == 2
    )
    assert f"{file}: is in out, which holds the results, expected a file beside it" in capsys.readouterr().err
    assert sorted(tmp_path.rglob("*")) == before
