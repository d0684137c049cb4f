"""A flight-control failure testbed: JSBSim is the truth, and a controller that knows only its design model flies it."""

from __future__ import annotations

TYPE_CHECKING = False  # as `typing` has it; importing that takes longer than all else here
if TYPE_CHECKING:
    from typing import Any

    from testbed.adoption.entry import adopt as adopt
    from testbed.api.benchmark import benchmark as benchmark
    from testbed.api.load import load as load
    from testbed.api.matrix import matrix as matrix
    from testbed.api.merge import merge as merge
    from testbed.api.search import search as search
    from testbed.api.sweep import sweep as sweep
    from testbed.gains.design import design as design
    from testbed.inputs.problems import BadInput as BadInput
    from testbed.logs.entry import diagnose as diagnose
    from testbed.parts import use as use
    from testbed.plant.linear import linearise as linearise
    from testbed.reliability.probability import failure_probability as failure_probability
    from testbed.reporting.comparison.compare import compare as compare
    from testbed.simulation import Session as Session
    from testbed.simulation import fly as fly
    from testbed.studies.run import Stopped as Stopped

    __version__: str

_MODULES = {
    "BadInput": "testbed.inputs.problems",
    "Session": "testbed.simulation",
    "Stopped": "testbed.studies.run",
    "adopt": "testbed.adoption.entry",
    "benchmark": "testbed.api.benchmark",
    "compare": "testbed.reporting.comparison.compare",
    "design": "testbed.gains.design",
    "diagnose": "testbed.logs.entry",
    "failure_probability": "testbed.reliability.probability",
    "fly": "testbed.simulation",
    "linearise": "testbed.plant.linear",
    "load": "testbed.api.load",
    "matrix": "testbed.api.matrix",
    "merge": "testbed.api.merge",
    "search": "testbed.api.search",
    "sweep": "testbed.api.sweep",
    "use": "testbed.parts",
}

__all__ = ["__version__", *_MODULES]


def __getattr__(name: str) -> Any:
    """Import on first use: `import testbed` stays quick, and reading results needs no simulator."""
    if name == "__version__":
        from importlib.metadata import PackageNotFoundError, version

        try:
            return version("testbed")
        except PackageNotFoundError:  # run from the repository, not installed
            return "0+unknown"
    if name not in _MODULES:
        raise AttributeError(f"module 'testbed' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_MODULES[name]), name)


def __dir__() -> list[str]:
    """The names that users need, also those that have not been imported yet."""
    return __all__
