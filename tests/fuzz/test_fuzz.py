"""A few hundred mutants of a fixed seed: each ends in words or in a flight. `run.py` tries as many as asked."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import outside
import pytest
import received
import yaml
from mutants import KINDS, scenario_bases, search_bases, sweep_bases
from run import Examiner, examiners, fuzz

from testbed.cli.validate import valid

_MUTANTS = 40
"""Of each kind."""


@pytest.fixture(scope="module")
def examiner() -> Iterator[Examiner]:
    with examiners() as one:
        yield one


@pytest.mark.nightly
@pytest.mark.parametrize("kind", KINDS)
def test_every_mutant_ends_in_words_or_in_a_flight(kind: str, examiner: Examiner) -> None:
    # A database is read by `--resume` alone, which flies little where all has been flown.
    found = fuzz(
        kind, _MUTANTS, 1, examiner, fly_every=1 if kind in ("search folder", "matrix folder") else 5
    )
    assert not found.bad, found.bad[:3]
    assert sum(found.outcomes.values()) == _MUTANTS and found.outcomes["refused"] > _MUTANTS // 10


@pytest.mark.nightly
def test_a_defect_a_hang_and_a_dead_process_are_noticed(examiner: Examiner) -> None:
    """The negative control: requests that the process cannot answer."""
    good = {"kind": "scenario", "files": {"s.yaml": "a: 1"}, "fly": False}
    assert examiner.examine(good)["outcome"] == "refused"
    assert examiner.examine({**good, "kind": "nothing"})["outcome"] == "DEFECT"
    assert examiner.examine({**good, "kind": "endless"}, 0.05)["outcome"] == "HANG"
    assert examiner.examine({**good, "files": None})["outcome"] == "DIED"
    assert examiner.examine(good)["outcome"] == "refused"  # in a new process


@pytest.mark.nightly
def test_further_unspoilt_files_are_valid(examiner: Examiner) -> None:
    files = {name: outside._coded(content) for name, content in outside.files().items()}
    for name in outside.LOGS:
        both = {each: files[each] for each in (name, outside.MAPS.get(name, "columns.yaml"))}
        answer = examiner.examine({"kind": "log", "files": both, "fly": True})
        assert answer["outcome"] == "valid", answer
    table = {"sweep.yaml": yaml.safe_dump(outside._WITH_TABLE), "cases.csv": outside._TABLE}
    suite = {"benchmark.yaml": yaml.safe_dump(received.STUDIES["benchmark.yaml"])}
    flown = yaml.safe_dump(received._SCENARIO)
    said = {"s.yaml": flown, "messages.jsonl": "\n".join(map(json.dumps, outside.MESSAGES))}
    for kind, one in (
        ("cases", table),
        ("entry", {**suite, "entry.yaml": files["entry.yaml"]}),
        ("message", said),
    ):
        answer = examiner.examine({"kind": kind, "files": one, "fly": False})
        assert answer["outcome"] in ("valid", "flown"), answer


def test_the_unspoilt_bases_are_valid(tmp_path: Path) -> None:
    """Else every mutant would be refused for the same reason."""
    for i, tree in enumerate([*scenario_bases(), *sweep_bases(), *search_bases()]):
        file = tmp_path / f"{i}.yaml"
        file.write_text(yaml.safe_dump(tree), encoding="utf-8")
        valid(str(file))
