"""Gymnasium environments: an agent flies the testbed's aircraft, and is broken like any other controller.

Importing this package registers `testbed/NAME-v0` for each aircraft NAME that is shipped or lies in the present folder or in its
folder `aircraft`, and `testbed/flight-v0` for one that is named in `make`. `gymnasium.make("testbed.env:testbed/NAME-v0")` imports
it by itself; Gymnasium 1.0 has no other way to find what was not imported.
"""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator
from contextlib import suppress

from testbed.aircraft.shipped import aircraft_names

ANY = "testbed/flight-v0"
"""The environment whose aircraft is an argument."""


def register() -> None:
    """Register an environment for each aircraft; those that are known already stay as they are."""
    from gymnasium.envs import registration

    known: dict[str, dict[str, str]] = {ANY: {}} | {
        f"testbed/{name}-v0": {"aircraft": place} for name, place in _aircraft()
    }
    for name, given in known.items():
        if name not in registration.registry and registration.ENV_ID_RE.fullmatch(name):
            registration.register(name, "testbed.env.flight:FlightEnv", kwargs=given)


def _aircraft() -> Iterator[tuple[str, str]]:
    """Name of each aircraft, and what `find_aircraft` takes it by; a shipped one comes last, so that no folder takes its name."""
    for folder in (".", "aircraft"):
        with suppress(OSError):
            for name in sorted(os.listdir(folder)):
                place = os.path.realpath(f"{folder}/{name}")
                if os.path.isfile(f"{place}/{name}.yaml") and any(glob.iglob(f"{glob.escape(place)}/*.xml")):
                    yield name, place
    yield from ((name, name) for name in aircraft_names())


with suppress(ImportError):  # without gymnasium a learnt policy can still be flown by `testbed run`
    register()
