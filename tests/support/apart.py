"""Workers begin their imports apart: what one has compiled, and written, the others need not compile.

In a new environment nothing is compiled before. Workers that import the same modules at the same time all compile all of them.
"""

from __future__ import annotations

import contextlib
import os
from importlib import import_module
from pathlib import Path

import pytest

_LARGE = (
    ("scipy.signal", "scipy.optimize", "scipy.stats", "scipy.integrate", "cma"),
    ("pandas", "distributed", "hypothesis", "jupyter_client"),
    ("matplotlib.pyplot", "numba", "pymavlink.dialects.v20.ardupilotmega", "control", "gymnasium"),
)
"""What collecting the tests imports anyway, in parts that take about as long."""


def begin(config: pytest.Config) -> None:
    """In a worker that runs all tests: import one part of what is large, and collect from another folder on than the others."""
    worker = os.environ.get("PYTEST_XDIST_WORKER", "").removeprefix("gw")
    if not worker.isdigit() or not _all(config):
        return
    number, workers = int(worker), int(os.environ["PYTEST_XDIST_WORKER_COUNT"])
    for module in _LARGE[number % len(_LARGE)]:
        with contextlib.suppress(ImportError):
            import_module(module)
    places = _places(config.rootpath / "tests")
    first = len(places) * number // workers
    config.args = [str(place) for place in places[first:] + places[:first]]


def in_order(config: pytest.Config, items: list[pytest.Item]) -> None:
    """The order in which all tests are run is that of the folders, wherever collecting them began."""
    if not _all(config):
        return
    order = {place: i for i, place in enumerate(_places(config.rootpath / "tests"))}
    depth = len((config.rootpath / "tests").parts)
    items.sort(key=lambda item: order.get(Path(*item.path.parts[: depth + 1]), -1))


def _all(config: pytest.Config) -> bool:
    """Whether no folders or files are asked for."""
    return config.args_source is pytest.Config.ArgsSource.TESTPATHS


def _places(tests: Path) -> list[Path]:
    """Folders and files of tests, in their order."""
    return [
        *sorted(
            each for each in tests.iterdir() if each.is_dir() and each.name not in ("support", "__pycache__")
        ),
        *sorted(tests.glob("test_*.py")),
    ]
