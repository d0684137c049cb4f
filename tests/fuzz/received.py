"""Folders that somebody sent: those of a run, a sweep, a search, a matrix and a benchmark, with one of their files changed.

A mutant is {name: text} of a whole folder `received`; the contents of a binary file are in base64. A table is changed as bytes or
in what its metadata say; a database as bytes, in its records, or by what is added to its tables.
"""

from __future__ import annotations

import base64
import io
import json
import sqlite3
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import yaml
from hypothesis import strategies as st

sys.path.append(str(Path(__file__).parents[1] / "support"))
import suite_files

Mutant = dict[str, str]
Change = Callable[[bytes], st.SearchStrategy[bytes]]
BASE64 = "base64:"
FOLDER = "received"

_SCENARIO = {
    "name": "sent", "aircraft": "vtail", "duration_s": 1, "log_hz": 20, "initial": {"heading_deg": 90},
    "failures": [{"type": "effectiveness", "actuator": "left_ruddervator", "at_s": 0.3, "value": 0.2}],
    "requirements": [{"name": "held", "metric": "altitude_error_max_m", "at_most": 1}],
}  # fmt: skip
_SWEEP = {
    "name": "sent", "scenario": _SCENARIO, "runs": 2, "seed": 3,
    "vary": {"failures.0.value": {"uniform": [0, 1]}},
    "compare": {"controller.type": ["adaptive_inversion", "pid"]},
}  # fmt: skip
_SEARCH = {
    "name": "sent", "scenario": _SCENARIO, "goal": "smallest", "budget": 20, "seed": 3,
    "set": {"atmosphere": {"wind_m_s": [0, 0, 0]}},
    "vary": {"atmosphere.wind_m_s.0": {"normal": [0, 4]}, "atmosphere.wind_m_s.1": {"normal": [0, 4]}},
}  # fmt: skip
MATRIX = {
    "name": "sent", "scenario": _SCENARIO, "at_s": 0.3, "severities": [1.0],
    "failures": [{"type": "effectiveness", "value": 0.2}],
}  # fmt: skip
STUDIES = {
    "sweep.yaml": _SWEEP,
    "search.yaml": _SEARCH,
    "matrix.yaml": MATRIX,
    "benchmark.yaml": suite_files.tree(),
}
"""What the folders of studies were flown from."""


@cache
def files_of(kind: str) -> dict[str, bytes]:
    """The files of a folder of a kind, unspoilt."""
    import testbed

    with tempfile.TemporaryDirectory() as place:
        source, folder = Path(place) / "sent.yaml", Path(place) / FOLDER
        source.write_text(yaml.safe_dump(STUDIES.get(f"{kind.split()[0]}.yaml", _SCENARIO)))
        if kind == "run folder":
            testbed.fly(source).save(folder, figures=False)
        elif kind == "sweep folder":
            testbed.sweep(source, folder, jobs=1, save_logs="all", figures=False)
        elif kind == "matrix folder":
            testbed.matrix(source, folder, jobs=1, save_logs="all", figures=False)
        elif kind == "benchmark folder":
            testbed.benchmark(source, folder, draws=2, seed=5, jobs=1)
        else:
            testbed.search(source, folder, jobs=1, figures=False)
        files = (file for file in sorted(folder.rglob("*")) if file.is_file() and file.suffix != ".html")
        return {str(file.relative_to(folder)): file.read_bytes() for file in files}


def mutants_of(kind: str, trees: Callable[[list[Any]], Any], texts: Callable[[list[str]], Any]) -> Any:
    """The mutants of a kind of folder, by the strategies of `mutants` for trees of values and for texts."""

    def changed(name: str) -> st.SearchStrategy[Mutant]:
        sent = {f"{FOLDER}/{each}": _said(old) for each, old in files_of(kind).items()} | _study(kind)
        return _contents(files_of(kind)[name], name, trees, texts).map(
            lambda content: {**sent, f"{FOLDER}/{name}": _said(content)}
        )

    return st.deferred(lambda: st.sampled_from(_read_back(sorted(files_of(kind)))).flatmap(changed))


@cache
def _study(kind: str) -> Mutant:
    """The file with which a study's folder is resumed."""
    name = f"{kind.split()[0]}.yaml"
    return {name: yaml.safe_dump(STUDIES[name])} if name in STUDIES else {}


def _read_back(names: list[str]) -> list[str]:
    """The files that the program reads: of a table in Parquet and CSV the former, and one of the kept logs."""
    logs = [name for name in names if name.startswith("logs/")]
    unread = {*logs[1:], *(["results.csv"] if "results.parquet" in names else [])}
    return [name for name in names if name not in unread]


