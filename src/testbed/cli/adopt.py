"""`testbed adopt`: make an aircraft of a JSBSim model, and print its card."""

from __future__ import annotations

from pathlib import Path

from testbed.inputs.problems import BadInput, Problem


def adopt(model: str, out: Path | None) -> None:
    """Adopt a model into `out`, by default a folder of the model's name here; raises BadInput with what is missing."""
    from testbed.adoption.child import adopted_card
    from testbed.adoption.first_flight import FILE
    from testbed.adoption.source import find_source, package_root

    source = find_source(model, package_root())
    folder = Path(source.name) if out is None else out
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise BadInput([Problem("exists already", str(folder), expected="--out with a new folder")])
    print(adopted_card(source, folder.resolve()))
    print(f"\nwrote {folder}; break it with: testbed run {folder / FILE}")
