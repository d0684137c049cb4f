"""Places that the page of architecture names are there."""

from __future__ import annotations

import re

import pytest
from command_line import ROOT

PAGE = (ROOT / "docs" / "explanation" / "architecture.md").read_text(encoding="utf-8")
PLACES = re.findall(r"`([\w/]+(?:\.py|/))`", PAGE.partition("## Where to look")[2].partition("## Adding")[0])


@pytest.mark.parametrize("place", PLACES)
def test_it_is_there(place: str) -> None:
    assert (ROOT / "src" / "testbed" / place).exists()


def test_there_are_many() -> None:
    assert len(PLACES) > 15
