"""Controllers of every kind side by side in a study: what one does not say is neither met nor missed."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import search_files
from sweep_files import run, swept

import testbed
from testbed.api import search
from testbed.controllers.config import ESTIMATES, FLAGS, TABLE, says
from testbed.controllers.user.loader import load_controller
from testbed.controllers.user.own import own_controllers
from testbed.inputs.problems import BadInput

EXAMPLES = Path(__file__).parents[2] / "examples"
ON_FLAGS = "{metric: false_alarms, at_most: 0}"
ON_ESTIMATES = "{signal: left_ruddervator_effectiveness_estimate, at_least: 0}"
SWEEP = """\
name: strangers
scenario: scenarios/left_tail_fail.yaml
runs: 2
seed: 3
set:
  duration_s: 1
  failures: [{{type: effectiveness, actuator: left_ruddervator, at_s: 0.3, value: 0.2}}]
  requirements: [{requirements}]
vary: {{failures.0.value: {{uniform: [0.1, 0.6]}}}}
compare: {{controller.type: [adaptive_inversion, pid]}}
"""
ON_HEIGHT = "{metric: altitude_error_max_m, at_most: 5}"


def written(folder: Path, *requirements: str) -> Path:
    file = folder / "strangers.yaml"
    file.write_text(SWEEP.format(requirements=", ".join(requirements)))
    return file


@pytest.mark.nightly
@pytest.mark.skipif(
    not (shutil.which("cc") and shutil.which("perl")), reason="there is no C compiler or no perl"
)
def test_four_kinds_fly_the_same_draws(tmp_path: Path) -> None:
    library = tmp_path / "pilot.so"
    command = [
        "cc",
        "-shared",
        "-fPIC",
        "-O1",
        f"-I{EXAMPLES}",
        str(EXAMPLES / "pilot.c"),
        "-o",
        str(library),
        "-lm",
    ]
    subprocess.run(command, check=True)
    kinds = {
        "python": f"{EXAMPLES / 'my_controller.py'}:MyController",
        "perl": EXAMPLES / "pilot.pl",
        "c": library,
    }
    named = [part for name, what in kinds.items() for part in ("--controller", f"{name}={what}")]
    done = run(tmp_path, "sweep", written(tmp_path, ON_HEIGHT, ON_FLAGS, ON_ESTIMATES), "--out", "out", "--jobs", "1",
               "--junit", "tests.xml", *named)  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    frame = testbed.load(tmp_path / "out")
    verdicts = {
        name: [list(rows[f"requirements.{j}.passed"]) for j in range(3)]
        for name, rows in frame.groupby("controller.type", observed=True)  # type: ignore[union-attr]
    }
    assert verdicts.pop("adaptive_inversion") == [[True, True]] * 3
    silent = [[True, True], [None, None], [None, None]]
    assert verdicts == {name: silent for name in ("c", "perl", "pid", "python")}
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    of = {variant["label"]: variant["requirements"] for variant in summary["variants"]}
    assert [(share["successes"], share["n"], share.get("not_judged")) for share in of["perl"]] == [
        (2, 2, None), (0, 0, 2), (0, 0, 2),
    ]  # fmt: skip
    assert "not_judged" not in json.dumps(of["adaptive_inversion"])
    assert sorted(summary["controllers_sha256"]) == ["c", "perl", "python"]
    page = run(tmp_path, "report", "out")
    assert page.returncode == 0, page.stderr
    assert (
        "Not judged in flights of perl: 2 of 3 requirements."
        in (tmp_path / "out" / "report.html").read_text()
    )


def test_an_argument_and_a_file_are_part_of_what_flies(tmp_path: Path) -> None:
    file = tmp_path / "pilot.pl"
    shutil.copy(EXAMPLES / "pilot.pl", file)
    short = {"duration_s": 0.1, "failures": [], "requirements": []}

    def digest(*words: str) -> str:
        flight = testbed.fly("left_tail_fail.yaml", load_controller(" ".join([str(file), *words])), set=short)
        assert flight.summary["flown_by_sha256"] == flight.flown_by_sha256
        own = own_controllers([f"pilot={file} {' '.join(words)}"])["pilot"]
        assert own.digest == flight.flown_by_sha256
        return flight.flown_by_sha256

    alone, slow = digest(), digest("--gain", "2")
    file.write_text(file.read_text() + "# changed\n")
    assert len({alone, slow, digest()}) == 3
    own = testbed.fly(
        "left_tail_fail.yaml", load_controller(f"{EXAMPLES / 'my_controller.py'}:MyController"), set=short
    )
    own.save(tmp_path / "mine", figures=False)
    assert testbed.load(tmp_path / "mine").flown_by_sha256 == own.flown_by_sha256 != ""  # type: ignore[union-attr]
    page = run(tmp_path, "report", "mine")
    assert (
        page.returncode == 0 and own.flown_by_sha256[:12] in (tmp_path / "mine" / "report.html").read_text()
    )


def test_a_sweep_is_not_resumed_with_other_arguments(tmp_path: Path) -> None:
    file = written(tmp_path, ON_HEIGHT)

    def flown(words: str, **more: object) -> object:
        own = [f"mine={EXAMPLES / 'pilot.pl'} {words}"]
        return swept(file, tmp_path / "out", None, controllers=own, **more)

    flown("--gain 2")
    with pytest.raises(BadInput, match="other code of mine"):
        flown("--gain 3", resume=True, runs=3)


def test_a_flight_in_which_nothing_can_be_judged_has_not_passed(tmp_path: Path) -> None:
    done = run(
        tmp_path, "sweep", written(tmp_path, ON_FLAGS), "--out", "out", "--jobs", "1", "--junit", "tests.xml"
    )
    assert done.returncode == 1, done.stdout + done.stderr
    frame = testbed.load(tmp_path / "out")
    assert list(frame["passed"]) == [True, None, True, None]  # type: ignore[index]
    rows = (tmp_path / "out" / "results.csv").read_text().splitlines()
    place = rows[0].split(",").index("passed")
    assert [row.split(",")[place] for row in rows[1:]] == ["True", "", "True", ""]
    assert "pid: 2 runs\n  not judged  all requirements" in done.stdout
    assert "figures could not" not in done.stderr
    assert "pid 0 of 0, 2 not judged" in frame.attrs["summary"]  # type: ignore[union-attr]
    cases = list(ElementTree.parse(tmp_path / "tests.xml").getroot()[0])
    assert [case.find("skipped") is not None for case in cases] == [False, True, False, True]
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert [v["all_requirements"]["n"] for v in summary["variants"]] == [2, 0] and summary["pairs"][0][
        "n"
    ] == 0


def test_two_runs_of_different_kinds_are_compared(tmp_path: Path) -> None:
    flights = {"default": None, "mine": load_controller(f"{EXAMPLES / 'my_controller.py'}:MyController")}
    scenario = {"duration_s": 1.0, "failures": [], "requirements": [{"metric": "false_alarms", "at_most": 0}]}
    for name, controller in flights.items():
        flight = testbed.fly("left_tail_fail.yaml", controller, set=scenario)
        assert flight.passed is (None if controller else True)
        flight.save(tmp_path / name, figures=False)
    assert testbed.load(tmp_path / "mine").requirements[0]["passed"] is None  # type: ignore[union-attr]
    done = run(tmp_path, "compare", "default", "mine", "--out", "both")
    assert done.returncode == 0, done.stderr
    assert "MyController: not judged." in done.stdout
    assert "0 of 1 requirements met, 1 not judged" in done.stdout


@pytest.mark.parametrize(("kind", "settings"), [*((kind, {}) for kind in TABLE), ("indi", {"monitor": True}),
                                                ("l1_inversion", {"monitor": False}),
                                                ("adaptive_inversion", {"ablate": ["monitor", "jam_test"]})])  # fmt: skip
def test_each_shipped_controller_says_what_it_is_known_to_say(kind: str, settings: dict[str, object]) -> None:
    changes = {
        "controller": {"type": kind, **settings},
        "duration_s": 0.1,
        "failures": [],
        "requirements": [],
    }
    flight = testbed.fly("left_tail_fail.yaml", set=changes)
    said = {
        what for what in (ESTIMATES, FLAGS) if not np.isnan(flight.column(f"left_ruddervator_{what}")).any()
    }
    assert said == says(flight.scenario.controller)
    assert math.isnan(flight.metrics["false_alarms"]) is ("failed" not in said)
    assert np.isnan(flight.column("left_ruddervator_belief")).all() == ("failed" not in said)


def test_a_search_for_what_cannot_be_judged_is_refused(tmp_path: Path) -> None:
    asked = search_files.SEARCH.replace("{name: held, metric: altitude_error_max_m, at_most: 1}", ON_FLAGS)
    file = search_files.written(tmp_path, asked)
    with pytest.raises(
        BadInput, match=r"requirements: cannot be judged: pid says nothing of what they limit"
    ):
        search.prepare(file, tmp_path / "out", ["set.controller={type: pid}"])
    search.prepare(file, tmp_path / "out", ["set.controller={type: adaptive_inversion}"])
