"""The check that a flight can begin: that there are a trimmed start and a design model.

That both were found is recorded in the user's cache folder. A scenario that was checked before is then checked again without
JSBSim and scipy.
"""

from __future__ import annotations

import hashlib

from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import DESIGN_MODEL, load_design_model
from testbed.aircraft.model_files.safe_xml import read_bytes
from testbed.plant import model_cache
from testbed.plant.first_load import property_catalog


def check_start(
    aircraft: Aircraft,
    physics_hz: float,
    airspeed_m_s: float,
    altitude_m: float,
    heading_rad: float,
    *,
    remembered: bool = True,
) -> dict[str, bool]:
    """Name of each property of the aircraft's model, and whether it can be written, if a flight can begin.

    Args:
        remembered: whether to look for a record, and to keep one. The flights of a sweep would fill the folder with them.

    Raises:
        BadInput: the model cannot be loaded, or the stored design model is none.
        NoTrim: there is no level flight at the initial condition, or none from which to identify a missing design model.
    """
    catalog = property_catalog(aircraft)
    start = (physics_hz, airspeed_m_s, altitude_m, heading_rad)
    if not remembered:
        _begin(aircraft, start)
        return catalog
    stored_text = _design_model(aircraft)
    key = f"{aircraft.fingerprint()}-{hashlib.sha256(repr((start, stored_text)).encode()).hexdigest()[:16]}"
    if not model_cache.has(key):
        _begin(aircraft, start)
        model_cache.write(key, {})
    return catalog


def _begin(aircraft: Aircraft, start: tuple[float, float, float, float]) -> None:
    """Find what a flight begins with."""
    from testbed.plant.identification import stored
    from testbed.plant.trim import trimmed_start

    trimmed_start(aircraft, *start)
    trimmed_start(aircraft.nominal, *start)
    stored(aircraft.nominal)


def _design_model(aircraft: Aircraft) -> bytes:
    """The contents of the stored design model, which was read; empty if there is none. Raises BadInput."""
    file = aircraft.folder / DESIGN_MODEL
    if not file.exists():
        return b""
    contents = read_bytes(file)
    load_design_model(file)
    return contents
