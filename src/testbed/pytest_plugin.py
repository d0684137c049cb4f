"""pytest plugin: a scenario is a test, and a failed flight leaves its report.

    def test_a_lost_tail_is_held(testbed):
        flight = testbed.passes("left_tail_fail.yaml", set={"sensors": "mems"})  # every requirement is an assertion
        assert flight.metrics["false_alarms"] == 0

Files that the ini option `testbed_scenarios` names are tests without any Python. Whatever fails in a test, the flights that it flew
are written, with their reports.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fnmatch import fnmatch
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:  # pytest loads this module in every project of an environment that has the testbed
    from testbed.reporting.flight import ReportedFlight
    from testbed.scenario.model import Scenario

_FLIGHTS = pytest.StashKey[list["ReportedFlight"]]()
"""The flights of a test, in their order."""


class Flights:
    """The fixture `testbed`: flies, and remembers what a test has flown."""

    def __init__(self, flown: list[ReportedFlight]) -> None:
        self._flown = flown

    def fly(
        self,
        scenario: Scenario | str | Path,
        controller: Callable[..., Any] | None = None,
        *,
        set: Mapping[str, Any] | None = None,
    ) -> ReportedFlight:
        """Fly a scenario, as `testbed.fly`; raises BadInput."""
        from testbed.simulation import fly

        self._flown.append(fly(scenario, controller, set=set))
        return self._flown[-1]

    def passes(
        self,
        scenario: Scenario | str | Path,
        controller: Callable[..., Any] | None = None,
        *,
        set: Mapping[str, Any] | None = None,
    ) -> ReportedFlight:
        """The same; raises AssertionError unless it is flown to the end and meets every requirement of the scenario."""
        __tracebackhide__ = True
        flight = self.fly(scenario, controller, set=set)
        if not flight.passed:
            raise AssertionError(_told(flight))
        return flight


def _told(flight: ReportedFlight) -> str:
    """What was not as required, and the story of the flight."""
    from testbed.reporting.junit import tests_of

    tests = list(tests_of(flight))
    failures = [f"NOT MET: {test.failure}" for test in tests if test.failure]
    return "\n".join([f"{flight.scenario.name}: not passed", *failures, tests[0].text])


@pytest.fixture
def testbed(request: pytest.FixtureRequest) -> Flights:
    """Flies scenarios: `testbed.fly(scenario)`, and `testbed.passes(scenario)`, which asserts that it meets its requirements."""
    return Flights(request.node.stash.setdefault(_FLIGHTS, []))


class ScenarioFile(pytest.File):
    """A scenario's file, which is one test."""

    def collect(self) -> Iterator[ScenarioTest]:
        yield ScenarioTest.from_parent(self, name=self.path.stem)


class ScenarioTest(pytest.Item):
    """A scenario that is flown, and has to pass."""

    def runtest(self) -> None:
        """Fly it; raises AssertionError when it does not pass."""
        Flights(self.stash.setdefault(_FLIGHTS, [])).passes(self.path)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """What was not met, without a traceback of the testbed."""
        from testbed.inputs.problems import BadInput

        if excinfo.errisinstance((AssertionError, BadInput)):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, None, str]:
        """Where it is, and its title."""
        return self.path, None, f"scenario: {self.name}"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The options."""
    meaning = "where failed flights leave their folders (default: pytest's folder for temporary files)"
    parser.getgroup("testbed").addoption("--testbed-out", type=Path, metavar="DIR", help=meaning)
    scenarios = "scenarios that are tests: paths from the root folder, with * for any part"
    parser.addini("testbed_scenarios", scenarios, type="args", default=[])
    parser.addini(
        "testbed_with", "files of parts of your own, as of `testbed run --with`", type="paths", default=[]
    )


def pytest_configure(config: pytest.Config) -> None:
    """Use the parts of one's own, for as long as pytest runs."""
    if files := config.getini("testbed_with"):
        from testbed.parts import use

        config.add_cleanup(use(*files).end)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> ScenarioFile | None:
    """A file that `testbed_scenarios` names."""
    root = parent.config.rootpath
    name = file_path.relative_to(root).as_posix() if file_path.is_relative_to(root) else file_path.name
    named = any(fnmatch(name, pattern) for pattern in parent.config.getini("testbed_scenarios"))
    return ScenarioFile.from_parent(parent, path=file_path) if named else None


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """Write the flights of a test that failed, and say where."""
    report: Any = yield
    if report.when == "call" and report.failed:
        for flight in item.stash.get(_FLIGHTS, []):
            folder = _saved(flight, item)
            report.sections.append((f"testbed: {flight.scenario.name}", f"{folder / 'report.html'}"))
    return report


def _saved(flight: ReportedFlight, item: pytest.Item) -> Path:
    """Write the run folder: DIR/<test>, or the next such name that is free; returns it."""
    from testbed.common.files import slug

    out: Path | None = item.config.getoption("--testbed-out")
    if out is None:
        out = item.config._tmp_path_factory.mktemp("flights")  # type: ignore[attr-defined]
    name = slug(item.name, otherwise="test")
    free = (out / (name if i == 1 else f"{name}-{i}") for i in count(1))
    return flight.save(next(folder for folder in free if not folder.exists()), figures=False)
