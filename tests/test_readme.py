"""What the README says is so: its links lead somewhere, its commands exist, its Python runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from command_line import ROOT

from testbed.cli.commands import parser

README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_links_lead_somewhere() -> None:
    links = [link for link in re.findall(r"\]\(([^)#]+)\)", README) if "://" not in link]
    assert links
    assert not [link for link in links if not (ROOT / link).exists()]


def test_files_in_the_tree_exist() -> None:
    tree = README.split("## The tree")[1].split("```")[1]
    names = re.findall(r"\b([a-z_]+\.py)\b", tree)
    assert len(names) > 10
    known = {path.name for path in ROOT.rglob("*.py")}
    assert not [name for name in names if name not in known]


def test_its_commands_are_the_programs(capsys: pytest.CaptureFixture[str]) -> None:
    """Each row of the table of commands, with a value for each placeholder, and each option offered is in a row."""
    rows = re.findall(r"^\| `testbed (.+?)` \|", README, flags=re.MULTILINE)
    for row in rows:
        plain = re.sub(r"\[(\w+)(?:\\\|\w+)+\]", r"\1", row)  # the first of [one\|two]
        words = re.sub(r"[][]|\.\.\.", " ", plain).replace("KEY=VALUE", "seed=1").split()
        parser().parse_args(words)
    with pytest.raises(SystemExit):
        parser().parse_args(["--help"])
    offered = set(re.findall(r"^    ([a-z]+)  ", capsys.readouterr().out, flags=re.MULTILINE))
    assert {row.split()[0] for row in rows} == offered


def test_its_python_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The block as it is written, in a folder where its run folder does not exist yet."""
    (block,) = re.findall(r"```python\n(import testbed\n.*?)```", README, flags=re.DOTALL)
    *lines, last = [line for line in block.splitlines() if line]
    assert "load" in last
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    names: dict[str, object] = {}
    exec("\n".join(lines), names)
    from testbed.flight.folder import write_run_folder

    write_run_folder(names["flight"], "runs/left-tail-failure")  # type: ignore[arg-type]
    exec(last, names)


def test_the_lines_that_are_run_from_scratch_are_marked() -> None:
    """.ci/run takes them from here."""
    for marker in ("installs and flies", "installs and tests"):
        assert re.search(rf"<!-- {marker} -->\n```bash\npython3 -m venv [^\n]+\n```", README)
