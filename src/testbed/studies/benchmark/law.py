"""The seed of a report: made from the controllers' code and a public word, so that nobody can choose the draws for the law."""

from __future__ import annotations

import hashlib
from pathlib import Path

from testbed.studies.drawing.sampling import hashed

_PACKAGE = Path(__file__).parents[2]
_LAW = ("controllers", "aircraft/control_design.py")
_OUTSIDE = ("controllers/external/", "controllers/user/")
"""Seams through which controllers of others come in: no shipped controller is flown by them."""


def law_sha256() -> str:
    """SHA-256 of the code of every shipped controller and of the control design, without the seams for others' controllers."""
    digest = hashlib.sha256()
    files = (file for name in _LAW for file in [_PACKAGE / name, *(_PACKAGE / name).rglob("*.py")])
    for file in sorted(file for file in files if file.is_file()):
        if file.relative_to(_PACKAGE).as_posix().startswith(_OUTSIDE):
            continue
        digest.update(f"{file.relative_to(_PACKAGE)}\0".encode() + file.read_bytes() + b"\0")
    return digest.hexdigest()


def seed_of(word: str) -> int:
    """The seed for a law that is frozen and a word that was said afterwards."""
    return hashed(law_sha256(), word)
