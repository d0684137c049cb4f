"""Adoption from Python: by a script without a guard, and into a new folder only."""

import subprocess
import sys

import pytest

import testbed

SCRIPT = """
import testbed
print(*testbed.adopt("SGS", "mine"), sep="\\n")
"""


def test_a_script_needs_no_guard(tmp_path):
    (tmp_path / "adopting.py").write_text(SCRIPT)
    done = subprocess.run(
        [sys.executable, "adopting.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("mine\n") and done.stdout.count("trim at") == 1
    assert {"mine.xml", "mine.yaml", "design_model.json"} <= {
        each.name for each in (tmp_path / "mine").iterdir()
    }


def test_a_folder_that_has_something_is_refused(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(testbed.BadInput, match="exists already, expected --out with a new folder"):
        testbed.adopt("SGS", tmp_path)
    assert [each.name for each in tmp_path.iterdir()] == ["notes.txt"]
