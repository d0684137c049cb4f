"""The table of what was tried against the program names tests that are there, and nothing in it failed."""

from __future__ import annotations

import csv
import re
from xml.etree import ElementTree

from attacks import CLASSES, HEADER, ROOT, TABLE, rows

XML = """<testsuite>
<testcase classname="tests.common.test_writing" name="test_a_link_is_not_followed[a/b]"/>
<testcase classname="tests.studies.flying.test_pool" name="test_it"><failure/></testcase>
<testcase classname="tests.common.test_private" name="test_two_users"><skipped/></testcase>
</testsuite>"""


def test_each_test_is_a_row() -> None:
    assert list(rows(ElementTree.fromstring(XML))) == [
        (
            "writing",
            "a link is not followed: a/b",
            "held",
            "common/test_writing.py::test_a_link_is_not_followed",
        ),
        ("faults", "it", "FAILED", "studies/flying/test_pool.py::test_it"),
        ("caches", "two users", "not tried", "common/test_private.py::test_two_users"),
    ]


def test_the_table_names_tests_that_are_there() -> None:
    with TABLE.open(newline="", encoding="utf-8") as stream:
        header, *table = csv.reader(stream)
    assert tuple(header) == HEADER and {row[0] for row in table} == set(CLASSES)
    assert sum(outcome == "held" for _, _, outcome, _ in table) >= 200
    assert not [row for row in table if row[2] == "FAILED"]
    for test in {row[3] for row in table}:
        file, _, name = test.partition("::")
        assert re.search(
            rf"^def {name}\(", (ROOT / "tests" / file).read_text(encoding="utf-8"), re.MULTILINE
        ), test
