"""A process that looks at mutants: it reads each from stdin, a line of JSON, and answers in lines of JSON on stdout.

It imports the program, flies each controller once, unspoilt, and then forks. The fork looks at mutants until one ends it; the
next one begins as warm, within milliseconds, where a new process needs seconds. An answer {"pid": ...} says that a fork is there.

The last answer to a mutant has `outcome`:

    refused   BadInput, in words
    valid     checked, not flown
    flown     flown to its end, or until the aircraft was lost
    DEFECT    any other exception

A mutant after which a file is changed or made where none may be, or which opens one for writing elsewhere, is a DEFECT too.

An answer {"stage": ...} says what is begun, in case the fork ends or hangs, and {"ended": status} that it has ended. An
aircraft's model is loaded here as the process of the first load does it (`plant.probe`): this fork may die as well as that.
"""

from __future__ import annotations

import base64
import contextlib
import io
import json
import os
import shutil
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache, partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

import mutants
import outside
import received
import yaml

if TYPE_CHECKING:
    from testbed.studies.drawing.builder import Task
    from testbed.studies.flying.flight import Job
    from testbed.studies.flying.pool import FlyAll
    from testbed.studies.record import Flown

_SCENARIO = """\
name: fuzz
aircraft: ./vtail
duration_s: 1
initial: {heading_deg: 90}
failures: [{type: effectiveness, actuator: left_ruddervator, at_s: 0.5, value: 0.2}]
"""
_LONGEST_S = 4.0
"""Longest flight that is flown here [s]."""
_BUDGET, _MOST_PARTS, _MOST_VARIANTS = 20, 1, 3
"""Flights of a search that is flown here, most searches in one file, and most variants of a sweep."""
_MADE = {received.FOLDER, "run", "out", "again.yaml"}
"""What a command is asked to make or to change."""
_SIZES = {"benchmark": {"draws": 2, "seed": 5}}
"""Options of those studies whose size is not in their file."""
_elsewhere: list[str] = []
"""What was opened for writing outside of the mutant's folder and of the caches."""
_NO_MORE = 77
"""Exit status of a fork that has read the last mutant; a mutant that makes it exit gives another one."""


def main() -> None:
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    sys.stdout = sys.stderr  # what the program prints is no answer
    root = Path(tempfile.mkdtemp(prefix="fuzz-"))
    tempfile.tempdir = os.environ["TMPDIR"] = os.environ["XDG_CACHE_HOME"]
    places = (root, Path(tempfile.tempdir), *map(Path, filter(None, [os.environ.get("NUMBA_CACHE_DIR")])))
    try:
        _warm_up(root)
        sys.addaudithook(partial(_hear, places))
        while _forked(root, answers):
            pass
    finally:
        os.chdir("/")
        shutil.rmtree(root, ignore_errors=True)


def _warm_up(root: Path) -> None:
    """Fly each controller once: neither compiling nor importing is what the mutants are timed for."""
    from testbed.controllers.config import TABLE as CONTROLLERS

    for controller in CONTROLLERS:
        tree = {**mutants.scenario_bases()[0], "controller": {"type": controller}}
        request = {"kind": "scenario", "files": {"s.yaml": yaml.safe_dump(tree)}, "fly": True}
        answer = _examined(request, root, sys.stderr)
        assert answer["outcome"] == "flown", answer


