"""Run the notebooks, and store them with what they show.

    python docs/generate/notebooks.py [NAME ...]        default: all

What differs between two runs or machines is left out: times, paths of folders, what is printed to stderr.
"""

from __future__ import annotations

import base64
import hashlib
import io
import os
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode
from PIL import Image

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))


def read(file: Path) -> NotebookNode:
    """A notebook as it is stored."""
    return nbformat.read(file, as_version=4)


def code_digest(notebook: NotebookNode) -> str:
    """Digest of the code of all cells: outputs that were stored with another are stale."""
    sources = [cell.source for cell in notebook.cells if cell.cell_type == "code"]
    return hashlib.sha256("\0".join(sources).encode()).hexdigest()[:16]


def run(notebook: NotebookNode, folder: Path) -> None:
    """Run all cells in a folder with nothing in it, with this Python and its testbed; outputs are left in the notebook."""
    paths = [str(ROOT / "src"), os.environ.get("PYTHONPATH", "")]
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(path for path in paths if path),
        "IPYTHONDIR": str(folder / "ipython"),
        "JUPYTER_DATA_DIR": str(folder / "jupyter"),  # not a kernel of the user's own
        "TMPDIR": str(folder),
        "OPENBLAS_CORETYPE": "Haswell",  # not the kernel of this processor, which changes the last digits, and so how one is lost
    }
    where = {"metadata": {"path": str(folder)}}
    client = NotebookClient(
        notebook, timeout=600, kernel_name="python3", resources=where, record_timing=False
    )
    client.execute(env=environment)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = [
                _portable(output, folder) for output in cell.outputs if output.get("name") != "stderr"
            ]


def _portable(output: NotebookNode, folder: Path) -> NotebookNode:
    """An output in which the folder that the notebook ran in has no name, and pictures have few colours."""
    if "text" in output:
        output.text = output.text.replace(str(folder), ".")
    for kind, content in output.get("data", {}).items():
        if kind == "image/png":
            output.data[kind] = _of_few_colours(content)
        elif isinstance(content, str):
            output.data[kind] = content.replace(str(folder), ".")
    return output


def _of_few_colours(png: str) -> str:
    """A picture, base64-encoded, with a palette: a third of the bytes, and lines look the same."""
    small = io.BytesIO()
    with Image.open(io.BytesIO(base64.b64decode(png))) as picture:
        picture.convert("RGB").quantize(64, dither=Image.Dither.NONE).save(small, "PNG", optimize=True)
    return base64.b64encode(small.getvalue()).decode()


def store(file: Path) -> None:
    """Run a notebook, and write it with its outputs and the digest of its code."""
    notebook = read(file)
    with tempfile.TemporaryDirectory() as folder:
        run(notebook, Path(folder))
    notebook.metadata["language_info"] = {"name": "python"}  # not the version of this Python
    notebook.metadata["code_digest"] = code_digest(notebook)
    nbformat.write(notebook, file)


def main(names: list[str]) -> None:
    """Store the notebooks of these names."""
    known = {file.stem: file for file in NOTEBOOKS}
    if unknown := [name for name in names if name not in known]:
        sys.exit(f"{unknown[0]}: there is no such notebook, expected one of {', '.join(known)}")
    for name in names or known:
        store(known[name])
        print(f"notebooks/{name}.ipynb")


if __name__ == "__main__":
    main(sys.argv[1:])
