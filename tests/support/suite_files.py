"""A small suite: the failures of the shipped one on the v-tail, in flights of two seconds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from testbed.aircraft.shipped import find_suite
from testbed.inputs import yaml_source as yamlfile

BAD = """\
class Raises:
    def __init__(self, setup): pass
    def update(self, time_s, state, reference): return [0.0, 1.0 / 0.0, 0.0, 0.0]

class NoNumber:
    def __init__(self, setup): self.trim = list(setup.trim_commands)
    def update(self, time_s, state, reference): return [float("nan"), *self.trim[1:]]

class Hangs:
    def __init__(self, setup): pass
    def update(self, time_s, state, reference):
        while True: pass
"""


def tree() -> dict[str, Any]:
    """The suite's tree, to be changed."""
    suite: dict[str, Any] = yamlfile.read(find_suite("open")).tree
    suite |= {"suite": "tiny", "version": 1, "duration_s": 2, "told": []}
    suite["controllers"] = {"default": {"type": "adaptive_inversion"}, "fixed": {"type": "fixed_inversion"}}
    suite["aircraft"] = {name: suite["aircraft"][name] for name in ("vtail", "vtail_aft")}
    early = {"uniform": [0.2, 1.2]}
    for part, key in (("references", "at_s"), ("sensor_faults", "at_s"), ("failures", "first_s")):
        suite[part][key] = early
    suite["failures"] |= {name: {"uniform": [0.1, 0.4]} for name in ("after_s", "lasts_s", "back_after_s")}
    return suite


def written(folder: Path, suite: dict[str, Any] | None = None) -> Path:
    file = folder / "tiny.yaml"
    file.write_text(yamlfile.dump(tree() if suite is None else suite))
    return file


def flown(suite: Path, out: Path, *, jobs: int | None = None, resume: bool = False, **asked: Any) -> Path:
    """Four draws of a suite, flown into a folder: in this process, or with `jobs` by as many others."""
    from testbed.api.benchmark import finish, fly, prepare  # not when tests are looked for
    from testbed.studies.flying.pool import serial, workers
    from testbed.studies.run import Options

    plan, folder = prepare(suite, out, **{"draws": 4, "seed": 5, **asked})
    how = Options(jobs, save_logs="none", workers=workers if jobs else serial)
    finish(plan, folder, fly(plan, folder, how, resume=resume))
    return out


def same_results(one: Path, other: Path) -> None:
    for name in ("results.csv", "summary.json"):
        assert (one / name).read_bytes() == (other / name).read_bytes(), name