def _hear(places: tuple[Path, ...], event: str, arguments: tuple[Any, ...]) -> None:
    """Keep the name of a file that is opened for writing in none of the places; Python tells each opening to an audit hook."""
    if event != "open" or not isinstance(arguments[0], str | bytes):
        return
    if arguments[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
        name = os.path.abspath(os.fsdecode(arguments[0]))
        nameless = os.path.isdir(name)  # rows of a live flight: a folder itself cannot be written
        if name != os.devnull and not nameless and not any(Path(name).is_relative_to(p) for p in places):
            _elsewhere.append(name)


def _forked(root: Path, answers: TextIO) -> bool:
    """Look at mutants in a fork until it ends; returns whether more may come."""
    pid = os.fork()
    if pid == 0:
        _answer_all(root, answers)
        os._exit(_NO_MORE)
    answers.write(json.dumps({"pid": pid}) + "\n")
    _, status = os.waitpid(pid, 0)
    status = os.waitstatus_to_exitcode(status)
    answers.write(json.dumps({"ended": status}) + "\n")
    return status != _NO_MORE


def _answer_all(root: Path, answers: TextIO) -> None:
    while line := sys.stdin.buffer.readline():
        answers.write(json.dumps(_examined(json.loads(line), root, answers)) + "\n")


def _examined(request: dict[str, Any], root: Path, answers: TextIO) -> dict[str, str]:
    def begin(stage: str) -> None:
        answers.write(json.dumps({"stage": stage}) + "\n")

    with contextlib.suppress(FileNotFoundError):
        shutil.rmtree(root)
    root.mkdir()
    os.chdir(root)
    _write(request["files"], root)
    before = _outside()
    answer = _outcome(request, begin)
    after = _outside()
    changed = [name for name in {*before, *after} if before.get(name) != after.get(name)]
    if wrote := [*changed, *_elsewhere]:
        _elsewhere.clear()
        return {"outcome": "DEFECT", "words": f"wrote {wrote}"[:300]}
    return answer


def _outcome(request: dict[str, Any], begin: Callable[[str], None]) -> dict[str, str]:
    from testbed.inputs.problems import BadInput

    try:
        return {"outcome": TABLE[request["kind"]](request["fly"], begin)}
    except BadInput as error:
        assert error.problems
        return {"outcome": "refused", "words": str(error.problems[0])[:300]}
    except Exception as error:
        last = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(last.filename).name}:{last.lineno}"
        return {"outcome": "DEFECT", "words": f"{type(error).__name__} at {place}: {str(error)[:200]}"}


def _write(files: dict[str, str], root: Path) -> None:
    if any(name.startswith("vtail/") for name in files):
        from testbed.aircraft.shipped import data_root

        skipped = shutil.ignore_patterns("*.py", "*.md", "__pycache__")
        shutil.copytree(data_root() / "aircraft" / "vtail", root / "vtail", ignore=skipped)
        (root / "s.yaml").write_text(_SCENARIO)
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        coded = text.startswith(received.BASE64)
        content = (
            base64.b64decode(text.removeprefix(received.BASE64))
            if coded
            else text.encode("utf-8", "surrogatepass")
        )
        (root / name).write_bytes(content)


