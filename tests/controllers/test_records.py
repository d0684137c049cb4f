"""The table of records: complete, used, and what the dtypes are made of."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import testbed.controllers
from testbed.controllers import records
from testbed.controllers.records import MEMORY, MODE, MODEL, SETTINGS, WORK

TABLES = {
    "MODEL": (MODEL, records.model_dtype),
    "SETTINGS": (SETTINGS, records.settings_dtype),
    "MODE": (MODE, records.mode_dtype),
    "MEMORY": (MEMORY, records.memory_dtype),
    "WORK": (WORK, records.work_dtype),
}
READ = {
    name
    for page in Path(testbed.controllers.__file__).parent.rglob("*.py")
    if page.name not in ("records.py", "initial_records.py")
    for name in re.findall(r"\b[a-z]+\.(\w+)", page.read_text())
}
"""Attributes that the pages of the controllers name, of any record."""


@pytest.mark.parametrize("table", TABLES)
def test_every_field_has_a_meaning_and_a_unit(table: str) -> None:
    for field in TABLES[table][0]:
        assert len(field.meaning.split()) >= 2 or field.equation, field
        assert field.unit, field
        assert set(field.shape) <= {"n", "n+4"} | set(range(100)), field
        assert re.fullmatch(r"|(section [\d.]+|\(\d+\)(, \(\d+\))*)", field.equation), field


@pytest.mark.parametrize("table", TABLES)
def test_every_field_is_read_by_a_page(table: str) -> None:
    """By any: a field that nothing reads is memory carried about for nothing."""
    assert not {field.name for field in TABLES[table][0]} - READ


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
