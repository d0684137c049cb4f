"""`testbed adopt`: make an aircraft of a JSBSim model, and print its card."""

from __future__ import annotations

from pathlib import Path


def adopt(model: str, out: Path | None) -> None:
    """Adopt a model into `out`, by default a folder of the model's name here; raises BadInput with what is missing."""
    from testbed.adoption import entry
    from testbed.adoption.first_flight import FILE

    folder, card = entry.adopt(model, out)
    print(card)
    print(f"\nwrote {folder}; break it with: testbed run {folder / FILE}")
