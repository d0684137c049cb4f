"""The shipped scenarios, flown as a user flies them, and measured on the log that they leave."""

from __future__ import annotations

import gc
import json
import subprocess
import sys
import types
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from command_line import in_this_process
from command_line import testbed as in_a_process

import testbed
from testbed.common.signals import STATE
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.flight.columns import Recorded
from testbed.flight.flight import Flight, Outcome
from testbed.flight.folder import write_run_folder
from testbed.plant.jsbsim import Plant
from testbed.reporting.story import diagnoses, story
from testbed.scenario.load import load_scenario
from testbed.simulation import Assembly, assemble, fly
from testbed.simulation.assembly import Lockstep

TAIL, PROPELLER = "scenarios/left_tail_fail.yaml", "scenarios/left_propeller_fail.yaml"
ACTUATORS = ("left_ruddervator", "right_ruddervator", "left_propeller", "right_propeller")
FILES = ("scenario.yaml", "log.csv", "summary.json")


def flown(file: str, *settings: str) -> Flight:
    return fly(load_scenario(file, settings))


@dataclass(frozen=True)
class Run:
    """What `testbed run` left: its folder, and what it printed."""

    folder: Path
    process: subprocess.CompletedProcess[str]

    @cached_property
    def flight(self) -> Flight:
        return testbed.load(self.folder)

    @cached_property
    def log(self) -> pd.DataFrame:
        return pd.read_csv(self.folder / "log.csv")


def run(folder: Path, file: str, *settings: str, call: Callable[..., Any] = in_this_process) -> Run:
    """A scenario flown by the command line, from a folder that has nothing to do with the testbed."""
    options = [part for setting in settings for part in ("--set", setting)]
    return Run(folder / "out", call(folder, "run", file, "--no-plots", "--out", "out", *options))


