"""Parts of one's own: named in a scenario like shipped ones, flown by every process, recorded, and refused where they are none."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from shutil import copyfile

import pytest
import yaml
from command_line import ROOT, in_this_process
from jsonschema import Draft202012Validator

import testbed
from testbed.api.conformance import conformance
from testbed.cli.schema import model_of, schema_of
from testbed.failures import TABLE as FAILURES
from testbed.flight.folder import write_run_folder
from testbed.inputs.problems import BadInput
from testbed.metrics import TABLE as METRICS
from testbed.reporting.page import groups
from testbed.reporting.panels import shown_log
from testbed.scenario.load import load_scenario
from testbed.studies.flying.flight import Job, fly_task
from testbed.studies.load import load_sweep

SCENARIO = """\
name: own parts
aircraft: vtail
duration_s: 2
reference: weave
failures:
  - {type: sticky, actuator: left_ruddervator, at_s: 0.5, until_s: 1.5, period_s: 0.3}
sensors:
  model: tactical
  faults: [{type: spikes, sensor: altitude, at_s: 1, value_m: 0.5}]
requirements:
  - {metric: worst_bank_deg, at_most: 30}
"""
SWEEP = """\
name: own
scenario: own.yaml
runs: 2
vary: {failures.0.period_s: {uniform: [0.25, 0.5]}}
"""


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A copy of the example, beside a scenario and a sweep that need it."""
    (tmp_path / "own.yaml").write_text(SCENARIO)
    (tmp_path / "sweep.yaml").write_text(SWEEP)
    return Path(copyfile(ROOT / "examples" / "my_parts.py", tmp_path / "my_parts.py"))


@pytest.fixture
def used(own: Path) -> Iterator[Path]:
    with testbed.use(own):
        yield own


def test_editors_know_them(own: Path) -> None:
    """By the schema of a command with `--with` a file that names each kind is right; by the shipped one it is not."""
    said = {**yaml.safe_load(SCENARIO), "sensors": "tactical", "reference": "weave"}

    def unknown() -> set[str]:
        errors = Draft202012Validator(schema_of(model_of("scenario"))).iter_errors(said)
        return {str(error.absolute_path[0]) for error in errors}

    assert unknown() == {"failures", "sensors", "requirements"}  # no reference is shipped
    with testbed.use(own):
        assert unknown() == set()
        said["reference"] = "weaves"
        assert unknown() == {"reference"}


def test_each_kind_is_flown_and_recorded(used: Path, tmp_path: Path) -> None:
    flight = testbed.fly(tmp_path / "own.yaml")
    assert [event["verified"] for event in flight.events if event["kind"] == "injection"] == [True, True]
    assert [event["verified"] for event in flight.events if event["kind"] == "sensor_fault"] == [True]
    position = flight.log["left_ruddervator_position"].diff()[101:141]
    assert (position == 0.0).sum() == 20  # of each 0.3 s it is free for 0.2
    assert flight.metrics["worst_bank_deg"] == flight.log["roll_deg"].abs().max() > 1.0
    assert flight.log["heading_command_deg"].max() > 5.0 and flight.log["heading_command_deg"][0] == 0.0
    shown = {group["name"]: group["panels"] for group in groups(flight, shown_log(flight))}
    assert [panel["title"] for panel in shown["own"]] == ["tail [deg]"]
    write_run_folder(flight, tmp_path / "run")
    assert list(json.loads((tmp_path / "run" / "summary.json").read_text())["parts_sha256"]) == [
        "my_parts.py"
    ]
    assert testbed.load(tmp_path / "run").parts == flight.parts


def test_without_the_file_the_names_are_unknown_and_it_is_said_what_is_missing(
    own: Path, tmp_path: Path
) -> None:
    with testbed.use(own):
        assert "sticky" in FAILURES and "worst_bank_deg" in METRICS
    with pytest.raises(BadInput) as caught:
        load_scenario(tmp_path / "own.yaml")
    problems = list(map(str, caught.value.problems))
    assert len(problems) == 4 and all("one of your own needs --with FILE.py" in text for text in problems)
    assert "sticky" not in FAILURES and "worst_bank_deg" not in METRICS


def test_a_sweep_flies_them_in_its_workers_and_is_resumed_with_the_same_code_only(
    own: Path, tmp_path: Path
) -> None:
    sweep, out = tmp_path / "sweep.yaml", tmp_path / "out"
    with testbed.use(own):
        frame = testbed.sweep(sweep, out, jobs=1, figures=False)
        assert (frame["outcome"] == "completed").all() and (frame["worst_bank_deg"] > 1.0).all()
    own.write_text(own.read_text().replace("0.05]", "0.06]"))
    with testbed.use(own):
        with pytest.raises(BadInput, match=r"other code of my_parts\.py"):
            testbed.sweep(sweep, out, jobs=1, figures=False, resume=True, runs=3)
        only = in_this_process(tmp_path, "sweep", "out/sweep.yaml", "--only", "1", "--no-plots")
        assert only.returncode == 2 and "other code of my_parts.py" in only.stderr


