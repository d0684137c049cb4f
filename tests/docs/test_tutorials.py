"""The tutorials work: every command and every block of Python is run, in order, as a reader would."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path
from urllib.request import urlopen

import pytest
from code_blocks import all_blocks
from command_line import ROOT, in_this_process
from live_server import serving

TUTORIALS = sorted((ROOT / "docs" / "tutorials").glob("*.md"))


@pytest.mark.nightly
@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_runs_as_written(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """YAML is saved under the name that the text gives it; a command ends with 0, or with what `# exit N` says.

    `testbed live` is ended by Ctrl-C, as the page says, once it has given its page.
    """
    for folder in ("examples", "aircraft", "scenarios"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    text = page.read_text(encoding="utf-8")
    ran = 0
    for number, block in enumerate(all_blocks(text)):
        if block.language == "yaml":
            file = block.file or _named_later(text, block.text)
            (tmp_path / file).write_text(block.text, encoding="utf-8")
        elif block.language == "python":
            exec(compile(block.text, f"{page.name}, block {number}", "exec"), {})
            ran += 1
        elif block.language == "bash":
            for line in block.text.splitlines():
                _run(line, tmp_path)
                ran += 1
    assert ran


def _named_later(page: str, block: str) -> str:
    """The name that the sentence after a block gives it."""
    after = page.partition(block)[2]
    found = re.search(r"[Ss]ave it as `([\w.]+)`", after)
    assert found, block
    return found[1]


def _run(line: str, folder: Path) -> None:
    command, _, comment = line.partition("  # ")
    expected = re.search(r"exit (\d)", comment)
    name, *arguments = shlex.split(command)
    assert name == "testbed", line
    if arguments[0] == "live":
        _serve(folder, *arguments[1:])
        return
    done = in_this_process(folder, *arguments)
    assert done.returncode == (int(expected[1]) if expected else 0), line + done.stdout + done.stderr


def _serve(folder: Path, *arguments: str) -> None:
    with serving(folder, *arguments) as (address, process), urlopen(address) as answer:
        assert b"<html" in answer.read()
    assert process.returncode == 130  # as after every Ctrl-C