@pytest.fixture(scope="session")
def tail(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return run(tmp_path_factory.mktemp("tail"), TAIL, call=in_a_process)


@pytest.fixture(scope="session")
def propeller(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return run(tmp_path_factory.mktemp("propeller"), PROPELLER, call=in_a_process)


# What the scenarios must show ---------------------------------------------------------------------------------------


def window(log: pd.DataFrame, start: float, end: float) -> pd.DataFrame:
    """Rows of [start, end), or nothing at all if the flight ended before."""
    rows = log[(log.time_s >= start - 1e-9) & (log.time_s < end - 1e-9)]
    return rows if len(rows) == round((end - start) * 200) else rows.iloc[:0]


def worst(log: pd.DataFrame, start: float, end: float, column: str, of: str | float) -> float:
    """Largest distance of a column from another, or from a number; infinite where the flight did not get there."""
    rows = window(log, start, end)
    error = rows[column] - (rows[of] if isinstance(of, str) else of)
    if column == "heading_deg":
        error = (error + 180.0) % 360.0 - 180.0
    return float(np.abs(error).max()) if len(rows) else float("inf")


ESTIMATES = {name: f"{name}_effectiveness_estimate" for name in ACTUATORS}
ALTITUDE = ("altitude_m", "altitude_command_m")
HEADING = ("heading_deg", "heading_command_deg")
AIRSPEED = ("airspeed_m_s", "airspeed_command_m_s")

# start, end, signal, of, limit: the table of the issue, row by row
TAIL_ROWS: list[tuple[float, float, str, str | float, float]] = [
    (2, 5, *ALTITUDE, 0.1),
    (2, 5, *HEADING, 0.1),
    (2, 5, *AIRSPEED, 0.1),
    *((2, 5, estimate, 1.0, 0.03) for estimate in ESTIMATES.values()),
    (6.5, 15, ESTIMATES["left_ruddervator"], 0.2, 0.03),
    (5, 15, *ALTITUDE, 0.5),
    (5, 15, *HEADING, 2.0),
    (12, 15, *HEADING, 0.3),
    *((5, 15, ESTIMATES[name], 1.0, 0.05) for name in ACTUATORS[1:]),
    (15, 60, *ALTITUDE, 0.5),
    (15, 60, *HEADING, 5.0),
    (35, 60, *HEADING, 0.2),
    (35, 60, *ALTITUDE, 0.1),
    (35, 60, *AIRSPEED, 0.1),
]
PROPELLER_ROWS: list[tuple[float, float, str, str | float, float]] = [
    (0, 60, *ALTITUDE, 3.0),
    (0, 60, *HEADING, 20.0),
    (40, 60, *HEADING, 0.5),
    (40, 60, *ALTITUDE, 0.2),
]


def title(row: object) -> str:
    return "-".join(map(str, row[:3])) if isinstance(row, tuple) else ""


@pytest.mark.parametrize("row", TAIL_ROWS, ids=title)
def test_tail_row(tail: Run, row: tuple[float, float, str, str | float, float]) -> None:
    *where, limit = row
    value = worst(tail.log, *where)
    print(f"{title(row)}: {value:.4g} of {limit:g}")
    assert value <= limit, f"{title(row)}: measured {value:.4g}, allowed {limit:g}"


@pytest.mark.parametrize("row", PROPELLER_ROWS, ids=title)
def test_propeller_row(propeller: Run, row: tuple[float, float, str, str | float, float]) -> None:
    *where, limit = row
    value = worst(propeller.log, *where)
    print(f"{title(row)}: {value:.4g} of {limit:g}")
    assert value <= limit, f"{title(row)}: measured {value:.4g}, allowed {limit:g}"


def flagged_at(log: pd.DataFrame, actuator: str) -> float:
    """When an actuator is first flagged [s], infinite for never."""
    times = log.time_s[log[f"{actuator}_failed"] > 0.5]
    return float(times.iloc[0]) if len(times) else float("inf")


def test_tail_is_flagged_and_nothing_else_ever(tail: Run) -> None:
    log = tail.log
    at = {name: flagged_at(log, name) for name in ACTUATORS}
    print("flagged at", at)
    assert 15.0 <= at["left_ruddervator"] <= 15.5, at
    assert all(np.isinf(at[name]) for name in ACTUATORS[1:]), at
    after = log[log.time_s >= at["left_ruddervator"]]
    assert np.all(after.left_ruddervator_failed == 1), "it stays flagged"
    assert np.all(after.r_dot_released == 1)
    assert np.all(log.r_dot_released[log.time_s < 15.0] == 0)
    for axis in ("p_dot", "q_dot", "u_dot"):
        assert np.all(log[f"{axis}_released"] == 0), axis


def test_the_papers_law_flags_whatever_the_standard_deviation() -> None:
    """`flag_std_max` is the weighted estimate's: (13) has no covariance."""
    flight = flown(TAIL, "controller.flag_std_max=0.001")
    assert "left_ruddervator" in {e.get("actuator") for e in flight.events if e["kind"] == "detection"}


def test_propeller_is_flagged_and_nothing_else_ever(propeller: Run) -> None:
    log = propeller.log
    at = {name: flagged_at(log, name) for name in ACTUATORS}
    print("flagged at", at)
    assert 15.0 <= at["left_propeller"] <= 15.6, at
    assert all(np.isinf(at[name]) for name in ACTUATORS if name != "left_propeller"), at
    after = log[log.time_s >= at["left_propeller"]]
    assert np.all(after.left_propeller_failed == 1)
    assert np.all(after.p_dot_released == 1), "the only roll control went with it"
    assert np.all(log.r_dot_released == 0)


def test_no_limit_cycle_and_a_steady_sideslip(tail: Run) -> None:
    """Heading peak to peak under 0.1 deg; crabbed flight: the sideslip that the trim of JSBSim says (-1.47 deg)."""
    settled = window(tail.log, 35, 60)
    heading, beta = settled.heading_deg, settled.beta_deg
    print(
        f"heading peak to peak {np.ptp(heading):.4f} deg, sideslip {beta.mean():.4f} +- {np.ptp(beta) / 2:.4f} deg"
    )
    assert np.ptp(heading) < 0.1
    assert np.ptp(beta) < 0.02
    assert beta.mean() == pytest.approx(-1.473, abs=0.01)
    assert settled.left_propeller_position.min() > 1.0, "no propeller at idle"


def test_the_failures_happened(tail: Run) -> None:
    """A receipt for each, verified on the plant, and the truth in the log; else all of the above shows nothing."""
    log, events = tail.log, tail.flight.events
    injections = [event for event in events if event["kind"] == "injection"]
    assert [(event["time_s"], event["verified"]) for event in injections] == [(5.0, True), (15.0, True)]
    for start, end, value in ((0, 5, 1.0), (5, 15, 0.2), (15, 60, 0.0)):
        assert np.all(window(log, start, end).left_ruddervator_effectiveness == value)
    detections = [event for event in events if event["kind"] == "detection"]
    assert [event["actuator"] for event in detections] == ["left_ruddervator"]
    assert detections[0]["delay_s"] == pytest.approx(detections[0]["time_s"] - 15.0)
    assert not [event for event in events if event["kind"] == "false_alarm"]


@pytest.mark.parametrize("fixture", ["tail", "propeller"])
def test_run_says_what_it_found(fixture: str, request: pytest.FixtureRequest) -> None:
    """Exit status 0, no word from JSBSim, the story of the flight, and the verdict of the scenario's own requirements."""
    done: Run = request.getfixturevalue(fixture)
    assert (done.process.returncode, done.process.stderr) == (0, "")
    first, *told, passed, wrote = done.process.stdout.splitlines()
    assert first.endswith("flew to the end, 60 s")
    assert [line.strip() for line in told] == [*story(done.flight), *diagnoses(done.flight)]
    count = len(done.flight.requirements)
    assert count > 5 and (passed, wrote) == (f"passed: {count} of {count} requirements met", "wrote out")
    assert done.flight.passed


def test_jsbsim_would_be_heard(tmp_path: Path) -> None:
    """The negative control of its silence: without the plant's logger it talks on the same file descriptors."""
    result = subprocess.run(
        [sys.executable, "-c", "import jsbsim; jsbsim.FGFDMExec('.').load_model('nothing')"],
        cwd=tmp_path, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "JSBSim" in result.stdout + result.stderr


# Other rates, mirror images, another controller ---------------------------------------------------------------------


@pytest.mark.parametrize("physics_hz", [400, 1000])
@pytest.mark.parametrize(
    ("file", "rows"), [(TAIL, TAIL_ROWS), (PROPELLER, PROPELLER_ROWS)], ids=["tail", "propeller"]
)
def test_the_tables_hold_at_other_physics_rates(
    file: str, rows: Iterable[tuple[float, float, str, str | float, float]], physics_hz: int
) -> None:
    """The verdict does not hang on the step of the integration; control stays at 200 Hz."""
    flight = flown(file, f"physics_hz={physics_hz}")
    missed = [
        f"{title(row)}: {value:.4g} of {row[-1]:g}"
        for row in rows
        if not (value := worst(flight.log, *row[:-1])) <= row[-1]
    ]
    assert not missed
    assert flight.passed, flight.requirements


LATERAL = ("north_m", "roll_deg", "beta_deg", "p_deg_s", "r_deg_s", "p_dot_", "r_dot_")


def mirrored(log: pd.DataFrame) -> pd.DataFrame:
    """The log as a mirror shows it: left is right, lateral signs turn; flown to the east, so heading h is 180 - h."""
    swap = {"left": "right", "right": "left"}
    columns = {}
    for name in log:
        side, _, rest = str(name).partition("_")
        values = log[f"{swap[side]}_{rest}" if side in swap else name]
        if str(name).startswith("heading"):
            values = (180.0 - values) % 360.0
        elif str(name).startswith(LATERAL) and not str(name).endswith("released"):
            values = -values
        columns[str(name)] = values
    return pd.DataFrame(columns)


DISCRETE = ("time_s", "_failed", "_released", "_effectiveness")


@pytest.mark.parametrize("part", ["tail", "propeller"])
def test_mirror_images_behave_as_mirror_images(part: str, request: pytest.FixtureRequest) -> None:
    """Left and right failures, column by column: flags, releases and failures in the same step, all else within 1e-6.

    Not to the bit: JSBSim and the law sum left before right on both sides, so the last digit of a sum differs, and so
    does the trim's; 60 s of closed loop make at most 6e-7 of it (measured, in desired rates, deg/s2).
    """
    left = request.getfixturevalue(part).log
    right = mirrored(flown(f"scenarios/right_{part}_fail.yaml").log)
    largest = {}
    for name in left:
        difference = float(np.abs(left[name] - right[name]).max())
        size = 1.0 + float(np.abs(left[name]).max())
        if str(name).endswith(DISCRETE):
            assert difference == 0.0, name
        largest[str(name)] = difference / size
    name = max(largest, key=lambda n: largest[n])
    print(f"largest difference of mirror images: {largest[name]:.1e} of 1 + size, in {name}")
    assert largest[name] < 1e-6, name


def test_an_image_in_no_mirror_is_another_flight(tail: Run) -> None:
    """The negative control: the right-hand flight itself, not mirrored, is nothing like the left-hand one."""
    right = flown("scenarios/right_tail_fail.yaml").log
    assert np.abs(tail.log.beta_deg - right.beta_deg).max() > 1.0


def test_fixed_inversion_holds_the_tail_loss_and_loses_the_propeller(tmp_path: Path) -> None:
    """The comparison of the README, honestly: no adaptation is needed for the tail; for the propeller it is."""
    flight = flown(TAIL, "controller.type=fixed_inversion")
    altitude, heading = worst(flight.log, 5, 60, *ALTITUDE), worst(flight.log, 5, 60, *HEADING)
    print(f"fixed inversion, tail lost: {altitude:.2f} m, {heading:.2f} deg")
    assert flight.outcome is Outcome.completed
    assert altitude < 0.5
    assert heading < 5.0
    assert not flight.passed, "it neither estimates nor flags, and settles beside its heading"
    lost = run(tmp_path, PROPELLER, "controller.type=fixed_inversion")
    print(f"fixed inversion, propeller lost: {lost.flight.outcome} at {lost.flight.end_time_s:g} s")
    assert lost.process.returncode == 1
    assert lost.flight.outcome is not Outcome.completed
    assert len(window(lost.log, 15, 60)) == 0


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_every_controller_flies_the_healthy_aircraft(controller: str) -> None:
    flight = flown(TAIL, f"controller.type={controller}", "failures=[]", "requirements=[]", "duration_s=20")
    assert flight.outcome is Outcome.completed
    assert worst(flight.log, 0, 20, *ALTITUDE) < 0.5
    assert worst(flight.log, 0, 20, *HEADING) < 0.5


# Determinism --------------------------------------------------------------------------------------------------------


def test_flown_twice_to_the_same_bytes(tail: Run, tmp_path: Path) -> None:
    """By the command line in another process, and here; every file."""
    again = write_run_folder(flown(TAIL), tmp_path / "again")
    for name in FILES:
        assert (again / name).read_bytes() == (tail.folder / name).read_bytes(), name


def test_the_resolved_scenario_flies_to_the_same_bytes(tail: Run, tmp_path: Path) -> None:
    again = run(tmp_path, str(tail.folder / "scenario.yaml"))
    for name in FILES:
        assert (again.folder / name).read_bytes() == (tail.folder / name).read_bytes(), name


def test_a_failure_a_step_later_is_another_flight(tail: Run) -> None:
    """The negative control: the same until the step in which the failure is missing, and not after."""
    later = flown(TAIL, "failures.0.at_s=5.005").log
    same = np.all(np.isclose(later, tail.flight.log, rtol=0, atol=0, equal_nan=True), axis=1)
    assert np.flatnonzero(~same)[0] == 5 * 200


# Lost aircraft ------------------------------------------------------------------------------------------------------

LOST = [
    (
        Outcome.ground_contact,
        TAIL,
        [
            "failures=[{type: effectiveness, actuator: left_propeller, at_s: 5, value: 0},"
            "{type: effectiveness, actuator: right_propeller, at_s: 5, value: 0},"
            "{type: effectiveness, actuator: left_ruddervator, at_s: 5, value: 0}]",
            "initial.altitude_m=30",
            "commands=[]",
        ],
    ),
    (
        Outcome.envelope_exceeded,
        PROPELLER,
        [
            "controller.type=fixed_inversion",
            "failures=[{type: effectiveness, actuator: left_propeller, at_s: 5, value: 0}]",
        ],
    ),
    (
        Outcome.diverged,
        TAIL,
        ["failures=[{type: property, at_s: 5, set: {inertia/pointmass-weight-lbs: 1.0e+300}}]"],
    ),
]


@pytest.mark.parametrize(("outcome", "file", "settings"), LOST, ids=[str(case[0]) for case in LOST])
def test_a_lost_aircraft_is_an_outcome(
    outcome: Outcome, file: str, settings: list[str], tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """Exit status 1, no traceback, and a log that is finite up to its last row, read with pandas."""
    lost = run(tmp_path, file, "requirements=[]", *settings)
    summary: Mapping[str, Any] = json.loads((lost.folder / "summary.json").read_text())
    assert (lost.process.returncode, lost.process.stderr) == (1, "")
    assert capfd.readouterr() == ("", ""), "JSBSim said something"
    assert outcome.sentence in lost.process.stdout
    assert (summary["outcome"], summary["passed"]) == (str(outcome), False)
    log = lost.log
    assert len(log) == round(summary["end_time_s"] * 200)
    assert 5.0 < summary["end_time_s"] < 60.0
    unsaid = [
        name for name in log if "_belie" in name or name.endswith(("_failed", "_estimate"))
    ]  # it flies without
    assert np.all(np.isfinite(log.drop(columns=unsaid).iloc[:-1].to_numpy()))
    if outcome is Outcome.ground_contact:
        assert log.altitude_m.iloc[-1] < 0.5 < log.altitude_m.iloc[-200]


def test_no_steady_flight_to_begin_from_is_bad_input(tmp_path: Path) -> None:
    """Within the envelope, but faster than full throttle flies level."""
    result = run(tmp_path, TAIL, "initial.airspeed_m_s=39", "requirements=[]")
    assert result.process.returncode == 2
    assert "initial: no steady flight of vtail was found at 39 m/s, 300 m" in result.process.stderr
    assert len(result.process.stderr.splitlines()) == 1
    assert not list(tmp_path.iterdir())


# The controller never reads the truth -------------------------------------------------------------------------------


def reachable(thing: object) -> list[object]:
    """Every object that can be reached from one through attributes and containers (not through modules and classes)."""
    seen: dict[int, object] = {}
    waiting = [thing]
    while waiting:
        this = waiting.pop()
        if id(this) in seen or isinstance(
            this, type | types.ModuleType | types.FunctionType | types.BuiltinFunctionType
        ):
            continue
        if type(this).__module__.startswith(("numba", "llvmlite")):
            continue
        seen[id(this)] = this
        waiting += gc.get_referents(this)
    return list(seen.values())


def test_nothing_of_the_plant_can_be_reached_from_the_controller() -> None:
    parts = assemble(load_scenario(TAIL))
    found = reachable(parts.controller)
    assert len(found) > 100, "the walk went somewhere"
    assert not [x for x in found if isinstance(x, Plant) or type(x).__module__.startswith("jsbsim")]
    assert any(x is parts.plant for x in reachable(parts.injector)), (
        "the negative control: it is seen where it is"
    )


def recorded(parts: Assembly) -> Recorded:
    flown = Lockstep(parts)
    flown.advance(parts.scenario.steps)
    return flown.recorded


def test_poisoned_truth_changes_nothing() -> None:
    """Effectiveness and true positions are logged beside the measured state; spoiling them changes no command."""
    scenario = load_scenario(TAIL, ["duration_s=20", "requirements=[]"])
    truth, measured, _, telemetry = recorded(assemble(scenario))
    parts = assemble(scenario)
    sample = parts.plant.sample

    def poisoned() -> None:
        sample()
        parts.plant.raw[len(STATE) :] = 1e6

    parts.plant.sample = poisoned  # type: ignore[method-assign]
    spoiled, measured_again, _, telemetry_again = recorded(parts)
    assert np.all(spoiled[:, len(STATE) :] != truth[:, len(STATE) :]), "the poison was taken"
    assert measured_again.tobytes() == measured.tobytes()
    assert telemetry_again.tobytes() == telemetry.tobytes()
    assert telemetry[:, len(ACTUATORS) * 2].min() < 0.3, "and the controller had something to find out"
