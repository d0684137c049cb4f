"""Further files of strangers: logs of flights, tables of cases, entries of a benchmark, and messages to a live flight."""

from __future__ import annotations

import base64
import json
import struct
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import received
import yaml
from hypothesis import strategies as st

Mutant = dict[str, str]
LOGS = ("log.csv", "log.parquet", "log.ulg", "log.bin")
MAPS = {"log.ulg": "px4.yaml", "log.bin": "ardupilot.yaml"}
"""The mapping file of a log; of the others it is `columns.yaml`."""
_SIGNALS = {
    "p": ("p_measured_deg_s", "deg_s", "xyz[0]", "rad_s"), "q": ("q_measured_deg_s", "deg_s", "xyz[1]", "rad_s"),
    "r": ("r_measured_deg_s", "deg_s", "xyz[2]", "rad_s"), "roll": ("roll_measured_deg", "deg", "roll", "rad"),
    "pitch": ("pitch_measured_deg", "deg", "pitch", "rad"),
    "airspeed": ("airspeed_measured_m_s", "m_s", "true_airspeed_m_s", "m_s"),
}  # fmt: skip
_TOPICS = {"roll": "vehicle_attitude", "pitch": "vehicle_attitude", "airspeed": "airspeed_validated"}
_ACTUATORS = {
    "left_ruddervator": "deg",
    "right_ruddervator": "deg",
    "left_propeller": "N",
    "right_propeller": "N",
}
_TABLE = "initial.airspeed_m_s,initial.heading_deg,failures.0.value\n18,80,0.5\n18.5,,0.2\n17,100,1\n"
_WITH_TABLE = {
    "name": "table", "scenario": received._SCENARIO, "cases": "cases.csv",
    "compare": {"controller.type": ["adaptive_inversion", "pid"]},
}  # fmt: skip
MESSAGES: list[Any] = [
    {"id": 1, "do": "break", "failure": {"type": "stuck_at", "actuator": "left_ruddervator", "value": 5}},
    {"id": 2, "do": "order", "command": {"heading_deg": 100, "altitude_m": 310}},
    {"id": 3, "do": "blow", "air": {"magnitude_m_s": [0, 3, 0], "duration_s": 1}},
    {"id": 4, "do": "blow", "air": {"wind_m_s": [1, 2, 0]}},
    {"id": 5, "do": "mend", "actuator": "left_ruddervator"},
    {"id": 6, "do": "ghosts", "controllers": ["pid"]},
    {"id": 7, "do": "rewind", "time_s": 0.05},
    {"id": 8, "do": "choose", "flight": "stuck_ruddervator.yaml", "controller": "pid"},
    {"id": 9, "do": "speed", "times": 4},
]


@cache
def files() -> dict[str, bytes]:
    """A log of 12 s in four formats, with their mapping files, and an entry of two draws."""
    import pandas as pd

    import testbed

    quick = {"duration_s": 12, "log_hz": 50, "sensors": {"model": "mems"}}
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "s.yaml").write_text(yaml.safe_dump({**received._SCENARIO, **quick}))
        (folder / "benchmark.yaml").write_text(yaml.safe_dump(received.STUDIES["benchmark.yaml"]))
        flight = testbed.fly(folder / "s.yaml")
        flight.save(folder / "run", figures=False)
        log = pd.read_csv(folder / "run/log.csv")
        log.to_parquet(folder / "log.parquet")
        flight.export("ulog", folder / "log.ulg")
        testbed.benchmark(
            folder / "benchmark.yaml", folder / "out", draws=2, seed=5, jobs=1, entry=folder / "entry.yaml"
        )
        made = {"log.csv": (folder / "run/log.csv").read_bytes(), "log.bin": _dataflash(log)}
        made |= {name: (folder / name).read_bytes() for name in ("log.parquet", "log.ulg", "entry.yaml")}
    return made | {name: yaml.safe_dump(tree).encode() for name, tree in _maps().items()}