@pytest.mark.nightly
def test_a_shard_with_other_parts_is_not_merged(own: Path, tmp_path: Path) -> None:
    shard = ("sweep", "sweep.yaml", "--jobs", "1", "--with", "my_parts.py")
    assert in_this_process(tmp_path, *shard, "--shard", "1/2", "--out", "one").returncode == 0
    own.write_text(own.read_text().replace("0.05]", "0.06]"))
    assert in_this_process(tmp_path, *shard, "--shard", "2/2", "--out", "two").returncode == 0
    merged = in_this_process(tmp_path, "merge", "one", "two", "--out", "both", "--with", "my_parts.py")
    assert merged.returncode == 2 and "other code of my_parts.py" in merged.stderr


def test_their_code_travels(own: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A Dask worker has the package alone: the file is gone after packing, and the row is the same."""
    pytest.importorskip("distributed", reason="the cluster extra")
    from testbed.studies.flying.pool import fly_packed, pack

    monkeypatch.setenv("TMPDIR", str(tmp_path))
    with testbed.use(own):
        plan = load_sweep(tmp_path / "sweep.yaml")
        job = Job(plan.builder, save_logs="none")
        expected, packed = fly_task(job, plan.task(0)), pack(job)
    own.unlink()
    assert repr(fly_packed(packed, plan.task(0)).record) == repr(expected.record)
    assert expected.record.outcome == "completed" and expected.record.metrics["worst_bank_deg"] > 1.0


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x = 1", "has no parts, expected a list FAILURES"),
        ("FAILURES = [int]", "FAILURES: int is no class of Failure"),
        (
            "from testbed.failures import Stuck as S\nFAILURES = {'stuck': S}",
            "stuck is the name of another failure",
        ),
        ("def f(r): return 1\nMETRICS = [f]", "METRICS: f has no docstring"),
        ("SENSORS = {'odd': {'nose': {}}}", "odd has no sensor 'nose'"),
        ("SENSORS = {'odd': {'gyro': {'noise': 1}}}", "in SENSORS"),
        ("1 / 0", "parts.py:1: raised while being read: ZeroDivisionError"),
    ],
)
def test_what_is_no_part_is_refused_and_nothing_is_used(tmp_path: Path, text: str, words: str) -> None:
    file = tmp_path / "parts.py"
    file.write_text(text.replace("import Stuck", "import TABLE; from testbed.failures.held import Stuck"))
    before = dict(FAILURES)
    with pytest.raises(BadInput) as caught:
        testbed.use(file)
    assert words in str(caught.value) and before == FAILURES


@pytest.mark.parametrize("name", ["none.py", "a\0b.py"])
def test_a_file_that_is_not_there_is_refused(name: str) -> None:
    with pytest.raises(BadInput, match="there is no such file"):
        testbed.use(name)


def test_an_error_in_a_part_is_reported_with_its_line(own: Path, tmp_path: Path) -> None:
    own.write_text(own.read_text().replace("rate = 2 * math.pi", "rate = 2 / 0"))
    run = in_this_process(tmp_path, "run", "own.yaml", "--with", "my_parts.py")
    line = own.read_text()[: own.read_text().index("2 / 0")].count("\n") + 1
    assert run.returncode == 2 and f"my_parts.py:{line}: raised" in run.stderr


def test_the_example_keeps_the_contract_and_worse_ones_do_not(own: Path) -> None:
    assert [finding.wrong for finding in conformance(own)] == [()] * 6
    text = own.read_text()
    for good, bad in {
        "span.offset[span": "span.steps[span",  # has no effect on the reading
        '"servo/malfunction/fail_stuck"): 1.0': '"command-scale"): 1.0',
        "float(t %": "1.0 or float(t %",  # nor has this on the servo
        "flight [deg]": "flight",
        "_position": "_place",
        "return rows": "return rows[1:]",
    }.items():
        assert text.count(good) == 1
        text = text.replace(good, bad)
    own.write_text(text)
    wrong = {finding.part: "; ".join(finding.wrong) for finding in conformance(own)}
    assert "start was not verified" in wrong["failure sticky"]
    assert "gyro_q reads as without it" in wrong["sensor fault spikes"]
    assert "does not have its unit [deg]" in wrong["metric worst_bank_deg"]
    assert "is not in the log" in wrong["panel tail"]
    assert "finite numbers" in wrong["reference weave"] and not wrong["preset of sensors tactical"]
