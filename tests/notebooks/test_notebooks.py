"""Notebooks are stored without output, use what is public, and run from top to bottom in a new folder."""

from __future__ import annotations

import os
import re
from pathlib import Path

import nbformat
import pytest
from command_line import ROOT
from nbclient import NotebookClient

NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))


def source(file: Path) -> str:
    """All code of a notebook."""
    cells = nbformat.read(file, as_version=4).cells
    return "\n".join(cell.source for cell in cells if cell.cell_type == "code")


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_stored_without_output(file: Path) -> None:
    notebook = nbformat.read(file, as_version=4)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        assert not cell.get("outputs") and cell.get("execution_count") is None


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_public_names_are_enough(file: Path) -> None:
    code = source(file)
    assert "import testbed" in code and not re.search(
        r"\btestbed\.(?!(design|fly|sweep|load)\()\w+|from testbed", code
    )


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_it_ends_in_what_it_shows(file: Path) -> None:
    """The last cell is a sentence or two, about the figure of the cell before it."""
    *_, figure, last = nbformat.read(file, as_version=4).cells
    assert (figure.cell_type, last.cell_type) == ("code", "markdown")
    assert "plot" in figure.source and 20 < len(last.source.split()) < 100


def executed(
    file: Path, folder: Path, monkeypatch: pytest.MonkeyPatch, old: str = "", new: str = ""
) -> list[dict]:
    """Outputs of a notebook's code cells, run in a folder with nothing in it; every cell must have some or none fail."""
    paths = [str(ROOT / "src"), os.environ.get("PYTHONPATH", "")]
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in paths if path))
    monkeypatch.setenv("IPYTHONDIR", str(folder / "ipython"))
    monkeypatch.setenv("JUPYTER_DATA_DIR", str(folder / "jupyter"))  # not a kernel of the user's own
    monkeypatch.setenv("TMPDIR", str(folder))
    notebook = nbformat.read(file, as_version=4)
    for cell in notebook.cells:
        cell.source = cell.source.replace(old, new) if old else cell.source
    where = {"metadata": {"path": str(folder)}}
    NotebookClient(notebook, timeout=600, kernel_name="python3", resources=where).execute()
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


def pictures(outputs: list[dict]) -> int:
    return sum("image/png" in output.get("data", {}) for output in outputs)


@pytest.mark.slow
@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_runs(file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    outputs = executed(file, tmp_path, monkeypatch)
    assert pictures(outputs[-1:]) == 1 and all(output["output_type"] != "error" for output in outputs)


@pytest.mark.slow
def test_the_sweep_says_something_of_few_runs_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    outputs = executed(ROOT / "notebooks/monte_carlo.ipynb", tmp_path, monkeypatch, "runs=30", "runs=4")
    assert pictures(outputs) == 2 and "left tail monte carlo: 4 of 4 runs flown" in str(outputs)
