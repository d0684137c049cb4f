"""`--copy-to`: shards that are copied to a bucket when they end, merged from there, and resumed on another machine."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import fsspec
import pytest
from command_line import Called
from sweep_files import SWEEP, same_rows, swept, written

from testbed.inputs.bucket import fetch
from testbed.inputs.problems import BadInput
from testbed.studies.folder import store

SMALL = SWEEP.replace("runs: 12", "runs: 4").replace("compare:", "# compare:")
QUIET = ("--jobs", "1", "--no-plots")


@pytest.fixture
def bucket() -> Iterator[str]:
    """A bucket in the memory of this process, which fsspec reaches as it does others."""
    yield "memory://shards"
    fsspec.filesystem("memory").store.clear()


@pytest.mark.nightly
def test_shards_meet_in_a_bucket(here: Path, called: Called, bucket: str) -> None:
    """What is merged from there has the rows of one machine, and its verdict is written too."""
    file = written(here, SMALL).name
    for k in (1, 2):
        status, out, err = called(
            "sweep", file, "--shard", f"{k}/2", *QUIET, "--out", str(k), "--copy-to", f"{bucket}/{k}"
        )
        assert (status, out.splitlines()[0], err) == (0, f"copied to {bucket}/{k}", "")
    whole = swept(here / file, here / "whole", None)
    merged = called(
        "merge", f"{bucket}/1", f"{bucket}/2", "--out", "merged", "--no-plots", "--junit", "merged.xml"
    )[0]
    assert merged == 1
    same_rows(here / "whole", here / "merged")
    missed = [case.find("failure") is not None for case in ElementTree.parse("merged.xml").iter("testcase")]
    assert missed == [not passed for passed in whole.passed]


@pytest.mark.nightly
def test_a_shard_goes_on_where_its_folder_is_not(here: Path, called: Called, bucket: str) -> None:
    file = written(here, SMALL).name
    arguments = ["sweep", file, "--shard", "1/2", *QUIET, "--out", "one", "--copy-to", f"{bucket}/1"]
    assert called(*arguments)[0] == 0
    with store.reading(here / "one") as kept:
        flights = len(kept)
    shutil.rmtree("one")
    status, _, err = called(*arguments)
    assert (status, err) == (2, f"{bucket}/1: exists already, expected a new folder, or --resume\n")
    status, out, _ = called(*arguments, "--resume")
    assert (status, out.splitlines()[1]) == (0, "no flight was missing")
    with store.reading(here / "one") as kept:
        assert len(kept) == flights == 2


def test_what_cannot_be_reached_is_said_before_a_flight(here: Path, called: Called, bucket: str) -> None:
    file = written(here, SMALL).name
    status, _, err = called("sweep", file, "--out", "one", "--copy-to", "nowhere://b/1")
    assert status == 2 and err.startswith(
        "nowhere://b/1: Protocol not known: nowhere, expected an address such"
    )
    assert not Path("one").exists()
    status, _, err = called("merge", f"{bucket}/1", "--out", "merged")
    assert (status, err) == (2, f"{bucket}/1: there is nothing, expected the folder of a study\n")


def test_a_name_that_leads_out_of_the_folder_is_refused(here: Path, bucket: str) -> None:
    fsspec.filesystem("memory").store["/shards/../../out"] = fsspec.implementations.memory.MemoryFile(
        fsspec.filesystem("memory"), "/shards/../../out", b"x"
    )
    with pytest.raises(BadInput, match="which leads out of it"):
        fetch(bucket, here / "new")
    assert not (here / "new").exists()
