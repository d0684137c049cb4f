"""`testbed identify`: find the design model that controllers use, and store it in the aircraft's folder."""

from __future__ import annotations

from testbed.aircraft.description import load_aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.cli.interrupts import tidily
from testbed.inputs.problems import BadInput, Problem


def identify(name: str, *, check: bool) -> bool:
    """Identify the design model and store it; with `check`, only compare it with the stored one.

    Returns False if the stored model differs. Raises BadInput when the aircraft has no trim or the file cannot be written.
    """
    from testbed.plant.identification import identify

    aircraft = load_aircraft(name)
    file = aircraft.folder / DESIGN_MODEL
    model = identify(aircraft)
    if check:
        same = file.is_file() and load_design_model(file).agrees_with(model)
        print(f"{file}: {'as identified' if same else 'differs from what is identified now'}")
        return same
    try:
        with tidily():
            model.save(file)
    except OSError as error:
        raise BadInput([Problem(f"cannot be written: {error.strerror}", str(file))]) from None
    print(f"wrote {file}")
    return True