def _said(content: bytes) -> str:
    return BASE64 + base64.b64encode(content).decode()


def _contents(content: bytes, name: str, trees: Any, texts: Any) -> st.SearchStrategy[bytes]:
    spoilt = texts([content.decode("latin-1")]).map(lambda text: text.encode("latin-1", "replace"))
    ending = Path(name).suffix
    if ending == ".json":
        return trees([json.loads(content)]).map(_json) | spoilt
    if ending == ".yaml":
        return trees([yaml.safe_load(content)]).map(lambda tree: yaml.safe_dump(tree).encode()) | spoilt
    if ending == ".parquet":
        return _tables(content, trees) | spoilt
    if ending == ".sqlite":
        return _databases(content, trees) | spoilt
    return spoilt


def _json(tree: Any) -> bytes:
    return json.dumps(tree).encode()


def _tables(content: bytes, trees: Any) -> st.SearchStrategy[bytes]:
    """A table with other metadata, or with columns renamed, left out, or of texts."""
    table = pq.read_table(io.BytesIO(content))
    about = {key: value for key, value in (table.schema.metadata or {}).items() if key != b"ARROW:schema"}

    def spoilt(key: bytes) -> st.SearchStrategy[bytes]:
        tree = yaml.safe_load(about[key])
        return trees([tree]).map(
            lambda tree: _parquet(table.replace_schema_metadata({**about, key: _json(tree)}))
        )

    names = st.sampled_from(table.column_names)
    columns = st.one_of(
        names.map(lambda name: _parquet(table.drop_columns([name]))),
        st.tuples(names, names).map(lambda two: _parquet(_renamed(table, *two))),
        st.tuples(names, st.sampled_from(["\x1b[2J", None])).map(lambda two: _parquet(_filled(table, *two))),
        st.integers(0, len(table)).map(lambda n: _parquet(table.slice(n))),
    )  # fmt: skip
    ours = sorted(key for key in about if key.startswith(b"testbed"))
    return columns | st.sampled_from(ours).flatmap(spoilt) if ours else columns


def _renamed(table: Any, name: str, other: str) -> Any:
    return table.rename_columns([other if each == name else each for each in table.column_names])


def _filled(table: Any, name: str, value: object) -> Any:
    return table.set_column(table.column_names.index(name), name, [[value] * len(table)])


def _parquet(table: Any) -> bytes:
    stream = io.BytesIO()
    pq.write_table(table, stream)
    return stream.getvalue()


_ADDED = (
    "CREATE TRIGGER t AFTER INSERT ON flights BEGIN DELETE FROM flights; END",
    "CREATE VIEW v AS SELECT load_extension('x.so')",
    "CREATE TABLE other (x)",
    "CREATE INDEX i ON flights (record)",
    "DELETE FROM begun",
    "DELETE FROM flights",
    "UPDATE flights SET history = zeroblob(3000000)",
    "UPDATE flights SET history = ''",
    "UPDATE flights SET key = x'00' WHERE rowid = 1",
    "UPDATE flights SET key = zeroblob(8) WHERE rowid = 2",
    "PRAGMA user_version = 99",
    "PRAGMA application_id = 0",
)  # fmt: skip


def _databases(content: bytes, trees: Any) -> st.SearchStrategy[bytes]:
    """A database with another record, other inputs, or with what testbed does not put there."""
    records = [json.loads(text) for (text,) in _asked(content, "SELECT record FROM flights")]
    (begun,) = [json.loads(text) for (text,) in _asked(content, "SELECT inputs FROM begun")]
    one = "UPDATE flights SET record = ? WHERE key = (SELECT key FROM flights LIMIT 1)"
    return st.one_of(
        trees(records).map(lambda tree: _edited(content, one, json.dumps(tree))),
        trees([begun]).map(lambda tree: _edited(content, "UPDATE begun SET inputs = ?", json.dumps(tree))),
        st.sampled_from(_ADDED).map(lambda statement: _edited(content, statement)),
    )


def _opened(content: bytes) -> sqlite3.Connection:
    """The database in memory, which knows no write-ahead log."""
    database = sqlite3.connect(":memory:", isolation_level=None)
    database.deserialize(content[:18] + b"\1\1" + content[20:])
    return database


def _asked(content: bytes, question: str) -> list[Any]:
    return _opened(content).execute(question).fetchall()


def _edited(content: bytes, statement: str, *values: object) -> bytes:
    database = _opened(content)
    try:
        database.execute(statement, values)
    except sqlite3.Error:  # a key that is there twice
        return content
    image = database.serialize()
    return image[:18] + b"\2\2" + image[20:]
