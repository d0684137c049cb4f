"""Programs of the tests, run by the Python that runs the tests."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

_FOLDER = Path(tempfile.mkdtemp(prefix="testbed-scripts-"))


def runnable(name: str) -> Path:
    """A program of `tests/support` whose first line names this Python: what it imports is installed here, and perhaps not in the
    one that PATH finds."""
    source = Path(__file__).parent / name
    script = _FOLDER / "bin" / name
    script.parent.mkdir(exist_ok=True)
    _, _, rest = source.read_text(encoding="utf-8").partition("\n")
    script.write_text(f"#!{sys.executable}\n{rest}", encoding="utf-8")
    script.chmod(0o755)
    return script
