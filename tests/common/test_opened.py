"""What the commands open for writing while they run: Python tells each opening to an audit hook, whatever library asks for it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import compiled_code
import pytest

CODE = """\
import json, os, sys
from pathlib import Path
import testbed
sources, opened = Path(testbed.__file__).parent, []

def told(event, arguments):
    if event == "open" and isinstance(arguments[0], (str, bytes)) and arguments[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
        frame = sys._getframe(1)
        while frame and not Path(frame.f_code.co_filename).is_relative_to(sources):
            frame = frame.f_back
        by = str(Path(frame.f_code.co_filename).relative_to(sources)) if frame else ""
        opened.append([os.fsdecode(arguments[0]), by])

sys.addaudithook(told)
from testbed.cli.commands import main
statuses = [main(line.split()) for line in sys.stdin.read().splitlines()]
Path("opened.json").write_text(json.dumps([statuses, opened]))
"""
SCENARIO = """\
name: short
aircraft: vtail
duration_s: 1
log_hz: 50
initial: {heading_deg: 90}
failures: [{type: effectiveness, actuator: left_ruddervator, at_s: 0.5, value: 0.2}]
"""
SWEEP = """\
name: short
scenario: s.yaml
runs: 2
seed: 3
vary: {failures.0.value: {uniform: [0, 1]}}
"""
COMMANDS = """\
run s.yaml --out run
report run
compare run run --out page.html
export run --to acmi
export run --to kml
export run --to parquet
export run --to mcap
export run --to ulog
export run --to mat
sweep sweep.yaml --out out --jobs 1 --save-logs all --junit out.xml
sweep sweep.yaml --out out --jobs 1 --resume --runs 3
sweep sweep.yaml --only 1 --out one
report out
sweep sweep.yaml --out shard-1 --shard 1/2 --jobs 1
sweep sweep.yaml --out shard-2 --shard 2/2 --jobs 1
merge shard-1 shard-2 --out whole
identify vtail --check
init project
validate s.yaml sweep.yaml
"""
BY = {"common/writing.py", "common/jit.py", "studies/folder/store.py", "cli/terminal.py"}
"""Modules that may open a file for writing; each but the first is explained in `test_writing`."""
PASSING = {
    "inputs/output_file.py",
    "flight/folder.py",
    "studies/flying/worker.py",
    "plant/first_load.py",
    "common/child.py",
}
"""Modules that make files without a name, or in a folder for the time being."""


@pytest.mark.nightly
def test_the_commands_open_nothing_elsewhere_for_writing(tmp_path: Path) -> None:
    place, scratch, cache = (tmp_path / name for name in ("place", "scratch", "cache"))
    for folder in (place, scratch, cache):
        folder.mkdir(mode=0o700)
    (place / "s.yaml").write_text(SCENARIO)
    (place / "sweep.yaml").write_text(SWEEP)
    environment = {
        **os.environ,
        "TMPDIR": str(scratch),
        "MPLCONFIGDIR": str(cache),
        **compiled_code.environment(cache),
    }
    compiled = environment.get("NUMBA_CACHE_DIR", cache)
    ended = subprocess.run(
        [sys.executable, "-B", "-c", CODE],
        cwd=place,
        input=COMMANDS,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0, ended.stderr[-2000:]
    statuses, opened = json.loads((place / "opened.json").read_text())
    assert set(statuses) <= {0, 1}, list(zip(COMMANDS.splitlines(), statuses, strict=True))
    assert any(by == "common/writing.py" for _, by in opened), "the hook hears nothing"
    for name, by in opened:
        passing = name == os.devnull or any(
            Path(name).is_relative_to(each) for each in (scratch, cache, compiled)
        )
        assert passing or by in BY | PASSING or name.endswith("opened.json"), (name, by)
