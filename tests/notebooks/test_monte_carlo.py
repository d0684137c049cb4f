"""The notebook is stored without output, and runs on a sweep folder from its first cell to its last."""

from __future__ import annotations

import os
from pathlib import Path

import nbformat
import pytest
from command_line import ROOT
from nbclient import NotebookClient
from sweep_files import written
from sweep_flights import quick

import testbed

NOTEBOOK = ROOT / "notebooks/monte_carlo.ipynb"


def test_stored_without_output() -> None:
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert 10 <= len(code) <= 14
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code)


@pytest.mark.parametrize("runs", [120, 6])  # enough for every answer, and too few for some
def test_runs_on_a_sweep_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, runs: int) -> None:
    testbed.sweep(written(tmp_path), tmp_path / "out", runs=runs, fly=quick, figures=False, save_logs="none")
    monkeypatch.setenv("SWEEP_FOLDER", str(tmp_path / "out"))
    monkeypatch.setenv("PYTHONPATH", f"{ROOT / 'src'}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    NotebookClient(
        notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": tmp_path}}
    ).execute()
    outputs = [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]
    assert all(outputs), [i for i, output in enumerate(outputs) if not output]
    figures = [output for cell in outputs for output in cell if "image/png" in output.get("data", {})]
    assert len(figures) == 2