def _scenario(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.cli.command import checked
    from testbed.scenario.load import dump, load_scenario
    from testbed.simulation import fly as flown

    begin("checking")
    scenario = checked("s.yaml")
    Path("again.yaml").write_text(dump(scenario), encoding="utf-8")
    assert dump(load_scenario("again.yaml")) == dump(scenario), "does not load again as it is"
    if not fly or scenario.duration_s > _LONGEST_S or scenario.physics_hz > 1000:
        return "valid"
    begin("flying")
    flight = flown(scenario)
    from testbed.flight.folder import load, write_run_folder

    write_run_folder(flight, "run")
    assert load("run").summary == flight.summary, "the run folder does not read back"
    return "flown"


def _sweep(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.api import sweep
    from testbed.studies.run import Options, fly_sweep

    begin("checking")
    plan, _ = sweep.prepare("sweep.yaml")
    if (
        not fly
        or len(plan.variants) > _MOST_VARIANTS
        or plan.builder.scenario(plan.task(0)).duration_s > _LONGEST_S
    ):
        return "valid"
    begin("flying")
    plan = replace(plan, runs=1)
    fly_sweep(plan, Path("out"), Options(save_logs="all", workers=_here))
    sweep.finish(plan, Path("out"), figures=False)
    return "flown"


def _search(fly: bool, begin: Callable[[str], None]) -> str:

    from testbed.api import search
    from testbed.studies.run import Options, Refused
    from testbed.studies.search.run import run_search

    begin("checking")
    search.prepare("search.yaml")
    if not fly:
        return "valid"
    plan, folder = search.prepare("search.yaml", "out", budget=_BUDGET)
    scenario = plan.builder.scenario(plan.task(0))
    if len(plan.parts) > _MOST_PARTS or scenario.duration_s > _LONGEST_S or scenario.physics_hz > 1000:
        return "valid"
    begin("flying")
    options = Options(save_logs="none", workers=_here)
    try:
        flights = run_search(plan, folder, options)
    except Refused:
        return "flown"
    search.finish(plan, folder, flights, figures=False)
    return "flown"


@contextlib.contextmanager
def _here(job: Job, jobs: int | None, cluster: str | None) -> Iterator[FlyAll]:
    """Flies in this process, where an exception is a defect."""
    from testbed.studies.flying.flight import fly_task

    def fly_all(tasks: Iterable[Task]) -> Iterator[Flown]:
        for task in tasks:
            flown = fly_task(job, task)
            assert flown.record.outcome != "error", flown.record.reason
            yield flown

    yield fly_all


def _matrix(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.api import matrix

    begin("checking")
    matrix.prepare("matrix.yaml")
    return "valid"


def _suite(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.api import benchmark

    begin("checking")
    plan, _folder = benchmark.prepare("benchmark.yaml", "out", draws=1)
    for number in range(len(plan.labels)):
        plan.builder.scenario(plan.task(number))
    return "valid"


def _log(fly: bool, begin: Callable[[str], None]) -> str:
    """Read a log by its mapping and, with `fly`, say what its actuators did."""
    import testbed
    from testbed.aircraft.description import load_aircraft
    from testbed.logs.mapped import read_table

    (name,) = (each for each in outside.LOGS if Path(each).exists())
    mapping = outside.MAPS.get(name, "columns.yaml")
    begin("reading")
    read_table(Path(name), Path(mapping), load_aircraft("vtail"))
    if fly:
        begin("diagnosing")
        testbed.diagnose(name, "vtail", mapping, "out")
    return "valid"


def _entry(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.api import benchmark
    from testbed.studies.benchmark import entry

    begin("reading")
    said = entry.read(Path("entry.yaml"), "benchmark.yaml")
    plan, _folder = benchmark.prepare("benchmark.yaml", "out", draws=said.draws, seed=said.seed)
    entry.refuse_other(said, plan, Path("entry.yaml"))
    entry.verdict(
        said, [entry.Checked(0, name, one.flights.split()[0], "h") for name, one in said.controllers.items()]
    )
    return "valid"


def _message(fly: bool, begin: Callable[[str], None]) -> str:
    """Fly by hand as messages say, each refused in words or carried out."""
    from testbed.inputs.problems import BadInput
    from testbed.live.aloft import Line
    from testbed.live.choices import Choices
    from testbed.live.messages import read
    from testbed.live.pilot import Pilot
    from testbed.scenario.load import load_scenario

    begin("flying")
    own, page = Line.pair()
    pilot = Pilot(Choices("s.yaml", load_scenario("s.yaml")), own, lambda *_: (Path("kept"), ""))
    refused: BadInput | None = None
    for line in Path("messages.jsonl").read_bytes().splitlines():
        try:
            pilot._do(0, read(line))
        except BadInput as error:
            refused = error
        pilot._advance(0.1)
        pilot._publish(True, 0.0)
        while page.hear(0.0) is not None:
            pass
    pilot.flight.close()
    if refused is not None:
        raise refused
    return "flown"


def _aircraft(fly: bool, begin: Callable[[str], None]) -> str:
    from testbed.aircraft.description import load_aircraft
    from testbed.aircraft.model_files.check import model_problems
    from testbed.inputs.problems import BadInput
    from testbed.plant import probe
    from testbed.plant.first_load import trust, write_record

    begin("checking")
    aircraft = load_aircraft("./vtail")
    problems = model_problems(aircraft)
    if problems:
        raise BadInput(problems)
    begin("loading")
    trust(aircraft)
    *_, answer = probe._started(aircraft)
    write_record(aircraft.fingerprint(), answer)
    return _scenario(fly, begin)


def _run_folder(fly: bool, begin: Callable[[str], None]) -> str:
    """Read the folder of a run, write its page and its log's other forms and, with `fly`, draw all figures."""
    import testbed
    from testbed.reporting.comparison.compare import compare
    from testbed.reporting.export import TABLE as FORMATS
    from testbed.reporting.figures import draw
    from testbed.reporting.run_report import write_page

    begin("reading")
    flight = testbed.load(received.FOLDER)
    begin("telling")
    write_page(flight, Path(received.FOLDER) / "report.html")
    flight._repr_html_()
    for to in FORMATS:
        flight.export(to, f"{received.FOLDER}/flight.{to}")
    if fly:
        compare([flight, flight], f"{received.FOLDER}/comparison.html")
        draw(flight, received.FOLDER)
    return "valid"


def _study_folder(kind: str, fly: bool, begin: Callable[[str], None]) -> str:
    """Read and resume the folder of a study and, with `fly`, report on it, each whether or not another refuses it."""
    import testbed
    from testbed.inputs.problems import BadInput

    refused: BadInput | None = None
    steps = {"reading": partial(testbed.load, received.FOLDER), "resuming": partial(_resumed, kind, fly)}
    if fly:
        steps["reporting"] = partial(_called, "report", received.FOLDER)
    for stage, step in steps.items():
        begin(stage)
        try:
            step()
        except BadInput as error:
            refused = error
    if refused is not None:
        raise refused
    return "valid"


def _resumed(kind: str, finish: bool) -> None:
    """Fly what a folder lacks, in this process, as its command does with `--resume`; raises BadInput where that refuses.

    Only what is to be finished is planned for this folder, which in all else depends on the study's file alone.
    """
    from testbed.inputs.problems import BadInput, Problem
    from testbed.studies.run import Options, Stopped

    study: Any = import_module(f"testbed.api.{kind}")
    plan = (
        study.prepare(f"{kind}.yaml", received.FOLDER, resume=True, **_SIZES.get(kind, {}))[0]
        if finish
        else _planned(kind)
    )
    folder = Path(received.FOLDER)
    try:
        flights = study.fly(plan, folder, Options(save_logs="none", workers=_here), resume=True)
    except Stopped as error:
        raise BadInput([Problem(str(error))]) from None
    if finish:
        study.finish(plan, folder, flights, figures=False)


@cache
def _planned(kind: str) -> Any:
    """The plan of a kind of study whose folders are received."""
    study: Any = import_module(f"testbed.api.{kind}")
    return study.prepare(f"{kind}.yaml", received.FOLDER, **_SIZES.get(kind, {}))[0]


def _called(*arguments: str) -> None:
    """A command; raises BadInput where it refuses, before or while it flies, AssertionError for a defect."""
    from testbed.cli.commands import main
    from testbed.inputs.problems import BadInput, Problem

    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        status = main(arguments)
    if status in (2, 3):
        raise BadInput([Problem(said.getvalue())])
    assert status in (0, 1), said.getvalue()[-200:]


def _outside() -> dict[str, bytes]:
    """The files that must stay as they are."""
    return {
        str(file): file.read_bytes()
        for file in Path().rglob("*")
        if file.is_file() and file.parts[0] not in _MADE
    }


def _endless(fly: bool, begin: Callable[[str], None]) -> str:
    """Of no mutant: the negative control, a request that is never answered."""
    begin("waiting")
    while True:
        time.sleep(1.0)


TABLE: dict[str, Callable[[bool, Callable[[str], None]], str]] = {
    "scenario": _scenario, "sweep": _sweep, "search": _search, "aircraft": _aircraft, "xml": _aircraft,
    "design model": _aircraft, "matrix": _matrix, "suite": _suite,
    "cases": _sweep, "log": _log, "entry": _entry, "message": _message,
    "run folder": _run_folder,
    **{f"{kind} folder": partial(_study_folder, kind) for kind in ("sweep", "search", "matrix", "benchmark")},
    "endless": _endless,
}  # fmt: skip


if __name__ == "__main__":
    main()
