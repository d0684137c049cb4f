"""The v-tail as it is shipped, and a copy of it to be edited."""

from __future__ import annotations

import gc
import os
import shutil
import signal
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

import golden
import pytest

# Before numpy is imported: a flight that is nearly lost has its numbers from the last digits, which depend on the kernel.
os.environ.setdefault("OPENBLAS_CORETYPE", golden.KERNEL["OPENBLAS_CORETYPE"])

import apart
import suite_files
from chromium import chromium

from testbed.aircraft.description import Aircraft, load_aircraft

# Programs started from here hear Ctrl-C, even where the tests themselves were begun in the background, which ignores it.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Generator[None, object, object]:
    """What the tests import stays: the collector of garbage need not look at it, now and later."""
    gc.disable()
    try:
        apart.begin(session.config)
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    apart.in_order(config, items)


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """One process more than cores, as some tests wait for other processes; the nightly tests, browsers among them, one a core."""
    cores = os.cpu_count() or 1
    return min(4, cores if config.option.markexpr == "nightly" else 1 + cores)


@pytest.fixture(scope="session")
def vtail() -> Aircraft:
    return load_aircraft("vtail")


@pytest.fixture
def vtail_copy(vtail: Aircraft, tmp_path: Path) -> Path:
    """The v-tail in a folder of the test's own."""
    return Path(shutil.copytree(vtail.folder, tmp_path / "aircraft" / "vtail"))


@pytest.fixture(scope="session")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of a small suite."""
    return suite_files.written(tmp_path_factory.mktemp("suite"))


@pytest.fixture(scope="session")
def flown_suite(suite: Path) -> Path:
    """Its four draws, flown by two controllers; nothing in this folder is changed."""
    return suite_files.flown(suite, suite.parent / "one")


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """Debian's chromium."""
    with chromium() as running:
        yield running