def _maps() -> dict[str, Any]:
    plain, px4, ardupilot = ({"time": {}, "signals": {}, "actuators": {}} for _ in range(3))
    plain["time"] = {"column": "time_s", "unit": "s"}
    px4["time"] = {"column": "vehicle_angular_velocity.timestamp", "unit": "us"}
    ardupilot["time"] = {"column": "LOG.TimeUS", "unit": "us"}
    for number, (name, (column, unit, field, si)) in enumerate(_SIGNALS.items()):
        topic = _TOPICS.get(name, "vehicle_angular_velocity")
        plain["signals"][name] = {"column": column, "unit": unit}
        px4["signals"][name] = {"column": f"{topic}.{field}", "unit": si}
        ardupilot["signals"][name] = {"column": f"LOG.F{number}", "unit": unit}
    for number, (name, unit) in enumerate(_ACTUATORS.items()):
        plain["actuators"][name] = {"column": f"{name}_command", "unit": unit}
        px4["actuators"][name] = {"column": f"{name}.command", "unit": unit}
        ardupilot["actuators"][name] = {"column": f"LOG.F{len(_SIGNALS) + number}", "unit": unit}
    return {"columns.yaml": plain, "px4.yaml": px4, "ardupilot.yaml": ardupilot}


def _dataflash(log: Any) -> bytes:
    """A DataFlash log of one kind of message."""
    names = [*(column for column, *_ in _SIGNALS.values()), *(f"{name}_command" for name in _ACTUATORS)]
    fields = ",".join(["TimeUS", *(f"F{i}" for i in range(len(names)))])
    declared = struct.pack(
        "<BB4s16s64s", 129, 11 + 4 * len(names), b"LOG", b"Q" + b"f" * len(names), fields.encode()
    )
    rows = np.column_stack([log[name] for name in names])
    messages = (struct.pack(f"<2sBQ{len(names)}f", b"\xa3\x95", 129, round(t * 1e6), *row)
                for t, row in zip(log["time_s"], rows, strict=True))  # fmt: skip
    return b"\xa3\x95\x80" + declared + b"".join(messages)


def logs(trees: Callable[[list[Any]], Any], texts: Callable[[list[str]], Any]) -> st.SearchStrategy[Mutant]:
    """A log, or its mapping, with changes."""

    def changed(name: str) -> st.SearchStrategy[Mutant]:
        mapping = MAPS.get(name, "columns.yaml")
        spoilt = texts([files()[name].decode("latin-1")]).map(
            lambda text: {name: _coded(text.encode("latin-1", "replace"))}
        )
        numbers = st.lists(
            st.tuples(st.integers(0, len(files()[name]) - 1), st.integers(0, 255)), min_size=1, max_size=20
        )
        flipped = numbers.map(lambda changes: {name: _coded(_flipped(files()[name], changes))})
        mapped = trees([yaml.safe_load(files()[mapping])]).map(lambda tree: {mapping: yaml.safe_dump(tree)})
        both = {each: _coded(files()[each]) for each in (name, mapping)}
        return st.one_of(spoilt, flipped, mapped).map(lambda mutant: {**both, **mutant})

    return st.deferred(lambda: st.sampled_from(LOGS).flatmap(changed))


def _flipped(content: bytes, changes: list[tuple[int, int]]) -> bytes:
    made = bytearray(content)
    for place, value in changes:
        made[place] = value
    return bytes(made)


def _coded(content: bytes) -> str:
    return received.BASE64 + base64.b64encode(content).decode()


def cases(texts: Callable[[list[str]], Any]) -> st.SearchStrategy[Mutant]:
    """A table of cases with changes, and the sweep that names it."""
    return texts([_TABLE, _TABLE.replace(",", ";")]).map(
        lambda text: {"sweep.yaml": yaml.safe_dump(_WITH_TABLE), "cases.csv": text}
    )


def entries(
    trees: Callable[[list[Any]], Any], texts: Callable[[list[str]], Any]
) -> st.SearchStrategy[Mutant]:
    """An entry with changes, and its suite."""

    def both() -> st.SearchStrategy[Mutant]:
        text = files()["entry.yaml"].decode()
        suite = {"benchmark.yaml": yaml.safe_dump(received.STUDIES["benchmark.yaml"])}
        spoilt = trees([yaml.safe_load(text)]).map(yaml.safe_dump) | texts([text])
        return spoilt.map(lambda each: {**suite, "entry.yaml": each})

    return st.deferred(both)


def messages(
    trees: Callable[[list[Any]], Any], texts: Callable[[list[str]], Any]
) -> st.SearchStrategy[Mutant]:
    """Messages to a live flight, one a line."""
    spoilt = trees(MESSAGES).map(lambda tree: json.dumps(tree, default=str)) | texts(
        [json.dumps(each) for each in MESSAGES]
    )
    flown = yaml.safe_dump(received._SCENARIO)
    return st.lists(spoilt, min_size=1, max_size=4).map(
        lambda lines: {"s.yaml": flown, "messages.jsonl": "\n".join(lines)}
    )
