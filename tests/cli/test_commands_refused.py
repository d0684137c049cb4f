"""What the command line refuses, it refuses with what was probably meant."""

from __future__ import annotations

from pathlib import Path

import pytest
from command_line import Called


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["runn"], "argument COMMAND: 'runn' is not known, did you mean run?"),
        (["fly"], "argument COMMAND: 'fly' is not known, expected one of run, live, sweep,"),
        (["list", "controler"], "'controler' is not known, did you mean controllers?"),
        (
            ["schema", "all"],
            "'all' is not known, expected one of aircraft, matrix, scenario, search, suite, sweep",
        ),
        (["search", "a", "--budget", "1e3"], "argument --budget: is '1e3', expected a whole number"),
        (["certify", "a", "--error", "10%"], "argument --error: is '10%', expected a number"),
        (["sweep", "a", "--rnus", "3"], "not known: --rnus 3, did you mean --runs?"),
        (["sweep", "a", "--rnus=3"], "not known: --rnus=3, did you mean --runs?"),
        (["report", "a", "--runs", "3"], "not known: --runs 3, --runs is an option of other commands"),
        (["run", "a", "b"], "not known: b\n"),
    ],
)
def test_a_wrong_argument_is_refused_with_what_was_meant(
    here: Path, called: Called, arguments: list[str], words: str
) -> None:
    status, out, err = called(*arguments)
    assert (status, out) == (2, "") and words in err, err
