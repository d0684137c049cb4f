"""The table of records: complete, used, and what the dtypes are made of."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import testbed.controllers
from testbed.controllers import records
from testbed.controllers.records import MEMORY, MODE, MODEL, SETTINGS, WORK, Field

TABLES = {
    "MODEL": (MODEL, records.model_dtype),
    "SETTINGS": (SETTINGS, records.settings_dtype),
    "MODE": (MODE, records.mode_dtype),
    "MEMORY": (MEMORY, records.memory_dtype),
    "WORK": (WORK, records.work_dtype),
}
FIELDS = [pytest.param(field, id=f"{table}.{field.name}") for table in TABLES for field in TABLES[table][0]]
PAGES = "\n".join(
    page.read_text()
    for page in Path(testbed.controllers.__file__).parent.rglob("*.py")
    if page.name not in ("records.py", "initial_records.py")
)


@pytest.mark.parametrize("field", FIELDS)
def test_every_field_has_a_meaning_and_a_unit(field: Field) -> None:
    assert len(field.meaning.split()) >= 2 or field.equation
    assert field.unit
    assert set(field.shape) <= {"n", "n+4"} | set(range(100))
    assert re.fullmatch(r"|(section [\d.]+|\(\d+\)(, \(\d+\))*)", field.equation)


@pytest.mark.parametrize("field", FIELDS)
def test_every_field_is_read_by_a_page(field: Field) -> None:
    assert re.search(rf"\b[a-z]+\.{field.name}\b", PAGES)


@pytest.mark.parametrize("table", TABLES)
def test_records_are_made_of_the_table(table: str) -> None:
    fields, dtype_of = TABLES[table]
    names = [field.name for field in fields]
    assert len(set(names)) == len(names)
    for n in (1, 4, 6):
        dtype = dtype_of(n)
        assert list(dtype.names) == names
        assert dtype.isalignedstruct
        for field in fields:
            size = {"n": n, "n+4": n + 4}
            assert dtype[field.name].shape == tuple(size.get(d, d) for d in field.shape)
            assert dtype[field.name].base == (np.int8 if field.unit == "flag" else np.float64)


def test_named_rows_and_columns_are_in_the_order_of_their_names() -> None:
    from testbed.aircraft.design_model import COLUMNS
    from testbed.common.signals import RATES

    for prefix, names in (("", RATES), ("D_", COLUMNS), ("", records.REGULATOR_STATE)):
        for i, name in enumerate(names):
            assert getattr(records, f"{prefix}{name}".upper()) == i
    for i, name in enumerate(records.INTEGRALS):
        assert getattr(records, f"{name}_integral".upper()) == i
