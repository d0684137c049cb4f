"""Notebooks are stored with what they show, use what is public, and run from top to bottom in a new folder."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
import pytest

from notebooks import NOTEBOOKS, ROOT, code_digest, read, run

of_all = pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)


def code(notebook: nbformat.NotebookNode) -> str:
    """All code of a notebook."""
    return "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "code")


def outputs(notebook: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    """Outputs of all code cells."""
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


def pictures(shown: list[nbformat.NotebookNode]) -> int:
    return sum("image/png" in output.get("data", {}) for output in shown)


def texts(notebook: nbformat.NotebookNode) -> list[str]:
    """What each cell shows in words and numbers; in how many pieces its prints arrive is chance."""
    return ["".join(map(_text, cell.get("outputs", []))) for cell in notebook.cells]


def _text(output: nbformat.NotebookNode) -> str:
    return output.get("text") or output["data"].get("text/plain", "")


@of_all
def test_stored_with_the_outputs_of_its_code(file: Path) -> None:
    """If it fails: python docs/generate/notebooks.py."""
    notebook = read(file)
    nbformat.validate(notebook)
    assert notebook.metadata.get("code_digest") == code_digest(notebook)
    assert pictures(outputs(notebook)) and not re.search(r"/tmp/|/home/|/root/", str(texts(notebook)))
    ran = [cell.execution_count for cell in notebook.cells if cell.cell_type == "code"]
    assert ran == list(range(1, len(ran) + 1))


@of_all
def test_public_names_are_enough(file: Path) -> None:
    source = code(read(file))
    assert "import testbed" in source and not re.search(
        r"\btestbed\.(?!(design|fly|sweep|load)\()\w+|from testbed", source
    )


@of_all
def test_it_ends_in_what_it_shows(file: Path) -> None:
    """The last cell is a sentence or two, about the figure of the cell before it."""
    *_, figure, last = read(file).cells
    assert (figure.cell_type, last.cell_type) == ("code", "markdown")
    assert "plot" in figure.source and 20 < len(last.source.split()) < 100


@pytest.mark.nightly
@of_all
def test_it_still_shows_what_is_stored(file: Path, tmp_path: Path) -> None:
    """Words and numbers; of pictures, that there are as many. If it fails: python docs/generate/notebooks.py."""
    stored, notebook = read(file), read(file)
    run(notebook, tmp_path)
    assert texts(notebook) == texts(stored)
    assert pictures(outputs(notebook)) == pictures(outputs(stored))
    assert pictures(outputs(notebook)[-1:]) == 1


@pytest.mark.nightly
def test_the_sweep_says_something_of_few_runs_too(tmp_path: Path) -> None:
    notebook = read(ROOT / "notebooks" / "monte_carlo.ipynb")
    for cell in notebook.cells:
        cell.source = cell.source.replace("runs=30", "runs=4")
    run(notebook, tmp_path)
    assert pictures(outputs(notebook)) == 2
    assert "left tail monte carlo: 4 of 4 runs flown" in str(outputs(notebook))
