"""First lines of docstrings, also with `python -OO`, which drops them."""

from __future__ import annotations

import subprocess
import sys

from testbed.common.docstrings import first_line
from testbed.metrics import TABLE


def undocumented() -> None: ...


def test_without_docstrings_they_are_read_from_the_source() -> None:
    def lines() -> dict[str, str]:
        return {name: first_line(metric) for name, metric in TABLE.items()}

    code = "from testbed.common.docstrings import first_line; from testbed.metrics import TABLE\n"
    code += "print({name: first_line(metric) for name, metric in TABLE.items()})"
    done = subprocess.run([sys.executable, "-OO", "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == f"{lines()}\n"
    assert all(lines().values())


def test_what_has_none() -> None:
    assert first_line(undocumented) == ""
    assert first_line((7).__add__) == "Return self+value."
